# SPDX-License-Identifier: GPL-3.0-or-later
"""A labyrinth of the gallery as lines, and the game in a session that runs in virtual time."""

import unittest

from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow

from palpate.vtkHapticInteraction import vtkHapticSession
from palpate.vtkHapticPipeline import vtkHapticLabyrinth

MAZES = ("chartres", "corridor", "hampton-court", "spiral", "versailles")
STRUCTURES = ("circle-set", "wedge-field")


def lines_of(world):
    source = vtkHapticLabyrinth()
    source.SetWorld(world)
    source.Update()
    return source.GetOutput()


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

    def session(self, world):
        session = vtkHapticSession()
        session.SetDeviceName("simulated-joystick")
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
        x, y, _ = session.GetProxyPosition()
        self.assertLess(max(abs(x - 7.5), abs(y + 0.5)), 0.5)  # in the corridor of the start
        session.PlayAgain()
        session.Step(1)
        session.Update()
        self.assertEqual(session.GetLabyrinthPhase(), "lets go")  # it is at the start already
        self.assertEqual(session.GetLabyrinthTime(), 0.0)
        session.EndLabyrinth()
        session.Step(1)
        session.Update()
        self.assertEqual(session.GetLabyrinthPhase(), "off")

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
