# SPDX-License-Identifier: GPL-3.0-or-later
"""The arrays of a soft body in a session are data: Displacement is the finite elements' at the node, Strain and Stress are the cell's, and
what is drawn further, where something presses, is Dent."""

import math
import unittest

from palpate.vtkHapticInteraction import vtkHapticSession
from palpate.vtkHapticPipeline import vtkHapticSoftBody, vtkHapticSoftSkin
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkOutputWindow, vtkStringOutputWindow
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkUnstructuredGrid
from vtkmodules.vtkFiltersGeneral import vtkDataSetTriangleFilter
from vtkmodules.vtkFiltersSources import vtkPlaneSource

CELL, CELLS = 16.0, (4, 4, 4)  # mm; powers of two are exact in single precision too
SIDE, HEIGHT = CELL * CELLS[0], CELL * CELLS[2]
UNIT = 0.001  # m
YOUNG = 20e3  # Pa
STRAIN = 0.1
RADIUS = 10.0  # mm


def tetrahedra():
    image = vtkImageData()
    image.SetDimensions(*[n + 1 for n in CELLS])
    image.SetSpacing(CELL, CELL, CELL)
    cut = vtkDataSetTriangleFilter()
    cut.SetInputData(image)
    cut.Update()
    return cut.GetOutput()


def pull(block, stress):
    """A point array: the traction on the top, a third of each triangle's on each corner [N]."""
    load = [0.0] * block.GetNumberOfPoints()
    for i in range(block.GetNumberOfCells()):
        ids = block.GetCell(i).GetPointIds()
        top = [ids.GetId(k) for k in range(4) if block.GetPoint(ids.GetId(k))[2] == HEIGHT]
        if len(top) == 3:  # half a square
            for v in top:
                load[v] += stress * 0.5 * CELL**2 * UNIT**2 / 3
    array = vtkDoubleArray()
    array.SetName("pull")
    array.SetNumberOfComponents(3)
    for newton in load:
        array.InsertNextTuple3(0, 0, newton)
    block.GetPointData().AddArray(array)


def moduli(block, upper):
    array = vtkDoubleArray()
    array.SetName("E")
    for i in range(block.GetNumberOfCells()):
        points = block.GetCell(i).GetPoints()
        array.InsertNextValue(YOUNG if sum(points.GetPoint(k)[2] for k in range(4)) < 2 * HEIGHT else upper)
    block.GetCellData().AddArray(array)


def tuples(array):
    return [array.GetTuple(i) for i in range(array.GetNumberOfTuples())]


