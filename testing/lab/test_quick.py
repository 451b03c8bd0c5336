# SPDX-License-Identifier: GPL-3.0-or-later
"""Every experiment at its quick size, or at its default one with PALPATE_TEST_FULL: all verdicts pass, all charts come."""

import os
import unittest

from lab_runs import LabTest

CHARTS = ("speed-accuracy", "stability-atlas", "facets", "solver", "rate-stiffness", "queries")


class Everything(LabTest):
    def test_all_verdicts_pass_and_all_charts_are_drawn(self):
        size = () if os.environ.get("PALPATE_TEST_FULL") else ("--quick",)
        run = self.lab("run", "all", *size, "--out", self.folder)
        self.assertEqual(run.returncode, 0, run.stdout)
        self.assertIn("verdicts passed", run.stdout.splitlines()[-1])
        drawn = self.charts(self.folder)
        self.assertEqual(drawn.returncode, 0, drawn.stderr)
        for name in CHARTS:
            self.assertGreater((self.folder / f"{name}.png").stat().st_size, 10000, name)
            self.assertNotIn("nan", (self.folder / f"{name}.svg").read_text(encoding="utf-8").lower(), name)


if __name__ == "__main__":
    unittest.main()
