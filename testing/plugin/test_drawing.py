# SPDX-License-Identifier: GPL-3.0-or-later
"""A line that is drawn and dragged in a view while a hand presses on it, in ParaView, in virtual time."""

import sys
import unittest

from paraview import simple

from haptic_proxies import put
from view_fixture import DEPTH, FORCE, SCALE, STIFFNESS, ViewTest

RADIUS = 0.25  # u
POINT = 1e-3 * RADIUS  # where there are curves a point is a ball of a thousandth of the thinnest
LARGEST_STEP = 0.1  # N in a tick: nobody feels a jump
FRAME = 33  # ticks between two pictures of a widget that is dragged
ACROSS = 0.1  # of the hand along the line [u]


class Drawing(ViewTest):
    def draw(self, *points):
        self.line = simple.PolyLineSource(Points=[c for point in points for c in point])
        put(self.proxy, "LineRadius", RADIUS)
        self.show(self.line)
        self.follow()

    def drag(self, *points):
        """What a widget does: the source's points; then a picture's time, in which no tick changes the force by a jump."""
        self.line.Points = [c for point in points for c in point]
        simple.Render(self.view)
        self.assertTrue(self.scene.Update())
        self.session.FinishScene()
        for _ in range(FRAME):
            before = self.session.GetForce()
            self.session.Step(1)
            after = self.session.GetForce()
            self.assertLessEqual(sum((a - b) ** 2 for a, b in zip(after, before)) ** 0.5, LARGEST_STEP)

    def expect_tube_around(self, x, slope):
        """The tube around the line x + slope y pushes the hand with the stiffness times its depth, along its normal."""
        length = (1.0 + slope * slope) ** 0.5
        hand = RADIUS - DEPTH
        depth = RADIUS + POINT - (hand - x - slope * ACROSS) / length
        force = STIFFNESS * depth / SCALE
        self.assertAlmostEqual(self.session.GetForce()[0], force / length, delta=1e-9)
        self.assertAlmostEqual(self.session.GetForce()[1], -force * slope / length, delta=1e-9)

    def test_an_end_that_is_dragged_is_felt_with_the_next_picture_and_without_a_jump(self):
        self.draw([0, -1, 0], [0, 1, 0])
        self.press(RADIUS - DEPTH, ACROSS, 0.0)
        self.expect_tube_around(0.0, 0.0)
        for i in range(1, 11):
            self.drag([0, -1, 0], [-0.0012 * i, 1, 0])
        self.session.Step(200)
        self.expect_tube_around(-0.006, -0.006)

    def test_points_that_are_added_while_drawing_goes_on_are_felt_and_make_no_jump(self):
        drawn = [[0, -1, 0], [0, 1, 0]]
        self.draw(*drawn)
        self.press(RADIUS - DEPTH, ACROSS, 0.0)
        for i in range(1, 11):
            drawn.append([-0.05 * i, 1 + 0.1 * i, 0])
            self.drag(*drawn)
        self.expect_tube_around(0.0, 0.0)
        self.assertIn("kept 11 of 11", self.session.GetSceneReport())

    def test_a_line_that_is_moved_from_under_the_hand_lets_go_without_a_jump(self):
        self.draw([0, -1, 0], [0, 1, 0])
        self.press(RADIUS - DEPTH, ACROSS, 0.0)
        self.assertAlmostEqual(self.session.GetForce()[0], FORCE + STIFFNESS * POINT / SCALE, delta=1e-9)
        for i in range(1, 21):
            self.drag([-0.002 * i, -1, 0], [-0.002 * i, 1, 0])
        self.session.Step(200)
        self.assertEqual(self.session.GetContacts(), 0)
        self.assertAlmostEqual(self.session.GetForceMagnitude(), 0.0, delta=1e-9)


if __name__ == "__main__":
    # A SystemExit would skip pvpython's own ending, which closes views before the display.
    if not unittest.main(exit=False).result.wasSuccessful():
        sys.exit(1)