class Arrays(unittest.TestCase):
    def setUp(self):
        vtkOutputWindow.SetInstance(vtkStringOutputWindow())

    def body(self, block, **settings):
        self.filter = vtkHapticSoftBody()
        self.filter.SetInputData(block)
        self.filter.SetUnit(UNIT)
        self.filter.SetFixed("zmin")
        for name, value in settings.items():
            getattr(self.filter, "Set" + name)(value)
        self.filter.Update()
        return self.filter.GetOutput()

    def bent(self, rest, depth=None):
        """As a session shows it, with the hand far above, or so deep below where the ball touches the top's middle."""
        session = vtkHapticSession()
        session.SetSetting("DeviceName", "fed")
        session.SetSetting("VirtualTime", True)
        session.SetSetting("Stiffness", 500.0)
        session.SetSetting("Scale", 1000.0)
        session.SetSetting("Radius", RADIUS)
        session.SetSetting("SoftRate", 20)
        session.SetSetting("SoftSource", "block")
        self.assertTrue(session.AddSoftBody("block", rest), session.GetProblem())
        above = HEIGHT + 5 * RADIUS
        session.SetHandPosition(SIDE / 2, SIDE / 2, above)
        session.TouchingOn()
        session.Step(1100)
        for i in range(200 if depth else 0):
            session.SetHandPosition(SIDE / 2, SIDE / 2, above + (HEIGHT + RADIUS - depth - above) * (i + 1) / 200)
            session.Step(1)
        session.Step(300)
        session.Update()
        shown = vtkUnstructuredGrid()
        shown.ShallowCopy(rest)
        self.assertTrue(session.BendSoftBody(shown))
        self.session = session
        return shown

    def judge(self, shown, rest, gone):
        """Each node has gone as `gone` says of its height, and is drawn there."""
        for i, moved in enumerate(tuples(shown.GetPointData().GetArray("Displacement"))):
            at, now = rest.GetPoint(i), shown.GetPoint(i)
            self.assertLess(math.dist(moved, (0, 0, gone(at[2]))), 1e-12 * gone(HEIGHT))
            self.assertLess(math.dist(now, (at[0], at[1], at[2] + gone(at[2]))), 1e-15 * HEIGHT + 1e-12 * gone(HEIGHT))
        self.assertEqual(shown.GetPointData().GetArray("Dent").GetMaxNorm(), 0.0)

    def test_a_block_in_pure_tension_has_its_exact_displacement_strain_and_stress_everywhere(self):
        block = tetrahedra()
        pull(block, STRAIN * YOUNG)
        rest = self.body(block, Young=YOUNG, Poisson=0.0, Model=vtkHapticSoftBody.Linear, LoadArray="pull")
        shown = self.bent(rest)
        self.judge(shown, rest, lambda z: STRAIN * z)
        green = STRAIN + STRAIN**2 / 2
        for strain, stress in zip(tuples(shown.GetCellData().GetArray("Strain")), tuples(shown.GetCellData().GetArray("Stress"))):
            self.assertLess(math.dist(strain, (0, 0, green, 0, 0, 0)), 1e-12)
            self.assertLess(math.dist(stress, (0, 0, STRAIN * YOUNG, 0, 0, 0)), 1e-12 * YOUNG)
        plane = vtkPlaneSource()
        plane.SetOrigin(0, 0, HEIGHT)
        plane.SetPoint1(SIDE, 0, HEIGHT)
        plane.SetPoint2(0, SIDE, HEIGHT)
        plane.SetResolution(9, 9)
        plane.Update()
        skin = vtkHapticSoftSkin()
        skin.SetInputData(0, plane.GetOutput())
        skin.SetInputData(1, shown)
        skin.Update()
        for moved in tuples(skin.GetOutput().GetPointData().GetArray("Displacement")):
            self.assertLess(math.dist(moved, (0, 0, STRAIN * HEIGHT)), 1e-11 * HEIGHT)
        self.assertEqual(skin.GetOutput().GetPointData().GetArray("Dent").GetMaxNorm(), 0.0)

    def test_two_layers_of_one_to_ten_bear_one_stress_and_are_strained_one_to_ten(self):
        block = tetrahedra()
        pull(block, STRAIN * YOUNG)
        moduli(block, 10 * YOUNG)
        rest = self.body(block, YoungArray="E", Poisson=0.0, Model=vtkHapticSoftBody.Linear, LoadArray="pull")
        shown = self.bent(rest)
        self.judge(shown, rest, lambda z: STRAIN * (min(z, HEIGHT / 2) + max(z - HEIGHT / 2, 0) / 10))
        young = shown.GetCellData().GetArray("Young")
        for i, stress in enumerate(tuples(shown.GetCellData().GetArray("Stress"))):
            self.assertLess(math.dist(stress, (0, 0, STRAIN * YOUNG, 0, 0, 0)), 1e-11 * YOUNG)
            small = STRAIN * YOUNG / young.GetTuple1(i)
            self.assertAlmostEqual(shown.GetCellData().GetArray("Strain").GetTuple(i)[2], small + small**2 / 2, delta=1e-12)

    def test_where_a_ball_presses_what_is_drawn_further_than_the_node_went_is_on_the_ball(self):
        rest = self.body(tetrahedra())
        shown = self.bent(rest, 6.0)
        centre = self.session.GetProxyPosition()
        dented = 0
        for i, (moved, dent) in enumerate(zip(tuples(shown.GetPointData().GetArray("Displacement")), tuples(shown.GetPointData().GetArray("Dent")))):
            at, now = rest.GetPoint(i), shown.GetPoint(i)
            self.assertLess(math.dist(now, [a + m + d for a, m, d in zip(at, moved, dent)]), 1e-12 * HEIGHT)
            if math.hypot(*dent) > 0:
                dented += 1
                self.assertAlmostEqual(math.dist(now, centre), RADIUS, delta=1e-9)
                self.assertLess(math.dist([a + m for a, m in zip(at, moved)], centre), RADIUS)
            if at[2] == 0:
                self.assertEqual(moved, (0, 0, 0))
        self.assertGreater(dented, 0)
        self.assertLess(shown.GetPointData().GetArray("Displacement").GetRange(2)[0], -0.1)


if __name__ == "__main__":
    unittest.main()
