# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh in the hand presses a soft block: Touch Along Path, and Press and Hold Tool together. A process of its own: the session is
registered. Judge: the exact ball on the same block."""

import os
import unittest

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

simple.LoadPlugin(os.environ["PALPATE_PLUGIN"], remote=False, ns=globals())
from palpate.simple import GetHapticSession, HapticRefusal, HapticState, HoldTool, LetGo, PressBody, SetHaptics, Touch  # noqa: E402

BALL, TOP, DEPTH = 30.0, 50.0, 1.0  # mm
PLACE = (1.1, 0.8)  # mm, not over a vertex
STIFFNESS, SCALE = 5000.0, 1000.0  # N/m, u/m


def shown_block(view):
    """The block of docs/soft.md, of cells of 12.5 mm."""
    block = simple.Transform(Input=simple.Wavelet(WholeExtent=[-4, 4, -4, 4, 0, 4]))
    block.Transform.Scale = [12.5, 12.5, 12.5]
    body = simple.SoftBody(registrationName="block", Input=simple.Tetrahedralize(Input=block), YoungsModulus=20000, Unit=0.001,
                           Fixed="zmin", Model="Linear")
    simple.Show(body, view)
    return body


def ball():
    return simple.Sphere(registrationName="ball", Radius=BALL, ThetaResolution=60, PhiResolution=60)


def forces(touch):
    return vtk_to_numpy(servermanager.Fetch(touch).GetPointData().GetArray("Force"))


class ToolOnBody(unittest.TestCase):
    def setUp(self):
        self.view = simple.CreateView("RenderView")
        self.view.ViewSize = [120, 100]
        simple.SetActiveView(self.view)
        SetHaptics(DeviceName="fed", VirtualTime=1, Stiffness=STIFFNESS, Scale=SCALE, Radius=BALL, FitOnTouch=0)

    def tearDown(self):
        LetGo()
        PressBody(None)
        HoldTool(None)
        for source in list(simple.GetSources().values()):
            simple.Delete(source)
        simple.Delete(self.view)

    def pressed(self):
        """Force on a hand of the session that goes down and rests."""
        session = GetHapticSession()
        session.SetHandPosition(*PLACE, TOP + BALL + 1)
        Touch()
        session.Step(2000)
        for i in range(101):
            session.SetHandPosition(*PLACE, TOP + BALL + 0.5 - 0.01 * (0.5 + DEPTH) * i)
            session.Step(1)
        session.Step(1500)
        session.Update()
        return numpy.array(session.GetForce())

    def test_along_a_path_a_mesh_ball_is_pushed_as_the_exact_ball_is(self):
        path = simple.Line(Point1=[*PLACE, TOP + BALL + 0.5], Point2=[*PLACE, TOP + BALL - DEPTH], Resolution=20)
        common = dict(Input=shown_block(self.view), Path=path, Stiffness=STIFFNESS, Scale=SCALE, LowRate=0)
        mesh = forces(simple.TouchAlongPath(Tool=ball(), **common))
        exact = forces(simple.TouchAlongPath(Radius=BALL, **common))
        self.assertEqual(len(mesh), len(exact))
        self.assertTrue((mesh[0] == 0).all(), "it begins above the block")
        self.assertGreater(exact[-1, 2], 0.1)
        self.assertAlmostEqual(mesh[-1, 2] / exact[-1, 2], 1, delta=0.02)
        self.assertLess(mesh[-1, 2], 0.1 * STIFFNESS * DEPTH / SCALE, "the block is not rigid")

    def test_a_tool_that_is_held_and_a_body_that_is_pressed_are_felt_together(self):
        body = shown_block(self.view)
        PressBody(body)
        exact = self.pressed()
        LetGo()
        box = simple.Box(registrationName="box", XLength=60, YLength=60, ZLength=2 * BALL)
        HoldTool(box)
        flat = self.pressed()
        session = GetHapticSession()
        self.assertIn("presses block", session.GetToolText())
        self.assertIn("solves per second", session.GetSoftText())
        self.assertGreater(flat[2], 3 * exact[2], "a plate is pushed more than a ball")
        self.assertLess(flat[2], 0.95 * STIFFNESS * DEPTH / SCALE, "the block is not rigid")
        pose = session.GetToolPose()
        self.assertAlmostEqual(flat[2], STIFFNESS * (pose[2] - (TOP + BALL - DEPTH)) / SCALE, delta=1e-3 * flat[2])
        HapticState()  # the view follows
        simple.Render(self.view)
        bent = vtk_to_numpy(servermanager.Fetch(body).GetPointData().GetArray("Displacement"))
        self.assertLess(bent[:, 2].min(), -0.3 * (DEPTH - flat[2] / STIFFNESS * SCALE))

    def test_a_tool_that_is_open_is_refused_in_words(self):
        PressBody(shown_block(self.view))
        with self.assertRaises(HapticRefusal) as refused:
            HoldTool(simple.Plane(registrationName="sheet"))
            Touch()
        self.assertIn("cannot press a soft body: the mesh is open", str(refused.exception))

    def test_another_surface_in_the_view_holds_the_tool_and_one_that_is_open_has_to_be_hidden(self):
        PressBody(shown_block(self.view))
        table = simple.Box(registrationName="table", XLength=200, YLength=200, ZLength=10, Center=[300, 0, -5])  # its top is z = 0
        simple.Show(table, self.view)
        HoldTool(simple.Box(registrationName="box", XLength=60, YLength=60, ZLength=2 * BALL))
        self.assertGreater(self.pressed()[2], 0.5)
        session = GetHapticSession()
        self.assertIn("presses block", session.GetToolText())
        deep = DEPTH / 2  # 2.5 N: a session gives 3 N at most
        for place in ((300, 0, TOP + BALL + 10), (300, 0, BALL + 1), (300, 0, BALL - deep)):
            session.SetHandPosition(*place)
            session.Step(500)
        session.Update()
        rest = 2e-5 * 2 * BALL * 3 ** 0.5  # mm: so far the box, whose sides are 60 mm, stays away from a mesh that stands
        self.assertAlmostEqual(session.GetForce()[2], STIFFNESS * (deep + rest) / SCALE, delta=1e-6)
        LetGo()
        simple.Hide(table, self.view)
        sheet = simple.Plane(registrationName="sheet", Origin=[200, 0, 0], Point1=[300, 0, 0], Point2=[200, 100, 0])
        simple.Show(sheet, self.view)
        self.pressed()
        self.assertIn("hide sheet", session.GetToolText())
        LetGo()
        simple.Hide(sheet, self.view)
        self.pressed()
        self.assertIn("presses block", session.GetToolText())


if __name__ == "__main__":
    unittest.main()
