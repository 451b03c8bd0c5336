# SPDX-License-Identifier: GPL-3.0-or-later
"""The filter Soft Body: bodies of tetrahedra, a closed surface and a label image, refusals, and the force along a path."""

import math
import unittest

from palpate.vtkHapticPipeline import vtkHapticSoftBody, vtkTouchAlongPath
from vtkmodules.vtkCommonCore import VTK_STRING, vtkDoubleArray, vtkOutputWindow, vtkPoints, vtkStringOutputWindow
from vtkmodules.vtkCommonDataModel import VTK_TETRA, vtkCellArray, vtkImageData, vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkFiltersGeneral import vtkDataSetTriangleFilter
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource

SIDE = 0.1  # m


def hexahedra(cells=4):
    """A block of voxels of SIDE x SIDE x SIDE / 2 on z = 0."""
    image = vtkImageData()
    image.SetDimensions(cells + 1, cells + 1, cells // 2 + 1)
    image.SetSpacing(*[SIDE / cells] * 3)
    return image


def tetrahedra(cells=4):
    cut = vtkDataSetTriangleFilter()
    cut.SetInputData(hexahedra(cells))
    cut.Update()
    return cut.GetOutput()


TWO = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1)]  # of two tetrahedra that share a face


def corners(points, cells):
    """Tetrahedra by their corners."""
    grid, at = vtkUnstructuredGrid(), vtkPoints()
    at.SetDataTypeToDouble()
    for point in points:
        at.InsertNextPoint(point)
    grid.SetPoints(at)
    for cell in cells:
        grid.InsertNextCell(VTK_TETRA, 4, cell)
    return grid


def sphere(radius=10.0):
    source = vtkSphereSource()
    source.SetRadius(radius)
    source.SetThetaResolution(24)
    source.SetPhiResolution(24)
    source.Update()
    return source.GetOutput()


def path(points):
    data, at, cell = vtkPolyData(), vtkPoints(), vtkCellArray()
    at.SetDataTypeToDouble()
    cell.InsertNextCell(len(points))
    for point in points:
        cell.InsertCellPoint(at.InsertNextPoint(point))
    data.SetPoints(at)
    data.SetLines(cell)
    return data


def volume(grid):
    total = 0.0
    for i in range(grid.GetNumberOfCells()):
        a, b, c, d = (grid.GetCell(i).GetPoints().GetPoint(k) for k in range(4))
        u, v, w = ([q[k] - a[k] for k in range(3)] for q in (b, c, d))
        total += abs(u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) + u[2] * (v[0] * w[1] - v[1] * w[0])) / 6
    return total


