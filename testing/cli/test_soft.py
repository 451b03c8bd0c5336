# SPDX-License-Identifier: GPL-3.0-or-later
"""`palpate touch --young`: a ball on a soft block, judged by Hertz's law on a layer."""

import itertools
import math
import random
import unittest

from palpate_cli import SQUARE_FACES, SQUARE_POINTS, CommandLineTest, vtu_text

SIDE, HEIGHT, CELLS = 0.1, 0.05, 6  # m, m, along a side
YOUNG, POISSON = 20e3, 0.4  # Pa, 1
RADIUS = 0.01  # m


def tetrahedra(cells, place):
    """Points and tetrahedra (Kuhn) of a grid of so many cells, whose point (i, j, k) lies at place(i, j, k)."""
    size = [n + 1 for n in cells]
    points = [place(i, j, k) for k in range(size[2]) for j in range(size[1]) for i in range(size[0])]
    number = lambda p: (p[2] * size[1] + p[1]) * size[0] + p[0]
    tetras = []
    for low in itertools.product(*map(range, cells)):
        for way in itertools.permutations(range(3)):
            corner, corners = list(low), [number(low)]
            for axis in way:
                corner[axis] += 1
                corners.append(number(corner))
            tetras.append(tuple(corners))
    return points, tetras


def block(scale=1.0):
    """Points and tetrahedra of a block on z = 0."""
    layers = CELLS // 2
    return tetrahedra((CELLS, CELLS, layers), lambda i, j, k: (
        scale * SIDE * i / CELLS, scale * SIDE * j / CELLS, scale * HEIGHT * k / layers))


LEAF, THICK, GAP, WIDTH = 0.06, 0.004, 0.012, 0.03  # m, of a sheet that is bent back on itself


def hairpin():
    """A sheet whose lower leaf lies on z = 0, with its upper leaf above it and the bend at x < 0."""
    along_leaf, along_bend, across, layers = 12, 8, 4, 2

    def place(i, j, k):
        y, below = WIDTH * j / across, THICK * k / layers  # from the outer side of the sheet
        if i <= along_leaf:
            return LEAF * (1 - i / along_leaf), y, below
        if i >= along_leaf + along_bend:
            return LEAF * (i - along_leaf - along_bend) / along_leaf, y, GAP + 2 * THICK - below
        turned, r = math.pi * (i - along_leaf) / along_bend, GAP / 2 + THICK - below
        return -r * math.sin(turned), y, GAP / 2 + THICK - r * math.cos(turned)

    return tetrahedra((2 * along_leaf + along_bend, across, layers), place)


def hertz(depth, young=YOUNG):
    """On a layer bonded below (Dimitriadis et al. 2002) [N]; lengths in metres."""
    plane = young / (1 - POISSON**2)
    chi = math.sqrt(RADIUS * depth) / HEIGHT
    a = -(1.2876 - 1.4678 * POISSON + 1.3442 * POISSON**2) / (1 - POISSON)
    layer = 1 - 2 * a / math.pi * chi + 4 * a**2 / math.pi**2 * chi**2
    return 4 / 3 * plane * math.sqrt(RADIUS) * depth**1.5 * layer


