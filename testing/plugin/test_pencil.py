# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines that are drawn freehand in a view, as events of its interactor, in ParaView, in virtual time."""

import math
import sys
import unittest

from paraview import simple

from displays import move
from haptic_proxies import manager, put
from palpate.vtkHapticViews import vtkHapticPencil  # noqa: F401  the proxy's object becomes scriptable
from view_fixture import STIFFNESS, ViewTest

WIDTH, HEIGHT = 120, 100  # px, of the fixture's view
PIXEL = 1 / 32  # u
RADIUS = 0.5  # u, of tubes
POINT = 1e-3 * RADIUS


def place(x, y):
    """Where a pixel is in the plane through the focal point, seen along -z."""
    return (x - WIDTH / 2) * PIXEL, (y - HEIGHT / 2) * PIXEL


class Pencil(ViewTest):
    def setUp(self):
        super().setUp()
        self.view.CameraParallelProjection = 1
        self.view.CameraParallelScale = HEIGHT / 2 * PIXEL
        self.look_from([0, 0, 10])
        self.pencil_proxy = manager().NewProxy("haptics", "HapticPencil")
        self.pencil = self.pencil_proxy.GetClientSideObject()
        put(self.pencil_proxy, "View", self.view.SMProxy)
        put(self.pencil_proxy, "Session", self.proxy)
        put(self.pencil_proxy, "Active", 1)

    def tearDown(self):
        put(self.pencil_proxy, "View", None)
        put(self.pencil_proxy, "Session", None)
        del self.pencil, self.pencil_proxy
        super().tearDown()

    def look_from(self, position, focus=(0, 0, 0)):
        self.view.CameraPosition = position
        self.view.CameraFocalPoint = focus
        self.view.CameraViewUp = [0, 1, 0]
        simple.Render(self.view)

    def say(self, event, x, y, shift=0):
        interactor = self.view.GetInteractor()
        interactor.SetEventInformation(x, y, 0, shift)
        interactor.InvokeEvent(event)

    def draw(self, *pixels):
        """Presses at the first and moves over all the others; the button stays down."""
        self.say("LeftButtonPressEvent", *pixels[0])
        for pixel in pixels[1:]:
            self.say("MouseMoveEvent", *pixel)

    def release(self, x, y):
        self.say("LeftButtonReleaseEvent", x, y)

    def lines(self):
        return list(simple.GetSources().values())

    def points(self):
        self.assertEqual(len(self.lines()), 1)
        numbers = list(self.lines()[0].Points)
        return [numbers[i : i + 3] for i in range(0, len(numbers), 3)]

    def assert_near(self, a, b, delta):
        for p, q in zip(a, b):
            self.assertAlmostEqual(p, q, delta=delta)

    def test_a_line_is_felt_while_the_button_is_still_held(self):
        put(self.proxy, "LineRadius", RADIUS)
        self.draw((60, 10), (60, 30))
        simple.Render(self.view)
        self.follow()
        self.press(RADIUS / 2, 0.5, 0.0)  # a pixel row of 66: above the end of the line
        self.assertEqual(self.session.GetContacts(), 0)
        self.session.SetHandPosition(RADIUS + 0.2, 0.5, 0.0)
        self.session.Step(500)
        self.say("MouseMoveEvent", 60, 80)
        simple.Render(self.view)
        self.assertTrue(self.follow())
        depth = 0.01
        for i in range(1, 101):
            self.session.SetHandPosition(RADIUS + 0.2 - 0.01 * i * (0.2 + depth), 0.5, 0.0)
            self.session.Step(10)
        self.session.Step(500)
        felt = STIFFNESS * (depth + POINT)
        self.assertAlmostEqual(self.session.GetForce()[0], felt, delta=1e-6)
        self.release(60, 90)
        simple.Render(self.view)
        self.follow()
        self.session.Step(200)
        self.assertAlmostEqual(self.session.GetForce()[0], felt, delta=1e-6)

    def test_points_lie_under_the_pointer(self):
        path = [(20, 20), (40, 70), (90, 60)]
        self.draw(*path)
        self.release(100, 10)
        for point, pixel in zip(self.points(), path + [(100, 10)]):
            self.assert_near(point, [*place(*pixel), 0.0], 1e-9)

    def test_a_finished_line_keeps_no_more_points_than_hold_it_within_a_pixel(self):
        bend = [(20 + i, 20) for i in range(0, 61, 2)] + [(80, 20 + i) for i in range(2, 51, 2)]
        self.draw(*bend)
        self.assertEqual(len(self.points()), len(bend))
        self.release(80, 70)
        self.assertEqual(len(self.points()), 3)
        self.assert_near(self.points()[1], [*place(80, 20), 0.0], 1e-9)

    def test_a_finished_line_is_the_active_source_and_what_was_active_stays_so_until_then(self):
        before = simple.Sphere()
        simple.SetActiveSource(before)
        self.draw((20, 20), (40, 70))
        self.assertEqual(simple.GetActiveSource(), before)
        self.release(40, 70)
        self.assertEqual(simple.GetActiveSource().SMProxy.GetXMLName(), "PolyLineSource")

    def test_a_click_a_press_with_shift_and_a_pencil_that_is_put_away_draw_nothing(self):
        self.draw((20, 20))
        self.say("MouseMoveEvent", 21, 20)
        self.release(21, 20)
        self.say("LeftButtonPressEvent", 20, 20, 1)
        self.say("MouseMoveEvent", 60, 60, 1)
        self.say("LeftButtonReleaseEvent", 60, 60, 1)
        put(self.pencil_proxy, "Active", 0)
        self.draw((20, 20), (60, 60))
        self.release(60, 60)
        self.assertEqual(self.lines(), [])

    def test_without_a_plane_world_the_line_lies_in_the_plane_through_the_focal_point(self):
        self.look_from([10, 0, 3], [0, 0, 3])
        self.draw((20, 20), (40, 70), (90, 60))
        self.release(90, 60)
        for point in self.points():
            self.assertAlmostEqual(point[0], 0.0, delta=1e-9)

    def test_a_line_that_begins_on_a_surface_lies_on_it_and_is_felt_there(self):
        """On a ball and on one that its representation has put elsewhere: seen without perspective x and y are those of the pixel."""
        radius, shift = 1.0, 0.25
        ball = simple.Sphere(Radius=radius, ThetaResolution=128, PhiResolution=128)
        flat = 1.0 - math.cos(math.pi / 127)  # of the radius: how far facets are inside of the ball
        display = self.show(ball)
        for across in (0.0, shift):
            move(display, [across, 0.0, 0.0])
            self.view.CameraParallelScale = HEIGHT / 2 * PIXEL  # the first source shown is brought into view
            self.look_from([0, 0, 10])
            path = [(50 + 2 * i, 40 + i) for i in range(10)]
            self.draw(*path)
            self.release(*path[-1])
            line = simple.GetActiveSource()
            drawn = [line.Points[i : i + 3] for i in range(0, len(line.Points), 3)]
            self.assertGreater(len(drawn), 2)  # it is bent
            for x, y, z in drawn:
                away = math.hypot(x - across, y, z)
                self.assertLess(away, radius + 1e-6)
                self.assertGreater(away, radius * (1 - 2 * flat) - 1e-6)
                self.assertGreater(z, 0.0)  # on the side that is seen
            for end, pixel in ((drawn[0], path[0]), (drawn[-1], path[-1])):
                self.assert_near(end[:2], place(*pixel), PIXEL)
            simple.Delete(line)

    def test_in_a_plane_world_the_line_lies_in_its_plane_however_it_is_looked_at(self):
        put(self.proxy, "DeviceName", "simulated-joystick")
        self.show(simple.PolyLineSource(Points=[-1, -1, 0.25, 1, -1, 0.25, 1, 1, 0.25]))
        self.follow()
        self.look_from([6, 0, 8])
        self.draw((20, 20), (40, 70), (90, 60))
        self.release(90, 60)
        drawn = list(simple.GetActiveSource().Points)
        self.assertEqual(len(drawn), 9)
        self.assertEqual(drawn[2::3], [0.25] * 3)
        simple.Render(self.view)
        self.assertTrue(self.follow())
        self.assertTrue(self.session.GetPlaneWorld())
        self.assertEqual(self.scene.GetNumberOfSurfaces(), 2)

    def test_a_line_that_is_deleted_while_it_is_drawn_stays_deleted_and_the_next_one_begins(self):
        self.draw((20, 20), (40, 70))
        simple.Delete(self.lines()[0])
        self.say("MouseMoveEvent", 60, 60)
        self.release(80, 60)
        self.assertEqual(self.lines(), [])
        self.draw((20, 20), (40, 70))
        self.release(40, 70)
        self.assertEqual(len(self.points()), 2)

    def test_putting_the_pencil_away_ends_the_line_and_another_view_may_be_drawn_in(self):
        self.draw((20, 20), (40, 70))
        self.assertIsNotNone(self.pencil.GetLine())
        put(self.pencil_proxy, "Active", 0)
        self.assertIsNone(self.pencil.GetLine())
        self.say("MouseMoveEvent", 90, 60)
        self.assertEqual(len(self.points()), 2)

    def test_another_view_ends_the_line(self):
        other = simple.CreateView("RenderView")
        self.draw((20, 20), (60, 20))
        self.assertIsNotNone(self.pencil.GetLine())
        put(self.pencil_proxy, "View", other.SMProxy)
        self.assertIsNone(self.pencil.GetLine())
        put(self.pencil_proxy, "View", self.view.SMProxy)
        self.say("MouseMoveEvent", 90, 60)
        self.assertEqual(len(self.points()), 2)
        simple.Delete(other)

    def test_a_view_that_is_deleted_while_it_is_drawn_in_ends_the_line(self):
        other = simple.CreateView("RenderView")
        other.ViewSize = [WIDTH, HEIGHT]
        simple.Render(other)
        put(self.pencil_proxy, "View", None)
        self.pencil.SetView(other.SMProxy)  # a property would keep it
        interactor = other.GetInteractor()
        for event, x in (("LeftButtonPressEvent", 20), ("MouseMoveEvent", 60)):
            interactor.SetEventInformation(x, 20, 0, 0)
            interactor.InvokeEvent(event)
        self.assertIsNotNone(self.pencil.GetLine())
        said = []
        self.pencil.AddObserver("EndInteractionEvent", lambda *_: said.append("end"))
        other.SMProxy.AddObserver("DeleteEvent", lambda *_: said.append("deleted"))
        simple.Delete(other)
        del other
        self.assertEqual(sorted(said), ["deleted", "end"])
        self.assertIsNone(self.pencil.GetView())
        self.assertIsNone(self.pencil.GetLine())
        self.assertEqual(simple.GetActiveSource(), self.lines()[0])
        interactor.SetEventInformation(90, 20, 0, 0)
        interactor.InvokeEvent("MouseMoveEvent")
        self.assertEqual(len(self.points()), 2)


if __name__ == "__main__":
    # A SystemExit would skip pvpython's own ending, which closes views before the display.
    if not unittest.main(exit=False).result.wasSuccessful():
        sys.exit(1)
