# SPDX-License-Identifier: GPL-3.0-or-later
"""A labyrinth of the gallery as lines, and the game in a session that runs in virtual time."""

import math
import unittest

from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules import vtkRenderingCore  # noqa: F401  wraps the actors

from palpate.vtkHapticInteraction import vtkHapticSession, vtkHapticToolProps
from palpate.vtkHapticPipeline import vtkHapticLabyrinth

MAZES = ("chartres", "corridor", "hampton-court", "spiral", "versailles")
STRUCTURES = ("circle-set", "wedge-field")
CORRIDOR_U = 1.0  # of hampton-court
PRESSING_N = 1.0  # of a hand that explores


def lines_of(world):
    source = vtkHapticLabyrinth()
    source.SetWorld(world)
    source.Update()
    return source.GetOutput()


def start_of(world):
    return lines_of(world).GetFieldData().GetArray("Start").GetTuple(0)


def step_until(session, phase, most_s=20):
    for _ in range(most_s * 100):
        session.Step(10)
        session.Update()
        if session.GetLabyrinthPhase() == phase:
            return True
    return False


class Labyrinths(unittest.TestCase):
    def setUp(self):
        self.window = vtkStringOutputWindow()
        vtkOutputWindow.SetInstance(self.window)

    def session(self, world, device="simulated-joystick"):
        session = vtkHapticSession()
        session.SetDeviceName(device)
        session.SetHand("none")
        session.SetVirtualTime(True)
        lines = lines_of(world)
        played = session.PlayLabyrinth(lines, world)
        session.ClearSurfaces()
        session.AddSurface(world, lines, None)
        session.CommitScene()
        session.FinishScene()
        return session, played

    def test_gallery_lists_mazes_and_structures_by_name(self):
        names = [vtkHapticLabyrinth.GetWorldName(i) for i in range(vtkHapticLabyrinth.GetNumberOfWorlds())]
        self.assertEqual(names, sorted(MAZES + STRUCTURES))

    def test_mazes_have_start_and_exit_and_a_fence_and_structures_a_fence(self):
        for world in MAZES + STRUCTURES:
            data = lines_of(world)
            self.assertEqual(data.GetFieldData().GetArray("Start") is not None, world in MAZES, world)
            self.assertGreater(data.GetNumberOfLines(), 4, world)

    def test_hand_is_brought_to_the_start_of_a_maze_and_let_go(self):
        session, played = self.session("hampton-court")
        self.assertTrue(played, session.GetProblem())
        session.SetTouching(True)
        self.assertTrue(step_until(session, "leads"), session.GetLabyrinthPhase() + session.GetFaultText())
        self.assertTrue(step_until(session, "explores"), session.GetLabyrinthPhase())
        start = start_of("hampton-court")
        x, y, _ = session.GetProxyPosition()
        self.assertLess(max(abs(x - start[0]), abs(y - start[1])), 0.5)  # in the corridor of the start
        session.PlayAgain()
        session.Step(1)
        session.Update()
        self.assertEqual(session.GetLabyrinthPhase(), "lets go")  # it is at the start already
        self.assertEqual(session.GetLabyrinthTime(), 0.0)
        session.EndLabyrinth()
        session.Step(1)
        session.Update()
        self.assertEqual(session.GetLabyrinthPhase(), "off")

    def test_zoom_makes_a_corridor_as_wide_as_a_hand_tells_apart(self):
        session, _ = self.session("hampton-court")
        stiffness_N_per_m = min(session.GetStiffness(), session.GetLargestStiffness())
        self.assertAlmostEqual(session.GetFeelableWidth(), 2 * PRESSING_N / stiffness_N_per_m, 15)
        width_m = CORRIDOR_U / session.GetScale()
        zoom = 2 * PRESSING_N / stiffness_N_per_m / width_m
        self.assertGreater(zoom, 1)
        self.assertAlmostEqual(session.GetFeelableZoom() / zoom, 1, 12)
        session.SetScale(session.GetScale() / zoom)
        self.assertAlmostEqual(session.GetFeelableZoom(), 1, 12)
        session.SetScale(session.GetScale() / 2)
        self.assertEqual(session.GetFeelableZoom(), 1)

    def test_zoom_is_one_where_nothing_was_played_and_infinite_without_stiffness(self):
        self.assertEqual(vtkHapticSession().GetFeelableZoom(), 1)
        session, _ = self.session("wedge-field")  # refused as a game, and explored
        self.assertGreater(session.GetFeelableZoom(), 1)
        session.SetStiffness(0)
        self.assertEqual(session.GetFeelableZoom(), math.inf)

    def test_hand_without_force_is_told_to_go_to_the_start(self):
        for device, forces in (("simulated-joystick", True), ("fed", False), ("mouse", False)):
            session, _ = self.session("hampton-court", device)
            start = start_of("hampton-court")
            session.SetHandPosition(start[0], start[1] + 3, 0)  # in the middle of a corridor
            self.assertEqual(session.GetDeviceGivesForce(), forces, device)
            session.SetTouching(True)
            self.assertTrue(step_until(session, "leads"), device)
            text = "leads" if forces else "go to the start yourself (no force)"
            self.assertEqual(session.GetLabyrinthText(), text, device)

    def test_trace_is_the_way_since_the_hand_was_let_go(self):
        session, _ = self.session("hampton-court", "fed")
        start = start_of("hampton-court")
        session.SetHandPosition(start[0], start[1], 0)
        trace = vtkPolyData()
        session.GetLabyrinthTrace(trace)
        self.assertEqual(trace.GetNumberOfPoints(), 0)
        session.SetTouching(True)
        self.assertTrue(step_until(session, "explores"), session.GetLabyrinthPhase() + session.GetFaultText())
        steps = 64
        for k in range(steps + 1):  # to and fro in the corridor of the start
            session.SetHandPosition(start[0], start[1] + 0.25 * math.sin(2 * math.pi * k / steps), 0)
            session.Step(20)
            session.Update()
        session.GetLabyrinthTrace(trace)
        way = [trace.GetPoint(k) for k in range(trace.GetNumberOfPoints())]
        self.assertEqual(trace.GetNumberOfLines(), 1)
        self.assertGreaterEqual(len(way), 5)  # a way of 1 u, a point each 0.1 u at least where it does not turn
        for a, b in zip(way, way[1:]):
            self.assertGreaterEqual(math.dist(a, b), 0.1 * CORRIDOR_U)
        for p in way:
            self.assertLessEqual(math.dist(p, (start[0], start[1], 0)), 0.25 + 1e-9)
        drawn = vtkHapticToolProps()
        drawn.UpdateFrom(session)
        self.assertFalse(drawn.GetTraceActor().GetVisibility())
        drawn.ShowTraceOn()
        drawn.UpdateFrom(session)
        self.assertTrue(drawn.GetTraceActor().GetVisibility())
        self.assertEqual(drawn.GetTraceActor().GetMapper().GetInput().GetNumberOfPoints(), len(way))
        session.PlayAgain()
        session.Step(1)
        session.GetLabyrinthTrace(trace)
        self.assertEqual(trace.GetNumberOfPoints(), 0)

    def test_no_button_that_was_not_pressed_asks_for_a_labyrinth(self):
        session, _ = self.session("hampton-court")
        session.SetTouching(True)
        session.Step(100)
        session.Update()
        self.assertEqual(session.TakeLabyrinthWish(), vtkHapticSession.NoWish)

    def test_structure_is_refused_before_the_hand_is_moved(self):
        session, played = self.session("wedge-field")
        self.assertFalse(played)
        self.assertIn("no place to start", session.GetProblem())
        session.SetTouching(True)
        session.Step(100)
        session.Update()
        self.assertEqual(session.GetLabyrinthPhase(), "off")

    def test_file_that_is_not_there_is_named(self):
        self.assertEqual(lines_of("no-such.vtp").GetNumberOfPoints(), 0)
        self.assertIn("no-such.vtp", self.window.GetOutput())


if __name__ == "__main__":
    unittest.main()
