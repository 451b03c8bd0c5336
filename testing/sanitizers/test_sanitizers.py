# SPDX-License-Identifier: GPL-3.0-or-later
"""The core's threads and its tick are clean under a sanitizer. Commits take turns, with the long experiments too."""

import os
import pathlib
import subprocess
import unittest

from turns import in_turn

HERE = pathlib.Path(__file__).resolve().parent
KINDS = ("address,undefined", "thread")


class Sanitizers(unittest.TestCase):
    def build_and_test(self, kind):
        folder = pathlib.Path(os.environ["PALPATE_SANITIZED_DIR"]) / kind.split(",", maxsplit=1)[0]
        command = [os.environ["PALPATE_CTEST"], "--build-and-test", HERE / "subset", folder, "--build-generator", "Ninja",
            "--build-noclean", "--build-options", f"-DPALPATE_SANITIZE={kind}", "-DCMAKE_BUILD_TYPE=None",
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
