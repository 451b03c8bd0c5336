# SPDX-License-Identifier: GPL-3.0-or-later
"""palpate.testing tells surfaces apart that a hand tells apart, says where, and refuses surfaces that cannot be compared."""

import json
import os
import random
import re
import tempfile
import unittest
from pathlib import Path

import numpy as np
from plates import HEIGHTS_MM, PRESSED, WAY, force_N, plate
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkMultiBlockDataSet, vtkPolyData, vtkTable
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkSphereSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

import palpate
from palpate.testing import UPDATE, Refused, assert_feels_the_same
from palpate.testing.compare import compare, jnd
from palpate.testing.feel import Touch
from palpate.testing.paths import read_path, strokes

JND_N = 0.07  # of a force of up to 1 N
WRITTEN = 1e-12 / JND_N  # forces of up to 1 N have twelve digits
SEED = int(os.environ.get("PALPATE_TEST_SEED", "20261123"))


def ball(radius_mm):
    source = vtkSphereSource()
    source.SetRadius(radius_mm)
    source.SetThetaResolution(60)
    source.SetPhiResolution(60)
    return source


class Case(unittest.TestCase):
    """A folder with the baseline of a plate at height 0."""

    def setUp(self):
        os.environ.pop(UPDATE, None)
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.file = self.folder / "plate.json"
        self.write(plate(), path=WAY)

    def write(self, surface, **given):
        return assert_feels_the_same(surface, self.file, unit="mm", update=True, **given)

    def difference(self, surface, **given):
        """The report on a surface that does not feel as it did."""
        with self.assertRaises(AssertionError) as raised:
            assert_feels_the_same(surface, self.file, unit="mm", **given)
        self.assertNotIsInstance(raised.exception, Refused)
        return str(raised.exception)

    def refusal(self, surface=None, baseline=None, unit="mm", **given):
        """One sentence."""
        with self.assertRaises(Refused) as raised:
            assert_feels_the_same(surface or plate(), baseline or self.file, unit=unit, **given)
        text = str(raised.exception)
        self.assertEqual(len(text.splitlines()), 1, text)
        return text


class Differences(Case):
    def test_a_surface_that_stays_differs_by_nothing(self):
        self.assertLess(assert_feels_the_same(plate(), self.file, unit="mm").jnd.max(), WRITTEN)

    def test_half_a_millimetre_is_told_with_the_place_the_forces_and_how_to_accept_it(self):
        text = self.difference(plate(0.5), differences=self.folder / "where.vtp")
        expected = (force_N(0.5) - force_N(0.0)) / JND_N
        self.assertIn(f"at most by {expected:.3g}", text)
        worst = next(line.split() for line in text.splitlines() if line.split()[0] == f"{PRESSED[0]}-{PRESSED[-1]}")
        self.assertEqual(worst[2:], ["(3,", "4,", "-2)", f"{force_N(0):.4g}", f"{force_N(0.5):.4g}", "0.0", f"{expected:.3g}"])
        self.assertIn(f"{UPDATE}=1", text)
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(self.folder / "where.vtp"))
        reader.Update()
        for row, height in enumerate(HEIGHTS_MM):
            data = reader.GetOutput().GetPointData()
            self.assertAlmostEqual(data.GetArray("JND").GetValue(row), expected if row in PRESSED else 0.0, delta=1e-9)
            self.assertEqual(reader.GetOutput().GetPoint(row)[2], height)
            self.assertAlmostEqual(data.GetArray("Now").GetTuple(row)[2], force_N(0.5) if row in PRESSED else 0.0, delta=1e-9)

    def test_what_no_hand_tells_apart_passes_up_to_the_tolerance(self):
        unnoticed_mm = 0.9 * JND_N / 500.0 * 1000.0
        found = assert_feels_the_same(plate(unnoticed_mm), self.file, unit="mm")
        self.assertAlmostEqual(found.jnd.max(), 0.9, delta=1e-6)  # the source makes single precision
        self.difference(plate(unnoticed_mm), tolerance=0.8)
        assert_feels_the_same(plate(0.5), self.file, unit="mm", tolerance=(force_N(0.5) - force_N(0.0)) / JND_N + 0.01)

    def test_a_difference_is_seven_percent_or_eighteen_degrees_and_of_faint_forces_so_much_as_of_one_newton(self):
        turned = [np.cos(np.radians(18)), np.sin(np.radians(18)), 0.0]
        before = np.array([[2, 0, 0], [2, 0, 0], [2, 0, 0], [0.1, 0, 0], [0, 0, 0], [0.5, 0, 0]], dtype=float)
        now = np.array([[2.14, 0, 0], [1.86, 0, 0], np.multiply(2, turned), [0.17, 0, 0], [0, 0, 0.07], np.multiply(0.5, turned)])
        np.testing.assert_allclose(jnd(before, now), [1, 1, 1, 1, 1, 0.5], atol=1e-12)

    def test_a_force_that_is_no_number_differs_whatever_is_tolerated(self):
        force = np.zeros((3, 3))
        found = compare(np.zeros((3, 4)), force, np.vstack([force[:2], [[np.nan, 0, 0]]]), tolerance=9.0)
        self.assertTrue(found.differs)
        self.assertEqual(found.stretches(), [(2, 2)])

    def test_a_new_baseline_keeps_the_way_of_the_old_one(self):
        found = self.write(plate(0.5))
        np.testing.assert_array_equal(found.path[:, 1:], WAY)
        self.assertLess(assert_feels_the_same(plate(0.5), self.file, unit="mm").jnd.max(), WRITTEN)


