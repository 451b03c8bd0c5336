# SPDX-License-Identifier: GPL-3.0-or-later
"""docs/example/regression under pytest and unittest: without a baseline they say how to write it, with one they pass, and
with another ball they fail."""

import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SOURCE = Path(os.environ["PALPATE_SOURCE_DIR"]) / "docs/example/regression"
UPDATE = "PALPATE_UPDATE_BASELINES"


class Examples(unittest.TestCase):
    def play(self, script, *runner):
        with tempfile.TemporaryDirectory() as folder:
            copy = Path(shutil.copy(SOURCE / script, folder))
            run = lambda **more: subprocess.run([sys.executable, *runner, copy], cwd=folder, capture_output=True, text=True,  # noqa: E731
                                                check=False, env={**os.environ, **more})
            first = run()
            self.assertNotEqual(first.returncode, 0)
            self.assertIn(f"{UPDATE}=1", first.stdout + first.stderr)
            for more in ({UPDATE: "1"}, {}):
                passed = run(**more)
                self.assertEqual(passed.returncode, 0, passed)
            text = copy.read_text(encoding="utf-8")
            copy.write_text(text.replace("SetRadius(50)", "SetRadius(50.5)"), encoding="utf-8")
            failed = run()
            self.assertEqual(failed.returncode, 1, failed)
            self.assertIn("does not feel as it did", failed.stdout + failed.stderr)

    def test_pytest(self):
        self.play("test_ball_pytest.py", "-m", "pytest", "-q", "-p", "no:cacheprovider")

    def test_unittest(self):
        self.play("test_ball_unittest.py")


if __name__ == "__main__":
    unittest.main(verbosity=2)
