# SPDX-License-Identifier: GPL-3.0-or-later
"""Every experiment at its quick size, or at its default one with PALPATE_TEST_FULL: all verdicts pass, all charts come."""

import os
import unittest

from charting.tables import read_folder
from charts import CHARTS
from lab_runs import LabTest


class Everything(LabTest):
    def test_all_verdicts_pass_and_all_charts_are_drawn(self):
        size = () if os.environ.get("PALPATE_TEST_FULL") else ("--quick",)
        run = self.lab("run", "all", *size, "--out", self.folder)
        self.assertEqual(run.returncode, 0, run.stdout)
        self.assertIn("verdicts passed", run.stdout.splitlines()[-1])
        drawn = self.charts(self.folder)
        self.assertEqual(drawn.returncode, 0, drawn.stderr)
        tables = read_folder(self.folder)
        for name, _, _, needs, _ in CHARTS:
            if any(all(row.value is None for row in tables[experiment]) for experiment in needs):
                continue  # a build without VTK has no gallery of mazes
            self.assertGreater((self.folder / f"{name}.png").stat().st_size, 10000, name)
            self.assertNotIn("nan", (self.folder / f"{name}.svg").read_text(encoding="utf-8").lower(), name)


if __name__ == "__main__":
    unittest.main()
