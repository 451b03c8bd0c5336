# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs of palpate-lab and of its charts, for the tests beside this file."""

import csv
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
PROGRAM = Path(os.environ["PALPATE_BUILD_DIR"]) / "bin" / "palpate-lab"


class LabTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def lab(self, *arguments):
        return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, check=False)

    def charts(self, *arguments):
        return subprocess.run([sys.executable, HERE / "charts.py", *map(str, arguments)], capture_output=True, text=True,
                              check=False)

    def assert_refused(self, run, *words):
        """Exit code 2, one line that says why, no trace."""
        self.assertEqual(run.returncode, 2, (run.stdout, run.stderr))
        self.assertNotIn("Traceback", run.stderr)
        for word in words:
            self.assertIn(str(word), run.stderr)


def rows(file):
    with open(file, newline="", encoding="utf-8") as stream:
        return list(csv.DictReader(stream))
