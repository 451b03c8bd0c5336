# SPDX-License-Identifier: GPL-3.0-or-later
"""Every experiment's verdicts pass and all charts come.

At default sizes run all that are short and those of the long ones whose turn it is; the others run at their quick size. With PALPATE_TEST_FULL all run at default sizes.
"""

import json
import sys
import unittest

from charting.tables import read_folder
from charts import CHARTS
from lab_runs import LabTest
from turns import in_turn

# 10 s or more each at default sizes.
LONG = (
    {"tunnelling", "queries"},
    {"deforming", "image-curves"},
    {"stability-atlas", "solver", "transparency"},
    {"speed-accuracy", "tick-cost", "recorded-touch"},
    {"blind-solver"},
)


class Everything(LabTest):
    def names(self):
        return {experiment["name"] for experiment in json.loads(self.lab("list", "--json").stdout)}

    def assert_all_verdicts_pass(self, names, *size):
        run = self.lab("run", *sorted(names), *size, "--out", self.folder)
        self.assertEqual(run.returncode, 0, run.stdout)
        self.assertIn("verdicts passed", run.stdout.splitlines()[-1])

    def test_all_verdicts_pass_and_all_charts_are_drawn(self):
        names = self.names()
        self.assertLessEqual(set().union(*LONG), names, "a long experiment was renamed")
        quick = set().union(*LONG) - set().union(*in_turn(LONG, first=0))
        print("at quick sizes:", ", ".join(sorted(quick)) or "none", file=sys.stderr)
        self.assert_all_verdicts_pass(names - quick)
        if quick:
            self.assert_all_verdicts_pass(quick, "--quick")
        drawn = self.charts(self.folder)
        self.assertEqual(drawn.returncode, 0, drawn.stderr)
        tables = read_folder(self.folder)
        self.assertEqual(set(tables), names)
        for name, _, _, needs, _ in CHARTS:
            if any(all(row.value is None for row in tables[experiment]) for experiment in needs):
                continue  # a build without VTK has no gallery of mazes
            self.assertGreater((self.folder / f"{name}.png").stat().st_size, 10000, name)
            self.assertNotIn("nan", (self.folder / f"{name}.svg").read_text(encoding="utf-8").lower(), name)


if __name__ == "__main__":
    unittest.main()
