# SPDX-License-Identifier: GPL-3.0-or-later
"""A labyrinth of the gallery as lines, and the game in a session that runs in virtual time."""

import math
import os
import shutil
import tempfile
import unittest

from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkPoints, vtkStringOutputWindow
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules import vtkRenderingCore  # noqa: F401  wraps the actors

from palpate.vtkHapticInteraction import vtkHapticSession, vtkHapticToolProps
from palpate.vtkHapticPipeline import vtkHapticLabyrinth
from says import unsaid

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
        if session.GetLabyrinth().GetPhase() == phase:
            return True
    return False


class Labyrinths(unittest.TestCase):
    def setUp(self):
        self.window = vtkStringOutputWindow()
        vtkOutputWindow.SetInstance(self.window)

    def session(self, world, device="simulated-joystick"):
        session = vtkHapticSession()
        session.SetSetting("DeviceName", device)
        session.SetSetting("Hand", "none")
        session.SetSetting("VirtualTime", True)
        lines = lines_of(world)
        played = session.GetLabyrinth().Play(lines, world)
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
        self.assertTrue(step_until(session, "leads"), session.GetLabyrinth().GetPhase() + session.GetFaultText())
        self.assertTrue(step_until(session, "explores"), session.GetLabyrinth().GetPhase())
        start = start_of("hampton-court")
        x, y, _ = session.GetProxyPosition()
        self.assertLess(max(abs(x - start[0]), abs(y - start[1])), 0.5)  # in the corridor of the start
        session.GetLabyrinth().PlayAgain()
        session.Step(1)
        session.Update()
        self.assertEqual(session.GetLabyrinth().GetPhase(), "lets go")  # it is at the start already
        self.assertEqual(session.GetLabyrinth().GetTime(), 0.0)
        session.GetLabyrinth().End()
        session.Step(1)
        session.Update()
        self.assertEqual(session.GetLabyrinth().GetPhase(), "off")

    def test_zoom_makes_a_corridor_as_wide_as_a_hand_tells_apart(self):
        session, _ = self.session("hampton-court")
        stiffness_N_per_m = min(session.GetSetting("Stiffness"), session.GetLargestStiffness())
        self.assertAlmostEqual(session.GetLabyrinth().GetFeelableWidth(), 2 * PRESSING_N / stiffness_N_per_m, 15)
        width_m = CORRIDOR_U / session.GetSetting("Scale")
        zoom = 2 * PRESSING_N / stiffness_N_per_m / width_m
        self.assertGreater(zoom, 1)
        self.assertAlmostEqual(session.GetLabyrinth().GetFeelableZoom() / zoom, 1, 12)
        session.SetSetting("Scale", session.GetSetting("Scale") / zoom)
        self.assertAlmostEqual(session.GetLabyrinth().GetFeelableZoom(), 1, 12)
        session.SetSetting("Scale", session.GetSetting("Scale") / 2)
        self.assertEqual(session.GetLabyrinth().GetFeelableZoom(), 1)

    def test_zoom_is_one_where_nothing_was_played_and_infinite_without_stiffness(self):
        self.assertEqual(vtkHapticSession().GetLabyrinth().GetFeelableZoom(), 1)
        session, _ = self.session("wedge-field")  # refused as a game, and explored
        self.assertGreater(session.GetLabyrinth().GetFeelableZoom(), 1)
        session.SetSetting("Stiffness", 0)
        self.assertEqual(session.GetLabyrinth().GetFeelableZoom(), math.inf)

    def test_hand_without_force_is_told_to_go_to_the_start(self):
        for device, forces in (("simulated-joystick", True), ("fed", False), ("mouse", False)):
            session, _ = self.session("hampton-court", device)
            start = start_of("hampton-court")
            session.SetHandPosition(start[0], start[1] + 3, 0)  # in the middle of a corridor
            self.assertEqual(session.GetDeviceGivesForce(), forces, device)
            session.SetTouching(True)
            self.assertTrue(step_until(session, "leads"), device)
            text = "leads" if forces else "move to the start yourself"
            self.assertTrue(session.GetLabyrinth().GetText().startswith(text), device)

    def test_trace_is_the_way_since_the_hand_was_let_go(self):
        session, _ = self.session("hampton-court", "fed")
        start = start_of("hampton-court")
        session.SetHandPosition(start[0], start[1], 0)
        trace = vtkPolyData()
        session.GetLabyrinth().GetTrace(trace)
        self.assertEqual(trace.GetNumberOfPoints(), 0)
        session.SetTouching(True)
        self.assertTrue(step_until(session, "explores"), session.GetLabyrinth().GetPhase() + session.GetFaultText())
        steps = 64
        for k in range(steps + 1):  # to and fro in the corridor of the start
            session.SetHandPosition(start[0], start[1] + 0.25 * math.sin(2 * math.pi * k / steps), 0)
            session.Step(20)
            session.Update()
        session.GetLabyrinth().GetTrace(trace)
        way = [trace.GetPoint(k) for k in range(trace.GetNumberOfPoints())]
        self.assertEqual(trace.GetNumberOfLines(), 1)
        self.assertGreaterEqual(len(way), 5)  # a path of 1 u, a point each 0.1 u at least where it does not turn
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
        session.GetLabyrinth().PlayAgain()
        session.Step(1)
        session.GetLabyrinth().GetTrace(trace)
        self.assertEqual(trace.GetNumberOfPoints(), 0)

    def test_way_is_still_drawn_when_nothing_is_touched_any_more(self):
        session, _ = self.session("corridor", "fed")
        session.SetHandPosition(*start_of("corridor"))
        session.SetTouching(True)
        self.assertTrue(step_until(session, "explores"), session.GetLabyrinth().GetPhase())
        drawn = vtkHapticToolProps()
        drawn.ShowTraceOn()
        drawn.UpdateFrom(session)
        session.SetTouching(False)
        drawn.UpdateFrom(session)
        self.assertTrue(drawn.GetTraceActor().GetVisibility())
        self.assertFalse(drawn.GetProxyActor().GetVisibility())
        self.assertFalse(drawn.GetStartActor().GetVisibility())
        session.GetLabyrinth().GetTrace(None)

    def test_start_and_exit_are_drawn_where_they_are_or_only_the_start_as_long_as_it_is_looked_for(self):
        session, _ = self.session("corridor", "fed")
        session.SetHandPosition(5, 0.5, 0)
        session.SetTouching(True)
        self.assertTrue(step_until(session, "leads"))
        drawn = vtkHapticToolProps()
        drawn.UpdateFrom(session)
        for actor, place in ((drawn.GetStartActor(), (0.5, 0.5, 0)), (drawn.GetExitActor(), (9.5, 0.5, 0))):
            self.assertTrue(actor.GetVisibility())
            self.assertEqual(actor.GetPosition(), place)
            self.assertEqual(actor.GetScale()[0], session.GetLabyrinth().GetReach())
        drawn.ShowPlacesOff()
        drawn.UpdateFrom(session)
        self.assertTrue(drawn.GetStartActor().GetVisibility())
        self.assertFalse(drawn.GetExitActor().GetVisibility())
        session.SetHandPosition(0.5, 0.5, 0)
        self.assertTrue(step_until(session, "explores"))
        drawn.UpdateFrom(session)
        self.assertFalse(drawn.GetStartActor().GetVisibility())

    def test_another_labyrinth_begins_at_its_own_start_while_one_is_explored(self):
        session, _ = self.session("corridor")
        session.SetTouching(True)
        self.assertTrue(step_until(session, "explores"))
        lines = lines_of("hampton-court")
        self.assertTrue(session.GetLabyrinth().Play(lines, "hampton-court"))
        session.ClearSurfaces()
        session.AddSurface("hampton-court", lines, None)
        session.CommitScene()
        session.FinishScene()
        session.Step(1)
        session.Update()
        self.assertEqual(session.GetLabyrinth().GetPhase(), "leads")
        self.assertTrue(step_until(session, "explores"))
        self.assertLess(math.dist(session.GetProxyPosition(), start_of("hampton-court")), 0.5)
        self.assertLess(session.GetLabyrinth().GetTime(), 0.1)

    def test_structure_is_fitted_as_a_maze_is(self):
        session, played = self.session("circle-set")
        self.assertFalse(played)
        fence = lines_of("circle-set").GetBounds()
        radius_m = 0.05  # of the joystick's workspace: the fence fits into the square inside
        self.assertAlmostEqual(session.GetSetting("Scale"), (fence[1] - fence[0]) / (math.sqrt(2) * radius_m), 9)
        self.assertAlmostEqual(session.GetSettingNumbers("Offset")[0], 0.5 * (fence[0] + fence[1]), 12)
        self.assertAlmostEqual(session.GetSetting("Radius"), 0.2 * CORRIDOR_U, 15)
        self.assertEqual(self.window.GetOutput(), "")

    def drawing(self, more):
        """A corridor of 1000 by 50 with a bend, as an SVG drawing."""
        folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, folder)
        path = os.path.join(folder, "bend.svg")
        with open(path, "w", encoding="utf-8") as file:
            file.write(
                '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1000 1000">'
                '<path d="M 0 0 H 1000 V 1000 H 950 V 50 H 0 Z" fill="none" stroke="black"/>' + more + "</svg>"
            )
        return lines_of(path)

    def test_corridors_of_a_drawing_are_measured_unless_it_is_said_how_wide_they_are(self):
        mark = '<circle id="{}" cx="{}" cy="{}" r="5"/>'
        data = self.drawing(mark.format("start", 25, 25) + mark.format("exit", 975, 975))
        width = data.GetFieldData().GetArray("Corridor").GetValue(0)
        fence = max(data.GetBounds()[1] - data.GetBounds()[0], data.GetBounds()[3] - data.GetBounds()[2])
        steps = fence / 512
        self.assertGreaterEqual(width, 50 * fence / 1000 - 3 * steps)
        self.assertLessEqual(width, 50 * fence / 1000 + steps)
        said = vtkHapticLabyrinth()
        said.SetWorld("spiral")
        said.SetCorridor(0.75)
        said.Update()
        self.assertEqual(said.GetOutput().GetFieldData().GetArray("Corridor").GetValue(0), 0.75)

    def test_maze_with_a_start_alone_lacks_its_exit(self):
        data = self.drawing('<circle id="start" cx="25" cy="25" r="5"/>')
        session = vtkHapticSession()
        self.assertFalse(session.GetLabyrinth().Play(data, "bend.svg"))
        self.assertIn("bend.svg: no exit", session.GetProblem())

    def test_line_of_one_point_changes_nothing_and_is_named_with_that_point(self):
        data = vtkPolyData()
        data.SetPoints(vtkPoints())
        data.GetPoints().InsertNextPoint(1, 2, 0)
        lines = vtkCellArray()
        lines.InsertNextCell(2, (0, 0))
        data.SetLines(lines)
        session = vtkHapticSession()
        before = session.GetSetting("Scale"), session.GetSetting("Radius"), session.GetSetting("LinesAsWalls")
        self.assertFalse(session.GetLabyrinth().Play(data, "dot.vtp"))
        self.assertEqual(unsaid(session.GetProblem(), "dot.vtp", "single point, (1, 2)"), [])
        self.assertEqual((session.GetSetting("Scale"), session.GetSetting("Radius"), session.GetSetting("LinesAsWalls")), before)
        self.assertFalse(session.GetLabyrinth().Play(vtkPolyData(), "none.vtp"))
        self.assertEqual(unsaid(session.GetProblem(), "none.vtp", "no labyrinth"), [])

    def test_no_button_that_was_not_pressed_asks_for_a_labyrinth(self):
        session, _ = self.session("hampton-court")
        session.SetTouching(True)
        session.Step(100)
        session.Update()
        self.assertEqual(session.GetLabyrinth().TakeWish(), 0)

    def test_structure_is_refused_before_the_hand_is_moved(self):
        session, played = self.session("wedge-field")
        self.assertFalse(played)
        self.assertIn("no start", session.GetProblem())
        session.SetTouching(True)
        session.Step(100)
        session.Update()
        self.assertEqual(session.GetLabyrinth().GetPhase(), "off")

    def test_file_that_is_not_there_is_named(self):
        self.assertEqual(lines_of("no-such.vtp").GetNumberOfPoints(), 0)
        self.assertIn("no-such.vtp", self.window.GetOutput())


if __name__ == "__main__":
    unittest.main()
