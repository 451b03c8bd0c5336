# SPDX-License-Identifier: GPL-3.0-or-later
"""The source Haptic Arm: links that end at the hand, and the points of the work space with condition, force and mass."""

import json
import math
import os
import unittest
from pathlib import Path

from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow

from vtkmodules.vtkFiltersSources import vtkSphereSource

from palpate.vtkHapticPipeline import vtkHapticArm, vtkHapticPlaceInWorkSpace

ARMS = Path(os.environ["PALPATE_SOURCE_DIR"]) / "data" / "arms"


def drawn(arm, hand=(0.0, 0.0, 0.0), scale=1.0):
    source = vtkHapticArm()
    source.SetArm(arm)
    source.SetHand(hand)
    source.SetScale(scale)
    source.Update()
    return source.GetOutputDataObject(0), source.GetOutputDataObject(1)


class Arm(unittest.TestCase):
    def test_the_links_of_every_arm_end_where_the_hand_is(self):
        hand, scale = (0.004, -0.003, 0.0), 50.0
        for file in sorted(ARMS.glob("*.json")):
            with self.subTest(file=file.name):
                centre = json.loads(file.read_text())["work_space"]["centre_m"]
                links, _ = drawn(file.stem, hand, scale)
                tip = [scale * (c + h) for c, h in zip(centre, hand)]
                ends = [links.GetPoint(i) for i in range(links.GetNumberOfPoints())]
                self.assertLess(min(math.dist(p, tip) for p in ends), 1e-9 * scale)
                self.assertGreater(links.GetNumberOfLines(), 0)

    def test_the_work_space_is_a_ball_of_points_with_condition_force_and_mass(self):
        falcon = json.loads((ARMS / "falcon.json").read_text())
        _, space = drawn("falcon")
        self.assertGreater(space.GetNumberOfPoints(), 500)
        centre, radius = falcon["work_space"]["centre_m"], falcon["work_space"]["radius_m"]
        arrays = {name: space.GetPointData().GetArray(name) for name in ("Condition", "LargestForce", "ApparentMass")}
        for i in range(space.GetNumberOfPoints()):
            self.assertLessEqual(math.dist(space.GetPoint(i), centre), radius * (1 + 1e-9))
            self.assertLess(arrays["Condition"].GetValue(i), falcon["max_condition"])
            self.assertGreater(arrays["LargestForce"].GetValue(i), 0.0)
            self.assertGreater(arrays["ApparentMass"].GetValue(i), 0.0)

    def test_data_are_placed_where_the_condition_is_least(self):
        ball = vtkSphereSource()
        ball.SetCenter(5.0, 6.0, 7.0)
        ball.SetRadius(3.0)
        placed = vtkHapticPlaceInWorkSpace()
        placed.SetInputConnection(ball.GetOutputPort())
        placed.SetScale(10.0)
        placed.Update()
        output = placed.GetOutput()
        _, space = drawn("falcon", scale=10.0)
        condition = space.GetPointData().GetArray("Condition")
        nearest = min(range(space.GetNumberOfPoints()), key=lambda i: math.dist(space.GetPoint(i), output.GetCenter()))
        least, most = condition.GetRange()
        self.assertLess(condition.GetValue(nearest), least + 0.1 * (most - least))
        falcon = json.loads((ARMS / "falcon.json").read_text())["work_space"]
        centre = [10.0 * c for c in falcon["centre_m"]]
        for i in range(output.GetNumberOfPoints()):
            self.assertLess(math.dist(output.GetPoint(i), centre), 10.0 * falcon["radius_m"] * 1.2)
        placed.FitOff()
        placed.Update()
        self.assertAlmostEqual(placed.GetOutput().GetLength(), ball.GetOutput().GetLength(), 4)

    def test_a_file_that_is_no_arm_is_named(self):
        window = vtkStringOutputWindow()
        vtkOutputWindow.SetInstance(window)
        source = vtkHapticArm()
        source.SetArm("nowhere.json")
        source.Update()
        self.assertIn("nowhere.json: it cannot be read", window.GetOutput())
        self.assertEqual(source.GetOutput().GetNumberOfPoints(), 0)


if __name__ == "__main__":
    unittest.main()
