# SPDX-License-Identifier: GPL-3.0-or-later
"""Every experiment's verdicts pass and all charts come.

usage: test_verdicts.py costs     of the experiments of which a verdict compares costs: nothing may run beside them
       test_verdicts.py others    of all others

At default sizes run those whose turn it is, a fifth of them; the others run at their quick size. With PALPATE_TEST_FULL all run
at default sizes.
"""

import json
import re
import sys
import unittest

from charting.tables import read_folder
from charts import CHARTS
from lab_runs import HERE, LabTest
from turns import in_turn

# 10 s or more each at default sizes: dealt by hand to the turns, the others by name.
LONG = (
    {"tunnelling", "queries"},
    {"deforming", "image-curves"},
    {"stability-atlas", "solver", "transparency"},
    {"speed-accuracy", "tick-cost", "recorded-touch"},
    {"blind-solver"},
)
COMPARED = re.compile(r"^(?!.*\b(Cost::of|return Cost)\b).*\b(p50_us|p99_us|quantile_us)\b", re.MULTILINE)


def compared_costs():
    """The experiments whose source compares a cost with another, by the name of its file."""
    files = [path.stem for path in sorted(HERE.glob("experiments/*.cpp")) if COMPARED.search(path.read_text(encoding="utf-8"))]
    return {re.sub("(?<!^)(?=[A-Z])", "-", stem).lower() for stem in files}


class Verdicts(LabTest):
    def all_names(self):
        return {experiment["name"] for experiment in json.loads(self.lab("list", "--json").stdout)}

    def assert_all_verdicts_pass(self, names, *size):
        run = self.lab("run", *sorted(names), *size, "--out", self.folder)
        self.assertEqual(run.returncode, 0, run.stdout)
        self.assertIn("verdicts passed", run.stdout.splitlines()[-1])

    def run_and_draw(self, names):
        long = set().union(*LONG)
        self.assertLessEqual(long, self.all_names(), "a long experiment was renamed")
        short = sorted(self.all_names() - long)
        shares = [some | set(short[i :: len(LONG)]) for i, some in enumerate(LONG)]
        self.assertEqual(set().union(*shares), self.all_names())
        quick = names - set().union(*in_turn(shares, first=0))
        print("at quick sizes:", ", ".join(sorted(quick)) or "none", file=sys.stderr)
        if names - quick:
            self.assert_all_verdicts_pass(names - quick)
        if quick:
            self.assert_all_verdicts_pass(quick, "--quick")
        drawn = self.charts(self.folder)
        self.assertEqual(drawn.returncode, 0, drawn.stderr)
        tables = read_folder(self.folder)
        self.assertEqual(set(tables), names)
        for name, _, _, needs, _ in CHARTS:
            if not names & set(needs):
                continue
            self.assertLessEqual(set(needs), names, f"neither part draws {name}")
            if any(all(row.value is None for row in tables[experiment]) for experiment in needs):
                continue  # a build without VTK has no gallery of mazes
            self.assertGreater((self.folder / f"{name}.png").stat().st_size, 10000, name)
            self.assertNotIn("nan", (self.folder / f"{name}.svg").read_text(encoding="utf-8").lower(), name)

    def test_all_that_compare_costs_pass(self):
        names = compared_costs()
        self.assertIn("tick-cost", names)
        self.assertLessEqual(names, self.all_names(), "an experiment that compares costs has another name than its file")
        self.run_and_draw(names)

    def test_all_others_pass(self):
        self.run_and_draw(self.all_names() - compared_costs())


if __name__ == "__main__":
    TEST = {"costs": "test_all_that_compare_costs_pass", "others": "test_all_others_pass"}[sys.argv.pop(1)]
    unittest.main(defaultTest=f"Verdicts.{TEST}")