class Updates(Case):
    def test_a_baseline_of_a_surface_that_shrank_away_from_the_old_way_still_tells_differences(self):
        file = self.folder / "ball.json"
        for radius_mm in (50, 44):  # strokes are 2 mm deep
            assert_feels_the_same(ball(radius_mm), file, unit="mm", update=True)
        assert_feels_the_same(ball(44), file, unit="mm")
        with self.assertRaisesRegex(AssertionError, "does not feel as it did"):
            assert_feels_the_same(ball(43), file, unit="mm")

    def test_a_way_that_touches_nothing_makes_no_baseline(self):
        held = self.file.read_bytes()
        self.assertIn("touches nothing", self.refusal(path=[[0, 0, 9], [0, 0, 8]], update=True))
        self.assertEqual(self.file.read_bytes(), held)

    def test_what_is_no_baseline_is_not_overwritten(self):
        for text in ("", "<VTKFile>", '{"other": 1}'):
            file = self.folder / "data.vtp"
            file.write_text(text, encoding="utf-8")
            self.assertIn("data.vtp: not a baseline", self.refusal(baseline=file, update=True))
            self.assertEqual(file.read_text(encoding="utf-8"), text)


class Ways(Case):
    @staticmethod
    def line(points, ids):
        """Poly data with the points and a line through those of the numbers."""
        way, places, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
        places.SetDataTypeToDouble()
        for point in points:
            places.InsertNextPoint(point)
        cells.InsertNextCell(len(ids), ids)
        way.SetPoints(places)
        way.SetLines(cells)
        return way

    def test_a_line_is_followed_from_point_to_point_and_by_its_time(self):
        way = self.line(WAY[::-1], range(len(WAY))[::-1])
        np.testing.assert_array_equal(read_path(way)[:, 1:], WAY)
        times = vtkDoubleArray()
        times.SetName("t")
        for row in range(len(WAY)):
            times.InsertNextValue(0.5 * (len(WAY) - row))
        way.GetPointData().AddArray(times)
        np.testing.assert_array_equal(read_path(way), [[0.5 * (row + 1), *place] for row, place in enumerate(WAY)])

    def test_a_line_through_some_of_the_points_leaves_the_others_out(self):
        np.testing.assert_array_equal(read_path(self.line(WAY, [4, 2]))[:, 1:], [WAY[4], WAY[2]])

    def test_two_lines_and_points_that_are_not_there_are_refused(self):
        two = self.line(WAY, [0, 1])
        two.GetLines().InsertNextCell(2, [2, 3])
        self.assertIn("2 lines", self.refusal(path=two))
        for ids in ([0, len(WAY)], [-1, 0]):
            self.assertIn("not there", self.refusal(path=self.line(WAY, ids)))

    def test_a_way_that_differs_by_rounding_near_zero_is_the_same(self):
        file = self.folder / "near.json"
        way = [[0.0, 0.0, height] for height in HEIGHTS_MM]
        assert_feels_the_same(plate(), file, unit="mm", path=way, update=True)
        assert_feels_the_same(plate(), file, unit="mm", path=np.add(way, [1e-15, -1e-15, 0.0]))
        self.assertIn("path of the baseline differs", self.refusal(baseline=file, path=np.add(way, [1e-3, 0.0, 0.0])))


class Strokes(Case):
    def test_without_a_path_all_six_sides_of_a_box_are_pressed_two_millimetres_deep(self):
        box = vtkCubeSource()
        box.SetXLength(100)
        box.SetYLength(60)
        box.SetZLength(80)
        box.Update()
        touch = Touch("mm", {})
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, box.GetOutput())
        for surface in (box.GetOutput(), blocks):
            way = strokes(surface, touch)
            force, _ = touch.along(way, surface)
            inside = (np.abs(way[:, 1:]) < [50, 30, 40]).all(axis=1)
            np.testing.assert_allclose(np.linalg.norm(force, axis=1), np.where(inside, 500.0 * 2e-3, 0.0), atol=1e-6)
            sides = {tuple(np.round(row).astype(int)) for row in force[inside]}
            self.assertEqual(sides, {tuple(sign * row) for row in np.eye(3, dtype=int) for sign in (1, -1)})


