# SPDX-License-Identifier: GPL-3.0-or-later
"""A line that is drawn and dragged in a view while a hand presses on it, in ParaView, in virtual time."""

import sys
import unittest

from paraview import simple

from haptic_proxies import put
from view_fixture import DEPTH, FORCE, SCALE, STIFFNESS, ViewTest
from says import unsaid

RADIUS = 0.25  # u
POINT = 1e-3 * RADIUS  # where there are curves a point is a ball of a thousandth of the thinnest
LARGEST_STEP = 0.1  # N in a tick: nobody feels a jump
FRAME = 33  # ticks between two pictures of a widget that is dragged
ACROSS = 0.1  # of the hand along the line [u]

JOYSTICK_FORCE = 0.6 * 5.0  # N, of the simulated one's 5 N
JOYSTICK_RISE = 50.0 * 5.0  # N/s
JOYSTICK_SCALE = 1000.0  # a unit is a millimetre
TICK = 1e-3  # s


class Drawing(ViewTest):
    def draw(self, *points):
        self.line = simple.PolyLineSource(Points=[c for point in points for c in point])
        put(self.proxy, "LineRadius", RADIUS)
        self.show(self.line)
        self.follow()

    def drag(self, *points):
        """As a widget does: the source's points; then a picture's time, in which no tick changes the force by a jump."""
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
        """As a widget does whose source is not applied at once: the unchecked values; then as drag()."""
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

    def expect_felt_with_the_next_picture(self, *points):
        """As a source whose widget was never touched: not before the picture that shows it."""
        self.line.Points = [c for point in points for c in point]
        self.assertFalse(self.follow())
        simple.Render(self.view)
        self.assertTrue(self.follow())

    def test_what_is_applied_is_felt_as_it_is_shown_once_a_picture_shows_it(self):
        self.draw([0, -1, 0], [0, 1, 0])
        self.expect_felt_with_the_next_picture([0.1, -1, 0], [0.1, 1, 0])
        self.drag_widget([0, -1, 0], [-0.5, 1, 0])
        self.line.Points = [0, -1, 0, -0.5, 1, 0]
        self.next_picture()
        self.expect_felt_with_the_next_picture([0.1, -1, 0], [0.1, 1, 0])

    def test_what_was_reset_is_felt_as_it_is_shown(self):
        self.draw([0, -1, 0], [0, 1, 0])
        self.drag_widget([0, -1, 0], [-0.5, 1, 0])
        self.line.SMProxy.GetProperty("Points").ClearUncheckedElements()
        self.next_picture()
        self.expect_felt_with_the_next_picture([0.1, -1, 0], [0.1, 1, 0])

    def test_an_applied_curve_of_which_nothing_is_shown_is_refused_although_it_was_dragged(self):
        self.draw([0, -1, 0], [0, 1, 0])
        self.drag_widget([0, -1, 0], [-0.5, 1, 0])
        self.line.Points = [0, -1, 0, -0.5, 1, 0]
        self.next_picture()
        self.assertEqual(self.scene.GetNumberOfSurfaces(), 1)
        simple.GetDisplayProperties(self.line, self.view).Representation = "Feature Edges"  # a line has none
        self.next_picture()
        self.assertEqual(self.scene.GetNumberOfSurfaces(), 0)
        self.assertEqual(unsaid(self.scene.GetReport(), "outline", "edges"), [])
        self.drag_widget([0, -1, 0], [-0.6, 1, 0])
        self.assertEqual(self.scene.GetNumberOfSurfaces(), 0)

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

    def test_a_line_source_is_felt_while_its_end_is_dragged_too(self):
        self.line = simple.Line(Point1=[0, -1, 0], Point2=[0, 1, 0])
        put(self.proxy, "LineRadius", RADIUS)
        self.show(self.line)
        self.follow()
        self.press(RADIUS - DEPTH, ACROSS, 0.0)
        for point in ("Point1", "Point2"):
            self.line.SMProxy.GetProperty(point).SetUncheckedElement(0, -1 / 256)  # its points are floats
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


