# SPDX-License-Identifier: GPL-3.0-or-later
"""palpate.testing makes no baseline that anything passes, and sees parts that come or go where the hand is not led."""

import json
import math
import os
import tempfile
import unittest
from pathlib import Path

import numpy as np
from plates import HEIGHTS_MM, WAY, plate
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkSphereSource
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource

from palpate.testing import UPDATE, Refused, assert_feels_the_same

PLATE_MM2 = 100.0 * 100.0
REACH_MM = 5.0
PRESS_MM = HEIGHTS_MM[3]


def cube(side_mm, centre):
    """Six faces whose corners are not shared, as of a file that has a normal at each."""
    source = vtkCubeSource()
    for axis in "XYZ":
        getattr(source, f"Set{axis}Length")(side_mm)
    source.SetCenter(*centre)
    return source


def together(*sources):
    append = vtkAppendPolyData()
    for source in sources:
        append.AddInputConnection(source.GetOutputPort())
    return append


def volume(half):
    source = vtkRTAnalyticSource()
    source.SetWholeExtent(-half, half, -half, half, -half, half)
    return source


class Case(unittest.TestCase):
    def setUp(self):
        os.environ.pop(UPDATE, None)
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.file = Path(folder.name) / "it.json"

    def write(self, surface, **given):
        return assert_feels_the_same(surface, self.file, unit="mm", update=True, **given)

    def check(self, surface, **given):
        return assert_feels_the_same(surface, self.file, unit="mm", **given)

    def difference(self, surface, **given):
        with self.assertRaises(AssertionError) as raised:
            self.check(surface, **given)
        self.assertNotIsInstance(raised.exception, Refused)
        return str(raised.exception)


class Nothing(Case):
    def refused(self, surface, **given):
        with self.assertRaises(Refused) as raised:
            self.write(surface, **given)
        self.assertFalse(self.file.exists())
        return str(raised.exception)

    def test_a_volume_that_is_so_small_that_no_hand_feels_it_makes_no_baseline(self):
        # Strokes are 2 % of the diagonal deep: 500 N/m times 0.02 sqrt(3) 2 mm and less are fainter than 0.07 N.
        said = self.refused(volume(2))
        for word in ("0.069 N", "from zero", "FieldArray", "Stiffness"):
            self.assertIn(word, said)

    def test_a_field_that_acts_elsewhere_than_the_strokes_makes_no_baseline(self):
        said = self.refused(volume(20), FieldArray="RTData", FieldIsosurface=True, FieldIsovalue=270.0)
        self.assertIn("through places where the field acts", said)
        self.assertIn("touches nothing", said)

    def test_a_baseline_of_zeros_passes_nobody(self):
        self.write(plate(), path=WAY)
        held = json.loads(self.file.read_text(encoding="utf-8"))
        for most_N in (0.0, 0.06):
            held["rows"] = [[*row[:4], 0.0, 0.0, min(row[6], most_N)] for row in held["rows"]]
            self.file.write_text(json.dumps(held), encoding="utf-8")
            with self.assertRaisesRegex(Refused, "felt nothing .* write the baseline again"):
                self.check(plate(-30.0))

    def test_what_a_smaller_tolerance_tells_from_nothing_is_something(self):
        depth_mm = 0.06 / 500.0 * 1000.0
        way = [[3.0, 4.0, height] for height in (1.0, -depth_mm, 1.0)]
        self.assertIn("0.06 N", self.refused(plate(), path=way))
        self.write(plate(), path=way, tolerance=0.5)
        self.check(plate(), tolerance=0.5)
        with self.assertRaises(AssertionError):
            self.check(plate(-1.0), tolerance=0.5)


