# SPDX-License-Identifier: GPL-3.0-or-later
"""palpate-lab as a program: its list, its refusals, and that a rerun gives the same values."""

import json
import unittest

from lab_runs import LabTest, rows

CHEAP = ("energy-leak", "bounce", "velocity-estimators", "thin-plate")
COSTS = ("cost_us_p50", "cost_us_p99", "cost_us_most")


class Program(LabTest):
    def names(self):
        return [experiment["name"] for experiment in json.loads(self.lab("list", "--json").stdout)]

    def test_the_list_names_each_experiment_once_with_what_it_shows_and_its_rows(self):
        listed = json.loads(self.lab("list", "--json").stdout)
        self.assertEqual(len({experiment["name"] for experiment in listed}), len(listed))
        for experiment in listed:
            self.assertGreater(len(experiment["shows"].split()), 4, experiment)
            self.assertTrue(all(1 <= row <= 90 for row in experiment["rows"]), experiment)
        plain = self.lab("list").stdout.splitlines()
        self.assertEqual([line.split()[0] for line in plain], [experiment["name"] for experiment in listed])

    def test_a_rerun_gives_the_same_values_cost_columns_aside(self):
        for run in ("first", "second"):
            done = self.lab("run", *CHEAP, "--quick", "--seed", "7", "--out", self.folder / run)
            self.assertEqual(done.returncode, 0, done.stdout)
            passed, judged = done.stdout.splitlines()[-1].split(" verdicts passed")[0].split(" of ")
            self.assertEqual(passed, judged)
        for name in CHEAP:
            first, second = rows(self.folder / "first" / f"{name}.csv"), rows(self.folder / "second" / f"{name}.csv")
            self.assertTrue(first)
            for row in first + second:
                for column in COSTS:
                    del row[column]
            self.assertEqual(first, second)

    def test_another_name_is_answered_with_near_ones(self):
        self.assert_refused(self.lab("run", "bouncy", "--out", self.folder), "bouncy", "bounce")
        self.assert_refused(self.lab("run", "wall", "--out", self.folder), "'wall'", "wall-stability")

    def test_bad_arguments_are_refused(self):
        self.assert_refused(self.lab("run", "bounce"), "--out")
        self.assert_refused(self.lab("run", "--out", self.folder), "NAME")
        self.assert_refused(self.lab("run", "bounce", "--out", self.folder, "--quick", "--soak"), "excludes")
        self.assert_refused(self.lab("run", "bounce", "--out", self.folder, "--seed", "x"), "--seed")
        self.assert_refused(self.lab("plot"), "subcommand")

    def test_a_folder_that_cannot_be_written_costs_no_experiment(self):
        blocked = self.folder / "file"
        blocked.write_text("")
        self.assert_refused(self.lab("run", "bounce", "--quick", "--out", blocked / "below"), blocked)


if __name__ == "__main__":
    unittest.main()
