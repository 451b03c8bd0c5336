# SPDX-License-Identifier: GPL-3.0-or-later
"""`palpate touch --tool`: a cube in the hand on a floor, each expected value derived from F = K (tool - hand) / scale."""

import math
import unittest

from palpate_cli import SQUARE_FACES, SQUARE_POINTS, CommandLineTest

CORNERS = [(x, y, z) for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)]
FACES = [(0, 2, 3), (0, 3, 1), (4, 5, 7), (4, 7, 6), (0, 1, 5), (0, 5, 4),
         (2, 6, 7), (2, 7, 3), (0, 4, 6), (0, 6, 2), (1, 3, 7), (1, 7, 5)]
GAP = 2e-7 * math.sqrt(12.0)  # at which a tool rests: of its diagonal
UPRIGHT = (1.0, 0.0, 0.0, 0.0)
POSES = "t,x,y,z,qw,qx,qy,qz"
COLUMNS = ",proxy_qw,proxy_qx,proxy_qy,proxy_qz,torque_x,torque_y,torque_z"


class Tool(CommandLineTest):
    def setUp(self):
        super().setUp()
        self.write_off("plane.off", SQUARE_POINTS, SQUARE_FACES)
        self.write_off("cube.off", CORNERS, FACES)

    def touch(self, poses, *options):
        rows = [(n / 1000, *pose) for n, pose in enumerate(poses)]
        self.write_path(rows, header=POSES)
        self.succeed("touch", "plane.off", "--tool", "cube.off", "--path", "path.csv", "--csv", "out.csv", *options)
        return self.read_rows()

    def test_a_cube_on_a_floor_pushes_by_the_depth_of_the_hand_and_its_pose_is_in_the_row(self):
        rows = self.touch([(0, 0, 3, *UPRIGHT), (0, 0, 0.75, *UPRIGHT), (0.5, 0, 0.5, *UPRIGHT)],
                          "--stiffness", 300, "--scale", 20)
        self.assertTrue((self.folder / "out.csv").read_text().splitlines()[0].endswith("cost_us" + COLUMNS))
        self.assertEqual([row["force_z"] for row in rows[:1]], [0.0])
        for row, depth in zip(rows[1:], (0.25, 0.5)):
            self.assertAlmostEqual(row["proxy_z"], 1 + GAP, delta=GAP)
            self.assertAlmostEqual(row["force_z"], 300 * (depth + GAP) / 20, delta=300 * GAP / 20)
            self.assertAlmostEqual(row["force_x"], 0.0, delta=1e-9)
            self.assertAlmostEqual(abs(row["proxy_qw"]), 1.0, delta=1e-9)
        self.assertAlmostEqual(rows[2]["proxy_x"], 0.5, delta=1e-6)

    def test_a_turn_that_the_floor_takes_away_is_a_torque_by_the_stiffness_of_turning(self):
        angle = 0.02
        turned = (math.cos(angle / 2), 0.0, math.sin(angle / 2), 0.0)
        for options, stiffness in ((("--torque-stiffness", 0.8), 0.8), (("--lever", 3.0), 300 * 9 / 400)):
            rows = self.touch([(0, 0, 3, *UPRIGHT), (0, 0, 0.5, *turned)], "--stiffness", 300, "--scale", 20, *options)
            left = 2 * math.asin(rows[1]["proxy_qy"])
            self.assertLess(left, angle / 2)
            self.assertAlmostEqual(rows[1]["torque_y"], -stiffness * (angle - left), delta=1e-6 * stiffness * angle)

    def test_friction_holds_a_cube_up_to_its_share_of_the_push_and_brakes_it_by_that(self):
        stiffness, friction, depth = 300.0, 0.4, 0.25
        drawn = (0.5 * friction * depth, 3.0 * friction * depth)  # times the stiffness: below and beyond friction times the push
        rows = self.touch([(0, 0, 3, *UPRIGHT), *((way, 0, 1 - depth, *UPRIGHT) for way in (0.0, *drawn))],
                          "--stiffness", stiffness, "--mu-static", friction)
        held = friction * (depth + GAP)
        beyond = 0.02 * held  # a step may end past where it must stay, and there friction holds it just as well
        for row, way, rests in zip(rows[2:], drawn, (0.0, drawn[1] - held)):
            self.assertTrue(rests - 1e-4 * held <= row["proxy_x"] <= rests + beyond, row["proxy_x"])
            self.assertAlmostEqual(row["force_x"], -stiffness * (way - row["proxy_x"]), delta=1e-6 * stiffness)
            self.assertAlmostEqual(row["force_z"], stiffness * (depth + GAP), delta=1e-3)
        self.refused("touch", "plane.off", "--tool", "cube.off", "--path", "path.csv", "--csv", "out.csv", "--mu-static", 2,
                     saying=("friction of a tool", "from 0 to 1"))

    def test_a_tool_that_can_never_leave_says_so(self):
        self.write_off("hall.off", [tuple(5 * x for x in corner) for corner in CORNERS], FACES)
        self.write_path([(0, 0, 0, 0, *UPRIGHT)], header=POSES)
        base = ("touch", "--path", "path.csv", "--csv", "out.csv")
        self.assertIn("inside a closed body", self.succeed(*base, "hall.off", "--tool", "cube.off").stderr)
        self.assertIn("encloses the visible data", self.succeed(*base, "cube.off", "--tool", "hall.off").stderr)
        self.write_path([(0, 0, 0, 20, *UPRIGHT)], header=POSES)
        self.assertNotIn("closed", self.succeed(*base, "hall.off", "--tool", "cube.off").stderr)

    def test_turns_of_few_digits_are_turns_all_the_same(self):
        rows = self.touch([(0, 0, 3, *UPRIGHT), (0, 0, 0.75, 0.99985, 0.0, 0.01745, 0.0)], "--stiffness", 300)
        self.assertGreater(rows[1]["force_z"], 300 * 0.25)

    def test_what_a_tool_does_not_feel_is_refused_by_name(self):
        self.write_path([(0, 0, 0, 3, *UPRIGHT)], header=POSES)
        base = ("touch", "plane.off", "--tool", "cube.off", "--path", "path.csv", "--csv", "out.csv")
        for option in (("--radius", 1), ("--two-d",), ("--stiffness-array", "E"), ("--shading",)):
            self.refused(*base, *option, saying=(option[0], "tool"))
        for option in (("--strength", 1), ("--compare-with", "g"), ("--values", 1), ("--range", "0,1"), ("--snap", "points")):
            self.refused(*base, *option, saying=(option[0], "--field"))
        self.refused(*base, "--lever", 0, saying=("lever",))
        for stiffness in (-1, 0, "inf"):
            self.refused(*base, "--torque-stiffness", stiffness, saying=(f"--torque-stiffness {stiffness}:", "finite number"))
        self.refused(*base, "--lever", 1, "--torque-stiffness", 1, saying=("--lever",))

    def test_a_path_without_turns_and_a_start_within_the_scene_are_refused_in_words(self):
        self.write_path([(0, 0, 0, 3)])
        base = ("touch", "plane.off", "--tool", "cube.off", "--path", "path.csv", "--csv", "out.csv")
        self.refused(*base, saying=("qw,qx,qy,qz",))
        self.write_path([(0, 0, 0, 0.5, *UPRIGHT)], header=POSES)
        self.refused(*base, saying=("start at a free position",))


if __name__ == "__main__":
    unittest.main()
