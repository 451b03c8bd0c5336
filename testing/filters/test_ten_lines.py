# SPDX-License-Identifier: GPL-3.0-or-later
"""A plain VTK program touches and sees in ten lines: the force by formula, then the proxy in the picture."""

import math
import sys
import unittest

import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 (the renderer's factory)
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter

from palpate.vtkHapticInteraction import vtkHapticInteractor

SIZE = 300
TICKS_TO_ENGAGE = 1100  # arming, the ramp of 1 s, and some to spare


def make_window(actor):
    renderer = vtkRenderer()
    renderer.AddActor(actor)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(SIZE, SIZE)
    window.AddRenderer(renderer)
    return window, renderer


def pixels_of(window):
    """Rows from the bottom up, as display coordinates count them."""
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    image.Update()
    scalars = image.GetOutput().GetPointData().GetScalars()
    return vtk_to_numpy(scalars).reshape(SIZE, SIZE, -1).astype(int)


class TenLines(unittest.TestCase):
    def setUp(self):
        plane = vtkPlaneSource()  # z = 0, one unit wide
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(plane.GetOutputPort())
        self.actor = vtkActor()
        self.actor.SetMapper(mapper)

    def test_touches_and_sees(self):
        window, renderer = make_window(self.actor)
        touch = vtkHapticInteractor()
        touch.SetRenderer(renderer)
        touch.AddActor(self.actor)
        session = touch.GetSession()
        session.SetSetting("Scale", 1.0)
        session.SetSetting("Stiffness", 200.0)
        session.SetSetting("VirtualTime", 1)
        session.SetHandPosition(0.1, 0.1, 0.1)
        self.assertTrue(touch.Start(), session.GetProblem())
        session.Step(TICKS_TO_ENGAGE)
        depth = 0.01
        session.SetHandPosition(0.1, 0.1, -depth)
        session.Step(100)
        touch.Update()
        for got, expected in zip(session.GetForce(), (0.0, 0.0, 200.0 * depth)):
            self.assertAlmostEqual(got, expected, delta=1e-12)
        for got, expected in zip(session.GetProxyPosition(), (0.1, 0.1, 0.0)):
            self.assertAlmostEqual(got, expected, delta=1e-12)

        touch.GetToolProps().SetForceScale(0.0)  # else the arrow stands in front of the proxy
        touch.GetToolProps().SetRelativeSize(0.05)
        touch.Update()
        renderer.ResetCamera()
        window.Render()
        renderer.SetWorldPoint(*session.GetProxyPosition(), 1.0)
        renderer.WorldToDisplay()
        x, y, _ = renderer.GetDisplayPoint()
        shown = pixels_of(window)
        red, _, blue = shown[round(y), round(x)][:3]
        self.assertGreater(red, 2 * blue + 40, "the proxy is yellow where the session says it is")
        touch.Stop()
        window.Render()
        red, _, blue = pixels_of(window)[round(y), round(x)][:3]
        self.assertLess(abs(red - blue), 5, "and gone when nothing is touched: the plane is white")

    def test_follows_an_actor_that_moves(self):
        touch = vtkHapticInteractor()
        touch.AddActor(self.actor)
        session = touch.GetSession()
        session.SetSetting("Scale", 1.0)
        session.SetSetting("VirtualTime", 1)
        session.SetHandPosition(0.0, 0.0, 3.0)
        self.assertTrue(touch.Start(), session.GetProblem())
        self.actor.SetPosition(0.0, 0.0, 2.0)
        self.actor.RotateY(30.0)
        touch.Update()
        self.assertTrue(session.FinishScene())
        session.Step(10)
        session.SetHandPosition(0.0, 0.0, 1.9)
        session.Step(10)
        # nearest point of the plane through (0, 0, 2) with normal (sin 30, 0, cos 30) to the hand
        normal = (math.sin(math.radians(30.0)), 0.0, math.cos(math.radians(30.0)))
        depth = 0.1 * normal[2]
        expected = (depth * normal[0], 0.0, 1.9 + depth * normal[2])
        for got, wanted in zip(session.GetProxyPosition(), expected):
            self.assertAlmostEqual(got, wanted, delta=1e-6)  # vtkPlaneSource makes points in single precision


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
