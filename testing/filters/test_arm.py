# SPDX-License-Identifier: GPL-3.0-or-later
"""The source Haptic Arm: links that end at the hand, and the points of the work space with condition, force and mass."""

import json
import math
import os
import unittest
from pathlib import Path

from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow
from vtkmodules.vtkCommonMath import vtkMatrix4x4
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


def points_of(links):
    return [links.GetPoint(i) for i in range(links.GetNumberOfPoints())]


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

    def following(self, arm, hand, turn=(1.0, 0.0, 0.0, 0.0)):
        """A source that was shown a hand: a quarter turn about z, 200 u/m, the middle of the work space at (5, 6, 7)."""
        source = vtkHapticArm()
        source.SetArm(arm)
        source.FollowHandOn()
        source.Update()
        self.show(source, hand, turn)
        return source

    def show(self, source, hand, turn=(1.0, 0.0, 0.0, 0.0)):
        to_scene = vtkMatrix4x4()
        to_scene.DeepCopy((0, -200, 0, 5, 200, 0, 0, 6, 0, 0, 200, 7, 0, 0, 0, 1))
        shown = source.ShowHand(hand, turn, to_scene)
        source.Update()
        return shown

    def test_an_arm_that_follows_ends_at_the_hand_in_the_scene_with_links_of_their_lengths(self):
        wooden = json.loads((ARMS / "woodenhaptics-2015.json").read_text())
        source = self.following("woodenhaptics-2015", (0.01, -0.02, 0.015))
        points = points_of(source.GetOutputDataObject(0))
        for got, wanted in zip(points[-1], (5 + 200 * 0.02, 6 + 200 * 0.01, 7 + 200 * 0.015)):
            self.assertAlmostEqual(got, wanted, delta=1e-11)
        for length, (a, b) in zip((wooden["column_m"], wooden["upper_m"], wooden["fore_m"]), zip(points, points[1:])):
            self.assertAlmostEqual(math.dist(a, b), 200 * length, delta=1e-11)
        # The middle of the work space is where the map puts the middle.
        space = source.GetOutputDataObject(1)
        _, typed = drawn("woodenhaptics-2015")
        centre = wooden["work_space"]["centre_m"]
        x, y, z = (p - c for p, c in zip(typed.GetPoint(0), centre))
        self.assertLess(math.dist(space.GetPoint(0), (5 - 200 * y, 6 + 200 * x, 7 + 200 * z)), 1e-11)

    def test_a_hand_out_of_reach_leaves_the_links_and_is_said_once(self):
        window = vtkStringOutputWindow()
        vtkOutputWindow.SetInstance(window)
        source = self.following("falcon", (0.01, 0.0, 0.0))
        before = points_of(source.GetOutputDataObject(0))
        for far in (0.5, 0.6, 0.7):
            self.assertTrue(self.show(source, (far, 0.0, 0.0)))
            self.assertEqual(points_of(source.GetOutputDataObject(0)), before)
        self.assertEqual(window.GetOutput().count("out of the arm's reach"), 1)
        self.assertFalse(self.show(source, (0.7, 0.0, 0.0)), "the same hand is no other picture")
        self.assertTrue(source.ShowTyped())
        source.Update()
        links, _ = drawn("falcon")
        self.assertEqual(points_of(source.GetOutputDataObject(0)), points_of(links))
        self.show(source, (0.5, 0.0, 0.0))
        self.assertEqual(window.GetOutput().count("out of the arm's reach"), 2, "the next touch says it again")
        self.assertLess(math.dist(points_of(source.GetOutputDataObject(0))[-1], (5, 6, 7)), 1e-11)

    def test_without_follow_hand_the_typed_hand_counts(self):
        source = self.following("falcon", (0.01, 0.0, 0.0))
        source.FollowHandOff()
        source.Update()
        links, _ = drawn("falcon")
        self.assertEqual(points_of(source.GetOutputDataObject(0)), points_of(links))

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
