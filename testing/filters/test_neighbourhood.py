# SPDX-License-Identifier: GPL-3.0-or-later
"""The part of a surface around a hand: the filter cuts out the polygons that a look at every polygon finds."""

import os
import random
import unittest

from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints
from vtkmodules.vtkFiltersGeneral import vtkRandomAttributeGenerator
from vtkmodules.vtkFiltersSources import vtkSphereSource

from palpate.vtkHapticPipeline import vtkHapticNeighbourhood

SEED = int(os.environ.get("PALPATE_TEST_SEED", "7"))


def corners(surface, cell):
    points = surface.GetCell(cell).GetPoints()
    return [points.GetPoint(i) for i in range(points.GetNumberOfPoints())]


def reaches(places, centre, reach):
    return all(min(p[k] for p in places) <= centre[k] + reach and max(p[k] for p in places) >= centre[k] - reach
               for k in range(3))


def cells_of(surface):
    """Places of the corners, in order, of each polygon."""
    return sorted(tuple(corners(surface, cell)) for cell in range(surface.GetNumberOfCells()))


def expected_cells(surface, centre, reach):
    """Those that reach into the box, and those that share a point with one of them."""
    within = [c for c in range(surface.GetNumberOfCells()) if reaches(corners(surface, c), centre, reach)]
    def points(cell):
        return {surface.GetCell(cell).GetPointId(i) for i in range(surface.GetCell(cell).GetNumberOfPoints())}
    touched = set().union(*(points(c) for c in within)) if within else set()
    return [c for c in range(surface.GetNumberOfCells()) if points(c) & touched]


class Neighbourhood(unittest.TestCase):
    def setUp(self):
        ball, arrays = vtkSphereSource(), vtkRandomAttributeGenerator()
        ball.SetRadius(50)
        ball.SetThetaResolution(40)
        ball.SetPhiResolution(40)
        arrays.SetInputConnection(ball.GetOutputPort())
        arrays.GeneratePointScalarsOn()
        arrays.GenerateCellScalarsOn()
        arrays.Update()
        self.surface = vtkPolyData()
        self.surface.DeepCopy(arrays.GetOutput())
        self.filter = vtkHapticNeighbourhood()
        self.filter.SetInputDataObject(self.surface)
        self.filter.SetLimit(1000)

    def cut(self, centre, reach):
        self.filter.SetCentre(centre)
        self.filter.SetReach(reach)
        self.filter.Update()
        return self.filter.GetOutput()

    def reach(self):
        return self.filter.GetOutput().GetFieldData().GetArray("Palpate part").GetValue(3)

    def test_it_has_all_polygons_that_reach_into_the_box_and_those_beside_them(self):
        generator = random.Random(SEED)
        for _ in range(12):
            centre = [generator.uniform(-40, 40) for _ in range(3)]
            found = self.cut(centre, generator.uniform(2, 20))
            cells = expected_cells(self.surface, centre, self.reach())
            self.assertEqual(cells_of(found), sorted(tuple(corners(self.surface, c)) for c in cells), (SEED, centre))
            self.assertGreater(found.GetNumberOfCells(), 0)

    def test_a_polygon_much_larger_than_a_bin_is_found_wherever_the_hand_is_on_it(self):
        points, polygon = vtkPoints(), vtkIdList()
        for i in range(self.surface.GetNumberOfPoints()):
            points.InsertNextPoint(self.surface.GetPoint(i))
        for place in ((-500, -500, 60), (500, -500, 60), (0, 500, 60)):
            polygon.InsertNextId(points.InsertNextPoint(place))
        cells = vtkCellArray()
        cells.DeepCopy(self.surface.GetPolys())
        cells.InsertNextCell(polygon)
        large = vtkPolyData()
        large.SetPoints(points)
        large.SetPolys(cells)
        self.filter.SetInputDataObject(large)
        for centre in ((-400, -450, 61), (300, -400, 59), (0, 400, 60)):
            self.assertEqual(self.cut(centre, 5.0).GetNumberOfCells(), 1, centre)

    def test_values_of_points_and_polygons_come_along(self):
        self.cut((0, 0, 50), 10)
        part = self.filter.GetOutput()
        names = {self.surface.GetPoint(i): self.surface.GetPointData().GetScalars().GetValue(i)
                 for i in range(self.surface.GetNumberOfPoints())}
        for i in range(part.GetNumberOfPoints()):
            self.assertEqual(part.GetPointData().GetScalars().GetValue(i), names[part.GetPoint(i)])
        of_cells = {tuple(corners(self.surface, c)): self.surface.GetCellData().GetScalars().GetValue(c)
                    for c in range(self.surface.GetNumberOfCells())}
        for c in range(part.GetNumberOfCells()):
            self.assertEqual(part.GetCellData().GetScalars().GetValue(c), of_cells[tuple(corners(part, c))])

    def test_up_to_the_limit_it_is_whole_and_beyond_it_no_more_than_the_limit_comes(self):
        cells = self.surface.GetNumberOfCells()
        self.filter.SetLimit(cells)
        self.assertEqual(self.cut((0, 0, 50), 1).GetNumberOfCells(), cells)
        for limit in (200, 50):
            self.filter.SetLimit(limit)
            self.cut((0, 0, 50), 1000.0)
            within = [c for c in range(cells) if reaches(corners(self.surface, c), (0, 0, 50), self.reach())]
            self.assertLessEqual(len(within), limit)
            self.assertGreater(len(within), limit // 8)

    def test_far_from_everything_it_reaches_until_something_is_there(self):
        self.assertGreater(self.cut((1e6, 0, 0), 1.0).GetNumberOfCells(), 0)
        self.assertLessEqual(self.reach(), 2e6)

    def test_an_empty_surface_gives_an_empty_part(self):
        self.filter.SetInputDataObject(vtkPolyData())
        self.assertEqual(self.cut((0, 0, 0), 1.0).GetNumberOfCells(), 0)


if __name__ == "__main__":
    unittest.main()
