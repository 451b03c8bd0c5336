# SPDX-License-Identifier: GPL-3.0-or-later
"""`palpate touch --tool --young`: a mesh in the hand on a soft block, and on surfaces beside it. Judges: the exact ball's own tick on the
same block, the rigid surface of that block, the spring of the hand, and the balance of a handle."""

import math
import unittest

from palpate_cli import SQUARE_FACES, SQUARE_POINTS, CommandLineTest, vtu_text
from test_soft import HEIGHT, POISSON, SIDE, YOUNG, tetrahedra
from test_tool import COLUMNS, CORNERS, FACES, POSES, UPRIGHT

CELLS = 8  # along a side
BALL = 0.03  # m
PLACE = (SIDE / 2 + 0.0011, SIDE / 2 + 0.0008)  # not over a vertex
FIRM = 1e5  # N/m: the spring takes a share of some 1e-3 of a depth
SOFT = ("--young", YOUNG, "--poisson", POISSON, "--fixed", "zmin")


def block(scale=1.0):
    layers = CELLS // 2
    return tetrahedra((CELLS, CELLS, layers), lambda i, j, k: (
        scale * SIDE * i / CELLS, scale * SIDE * j / CELLS, scale * HEIGHT * k / layers))


def ball(level, middle=(0.0, 0.0, 0.0)):
    """An icosahedron of radius BALL, each of its triangles cut in four so many times: 162, 642, 2,562 vertices."""
    golden = (1 + math.sqrt(5)) / 2
    points = [(a, b * golden, 0) for a in (-1, 1) for b in (-1, 1)] + [(0, a, b * golden) for a in (-1, 1) for b in (-1, 1)]
    points += [(b * golden, 0, a) for a in (-1, 1) for b in (-1, 1)]
    near = lambda i, j: i != j and abs(math.dist(points[i], points[j]) - 2) < 1e-9
    faces = [(i, j, k) for i in range(12) for j in range(i) for k in range(j) if near(i, j) and near(j, k) and near(i, k)]
    for _ in range(level):
        middles, finer = {}, []
        for a, b, c in faces:
            ends = [tuple(sorted(edge)) for edge in ((a, b), (b, c), (c, a))]
            for i, j in ends:
                if (i, j) not in middles:
                    middles[i, j] = len(points)
                    length = math.hypot(*points[0])
                    sum_ = [p + q for p, q in zip(points[i], points[j])]
                    points.append(tuple(length * x / math.hypot(*sum_) for x in sum_))
            d, e, f = (middles[edge] for edge in ends)
            finer += [(a, d, f), (d, b, e), (f, e, c), (d, e, f)]
        faces = finer
    length = math.hypot(*points[0])
    return [tuple(m + BALL * x / length for m, x in zip(middle, p)) for p in points], faces


