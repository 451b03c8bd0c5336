# SPDX-License-Identifier: GPL-3.0-or-later
"""The drawn soft body is the felt one: no place of it is within the ball, the lowest place under it is as deep as the ball. Where
the hand was when the body was computed is known. A fine surface rides on coarse tetrahedra."""

import math
import re
import unittest

from palpate.vtkHapticInteraction import vtkHapticSession
from palpate.vtkHapticPipeline import vtkHapticSoftBody, vtkHapticSoftSkin
from vtkmodules.vtkCommonCore import VTK_STRING, vtkOutputWindow, vtkStringOutputWindow
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkFiltersGeneral import vtkDataSetTriangleFilter
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from says import unsaid

SIDE, HEIGHT = 100.0, 50.0  # mm
RADIUS = 10.0  # mm
RATE = 20  # Hz
TICKS_TO_ENGAGE = 1100
FINE = 1.0  # mm between points of the skin


def block(cells=6):
    """Of tetrahedra around the origin, its top at z = HEIGHT."""
    image = vtkImageData()
    image.SetDimensions(cells + 1, cells + 1, cells // 2 + 1)
    image.SetSpacing(*[SIDE / cells] * 3)
    image.SetOrigin(-SIDE / 2, -SIDE / 2, 0)
    cut = vtkDataSetTriangleFilter()
    cut.SetInputData(image)
    body = vtkHapticSoftBody()
    body.SetInputConnection(cut.GetOutputPort())
    body.SetUnit(0.001)
    body.SetFixed("zmin")
    body.Update()
    return body.GetOutput()


def top(z=HEIGHT):
    plane = vtkPlaneSource()
    plane.SetOrigin(-SIDE / 2, -SIDE / 2, z)
    plane.SetPoint1(SIDE / 2, -SIDE / 2, z)
    plane.SetPoint2(-SIDE / 2, SIDE / 2, z)
    plane.SetResolution(*[int(SIDE / FINE)] * 2)
    plane.Update()
    return plane.GetOutput()


def points(data):
    return [data.GetPoint(i) for i in range(data.GetNumberOfPoints())]


class Shown(unittest.TestCase):
    rest = block()

    def setUp(self):
        vtkOutputWindow.SetInstance(vtkStringOutputWindow())
        self.skin = vtkHapticSoftSkin()
        self.skin.SetInputData(0, top())

    def press(self, x, y, depth):
        """The hand so deep below where the ball touches; the bent body."""
        session = vtkHapticSession()
        session.SetSetting("DeviceName", "fed")
        session.SetSetting("VirtualTime", True)
        session.SetSetting("Stiffness", 500.0)
        session.SetSetting("Scale", 1000.0)
        session.SetSetting("Radius", RADIUS)
        session.SetSetting("SoftRate", RATE)
        session.SetSetting("SoftSource", "block")
        self.assertTrue(session.AddSoftBody("block", self.rest), session.GetProblem())
        session.SetHandPosition(x, y, HEIGHT + RADIUS + 5)
        session.TouchingOn()
        session.Step(TICKS_TO_ENGAGE)
        self.path = [HEIGHT + RADIUS + 5 - 0.05 * i for i in range(int(20 * (depth + 5)) + 1)]
        for z in self.path:
            session.SetHandPosition(x, y, z)
            session.Step(1)
        self.moving = session.GetSoftHandPosition()[2]
        session.Step(300)
        session.Update()
        bent = vtkUnstructuredGrid()
        bent.ShallowCopy(self.rest)
        self.assertTrue(session.BendSoftBody(bent))
        self.session = session
        return bent

    def above_ball(self, data):
        """How far the places of data are outside the ball, the least of it."""
        centre = self.session.GetProxyPosition()
        return min(math.dist(p, centre) for p in points(data)) - RADIUS

    def test_the_surface_comes_as_deep_as_the_ball_is_felt_and_no_place_is_within_it(self):
        for x, y in ((0.0, 0.0), (6.0, 3.0)):  # over a vertex, and within a triangle
            bent = self.press(x, y, 8.0)
            self.assertGreater(self.session.GetForceMagnitude(), 0.1)
            self.skin.SetInputData(1, bent)
            self.skin.Update()
            skin = self.skin.GetOutput()
            lowest = min(points(skin), key=lambda p: p[2])
            felt = self.session.GetProxyPosition()[2] - RADIUS
            self.assertLess(felt, HEIGHT - 1.0)
            centre = self.session.GetProxyPosition()
            aside = math.hypot(lowest[0] - centre[0], lowest[1] - centre[1])
            self.assertLess(aside, FINE)  # it was within FINE / sqrt 2 of the foot, and is pushed straight from the ball's middle
            self.assertAlmostEqual(lowest[2], centre[2] - math.sqrt(RADIUS**2 - aside**2), delta=1e-9)
            self.assertGreaterEqual(self.above_ball(skin), -1e-9)
            self.assertGreaterEqual(self.above_ball(bent), -1e-9)

    def test_over_a_vertex_the_force_on_a_hand_at_rest_is_one_packet_after_packet(self):
        self.press(0.0, 0.0, 12.0)  # four faces meet there, and each snapshot has them tilted by rounding in another way
        felt = []
        for _ in range(20):
            self.session.Step(1000 // RATE)
            self.session.Update()
            felt.append(self.session.GetForceMagnitude())
        self.assertLess(max(felt) - min(felt), 1e-3 * max(felt))
        self.assertLess(math.hypot(*self.session.GetProxyPosition()[0:2]), 1e-3)

    def test_in_motion_the_force_is_the_spring_s_and_what_the_energy_balance_adds(self):
        self.press(0.0, 0.0, 4.0)
        session, spring = self.session, 0.5  # N/mm
        added = []
        for i in range(400):  # further in, out a little, and at rest
            z = self.path[-1] - 0.05 * min(i, 100) + 0.02 * min(max(i - 100, 0), 100)
            session.SetHandPosition(0.0, 0.0, z)
            session.Step(1)
            session.Update()
            stretch = math.dist(session.GetProxyPosition(), (0.0, 0.0, z))
            added.append(session.GetSoftBalanceForce())
            self.assertAlmostEqual(session.GetForceMagnitude(), spring * stretch + added[-1], delta=1e-12)
        self.assertGreater(max(map(abs, added)), 1e-3)
        self.assertEqual(added[-1], 0.0)

    def test_its_stress_has_no_part_of_the_dent_and_the_hand_that_it_was_computed_for_was_there_before(self):
        bent = self.press(0.0, 0.0, 8.0)
        went = max(math.dist(p, q) for p, q in zip(points(bent), points(self.rest)))
        self.assertGreater(went, 1.0)
        self.assertLess(bent.GetPointData().GetArray("Displacement").GetRange(-1)[1], went)  # the nodes have no part of it
        strain = bent.GetCellData().GetArray("Strain").GetRange(-1)[1]
        self.assertLess(strain, 1.5 * self.session.GetSoftStrain())  # Green's strain is |F - 1| for small ones
        behind = round((self.moving - self.path[-1]) / 0.05)  # ticks
        self.assertIn(behind, range(1, 2 * 1000 // RATE + 1))  # at most two periods old
        self.assertAlmostEqual(self.session.GetSoftHandPosition()[2], self.path[-1], delta=1e-9)

    def test_at_rest_nothing_has_gone_anywhere(self):
        self.skin.SetInputData(1, self.rest)
        self.skin.Update()
        self.assertEqual(self.skin.GetOutput().GetPointData().GetArray("Displacement").GetRange(-1), (0.0, 0.0))
        self.assertIn(f"0 of {(int(SIDE / FINE) + 1) ** 2} points are outside", self.skin.GetText())
        self.assertFalse(vtkHapticSoftSkin.IsSkin(self.rest))
        self.assertTrue(vtkHapticSoftSkin.IsSkin(self.skin.GetOutput()))

    def test_how_far_the_tetrahedra_are_from_the_surface_is_said(self):
        above = 2.5
        self.skin.SetInputData(0, top(HEIGHT + above))
        self.skin.SetInputData(1, self.rest)
        self.skin.Update()
        said = re.match(r"(\d+) of \1 points are outside the tetrahedra, within ([\d.]+) u", self.skin.GetText())
        self.assertGreaterEqual(float(said[2]), above)  # a bound: by where it leads to in the tetrahedron that it follows
        self.assertLessEqual(float(said[2]), SIDE / 6)  # of the cells
        ball = vtkSphereSource()
        ball.SetCenter(0, 0, 25)
        ball.SetRadius(20)
        ball.SetThetaResolution(64)
        ball.SetPhiResolution(64)
        ball.Update()
        self.skin.SetInputData(0, ball.GetOutput())
        self.skin.Update()
        more = float(self.skin.GetText().split("tetrahedra is ")[1].split(" %")[0])
        self.assertIn("% above", self.skin.GetText())
        self.assertAlmostEqual(more, 100 * (SIDE**2 * HEIGHT / (4 / 3 * math.pi * 20**3) - 1), delta=0.01 * more)

    def test_what_is_no_body_carries_nothing(self):
        errors = []
        def complain(_object, _event, text):
            errors.append(text)

        complain.CallDataType = VTK_STRING
        self.skin.AddObserver("ErrorEvent", complain)
        for surface, body in ((top(), vtkUnstructuredGrid()), (vtkPolyData(), self.rest)):
            self.skin.SetInputData(0, surface)
            self.skin.SetInputData(1, body)
            self.skin.Update()
            self.assertEqual(unsaid(errors.pop(), "surface", "body"), [])
            self.assertEqual(self.skin.GetText(), "")


if __name__ == "__main__":
    unittest.main()
