# SPDX-License-Identifier: GPL-3.0-or-later
"""`palpate touch --loose --density`: a ball or a mesh in the hand pushes a stone over a table, without a scene file. Judges: the force of
friction, Newton's law and the weight of a box whose volume is known."""

import unittest

from palpate_cli import CommandLineTest

HALF = (30.0, 20.0, 10.0)  # mm
DENSITY, GRAVITY, FRICTION = 2500.0, 9.81, 0.3
MASS = DENSITY * 8e-9 * HALF[0] * HALF[1] * HALF[2]  # kg
RADIUS, SPEED = 5.0, 0.05  # mm, mm a tick
FACES = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]


def box(half, at):
    signs = [(-1, -1, -1), (1, -1, -1), (1, 1, -1), (-1, 1, -1), (-1, -1, 1), (1, -1, 1), (1, 1, 1), (-1, 1, 1)]
    return [tuple(a + s * h for a, s, h in zip(at, sign, half)) for sign in signs], FACES


class Loose(CommandLineTest):
    def setUp(self):
        super().setUp()
        self.write_off("table.off", *box((300, 300, 10), (0, 0, -10)))
        self.write_off("stone.off", *box(HALF, (0, 0, HALF[2])))
        self.scene = ("touch", "table.off", "--path", "path.csv", "--csv", "out.csv", "--scale", 1000)
        self.stone = ("--loose", "stone.off", "--density", DENSITY)
        self.rubs = ("--mu-static", FRICTION, "--mu-kinetic", FRICTION)

    def pushed(self, *options, before=HALF[0] + RADIUS + 1):
        self.write_path([(n / 1000, SPEED * n - before, 0, HALF[2], 1, 0, 0, 0) for n in range(1500)], header="t,x,y,z,qw,qx,qy,qz")
        self.succeed(*self.scene, *self.stone, *options)
        return self.read_rows()

    def test_a_ball_pushes_it_by_its_friction_and_the_rows_say_where_it_is(self):
        rows = self.pushed("--radius", RADIUS, *self.rubs)
        mean = -sum(row["force_x"] for row in rows[-500:]) / 500
        self.assertAlmostEqual(mean, FRICTION * MASS * GRAVITY, delta=0.02 * FRICTION * MASS * GRAVITY)
        self.assertTrue(all(row["force_x"] == 0 for row in rows[:15]), "nothing is met yet")
        self.assertAlmostEqual(rows[0]["loose_z"], HALF[2], delta=1e-3)
        self.assertAlmostEqual(rows[-1]["loose_x"], SPEED * 1499 - 1, delta=0.5)
        self.assertAlmostEqual(rows[-1]["loose_qw"], 1, delta=1e-3)

    def test_a_mesh_pushes_it_as_the_ball_does(self):
        self.write_off("cube.off", *box((RADIUS,) * 3, (0, 0, 0)))
        rows = self.pushed("--tool", "cube.off", *self.rubs)
        mean = -sum(row["force_x"] for row in rows[-500:]) / 500
        self.assertAlmostEqual(mean, FRICTION * MASS * GRAVITY, delta=0.02 * FRICTION * MASS * GRAVITY)

    def test_without_it_nothing_is_pushed(self):
        self.write_path([(n / 1000, SPEED * n - 36, 0, HALF[2]) for n in range(1000)])
        self.succeed(*self.scene, "--radius", RADIUS)
        self.assertNotIn("loose_x", self.read_rows()[0])

    def test_what_cannot_be_loose_is_refused_by_its_name(self):
        self.write_path([(0, 0, 0, 50)])
        points, faces = box(HALF, (0, 0, HALF[2]))
        self.write_off("open.off", points, faces[:-1])
        ball = ("--radius", RADIUS)
        self.refused(*self.scene, *ball, "--loose", "open.off", "--density", DENSITY, saying=("open.off", "cannot be loose", "open"))
        for density in (0, -1, "inf", "nan", 1e7):
            self.refused(*self.scene, *ball, "--loose", "stone.off", "--density", density, saying=("stone.off", "density", "above 0"))
        self.refused(*self.scene, *self.stone, saying=("--radius", "above 0"))
        self.refused(*self.scene, *ball, *self.stone, "--shading", saying=("--shading", "loose bodies"))
        for table in (self.scene[1], "./table.off"):
            self.refused("touch", table, *self.scene[2:], *ball, "--loose", "table.off", "--density", DENSITY,
                         saying=("table.off", "both FILE and --loose", "omit one"))
        self.refused(*self.scene, *ball, *self.stone, "--loose", "stone.off", saying=("--loose",))
        metres = ("--scale", 1)
        self.refused(*self.scene[:6], *metres, *ball, *self.stone,
                     saying=("stone.off", "beyond 1e6 N): one unit is taken as 1 m", "unit of lengths by --scale, which is 1000 for millimetres"))
        self.refused("touch", "table.off", "--path", "path.csv", "--csv", "stone.off", *self.scene[6:], *ball, *self.stone,
                     saying=("stone.off", "also an input"))
        self.refused(*self.scene, *ball, "--loose", "gone.off", "--density", DENSITY, saying=("gone.off",))
        self.refused("touch", "open.off", *self.scene[2:], *ball, *self.stone, saying=("open.off", "loose bodies", "omit this input"))


if __name__ == "__main__":
    unittest.main()
