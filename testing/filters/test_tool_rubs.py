# SPDX-License-Identifier: GPL-3.0-or-later
"""Touch Along Path with a tool: it has the friction FrictionKinetic, as the filter's pages say, and feels no material from data."""

import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkPlaneSource

from palpate.testing.feel import Refused, updated
from palpate.vtkHapticPipeline import vtkTouchAlongPath

SIDE, DEPTH, STIFFNESS_N_PER_M = 2.0, 0.2, 400.0
FELT = 0.07  # of a force, the difference that a hand tells apart (docs/theory.md, "What a hand tells apart")
WITHIN_N = 1e-5 * STIFFNESS_N_PER_M * SIDE  # a tool keeps a gap of some millionths of its size


def slide(**settings):
    """Forces on a hand that presses a cube on a floor and slides it along x, without the path down (n, 3)."""
    floor, cube, touch = vtkPlaneSource(), vtkCubeSource(), vtkTouchAlongPath()
    way, places = vtkPolyData(), vtkPoints()
    floor.SetOrigin(-20, -20, 0)
    floor.SetPoint1(20, -20, 0)
    floor.SetPoint2(-20, 20, 0)
    for axis in "XYZ":
        getattr(cube, f"Set{axis}Length")(SIDE)
    cube.Update()
    for place in [(0.3, 0.2, SIDE), *((0.3 + 0.05 * i, 0.2, SIDE / 2 - DEPTH) for i in range(40))]:
        places.InsertNextPoint(place)
    way.SetPoints(places)
    touch.SetInputConnection(floor.GetOutputPort())
    touch.SetPathData(way)
    touch.SetToolData(cube.GetOutput())
    touch.SetSetting("Stiffness", STIFFNESS_N_PER_M)
    for name, value in settings.items():
        touch.SetSetting(name, value)
    return vtk_to_numpy(updated(touch).GetPointData().GetArray("Force"))[1:]


class Rubbing(unittest.TestCase):
    def test_a_cube_that_slides_is_held_back_by_its_friction(self):
        for friction in (0.0, 0.1, 0.4):
            force = slide(FrictionStatic=friction, FrictionKinetic=friction)[-5:]  # by then it slides
            np.testing.assert_allclose(force[:, 2], STIFFNESS_N_PER_M * DEPTH, rtol=1e-3)
            self.assertTrue((-force[:, 0] <= friction * force[:, 2] + WITHIN_N).all(), "it is in the cone")
            self.assertTrue((-force[:, 0] >= (1 - FELT) * friction * force[:, 2] - WITHIN_N).all(), "a hand feels no less")

    def test_more_friction_than_one_and_material_from_data_are_refused(self):
        for settings, said in (({"FrictionStatic": 2, "FrictionKinetic": 1.5}, "from 0 to 1"), ({"StiffnessArray": "density"}, "has no effect on a tool")):
            with self.assertRaises(Refused) as refused:
                slide(**settings)
            self.assertIn(said, str(refused.exception))


if __name__ == "__main__":
    unittest.main(verbosity=2)
