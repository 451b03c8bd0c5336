# SPDX-License-Identifier: GPL-3.0-or-later
"""Large data are read by threads before a session gets them; small ones, and all where nobody asks for it, are there at once."""

import math
import sys
import time
import unittest

from paraview import simple

from haptic_proxies import put
from view_fixture import DEPTH, FORCE, ViewTest

AROUND, ALONG = 340, 160  # facets of a ball: more than are read at once
RADIUS = 0.5  # u
SAG = RADIUS * ((math.pi / AROUND) ** 2 + (math.pi / ALONG) ** 2)  # twice the depth of a facet's middle inside of the ball


class LargeData(ViewTest):
    def ball(self):
        return simple.Sphere(Radius=RADIUS, ThetaResolution=AROUND, PhiResolution=ALONG)

    def wait(self):
        """Looks until the scene is handed over."""
        for _ in range(2000):
            if self.follow():
                return True
            time.sleep(0.005)
        return False

    def test_they_are_read_at_once_unless_it_is_asked_for(self):
        self.show(self.ball())
        self.assertTrue(self.follow())

    def test_small_data_are_there_at_once(self):
        self.scene.SetReadsAhead(True)
        self.show(simple.Sphere())
        self.assertTrue(self.follow())

    def test_they_are_said_to_be_read_and_are_felt_then(self):
        self.scene.SetReadsAhead(True)
        self.show(self.ball())
        self.assertFalse(self.follow())
        self.assertIn("Reading Sphere1.", self.scene.GetReport())
        self.assertEqual(self.session.GetSceneProgress(), 0.0)
        self.assertTrue(self.wait())
        self.assertEqual(self.session.GetSceneProgress(), 1.0)
        self.assertIn("Touching Sphere1.", self.scene.GetReport())
        self.assertFalse(self.follow())
        self.press(RADIUS - DEPTH, 0.0, 0.0)
        self.assertAlmostEqual(self.session.GetForceMagnitude(), FORCE, delta=FORCE * SAG / DEPTH)

    def test_so_are_lines_as_tubes_and_points_as_balls(self):
        self.scene.SetReadsAhead(True)
        radius, many = 0.05, 100000
        put(self.proxy, "LineRadius", radius)
        put(self.proxy, "PointRadius", 4 * radius)
        line = simple.Line(Point1=[0, -1, 0], Point2=[0, 1, 0], Resolution=many)
        self.show(line)
        self.assertFalse(self.follow())
        self.assertIn("Reading Line1.", self.scene.GetReport())
        self.assertTrue(self.wait())
        self.press(radius - DEPTH, 0.3, 0.0)
        self.assertAlmostEqual(self.session.GetForceMagnitude(), FORCE, delta=0.01 * FORCE)  # the point is a small ball
        put(self.proxy, "Touching", 0)
        simple.Hide(line, self.view)
        self.show(simple.PointSource(NumberOfPoints=many, Radius=0.0))
        self.assertFalse(self.follow())
        self.assertIn("Reading PointSource1.", self.scene.GetReport())
        self.assertTrue(self.wait())
        self.press(4 * radius - DEPTH, 0.0, 0.0)
        self.assertAlmostEqual(self.session.GetForceMagnitude(), FORCE, delta=0.05 * FORCE)

    def test_what_is_hidden_while_it_is_read_is_not_handed_over(self):
        self.scene.SetReadsAhead(True)
        ball = self.ball()
        self.show(ball)
        self.assertFalse(self.follow())
        simple.Hide(ball, self.view)
        self.show(simple.Box())
        self.assertTrue(self.follow())
        self.assertEqual(self.session.GetSceneReport().count("\n"), 1)
        self.assertIn("Box1", self.session.GetSceneReport())

    def test_what_is_hidden_again_while_it_is_read_leaves_all_as_it_was(self):
        self.scene.SetReadsAhead(True)
        self.show(simple.Box())
        self.assertTrue(self.follow())
        ball = self.ball()
        self.show(ball)
        self.assertFalse(self.follow())
        self.assertIn("Reading Sphere1.", self.scene.GetReport())
        simple.Hide(ball, self.view)
        self.assertFalse(self.follow())
        self.assertNotIn("Reading", self.scene.GetReport())
        self.assertEqual(self.session.GetSceneProgress(), 1.0)

    def test_two_sources_of_the_same_points_and_cells_are_both_read_ahead(self):
        self.scene.SetReadsAhead(True)
        ball = self.ball()
        self.show(ball)
        self.show(simple.Elevation(Input=ball))
        self.assertTrue(self.wait())
        self.assertEqual(self.session.GetSceneReport().count("\n"), 2)

    def test_what_was_given_up_stays_away_until_it_is_asked_for_again(self):
        self.scene.SetReadsAhead(True)
        self.show(simple.Box())
        self.assertTrue(self.follow())
        self.show(self.ball())
        self.assertFalse(self.follow())
        self.session.CancelScene()
        for _ in range(20):
            self.assertFalse(self.follow())
            time.sleep(0.02)
        self.assertNotIn("Sphere1", self.session.GetSceneReport())
        self.scene.TakeAgain()
        self.assertTrue(self.wait())
        self.assertIn("Sphere1", self.session.GetSceneReport())
        self.assertIn("Box1", self.session.GetSceneReport())


if __name__ == "__main__":
    # A SystemExit would skip pvpython's own ending, which closes views before the display.
    if not unittest.main(exit=False).result.wasSuccessful():
        sys.exit(1)