class DrawingWithWallsOnTheDevice(ViewTest):
    """A joystick holds the wall that a line is, and is led through it by a hand, while the line is dragged."""

    def setUp(self):
        super().setUp()
        put(self.proxy, "DeviceName", "simulated-joystick")
        put(self.proxy, "Scale", JOYSTICK_SCALE)
        put(self.proxy, "WallRate", 1 / TICK)
        self.session.SetSetting("Hand", "firm")
        for point in ((0, 5, 0), (20, -20, 0)):
            self.session.AddStrokePoint(*point)
        self.line = simple.PolyLineSource(Points=[-40, 0, 0, 40, 0, 0])
        self.show(self.line)
        self.follow()
        self.height = self.felt = 0.0  # of the line that is shown, and of the one that is felt [u]
        put(self.proxy, "Touching", 1)
        self.session.Step(1500)
        while self.session.GetForce()[1] < 0.4:
            self.session.Step(1)

    def drag_to(self, height):
        values = self.line.SMProxy.GetProperty("Points")
        values.SetUncheckedElement(1, height)
        values.SetUncheckedElement(4, height)
        simple.Render(self.view)
        self.follow()
        self.height = height

    def step(self, ticks):
        """Up with the line, always over the hand, and pushed no harder or sooner than is allowed. Largest rise."""
        largest = 0.0
        for _ in range(ticks):
            force, hand = self.session.GetForce()[1], self.session.GetHandPosition()[1]
            self.session.Step(1)
            proxy, now = self.session.GetProxyPosition()[1], self.session.GetHandPosition()[1]
            rise = self.session.GetForce()[1] - force
            self.assertGreaterEqual(self.session.GetWallsHeld(), 1)
            self.assertGreaterEqual(proxy, self.felt - 1e-9)
            self.assertLessEqual(proxy, self.height + 1e-9)
            self.assertGreater(proxy, now)
            self.felt = proxy
            self.assertLessEqual(self.session.GetForceMagnitude(), JOYSTICK_FORCE + 1e-9)
            by_hand = self.session.GetStiffnessUsed() * max(0.0, hand - now) / JOYSTICK_SCALE
            self.assertLessEqual(rise, JOYSTICK_RISE * TICK + by_hand + 1e-9)
            largest = max(largest, rise - by_hand)
        return largest

    def test_the_wall_that_the_device_holds_goes_with_the_handle_that_is_dragged(self):
        for i in range(1, 11):
            self.drag_to(0.2 * i)
            self.step(FRAME)
        self.step(50)
        self.assertAlmostEqual(self.session.GetProxyPosition()[1], 2.0, delta=1e-9)

    def test_a_hasty_drag_leads_the_wall_into_the_hand_no_faster_than_the_force_may_rise(self):
        self.drag_to(0.1)
        self.step(5)
        self.drag_to(10.1)  # within 5 ticks: 200 N/m x 2 mm, 0.4 N a tick, were nobody to limit it
        largest = self.step(30)
        self.assertGreater(largest, 0.9 * JOYSTICK_RISE * TICK)
        self.assertAlmostEqual(self.session.GetProxyPosition()[1], 10.1, delta=1e-9)

    def test_a_wall_that_is_dragged_far_into_the_hand_pushes_with_no_more_than_the_limit(self):
        for i in range(1, 31):
            self.drag_to(1.0 * i)
            self.step(FRAME)
        self.step(FRAME)
        self.assertAlmostEqual(self.session.GetForce()[1], JOYSTICK_FORCE, delta=1e-9)

    def test_what_is_dragged_away_lets_go_of_the_hand(self):
        for i in range(1, 21):
            self.drag_to(-1.0 * i)
            self.session.Step(FRAME)
        self.session.Step(FRAME)
        self.assertEqual(self.session.GetForceMagnitude(), 0.0)


if __name__ == "__main__":
    # A SystemExit would skip pvpython's own ending, which closes views before the display.
    if not unittest.main(exit=False).result.wasSuccessful():
        sys.exit(1)