class Refusals(Case):
    def edit(self, **changes):
        held = json.loads(self.file.read_text(encoding="utf-8"))
        self.file.write_text(json.dumps({**held, **changes}), encoding="utf-8")

    def test_a_baseline_of_another_scene(self):
        self.assertIn("'plate', not of 'skull'", self.refusal(scene="skull"))

    def test_a_baseline_in_another_unit(self):
        self.assertIn("in mm, the test in m;", self.refusal(unit="m"))
        self.assertIn("'inch' is unknown", self.refusal(unit="inch"))

    def test_a_surface_that_came_in_another_unit(self):
        small = vtkCubeSource()
        small.SetXLength(0.1)
        self.assertIn("times as large", self.refusal(small))

    def test_a_baseline_of_another_version_but_not_of_another_patch(self):
        major, minor, patch = palpate.__version__.split(".")
        self.edit(version=f"{major}.{minor}.{int(patch) + 7}")
        assert_feels_the_same(plate(), self.file, unit="mm")
        self.edit(version=f"{major}.{int(minor) + 1}.0")
        self.assertIn(f"Palpate {major}.{int(minor) + 1}.0", self.refusal())
        self.edit(**{"palpate baseline": 2})
        self.assertIn("format 2", self.refusal())

    def test_other_settings_and_another_way(self):
        self.assertIn("Stiffness 500.0 then, 300.0 now", self.refusal(Stiffness=300.0))
        self.assertIn("path of the baseline differs", self.refusal(path=[[0, 0, 9], [0, 0, 8]]))

    def test_settings_that_are_none_and_values_that_they_do_not_take(self):
        self.assertIn("is Stiffness meant?", self.refusal(Stifness=300))
        self.assertIn("Radius='wide'", self.refusal(Radius="wide"))

    def test_a_setting_may_be_a_number_of_numpy(self):
        self.write(plate(), path=WAY, Radius=np.int64(1))
        assert_feels_the_same(plate(), self.file, unit="mm", Radius=1)

    def test_a_tolerance_that_no_difference_exceeds(self):
        for tolerance in (float("nan"), float("inf"), -1.0):
            self.assertIn(f"tolerance {tolerance}", self.refusal(plate(0.5), tolerance=tolerance))

    def test_a_baseline_that_is_not_there_a_path_that_is_none_and_nothing_to_touch(self):
        self.assertIn(f"{UPDATE}=1", self.refusal(baseline=self.folder / "none.json"))
        self.assertIn("none.csv", self.refusal(path=self.folder / "none.csv"))
        for path in ([[1, 2]], [], [[0, 0, float("nan")]], [[1, 0, 0, 0], [1, 0, 0, 0]], "way", vtkPolyData()):
            self.refusal(path=path)
        self.assertIn("is empty", self.refusal(vtkPolyData()))
        self.assertIn("cannot be touched", self.refusal(vtkTable()))

    def test_a_baseline_that_cannot_be_written_leaves_the_old_one(self):
        held = self.file.read_bytes()
        (self.folder / "plate.json.part").mkdir()
        with self.assertRaises(Refused):
            self.write(plate(0.5))
        self.assertEqual(self.file.read_bytes(), held)

    def test_numbers_and_depths_that_are_beyond_the_machine(self):
        huge, held = "9" * 400, self.file.read_text(encoding="utf-8")
        for text in (re.sub(r'"size": [^,]*', f'"size": {huge}', held), held.replace(" 5.0,", f" {huge},"), "[" * 200_000):
            self.assertNotEqual(text, held)
            self.file.write_text(text, encoding="utf-8")
            self.assertIn("write the baseline again", self.refusal())

    def test_damaged_files_are_refused_or_say_the_same_never_anything_else(self):
        rng, whole = random.Random(SEED), self.file.read_bytes()
        for _ in range(int(os.environ.get("PALPATE_TEST_COUNT", "300"))):
            damaged = bytearray(whole)
            if rng.random() < 0.3:
                del damaged[rng.randrange(len(damaged)):]
            for _ in range(rng.randrange(1, 4)):
                if damaged:
                    damaged[rng.randrange(len(damaged))] = rng.choice(b'0123456789-.eE[]{},:"nulNaI\x00\xff')
            self.file.write_bytes(damaged)
            try:
                assert_feels_the_same(plate(), self.file, unit="mm")
            except AssertionError:
                pass


if __name__ == "__main__":
    unittest.main(verbosity=2)
