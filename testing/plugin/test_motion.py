# SPDX-License-Identifier: GPL-3.0-or-later
"""Actors that move and time series that are scrubbed while a hand presses, in ParaView, in virtual time."""

import os
import sys
import tempfile
import unittest

from paraview import simple
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

from displays import move
from view_fixture import DEPTH, FORCE, SCALE, STIFFNESS, ViewTest

CELLS = 8
WALL = 0.5  # where all walls of the series stand at y = 0 [u]
TILTS = [0.01, 0.02, 0.04, None, 0.01]  # of the walls x = WALL + tilt y, one a time step; None: nothing there


def make_wall(tilt):
    wall = vtkPolyData()
    if tilt is None:
        return wall
    points, polys = vtkPoints(), vtkCellArray()
    points.SetDataTypeToDouble()
    for i in range(CELLS + 1):
        for j in range(CELLS + 1):
            y, z = 2.0 * i / CELLS - 1.0, 2.0 * j / CELLS - 1.0
            points.InsertNextPoint(WALL + tilt * y, y, z)
    for i in range(CELLS):
        for j in range(CELLS):
            corner = i * (CELLS + 1) + j
            polys.InsertNextCell(3, [corner, corner + CELLS + 1, corner + CELLS + 2])
            polys.InsertNextCell(3, [corner, corner + CELLS + 2, corner + 1])
    wall.SetPoints(points)
    wall.SetPolys(polys)
    return wall


def write_series(folder):
    entries = ""
    for step, tilt in enumerate(TILTS):
        writer = vtkXMLPolyDataWriter()
        writer.SetFileName(os.path.join(folder, f"wall{step}.vtp"))
        writer.SetInputData(make_wall(tilt))
        writer.Write()
        entries += f'<DataSet timestep="{step}" file="wall{step}.vtp"/>'
    series = os.path.join(folder, "walls.pvd")
    with open(series, "w", encoding="ascii") as file:
        file.write(f'<VTKFile type="Collection" version="0.1"><Collection>{entries}</Collection></VTKFile>')
    return series


class MotionInAView(ViewTest):
    def test_an_actor_that_is_moved_pushes_a_pressed_hand_and_is_not_built_again(self):
        display = self.show(simple.Box())
        self.follow()
        self.press(WALL - DEPTH, 0.1, 0.1)
        self.assertFalse(self.session.GetSceneMoves())
        for position in (0.001, 0.002, 0.004, -0.002):
            move(display, [position, 0.0, 0.0])
            simple.Render(self.view)
            self.assertTrue(self.scene.Update())
            self.session.Update()
            self.session.Step(10)
            self.assertTrue(self.session.GetSceneMoves())
            self.assertGreater(self.session.GetMotionLag(), 0.0)
            self.session.Step(200)
            self.assertEqual(self.session.GetMotionLag(), 0.0)
            self.assertAlmostEqual(self.session.GetForce()[0], FORCE + STIFFNESS * position / SCALE, delta=1e-9)
        self.assertNotIn("refitted", self.session.GetSceneReport())
        self.assertEqual(self.session.GetFaultText(), "")

    def test_a_turned_actor_carries_a_pressed_hand_until_it_rests(self):
        display = self.show(simple.Box())
        self.follow()
        self.press(WALL - DEPTH, 0.0, 0.0)
        display.Orientation = [90.0, 0.0, 0.0]  # about the path of the hand: the face comes to lie on itself
        simple.Render(self.view)
        self.assertTrue(self.scene.Update())
        self.session.Update()
        for _ in range(150):
            self.session.Step(10)
            self.assertAlmostEqual(self.session.GetForce()[0], FORCE, delta=1e-9)
        self.session.FinishScene()
        self.assertFalse(self.session.GetSceneMoves())
        self.session.Step(100)
        self.assertAlmostEqual(self.session.GetForce()[0], FORCE, delta=1e-9)

    def show_time(self, step):
        simple.GetAnimationScene().AnimationTime = float(step)
        self.view.ViewTime = float(step)
        simple.Render(self.view)
        self.assertTrue(self.follow())

    def expect_wall(self, y, tilt):
        """The wall holds the hand with the stiffness times its distance, along its normal."""
        length = (1.0 + tilt * tilt) ** 0.5
        force = STIFFNESS * (DEPTH + tilt * y) / length / SCALE
        self.assertAlmostEqual(self.session.GetForce()[0], force / length, delta=1e-9)
        self.assertAlmostEqual(self.session.GetForce()[1], -force * tilt / length, delta=1e-9)

    def test_a_scrubbed_time_series_takes_the_hand_along_and_an_empty_step_lets_go(self):
        y = 0.1
        with tempfile.TemporaryDirectory() as folder:
            self.show(simple.PVDReader(FileName=write_series(folder)))
            self.follow()
            self.press(WALL - DEPTH, y, 0.1)
            self.expect_wall(y, TILTS[0])
            for step in (1, 2, 0, 2):
                self.show_time(step)
                self.assertIn("refitted", self.session.GetSceneReport())
                self.session.Step(1500)  # the blend has faded
                self.expect_wall(y, TILTS[step])
            self.show_time(3)
            self.assertIn("the source has no points: it may be empty at this time", self.scene.GetReport())
            self.session.Step(100)
            self.assertEqual(self.session.GetForceMagnitude(), 0.0)
            self.show_time(4)
            self.press(WALL - DEPTH, y, 0.1)
            self.expect_wall(y, TILTS[4])


if __name__ == "__main__":
    # A SystemExit would skip pvpython's own ending, which closes views before the display.
    if not unittest.main(exit=False).result.wasSuccessful():
        sys.exit(1)
