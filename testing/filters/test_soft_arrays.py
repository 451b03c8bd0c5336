# SPDX-License-Identifier: GPL-3.0-or-later
"""The arrays of a soft body in a session are data: Displacement is the finite elements' at the node, Strain and Stress are the
cell's, and the further displacement in the picture, where something presses, is Dent."""

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


def tetrahedra(cells=CELLS, cell=CELL):
    image = vtkImageData()
    image.SetDimensions(*[n + 1 for n in cells])
    image.SetSpacing(cell, cell, cell)
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


def bend(bar, length, force):
    """A point array: a force along z across the end of the bar, an even traction, a third of each triangle's on each corner [N]."""
    array = vtkDoubleArray()
    array.SetName("bend")
    array.SetNumberOfComponents(3)
    ends = [[i for i in map(bar.GetCell(c).GetPointIds().GetId, range(4)) if bar.GetPoint(i)[0] == length]
            for c in range(bar.GetNumberOfCells())]
    corners = [i for end in ends if len(end) == 3 for i in end]  # of triangles of one size
    for v in range(bar.GetNumberOfPoints()):
        array.InsertNextTuple3(0, 0, force * corners.count(v) / len(corners))
    bar.GetPointData().AddArray(array)


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
    fixed = "zmin"

    def setUp(self):
        vtkOutputWindow.SetInstance(vtkStringOutputWindow())

    def body(self, block, **settings):
        self.filter = vtkHapticSoftBody()
        self.filter.SetInputData(block)
        self.filter.SetUnit(UNIT)
        self.filter.SetFixed(self.fixed)
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

    def test_a_cantilever_as_tetrahedralize_cuts_it_has_the_stress_of_a_beam(self):
        side, length, force = 20.0, 100.0, 1e-3  # mm, mm, N; four cells across
        moment = side**4 / 12 * UNIT**4
        for poisson in (0.3, 0.4, 0.45, 0.49):
            bar = tetrahedra((20, 4, 4), side / 4)
            bend(bar, length, force)
            self.fixed = "xmin"
            rest = self.body(bar, Young=YOUNG, Poisson=poisson, Model=vtkHapticSoftBody.Linear, LoadArray="bend")
            shown = self.bent(rest)
            off = along = 0.0
            for i, stress in enumerate(tuples(shown.GetCellData().GetArray("Stress"))):
                points = rest.GetCell(i).GetPoints()
                x, _, z = (sum(points.GetPoint(k)[axis] for k in range(4)) / 4 for axis in range(3))
                if side < x < length - side:  # Saint-Venant's away from the ends
                    exact = force * (length - x) * (side / 2 - z) * UNIT**2 / moment
                    off, along = off + (stress[0] - exact)**2, along + exact**2
            self.assertLess(math.sqrt(off / along), 0.02, poisson)

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
