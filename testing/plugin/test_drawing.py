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
        self.step_without_a_jump()

    def step_without_a_jump(self):
        for _ in range(FRAME):
            before = self.session.GetForce()
            self.session.Step(1)
            after = self.session.GetForce()
            self.assertLessEqual(sum((a - b) ** 2 for a, b in zip(after, before)) ** 0.5, LARGEST_STEP)

    def drag_widget(self, *points):
        """What a widget does whose source is not applied at once: the unchecked values; then as drag()."""
        drawn = [c for point in points for c in point]
        values = self.line.SMProxy.GetProperty("Points")
        values.SetNumberOfUncheckedElements(len(drawn))
        for index, value in enumerate(drawn):
            values.SetUncheckedElement(index, value)
        self.next_picture()

    def next_picture(self):
        simple.Render(self.view)
        self.follow()
        self.step_without_a_jump()

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

    def test_a_handle_is_felt_while_it_is_dragged_and_the_source_stays_as_it_was_applied(self):
        self.draw([0, -1, 0], [0, 1, 0])
        self.press(RADIUS - DEPTH, ACROSS, 0.0)
        for i in range(1, 11):
            self.drag_widget([0, -1, 0], [-0.0012 * i, 1, 0])
        self.session.Step(200)
        self.expect_tube_around(-0.006, -0.006)
        self.assertEqual(list(self.line.Points), [0, -1, 0, 0, 1, 0])
        self.assertEqual(self.line.GetDataInformation().GetBounds()[:2], (0.0, 0.0))

    def test_apply_keeps_what_was_felt_while_drawing(self):
        self.draw([0, -1, 0], [0, 1, 0])
        self.press(RADIUS - DEPTH, ACROSS, 0.0)
        self.drag_widget([0, -1, 0], [-0.002, 1, 0])
        self.session.Step(200)
        felt = self.session.GetForce()
        self.line.Points = [0, -1, 0, -0.002, 1, 0]
        self.follow()  # applied, and no picture yet
        for _ in range(3):
            self.session.Step(FRAME)
            self.assertEqual(self.session.GetForce(), felt)
            self.next_picture()
        self.assertFalse(self.follow())

    def test_reset_takes_the_force_back_without_a_jump(self):
        self.draw([0, -1, 0], [0, 1, 0])
        self.press(RADIUS - DEPTH, ACROSS, 0.0)
        self.drag_widget([-0.005, -1, 0], [-0.005, 1, 0])
        self.session.Step(200)
        self.expect_tube_around(-0.005, 0.0)
        self.line.SMProxy.GetProperty("Points").ClearUncheckedElements()
        self.next_picture()
        self.session.Step(200)
        self.expect_tube_around(0.0, 0.0)

    def test_a_curve_is_felt_before_it_is_applied_for_the_first_time(self):
        self.line = simple.PolyLineSource(Points=[0, -1, 0, 0, 1, 0])
        put(self.proxy, "LineRadius", RADIUS)
        simple.Render(self.view)
        put(self.scene_proxy, "Drawing", self.line.SMProxy)
        self.follow()
        self.press(RADIUS - DEPTH, ACROSS, 0.0)
        self.expect_tube_around(0.0, 0.0)
        self.drag_widget([-0.005, -1, 0], [-0.005, 1, 0])
        self.session.Step(200)
        self.expect_tube_around(-0.005, 0.0)
        felt = self.session.GetForce()
        self.line.Points = [-0.005, -1, 0, -0.005, 1, 0]
        simple.Show(self.line, self.view)
        self.follow()  # it has a representation, and no picture yet
        self.step_without_a_jump()
        put(self.scene_proxy, "Drawing", None)
        self.next_picture()
        self.assertEqual(self.session.GetForce(), felt)
        put(self.proxy, "Touching", 0)
        simple.Hide(self.line, self.view)
        self.follow()
        self.assertEqual(self.scene.GetNumberOfSurfaces(), 0)

    def test_a_curve_that_is_deleted_while_its_handle_is_held_lets_go(self):
        self.draw([0, -1, 0], [0, 1, 0])
        self.press(RADIUS - DEPTH, ACROSS, 0.0)
        self.drag_widget([0, -1, 0], [-0.002, 1, 0])
        simple.Delete(self.line)
        del self.line
        simple.Render(self.view)
        self.follow()
        self.session.Step(100)
        self.assertEqual(self.session.GetForceMagnitude(), 0.0)
        self.assertEqual(self.scene.GetNumberOfSurfaces(), 0)

    def test_a_spline_is_felt_while_it_is_drawn_too(self):
        self.line = simple.SplineSource(ParametricFunction="Spline")
        spline = self.line.ParametricFunction
        spline.Points = [0, -1, 0, 0, 0, 0, 0, 1, 0]
        put(self.proxy, "LineRadius", RADIUS)
        self.show(self.line)
        self.follow()
        self.press(RADIUS - DEPTH, ACROSS, 0.0)
        self.expect_tube_around(0.0, 0.0)
        values = spline.SMProxy.GetProperty("Points")
        for point in range(3):
            values.SetUncheckedElement(3 * point, -1 / 256)  # its points are floats
        self.next_picture()
        self.session.Step(200)
        self.expect_tube_around(-1 / 256, 0.0)

    def test_what_has_no_curve_to_drag_is_felt_as_it_is_applied(self):
        sphere = simple.Sphere(Radius=1.0)
        self.show(sphere)
        self.assertTrue(self.follow())
        sphere.SMProxy.GetProperty("Radius").SetUncheckedElement(0, 2.0)
        simple.Render(self.view)
        self.assertFalse(self.follow())

    def test_a_curve_whose_points_are_all_deleted_while_it_is_drawn_is_refused_and_comes_back(self):
        self.draw([0, -1, 0], [0, 1, 0])
        self.drag_widget([0, 0, 0])
        self.assertIn("refused: none of its 1 segments", self.session.GetSceneReport())
        self.drag_widget()
        self.assertEqual(self.scene.GetNumberOfSurfaces(), 0)
        self.drag_widget([0, -1, 0], [0, 1, 0])
        self.assertIn("kept 1 of 1", self.session.GetSceneReport())


if __name__ == "__main__":
    # A SystemExit would skip pvpython's own ending, which closes views before the display.
    if not unittest.main(exit=False).result.wasSuccessful():
        sys.exit(1)