class SoftBody(unittest.TestCase):
    def setUp(self):
        vtkOutputWindow.SetInstance(vtkStringOutputWindow())  # refusals are not printed

    def make(self, data, fixed="zmin", held=None, **settings):
        """The output, and the errors."""
        body, errors = vtkHapticSoftBody(), []
        def complain(_object, _event, text):
            errors.append(text)

        complain.CallDataType = VTK_STRING
        body.AddObserver("ErrorEvent", complain)
        body.SetInputData(data)
        body.SetFixed(fixed)
        if held:
            body.SetInputData(1, held)
        for name, value in settings.items():
            getattr(body, "Set" + name)(value)
        body.Update()
        self.body = body
        return body.GetOutput(), errors

    def fixed(self, grid):
        array = grid.GetPointData().GetArray("Fixed")
        return [i for i in range(array.GetNumberOfTuples()) if array.GetTuple1(i)]

    def test_tetrahedra_stay_and_have_their_material(self):
        block = tetrahedra()
        grid, errors = self.make(block, Young=5000.0, Unit=1.0)
        self.assertFalse(errors)
        self.assertEqual(grid.GetNumberOfCells(), block.GetNumberOfCells())
        self.assertEqual(grid.GetCellData().GetArray("Young").GetRange(), (5000.0, 5000.0))
        self.assertEqual(grid.GetPointData().GetArray("Displacement").GetRange(-1), (0.0, 0.0))
        self.assertLess(grid.GetCellData().GetArray("Stress").GetRange(-1)[1], 1e-12 * 5000.0)
        self.assertEqual([grid.GetPoint(i)[2] for i in self.fixed(grid)], [0.0] * 25)
        self.assertIn("5000 Pa,", self.body.GetText())
        self.assertIn("0.4 (assumed)", self.body.GetText())

    def test_a_modulus_comes_from_an_array_and_what_touches_the_body_holds_it(self):
        block, young = tetrahedra(), vtkDoubleArray()
        young.SetName("E")
        for i in range(block.GetNumberOfCells()):
            young.InsertNextValue(1000.0 + i)
        block.GetCellData().AddArray(young)
        plane = vtkPlaneSource()
        plane.SetOrigin(-1, -1, SIDE / 2)
        plane.SetPoint1(1, -1, SIDE / 2)
        plane.SetPoint2(-1, 1, SIDE / 2)
        plane.Update()
        grid, errors = self.make(block, "", plane.GetOutput(), YoungArray="E")
        self.assertFalse(errors)
        self.assertEqual(grid.GetCellData().GetArray("Young").GetRange(), (1000.0, 999.0 + block.GetNumberOfCells()))
        self.assertEqual(len(self.fixed(grid)), 25)
        self.assertTrue(all(abs(grid.GetPoint(i)[2] - SIDE / 2) < 1e-6 for i in self.fixed(grid)))

    def test_what_a_body_is_held_by_is_its_own_and_an_array_of_that_name_is_read(self):
        first, errors = self.make(tetrahedra())
        self.assertFalse(errors)
        second, errors = self.make(first, "zmax")
        self.assertFalse(errors)
        self.assertEqual((len(self.fixed(first)), len(self.fixed(second))), (25, 50))
        block, fixed = tetrahedra(), vtkDoubleArray()
        fixed.SetName("Fixed")
        for i in range(block.GetNumberOfPoints()):
            fixed.InsertNextValue(1.0 if block.GetPoint(i)[0] == 0.0 else 0.0)
        block.GetPointData().AddArray(fixed)
        grid, errors = self.make(block, "Fixed")
        self.assertFalse(errors)
        self.assertEqual({grid.GetPoint(i)[0] for i in self.fixed(grid)}, {0.0})

    def test_a_closed_surface_is_filled(self):
        grid, errors = self.make(sphere(), "", sphere(3.0), FixedDistance=3.0, EdgeLength=4.0, SurfaceDistance=0.5)
        self.assertFalse(errors)
        self.assertAlmostEqual(volume(grid) / (4 / 3 * math.pi * 1000), 1.0, delta=0.1)
        self.assertTrue(self.fixed(grid))
        self.assertIn("within", self.body.GetText())

    def test_each_label_of_an_image_is_filled(self):
        image, labels = vtkImageData(), vtkDoubleArray()
        image.SetDimensions(20, 20, 20)
        for z in range(20):
            for y in range(20):
                for x in range(20):
                    inside = 3 <= x < 17 and 3 <= y < 17 and 3 <= z < 17
                    labels.InsertNextValue(0.0 if not inside else 7.0 if z < 10 else 9.0)
        image.GetPointData().SetScalars(labels)
        grid, errors = self.make(image, EdgeLength=5.0, SurfaceDistance=0.7)
        self.assertFalse(errors)
        self.assertEqual(grid.GetCellData().GetArray("Label").GetRange(), (7.0, 9.0))
        self.assertAlmostEqual(volume(grid) / 14**3, 1.0, delta=0.1)

    def test_what_is_no_body_is_an_error_and_leaves_nothing(self):
        nothing = vtkImageData()
        nothing.SetDimensions(5, 5, 5)
        zeros = vtkDoubleArray()
        zeros.SetNumberOfTuples(125)
        zeros.Fill(0.0)
        nothing.GetPointData().SetScalars(zeros)
        sheet = vtkPlaneSource()
        sheet.Update()
        holed = sphere()
        holed.BuildLinks()
        holed.DeleteCell(7)
        holed.RemoveDeletedCells()
        for data, settings, words in (
                (tetrahedra(), {"Young": 0.0}, "from 10 Pa"), (tetrahedra(), {"Young": -5.0}, "from 10 Pa"),
                (tetrahedra(), {"Young": math.nan}, "from 10 Pa"), (tetrahedra(), {"Young": 1e12}, "below 1e12"),
                (tetrahedra(), {"Poisson": 0.5}, "below 0.5"), (tetrahedra(), {"Poisson": 0.6}, "below 0.5"),
                (tetrahedra(), {"fixed": ""}, "fixed"), (tetrahedra(), {"fixed": "top"}, "'top'"),
                (tetrahedra(), {"YoungArray": "E"}, "'E'"), (nothing, {}, "has no labels"), (sheet.GetOutput(), {}, "has holes"),
                (holed, {}, "has holes"), (sphere(), {"EdgeLength": -1.0}, "0 or above"),
                (sphere(), {"EdgeLength": 0.01}, "use a longer edge"), (corners([*TWO[:4], (0.2, 0.2, 0.4)], ((0, 1, 2, 3), (0, 1, 2, 4))), {}, "mesh the body again")):
            grid, errors = self.make(data, **settings)
            self.assertEqual(len(errors), 1, settings)
            self.assertIn(words, errors[0])
            self.assertEqual(grid.GetNumberOfCells(), 0, settings)

    def test_what_is_left_out_of_a_body_is_said(self):
        far = [(x + 9, y, z + 9) for x, y, z in TWO[:4]]
        flat = (0, 1, 2, 5)  # in the plane z = 0
        grid, errors = self.make(corners([*TWO, (1, 1, 0), *far], ((0, 1, 2, 3), (3, 2, 1, 0), (2, 1, 3, 4), flat, (6, 7, 8, 9))))
        self.assertFalse(errors)
        self.assertEqual(grid.GetNumberOfCells(), 5)
        self.assertIn("tetrahedra: 1 with reversed orientation, 1 without volume removed, 1 duplicated, removed, 1 without connection to a fixed vertex removed",
                      self.body.GetText())

    def test_its_weight_and_loads_of_points_are_borne_by_its_corners(self):
        def borne(grid):
            load = grid.GetPointData().GetArray("Load")
            return [sum(load.GetTuple3(i)[axis] for i in range(load.GetNumberOfTuples())) for axis in range(3)] if load else None

        grid, _ = self.make(tetrahedra(), Gravity=(0, 0, -9.81), Density=900.0)
        weight = 900 * 9.81 * SIDE**3 / 2
        for got, expected in zip(borne(grid), (0, 0, -weight)):
            self.assertAlmostEqual(got, expected, delta=1e-6 * weight)  # its points are of single precision
        self.assertIn(f"total load {weight:.5g} N", self.body.GetText())
        block, pull = tetrahedra(), vtkDoubleArray()
        pull.SetName("pull")
        pull.SetNumberOfComponents(3)
        for i in range(block.GetNumberOfPoints()):
            pull.InsertNextTuple3(0.25 if i == 40 else 0.0, 0, 0)
        block.GetPointData().AddArray(pull)
        grid, errors = self.make(block, LoadArray="pull")
        self.assertFalse(errors)
        self.assertEqual(borne(grid), [0.25, 0, 0])
        grid, _ = self.make(grid)  # the load of one body is not that of a body made of it
        self.assertIsNone(borne(grid))
        for settings, words in (({"LoadArray": "none"}, "'none'"), ({"Gravity": (0, math.nan, 0)}, "gravity"),
                                ({"Gravity": (0, 0, 1), "Density": 0.0}, "density")):
            grid, errors = self.make(tetrahedra(), **settings)
            self.assertIn(words, errors[0])
            self.assertEqual(grid.GetNumberOfCells(), 0)

    def test_moduli_that_differ_by_ten_powers_of_ten_are_pressed_or_refused_in_words(self):
        block, young = tetrahedra(), vtkDoubleArray()
        young.SetName("E")
        for i in range(block.GetNumberOfCells()):
            young.InsertNextValue(10.0 if i % 2 else 0.9e11)
        block.GetCellData().AddArray(young)
        grid, errors = self.make(block, YoungArray="E")
        self.assertFalse(errors)
        touch, said = vtkTouchAlongPath(), []
        def complain(_object, _event, text):
            said.append(text)

        complain.CallDataType = VTK_STRING
        touch.AddObserver("ErrorEvent", complain)
        touch.SetInputData(grid)
        touch.SetPathData(path([(0.05, 0.05, 0.062 - 0.0001 * min(i, 60)) for i in range(120)]))
        touch.SetSetting("Radius", 0.01)
        touch.Update()
        force = touch.GetOutput().GetPointData().GetArray("Force")
        felt = [force.GetTuple(i) for i in range(force.GetNumberOfTuples())] if force else []
        self.assertTrue(any("matrix is singular" in text for text in said) or
                        (felt and all(math.isfinite(n) for row in felt for n in row) and felt[-1][2] > 0), (said, felt[-1:]))

    def test_along_a_path_it_gives_way_as_its_packets_say(self):
        grid, _ = self.make(tetrahedra(), Model=vtkHapticSoftBody.Linear)
        forces = {}
        for rate in (0.0, 30.0):
            touch = vtkTouchAlongPath()
            touch.SetInputData(grid)
            touch.SetPathData(path([(0.05, 0.05, 0.062 - 0.0001 * min(i, 60)) for i in range(120)]))
            touch.SetSetting("Radius", 0.01)
            touch.SetSetting("SoftRate", rate)
            touch.Update()
            forces[rate] = touch.GetOutput().GetPointData().GetArray("Force").GetTuple(119)[2]
        depth = 0.004
        self.assertLess(forces[0.0], 0.5 * 1000 * depth)  # of a rigid one
        self.assertGreater(forces[0.0], 0.05 * 1000 * depth)
        self.assertAlmostEqual(forces[30.0], forces[0.0], delta=1e-6 * forces[0.0])


if __name__ == "__main__":
    unittest.main()