class Elsewhere(Case):
    """A plate that is pressed at (3, 4), and bodies that the hand never comes to."""

    def test_a_second_body_that_comes_or_goes_is_said_with_its_area_and_place(self):
        far, small = (-40.0, -40.0, 10.0), (30.0, -30.0, 5.0)
        both = together(plate(), cube(4.0, far), cube(1.0, small))
        self.write(both, path=WAY)
        self.check(both)
        said = self.difference(together(plate(), cube(4.0, far)))  # "largest=False": a speck less
        self.assertIn("feels the same along the path of the hand, but", said)
        self.assertIn("2 separate pieces, and had 3", said)
        self.assertIn("gone, and never touched: a piece of area 6 around (30, -30, 5)", said)
        self.assertNotIn("area 96", said)
        self.write(together(plate(), cube(4.0, far)), path=WAY)
        said = self.difference(both)
        self.assertIn("new, and not touched: a piece of area 6 around (30, -30, 5)", said)
        self.assertIn(f"{UPDATE}=1", said)

    def test_a_body_that_moves_grows_or_is_another_is_seen_and_one_that_hardly_does_is_not(self):
        self.write(together(plate(), cube(4.0, (-40, -40, 10))), path=WAY)
        for place, side in (((-40, -40, 16), 4.0), ((-40, -40, 10), 4.5), ((40, 40, 10), 4.0)):
            with self.subTest(place=place, side=side):
                said = self.difference(together(plate(), cube(side, place)))
                self.assertIn("gone", said)
                self.assertIn("new", said)
                self.assertNotIn("separate pieces, and had", said)
        for place, side in (((-40, -40, 11), 4.0), ((-40, -40, 10), 4.1)):
            self.check(together(plate(), cube(side, place)))

    def test_a_baseline_of_before_there_were_pieces_is_read_and_compares_none(self):
        self.write(plate(), path=WAY)
        held = json.loads(self.file.read_text(encoding="utf-8"))
        del held["surface"]
        self.file.write_text(json.dumps(held), encoding="utf-8")
        self.check(together(plate(), cube(4.0, (-40, -40, 10))))

    def test_a_surface_that_grows_where_the_way_does_not_lead_is_seen_without_another_piece(self):
        self.write(plate(), path=WAY)
        wide = plate()
        wide.SetPoint1(70, -50, 0)
        self.assertIn("area is 1.2e+04, and was 1e+04", self.difference(wide))

    def test_the_share_of_the_surface_that_a_way_covers_is_that_of_a_disc(self):
        found = self.write(plate(), path=WAY)
        disc = math.pi * REACH_MM**2 / PLATE_MM2  # the proxy stands in one place of the plate
        self.assertAlmostEqual(found.coverage.share, disc, delta=0.1 * disc)
        self.assertEqual([piece.touched for piece in found.coverage.pieces], [True])
        self.assertAlmostEqual(found.coverage.area, PLATE_MM2, delta=1e-6 * PLATE_MM2)
        self.assertRegex(found.coverage.text(), r"covers 0\.[78]\d? % of the surface and touches its one piece")
        wider = self.write(plate(), path=WAY, Radius=3.0)
        wide = math.pi * ((REACH_MM + 3.0)**2 - 3.0**2) / PLATE_MM2  # of the ball's centre, 3 mm above the plate
        self.assertAlmostEqual(wider.coverage.share, wide, delta=0.1 * wide)

    def test_a_way_over_half_of_a_plate_covers_half_of_it(self):
        lines = [[-49.0, -50.0, 5.0]] + [[x, y, PRESS_MM] for x in np.arange(-49.0, 0.0, 4.0) for y in np.linspace(-50, 50, 80)]
        found = self.write(plate(), path=lines)
        self.assertAlmostEqual(found.coverage.share, (50.0 - 1.0 + 5.0) / 100.0, delta=0.03)

    def test_strokes_over_one_of_two_balls_do_not_reach_the_other(self):
        def ball(radius_mm, place):
            source = vtkSphereSource()
            source.SetRadius(radius_mm)
            source.SetCenter(*place)
            source.SetThetaResolution(40)
            source.SetPhiResolution(40)
            return source

        near, far = ball(20.0, (0, 0, 0)), ball(2.0, (21.0, 21.0, 21.0))
        found = self.write(together(near, far))
        self.assertEqual([piece.touched for piece in found.coverage.pieces], [True, False])
        self.assertIn("touches 1 of its 2 pieces", found.coverage.text())
        self.assertLess(found.coverage.share, 0.9)
        self.assertGreater(found.coverage.share, 0.05)
        self.assertIn("gone, and never touched", self.difference(near))

    def test_of_a_field_no_surface_is_compared(self):
        way = [[0.0, 0.0, height] for height in np.linspace(24.0, 4.0, 60)]
        found = self.write(volume(20), path=way, FieldArray="RTData", FieldDrag=0.5)
        self.assertIsNone(found.coverage)
        self.check(volume(20), FieldArray="RTData", FieldDrag=0.5)


if __name__ == "__main__":
    unittest.main(verbosity=2)
