# SPDX-License-Identifier: GPL-3.0-or-later
"""charts.py: its refusals, and that the same numbers give the same pictures."""

import unittest

from charting import arms
from charting.style import pyplot
from lab_runs import LabTest

HEADER = "experiment,case,method,quantity,value,unit,truth,pass_line,verdict,cost_us_p50,cost_us_p99,cost_us_most\n"
FACETS = "".join(
    f"facets,triangles={n},god-object r=0,force error,{291.5 / n},,{291.5 / n},1e-9,pass,0.5,{1 + n * 1e-5},\n"
    for n in (320, 1280, 5120, 20480))

# Of each arm three places of a grid of 20 mm; the fourth corner cannot be used.
PLACES = [(-20, 40, 1.5), (0, 40, 2.0), (-20, 60, 3.0)]
MAPS = "".join(
    f"arms,x_mm={x} y_mm={y},{arm},map: {quality},{value},,,,info,,,\n"
    for arm in arms.ARMS for quality in arms.QUALITIES for x, y, value in PLACES)


class Maps(unittest.TestCase):
    def test_each_place_is_where_it_was_measured_and_the_others_are_empty(self):
        figure, axes = pyplot.subplots()
        norm, colours = arms.QUALITIES["condition"][1:]
        mesh = arms.draw_map(axes, PLACES, norm(1.0, 5.0), colours)
        corners = mesh.get_coordinates()
        values = mesh.get_array().reshape(2, 2)
        found = {}
        for row in range(2):
            for column in range(2):
                middle = 0.5 * (corners[row, column] + corners[row + 1, column + 1])
                if not values.mask[row, column]:
                    found[tuple(middle)] = values[row, column]
        self.assertEqual(found, {(x, y): value for x, y, value in PLACES})
        pyplot.close(figure)


class Charts(LabTest):
    def write(self, text, name="facets.csv"):
        (self.folder / name).write_text(text, encoding="utf-8")

    def test_draws_what_is_there_and_says_what_is_not(self):
        self.write(HEADER + FACETS)
        run = self.charts(self.folder)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertGreater((self.folder / "facets.png").stat().st_size, 5000)
        page = (self.folder / "index.html").read_text(encoding="utf-8")
        self.assertIn("4 of 4 verdicts passed", page)
        self.assertIn("the run measured nothing of speed-accuracy", page)
        self.assertNotIn("http", page)  # works from a disk without a network

    def test_maps_are_drawn_and_not_listed(self):
        self.write(HEADER + MAPS + "arms,half plane,serial,usable,1100,cm2,1100,11,pass,,,\n", "arms.csv")
        run = self.charts(self.folder)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertGreater((self.folder / "arms.png").stat().st_size, 5000)
        page = (self.folder / "index.html").read_text(encoding="utf-8")
        self.assertIn("25 rows, 24 of them drawn as maps alone", page)
        self.assertNotIn("map: condition", page)

    def test_the_same_numbers_give_the_same_picture(self):
        self.write(HEADER + FACETS)
        pictures = []
        for out in ("a", "b"):
            self.assertEqual(self.charts(self.folder, "--out", self.folder / out).returncode, 0)
            pictures.append((self.folder / out / "facets.svg").read_bytes())
        self.assertEqual(*pictures)

    def test_what_failed_stands_first(self):
        self.write(HEADER + FACETS + "facets,triangles=1,point,force error,2,,0,1,fail,,,\n")
        self.assertEqual(self.charts(self.folder).returncode, 0)
        page = (self.folder / "index.html").read_text(encoding="utf-8")
        self.assertLess(page.index("What failed"), page.index("How fine a sphere"))

    def test_absent_libraries_are_named(self):
        self.write(HEADER + FACETS + "queries,triangles=1 query=far,embree,disagreements,,,,,absent,,,\n")
        self.assertEqual(self.charts(self.folder).returncode, 0)
        page = (self.folder / "index.html").read_text(encoding="utf-8")
        self.assertIn("queries: embree", page)
        self.assertIn("the run measured nothing of queries", page)

    def test_a_file_of_another_version_is_named(self):
        self.write("experiment,case,value\nfacets,1,2\n")
        self.assert_refused(self.charts(self.folder), "facets.csv", "not of this version")

    def test_damaged_numbers_are_named_with_their_line(self):
        for text in ("x1", "nan", "inf"):
            with self.subTest(text=text):
                self.write(HEADER + FACETS + f"facets,triangles=1,point,force error,{text},,0,1,fail,,,\n")
                self.assert_refused(self.charts(self.folder), "facets.csv, line 6", "value")

    def test_a_case_that_a_chart_cannot_read_is_named(self):
        self.write(HEADER + FACETS + "facets,N=320,point,force error,1,,0,1,fail,,,\n")
        self.assert_refused(self.charts(self.folder), "facets.csv", "triangles")
        self.write("\0" * 10)
        self.assert_refused(self.charts(self.folder), "facets.csv", "not of this version")

    def test_a_cut_line_and_a_foreign_verdict_are_named(self):
        self.write(HEADER + FACETS + "facets,triangles=1\n")
        self.assert_refused(self.charts(self.folder), "line 6", "2 fields")
        self.write(HEADER + "facets,triangles=1,point,force error,1,,0,1,maybe,,,\n")
        self.assert_refused(self.charts(self.folder), "line 2", "maybe")

    def test_no_folder_an_empty_one_and_no_place_to_write(self):
        self.assert_refused(self.charts(self.folder / "none"), "none is not a folder")
        self.assert_refused(self.charts(self.folder), "holds no CSV")
        self.write(HEADER + FACETS)
        self.write("", "blocked")
        self.assert_refused(self.charts(self.folder, "--out", self.folder / "blocked" / "below"), "blocked", "cannot be written")


if __name__ == "__main__":
    unittest.main()
