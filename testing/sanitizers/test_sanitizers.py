# SPDX-License-Identifier: GPL-3.0-or-later
"""The core's threads and its tick are clean under a sanitizer. Commits take turns, with the long experiments too. The thread
sanitizer's turn takes the folders in which no threads meet from the build as it is; the long form instruments them too."""

import os
import pathlib
import subprocess
import unittest

from turns import in_turn

HERE = pathlib.Path(__file__).resolve().parent
LIBRARY = pathlib.Path(os.environ["PALPATE_BUILD_DIR"]) / "lib" / "libpalpate.so"
KINDS = ("address,undefined", "thread")


class Sanitizers(unittest.TestCase):
    def build_and_test(self, kind):
        folder = pathlib.Path(os.environ["PALPATE_SANITIZED_DIR"]) / kind.split(",", maxsplit=1)[0]
        library = "" if kind != "thread" or os.environ.get("PALPATE_TEST_FULL") else LIBRARY
        command = [os.environ["PALPATE_CTEST"], "--build-and-test", HERE / "subset", folder, "--build-generator", "Ninja",
            "--build-noclean", "--build-options", f"-DPALPATE_SANITIZE={kind}", f"-DPALPATE_LIBRARY={library}", "-DCMAKE_BUILD_TYPE=None",
            "--test-command", folder / "bin" / "sanitized-tests", "--gtest_brief=1"]
        halting = {"TSAN_OPTIONS": "halt_on_error=1", "UBSAN_OPTIONS": "print_stacktrace=1"}
        return subprocess.run(command, env=os.environ | halting, capture_output=True, text=True, check=False)

    def test_the_core_is_clean_under_the_sanitizer_whose_turn_it_is(self):
        kinds = in_turn(KINDS, first=5)
        print("in turn:", ", ".join(kinds) or "neither; the next commits have theirs")
        for kind in kinds:
            with self.subTest(kind):
                run = self.build_and_test(kind)
                self.assertEqual(run.returncode, 0, run.stdout[-6000:] + run.stderr[-2000:])
                self.assertIn("[  PASSED  ]", run.stdout)


if __name__ == "__main__":
    unittest.main()
