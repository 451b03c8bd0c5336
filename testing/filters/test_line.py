# SPDX-License-Identifier: GPL-3.0-or-later
"""A value along a path is felt by turning, from Python: forces by formula, refusals by name."""

import math
import unittest

from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkOutputWindow, vtkPoints, vtkStringOutputWindow
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

from palpate.vtkHapticInteraction import vtkHapticLine


def path(points, values):
    where, lines, data, array = vtkPoints(), vtkCellArray(), vtkPolyData(), vtkDoubleArray()
    array.SetName("height")
    for point, value in zip(points, values):
        where.InsertNextPoint(point)
        array.InsertNextValue(value)
    lines.InsertNextCell(len(points), list(range(len(points))))
    data.SetPoints(where)
    data.SetLines(lines)
    data.GetPointData().AddArray(array)
    return data


class Line(unittest.TestCase):
    def setUp(self):
        vtkOutputWindow.SetInstance(vtkStringOutputWindow())  # refusals are not printed
        self.line = vtkHapticLine()
        self.line.VirtualTimeOn()

    def test_a_hand_rests_where_its_spring_and_the_slope_balance(self):
        # 40 mm to the right at 1000 units a metre, round a corner; the second half rises twice as steeply.
        self.assertTrue(self.line.SetPath(path([(0, 0, 0), (20, 0, 0), (20, 20, 0)], [0, 1, 3]), "height", 1000.0))
        self.line.SetHardestForce(0.4)
        self.assertAlmostEqual(self.line.GetForceAt(0.01), -0.4)
        self.assertAlmostEqual(self.line.GetForceAt(-0.01), -0.2)
        self.line.SetHandPosition(0.01)
        self.assertTrue(self.line.Start(), self.line.GetProblem())
        self.line.Step(500)
        self.assertEqual(self.line.GetForce(), 0.0)  # nobody has engaged
        self.line.Engage()
        self.line.Step(2000)
        self.assertAlmostEqual(self.line.GetForce(), -0.4)
        self.line.Stop()
        self.assertFalse(self.line.GetRunning())

    def test_bad_input_is_named(self):
        self.assertFalse(self.line.Start())
        self.assertIn("two positions", self.line.GetProblem())
        self.assertTrue(math.isnan(self.line.GetForceAt(0.0)))
        self.assertFalse(self.line.SetPath(path([(0, 0, 0), (1, 0, 0)], [0, 1]), "depth", 1000.0))
        self.assertIn("array", self.line.GetProblem())
        self.line.AddPlace(-0.01, 0.0)
        self.line.AddPlace(0.01, 1.0)
        self.line.SetDeviceName("abacus")
        self.assertFalse(self.line.Start())
        self.assertIn("abacus", self.line.GetProblem())


if __name__ == "__main__":
    unittest.main()