class Soft(CommandLineTest):
    def setUp(self):
        super().setUp()
        self.write("block.vtu", vtu_text(*block(), cell_type=10))

    def press(self, depth, *options, scale=1.0, body="block.vtu", ticks=120):
        """The ball comes down beside the middle of the top, so deep; the last row."""
        rows = [(n / 1000, scale * 0.052, scale * 0.047,
                 scale * (HEIGHT + RADIUS + 0.001 - (0.001 + depth) * min(1.0, 2 * n / ticks))) for n in range(ticks + 1)]
        self.write_path(rows)
        self.succeed("touch", body, "--young", YOUNG, "--fixed", "zmin", "--radius", scale * RADIUS, "--scale", scale,
                     "--path", "path.csv", "--csv", "out.csv", *options)
        return self.read_rows()[-1]

    def test_a_ball_is_pushed_by_what_hertz_says_of_a_layer(self):
        for rate, ticks in ((0, 6), (30, 120)):
            row = self.press(0.001, "--stiffness", 1e5, "--low-rate", rate, ticks=ticks)
            depth = HEIGHT + RADIUS - row["proxy_z"]
            self.assertAlmostEqual(row["force_z"] / hertz(depth), 1.0, delta=0.07)
            self.assertLess(math.hypot(row["force_x"], row["force_y"]), 0.02 * row["force_z"])
            self.assertAlmostEqual(row["force_z"], 1e5 * (row["proxy_z"] - row["device_z"]), delta=1e-6 * row["force_z"])
            self.assertEqual(row["contacts"], 1)

    def test_over_bumps_every_row_has_the_force_of_the_spring_between_proxy_and_hand(self):
        numbers = random.Random(28)
        for scale in (1.0, 1000.0):
            points, tetras = block(scale)
            top = max(z for _, _, z in points)
            points = [(x, y, z + (scale * numbers.uniform(-0.001, 0.001) if z == top else 0.0)) for x, y, z in points]
            self.write("bumps.vtu", vtu_text(points, tetras, cell_type=10))
            # The second is so soft that the ball comes down to the fixed nodes, 50 mm below the top.
            for young, deep, model in ((YOUNG, 0.006, "neohookean"), (10, 0.055, "linear")):
                self.write_path([(n / 1000, scale * (0.02 + 5e-5 * n), scale * (0.05 + 0.01 * math.sin(0.01 * n)),
                                  scale * (HEIGHT + 0.009 - min(1.0, n / 100) * (0.004 + deep))) for n in range(600)])
                self.succeed("touch", "bumps.vtu", "--young", young, "--fixed", "zmin", "--radius", scale * 0.005,
                             "--scale", scale, "--model", model, "--low-rate", 30, "--stiffness", 1000,
                             "--path", "path.csv", "--csv", "out.csv")
                rows = self.read_rows()
                self.assertEqual(len(rows), 600)
                for row in rows:
                    force = [row[f"force_{axis}"] for axis in "xyz"]
                    spring = [1000 / scale * (row[f"proxy_{axis}"] - row[f"device_{axis}"]) for axis in "xyz"]
                    # Proxy and device are rounded, one part in 2^53 each.
                    place = math.hypot(*(row[f"device_{axis}"] for axis in "xyz"))
                    self.assertLess(math.dist(force, spring),
                                    1e-12 * math.hypot(*force) + 4e-16 * 1000 / scale * place + 1e-300)
                self.assertGreater(sum(row["force_z"] > 0.01 for row in rows), 400)

    def test_millimetres_with_a_scale_of_a_thousand_are_the_same_body(self):
        self.write("mm.vtu", vtu_text(*block(1000.0), cell_type=10))
        metres = self.press(0.004)["force_z"]
        self.assertAlmostEqual(self.press(0.004, scale=1000.0, body="mm.vtu")["force_z"], metres, delta=1e-6 * metres)

    def test_models_differ_where_strain_is_large_and_not_where_it_is_small(self):
        forces = {model: [self.press(depth, "--model", model, "--low-rate", 0, "--stiffness", 1e4, ticks=4)["force_z"]
                          for depth in (0.0005, 0.02)]
                  for model in ("linear", "corotational", "neohookean")}
        self.assertAlmostEqual(forces["neohookean"][0] / forces["linear"][0], 1.0, delta=0.01)
        self.assertAlmostEqual(forces["corotational"][0] / forces["linear"][0], 1.0, delta=0.01)
        self.assertLess(forces["corotational"][1] / forces["neohookean"][1], 0.99)  # it softens where it is squeezed

    def test_a_fold_that_is_pressed_shut_is_told_and_one_that_is_pressed_less_is_not(self):
        self.write("sheet.vtu", vtu_text(*hairpin(), cell_type=10))
        ball, top = 0.005, GAP + 2 * THICK
        # The gap is 12 mm wide: by 2 mm of the hand the leaves cannot meet. At 40 mm the hand is far below the table,
        # and its spring of 1000 N/m pushes with more than the sheet of 50 kPa can hold.
        for deep, told in ((0.002, False), (0.04, True)):
            self.write_path([(n / 1000, 0.04, WIDTH / 2 + 0.001, top + ball + 0.001 - (0.001 + deep) * min(1.0, n / 100))
                             for n in range(200)])
            run = self.succeed("touch", "sheet.vtu", "--young", 50e3, "--fixed", "zmin", "--radius", ball, "--model",
                               "linear", "--path", "path.csv", "--csv", "out.csv")
            self.assertEqual("was pressed through itself" in run.stderr, told, run.stderr)
            self.assertEqual(len(self.read_rows()), 200)

    def test_what_is_no_body_is_refused_in_one_line(self):
        self.write_off("sheet.off", SQUARE_POINTS, SQUARE_FACES)
        self.write_path([(0, 0, 0, 1)])
        tail = ("--path", "path.csv", "--csv", "out.csv")
        base = ("touch", "block.vtu", "--young")
        for young in (0, -5, "nan", 1e12, 0.02, 9.9):
            self.refused(*base, young, "--fixed", "zmin", *tail, saying=("block.vtu", "modulus", "10 Pa"))
        for poisson in (-0.1, 0.5):
            self.refused(*base, YOUNG, "--fixed", "zmin", "--poisson", poisson, *tail, saying=("block.vtu", "Poisson"))
        self.refused(*base, YOUNG, *tail, saying=("block.vtu", "fixed"))
        self.refused(*base, YOUNG, "--fixed", "top", *tail, saying=("block.vtu", "top", "zmin"))
        self.refused("touch", "sheet.off", "--young", YOUNG, "--fixed", "zmin", *tail, saying=("sheet.off", "holes"))
        self.refused(*base, YOUNG, "--fixed", "zmin", "--low-rate", -1, *tail, saying=("--low-rate",))
        self.refused(*base, YOUNG, "--fixed", "zmin", "--shading", *tail, saying=("--shading",))


if __name__ == "__main__":
    unittest.main()