class ToolOnBody(CommandLineTest):
    def setUp(self):
        super().setUp()
        self.write("block.vtu", vtu_text(*block(), cell_type=10))

    def touch(self, places, *options, body="block.vtu"):
        """A row a millisecond."""
        self.write_path([(n / 1000, *place, *UPRIGHT) for n, place in enumerate(places)], header=POSES)
        self.said = self.succeed("touch", body, "--path", "path.csv", "--csv", "out.csv", *options).stderr
        return self.read_rows()

    def test_a_mesh_ball_presses_as_the_exact_ball_does_and_not_as_on_a_rigid_body(self):
        self.write_off("ball.off", *ball(4))
        depths, down, rest = (0.0005, 0.001, 0.002), 50, 1000
        top, ways, ends, before = HEIGHT + BALL, [(*PLACE, HEIGHT + BALL + 0.001)], [], 0.0
        for depth in depths:
            ways += [(*PLACE, top - before - (depth - before) * (i + 1) / down) for i in range(down)]
            ways += [(*PLACE, top - depth)] * rest
            ends.append(len(ways) - 1)
            before = depth
        rows = self.touch(ways, "--tool", "ball.off", *SOFT, "--stiffness", FIRM)
        self.assertTrue((self.folder / "out.csv").read_text().splitlines()[0].endswith("cost_us" + COLUMNS))
        exact = self.touch([ways[0], *((*PLACE, top - depth) for depth in depths)], "--radius", BALL, *SOFT, "--stiffness", FIRM,
                           "--low-rate", 0)
        rigid = self.touch([ways[0], *((*PLACE, top - depth) for depth in depths)], "--tool", "ball.off", "--stiffness", FIRM)
        for end, depth, judge, hard in zip(ends, depths, exact[1:], rigid[1:]):
            row = rows[end]
            self.assertAlmostEqual(row["force_z"] / judge["force_z"], 1.0, delta=0.02, msg=depth)
            self.assertLess(math.hypot(row["force_x"], row["force_y"]), 0.01 * row["force_z"])
            self.assertAlmostEqual(row["force_z"], FIRM * (row["proxy_z"] - row["device_z"]), delta=1e-6)
            self.assertGreaterEqual(row["contacts"], 1)
            # The rigid block holds the ball with the whole spring, but for facets that lie R (1 - cos .0415) below the ball.
            self.assertAlmostEqual(hard["force_z"], FIRM * depth, delta=FIRM * BALL * (1 - math.cos(0.0415)))
            self.assertLess(row["force_z"], 0.02 * hard["force_z"])

    def test_a_ball_beside_the_handle_turns_it_by_its_lever_and_by_the_stiffness_of_turning(self):
        aside, turning, depth = 0.02, 5.0, 0.002
        handle = (PLACE[0] - aside, PLACE[1])
        ways = [(*handle, HEIGHT + BALL + 0.001 - 1e-5 * min(i, 100 + 1e5 * depth)) for i in range(800)]
        for scale, options in ((1, ("--torque-stiffness", turning)), (1000, ("--lever", 1000 * math.sqrt(turning / FIRM)))):
            points, faces = ball(3, (aside, 0.0, 0.0))
            self.write_off("ball.off", [[scale * x for x in point] for point in points], faces)
            self.write("scaled.vtu", vtu_text(*block(scale), cell_type=10))
            row = self.touch([[scale * x for x in place] for place in ways], "--tool", "ball.off", *SOFT, "--stiffness", FIRM,
                             "--scale", scale, *options, body="scaled.vtu")[-1]
            self.assertGreater(row["force_z"], 0.3)
            # The force goes through the ball's middle, which lies before the handle: (a, 0, 0) x (0, 0, F).
            self.assertAlmostEqual(row["torque_y"], -aside * row["force_z"], delta=0.02 * aside * row["force_z"])
            self.assertAlmostEqual(row["torque_y"], turning * 2 * math.asin(row["proxy_qy"]), delta=1e-6)

    def test_a_ball_that_is_drawn_aside_is_held_back_by_its_friction(self):
        friction = 0.3
        self.write_off("ball.off", *ball(3))
        top = HEIGHT + BALL
        down = [(*PLACE, top + 0.0005 - 1e-5 * i) for i in range(200)]
        aside = [(PLACE[0] + 2e-5 * i, PLACE[1], top - 0.0015) for i in range(500)]
        last = self.touch(down + aside, "--tool", "ball.off", *SOFT, "--stiffness", 5000, "--mu-static", friction,
                          "--torque-stiffness", 20)[-1]
        self.assertGreater(last["force_z"], 0.2)
        self.assertAlmostEqual(-last["force_x"] / last["force_z"], friction, delta=0.03)

    def test_a_rigid_surface_beside_the_body_holds_the_tool_with_the_whole_spring_and_rubs(self):
        half, friction = 0.01, 0.3
        rest = 2e-5 * 2 * half * 3 ** 0.5  # m: so far the cube stays away from a mesh that stands
        self.write_off("cube.off", [[half * x for x in corner] for corner in CORNERS], FACES)
        self.write_off("table.off", [(-0.3 + 0.2 * x, 0.2 * y, 0.05 * z - 0.05) for x, y, z in CORNERS], FACES)  # its top is z = 0
        down = [(-0.3, 0.0, half + 0.0005 - 1e-5 * i) for i in range(200)]
        aside = [(-0.3 + 1e-5 * i, 0.0, down[-1][2]) for i in range(500)]
        on_body = [(*PLACE, HEIGHT + half + 0.0005 - 1e-5 * i) for i in range(200)] + [(*PLACE, HEIGHT + half - 0.0015)] * 500
        rows = self.touch(down + aside, "table.off", "--tool", "cube.off", *SOFT, "--stiffness", 5000, "--mu-static", friction)
        for row in rows:
            self.assertAlmostEqual(row["force_z"], 5000 * max(half + rest - row["device_z"], 0.0), delta=1e-6)
        self.assertAlmostEqual(-rows[-1]["force_x"] / rows[-1]["force_z"], friction, delta=1e-3)
        alone = self.touch(on_body, "--tool", "cube.off", *SOFT, "--stiffness", 5000)[-1]
        beside = self.touch(on_body, "table.off", "--tool", "cube.off", *SOFT, "--stiffness", 5000)[-1]
        self.assertGreater(alone["force_z"], 0.3)
        self.assertAlmostEqual(alone["force_z"], beside["force_z"], delta=1e-12, msg="the table is far away")

    def test_a_body_that_lies_in_a_surface_is_named(self):
        self.write_off("ball.off", *ball(1))
        self.write_off("skin.off", CORNERS, FACES)
        self.write_path([(0, *PLACE, 1.0, *UPRIGHT)], header=POSES)
        self.refused("touch", "block.vtu", "skin.off", *SOFT, "--path", "path.csv", "--csv", "out.csv", "--tool", "ball.off",
                     saying=("block.vtu lies in skin.off", "hide"))

    def test_a_path_that_begins_in_the_body_says_so(self):
        self.write_off("ball.off", *ball(2))
        self.touch([(*PLACE, HEIGHT + BALL - 0.002)] * 3, "--tool", "ball.off", *SOFT)
        self.assertIn('the path begins with bodies "--tool: ball.off" and "block.vtu" in one another', self.said)

    def test_what_a_tool_on_a_soft_body_cannot_do_is_refused_in_words(self):
        self.write_off("ball.off", *ball(1))
        self.write_off("square.off", SQUARE_POINTS, SQUARE_FACES)
        self.write_path([(0, *PLACE, 1.0, *UPRIGHT)], header=POSES)
        base = ("touch", "block.vtu", *SOFT, "--path", "path.csv", "--csv", "out.csv", "--tool")
        self.succeed(*base, "ball.off")
        self.refused(*base, "square.off", saying=("square.off", "cannot be held", "open"))
        self.refused("touch", "block.vtu", "square.off", *base[2:], "ball.off",
                     saying=("square.off", "the mesh is open", "omit"))
        for option in (("--radius", 1), ("--shading",), ("--friction-array", "f")):
            self.refused(*base, "ball.off", *option, saying=(option[0], "no effect", "omit"))
        for option in (("--two-d",), ("--iso", 1), ("--field", "f"), ("--virtual-coupling",)):
            self.refused(*base, "ball.off", *option, saying=(option[0], "a tool on a soft body"))
        self.refused(*base, "ball.off", "--mu-static", 2, saying=("friction of a tool", "from 0 to 1"))
        self.refused(*base, "ball.off", "--stiffness", 0, saying=("--stiffness", "above 0"))


if __name__ == "__main__":
    unittest.main()
