# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines that a view shows are touched as tubes once they have a radius, and as walls across their plane."""

import sys
import unittest

from paraview import simple

from haptic_proxies import put
from view_fixture import DEPTH, SCALE, STIFFNESS, ViewTest

RADIUS = 0.25  # u
POINT = 1e-3 * RADIUS  # where there are curves a point is a ball of a thousandth of the thinnest


class LinesInAView(ViewTest):
    def test_lines_are_tubes_once_they_have_a_radius(self):
        self.show(simple.Line(Point1=[0.0, -1.0, 0.0], Point2=[0.0, 1.0, 0.0]))
        self.follow()
        self.assertEqual(self.scene.GetNumberOfSurfaces(), 0)
        self.assertIn("Radius of lines", self.scene.GetReport())
        put(self.proxy, "LineRadius", RADIUS)
        self.assertTrue(self.follow())
        self.assertEqual(self.scene.GetNumberOfSurfaces(), 1)
        self.assertIn("(lines): kept", self.session.GetSceneReport())
        self.press(RADIUS - DEPTH, 0.1, 0.0)
        self.assertAlmostEqual(self.session.GetForce()[0], STIFFNESS * (DEPTH + POINT) / SCALE, delta=1e-9)
        self.assertAlmostEqual(self.session.GetForce()[1], 0.0, delta=1e-9)

    def test_a_change_of_the_radius_is_felt_in_the_next_scene(self):
        self.show(simple.Line(Point1=[0.0, -1.0, 0.0], Point2=[0.0, 1.0, 0.0]))
        put(self.proxy, "LineRadius", RADIUS)
        self.assertTrue(self.follow())
        self.assertFalse(self.follow())
        put(self.proxy, "LineRadius", 2 * RADIUS)
        self.assertTrue(self.follow())
        self.press(2 * RADIUS - DEPTH, 0.1, 0.0)
        self.assertAlmostEqual(self.session.GetForce()[0], STIFFNESS * (DEPTH + 2 * POINT) / SCALE, delta=1e-9)

    def test_points_are_balls_once_they_have_a_radius(self):
        self.show(simple.PointSource(Center=[0.0, 0.1, 0.0], Radius=0.0, NumberOfPoints=1))
        self.follow()
        self.assertEqual(self.scene.GetNumberOfSurfaces(), 0)
        put(self.proxy, "PointRadius", RADIUS)
        self.assertTrue(self.follow())
        self.assertEqual(self.scene.GetNumberOfSurfaces(), 1)
        self.assertIn("(points): kept", self.session.GetSceneReport())
        self.press(RADIUS - DEPTH, 0.1, 0.0)
        half = 0.5e-6 * RADIUS  # a ball is a tube along x that is a millionth of its radius long
        self.assertAlmostEqual(self.session.GetForce()[0], STIFFNESS * (DEPTH + POINT + half) / SCALE, delta=1e-9)
        put(self.proxy, "PointRadius", 0.0)
        self.assertTrue(self.follow())
        self.assertEqual(self.scene.GetNumberOfSurfaces(), 0)

    def test_a_source_that_is_switched_off_is_not_touched_until_it_is_on_again(self):
        self.show(simple.Plane(Origin=[0, -1, -1], Point1=[0, 1, -1], Point2=[0, -1, 1]))
        name = next(iter(simple.GetSources()))[0]
        self.follow()
        self.assertIn(name + ": kept", self.session.GetSceneReport())
        self.session.SetSourceTouched(name, False)
        self.assertTrue(self.follow())
        self.assertIn(name + ": the source is switched off", self.session.GetSceneReport())
        self.session.SetSourceTouched(name, True)
        self.assertTrue(self.follow())
        self.press(-DEPTH, 0.1, 0.0)
        self.assertAlmostEqual(self.session.GetForce()[0], STIFFNESS * DEPTH / SCALE, delta=1e-9)

    def test_lines_in_a_plane_are_walls_where_that_is_asked_for(self):
        self.show(simple.Line(Point1=[0.0, -1.0, 0.0], Point2=[0.0, 1.0, 0.0]))
        self.follow()
        self.assertFalse(self.session.GetPlaneWorld())
        put(self.proxy, "LinesAsWalls", 2)
        self.assertTrue(self.follow())
        self.assertTrue(self.session.GetPlaneWorld())
        self.press(-DEPTH, 0.1, 0.0)
        self.assertAlmostEqual(self.session.GetForce()[0], STIFFNESS * DEPTH / SCALE, delta=1e-9)

    def test_on_a_joystick_they_are_walls_by_themselves(self):
        put(self.proxy, "DeviceName", "simulated-joystick")
        self.show(simple.Line(Point1=[0.0, -1.0, 0.0], Point2=[0.0, 1.0, 0.0]))
        self.assertTrue(self.follow())
        self.assertIn("device itself holds", self.session.GetPlanText())


if __name__ == "__main__":
    # A SystemExit would skip pvpython's own ending, which closes views before the display.
    if not unittest.main(exit=False).result.wasSuccessful():
        sys.exit(1)
