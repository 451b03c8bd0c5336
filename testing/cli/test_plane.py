# SPDX-License-Identifier: GPL-3.0-or-later
"""`palpate touch --two-d`: lines in the plane z = 0, each expected value from the geometry of the plane."""

import json
import math
import unittest

from palpate_cli import SQUARE_FACES, SQUARE_POINTS, CommandLineTest, vti_text, vtp_text
from says import unsaid

STIFFNESS = 512.0
PLACE = 1e-12  # a point rests a few units in the last place off a line


def wedge(angle):
    """Two lines of length 10 that meet in the origin, `angle` apart, about the x axis."""
    x, y = 10 * math.cos(angle / 2), 10 * math.sin(angle / 2)
    return [(x, y, 0), (0, 0, 0), (x, -y, 0)], [(0, 1, 2)]


class PlaneTest(CommandLineTest):
    def lines(self, points, lines, name="lines.vtp"):
        self.write(name, vtp_text(points, lines, kind="Lines"))

    def touch(self, places, *options, files=("lines.vtp",)):
        self.write_path([(n / 1024, x, y, 0.0) for n, (x, y) in enumerate(places)])
        self.succeed("touch", *files, "--two-d", "--path", "path.csv", "--csv", "out.csv", "--stiffness", STIFFNESS, *options)
        rows = self.read_rows()
        for row in rows:
            self.assertEqual((row["device_z"], row["proxy_z"], row["force_z"]), (0.0, 0.0, 0.0))
        return rows

    def assert_at(self, row, x, y, delta=PLACE):
        self.assertAlmostEqual(row["proxy_x"], x, delta=delta)
        self.assertAlmostEqual(row["proxy_y"], y, delta=delta)
        self.assertAlmostEqual(row["force_x"], STIFFNESS * (x - row["device_x"]), delta=STIFFNESS * delta)
        self.assertAlmostEqual(row["force_y"], STIFFNESS * (y - row["device_y"]), delta=STIFFNESS * delta)


class Touch(PlaneTest):
    def test_a_disc_in_a_wedge_rests_at_its_radius_over_the_sine_of_half_the_angle(self):
        radius = 0.25
        for degrees in (120, 90, 60, 30, 10, 5):
            angle = math.radians(degrees)
            self.lines(*wedge(angle))
            away = radius / math.sin(angle / 2)
            out = self.touch([(9.0, 0.0), (-1.0, 0.0)], "--radius", radius)
            # two lines that are `angle` apart amplify the rounding of a place by 1 / sin(angle / 2)
            self.assert_at(out[1], away, 0.0, delta=PLACE / math.sin(angle / 2))
            self.assertEqual(out[1]["contacts"], 2)

    def test_a_point_in_a_wedge_rests_in_its_tip(self):
        self.lines(*wedge(math.radians(60)))
        self.assert_at(self.touch([(5.0, 0.0), (-1.0, 0.25)])[1], 0.0, 0.0)

    def test_a_line_holds_from_both_sides(self):
        self.lines([(-4, 0, 0), (4, 0, 0)], [(0, 1)])
        for side in (1.0, -1.0):
            out = self.touch([(0.5, side), (0.75, -0.5 * side)])
            self.assert_at(out[1], 0.75, 0.0)
            self.assertEqual(out[1]["contacts"], 1)

    def test_a_point_goes_round_the_end_of_a_line(self):
        # along the line while it is held, then straight to the hand once that is seen from the end
        self.lines([(-4, 0, 0), (0, 0, 0)], [(0, 1)])
        out = self.touch([(-1.0, 0.5), (-1.0, -0.5), (-0.25, -0.5), (0.5, -0.5), (-1.0, -0.5)])
        self.assert_at(out[1], -1.0, 0.0)
        self.assert_at(out[2], -0.25, 0.0)
        self.assert_at(out[3], 0.5, -0.5)
        self.assertEqual((out[3]["contacts"], out[4]["contacts"], out[4]["force_y"]), (0, 0, 0.0))

    def test_a_disc_rolls_on_a_circle_of_its_radius_round_the_end_of_a_line(self):
        radius = 0.25
        self.lines([(-4, 0, 0), (0, 0, 0)], [(0, 1)])
        angles = [math.radians(60 - 2 * n) for n in range(60)]
        out = self.touch([(0.0, 0.5)] + [(0.125 * math.cos(a), 0.125 * math.sin(a)) for a in angles], "--radius", radius)
        for angle, row in zip(angles, out[1:]):
            self.assert_at(row, radius * math.cos(angle), radius * math.sin(angle))

    def test_friction_holds_up_to_its_cone(self):
        self.lines([(-4, 0, 0), (4, 0, 0)], [(0, 1)])
        depth, static = 0.5, 0.5
        ways = [k / 16 for k in range(9)]
        out = self.touch([(0.25, 1.0), (0.25, -depth)] + [(0.25 + way, -depth) for way in ways], "--mu-static", static)
        for way, row in zip(ways, out[2:]):
            self.assertAlmostEqual(row["force_x"], -STIFFNESS * min(way, static * depth), delta=STIFFNESS * PLACE)

    def test_two_files_are_one_plane(self):
        self.lines([(-4, 0, 0), (4, 0, 0)], [(0, 1)])
        self.lines([(0, -4, 0), (0, 4, 0)], [(0, 1)], name="other.vtp")
        out = self.touch([(1.0, 1.0), (-0.5, -0.25)], files=("lines.vtp", "other.vtp"))
        self.assert_at(out[1], 0.0, 0.0)

    def test_a_plane_in_single_precision_is_a_plane(self):
        self.lines([(-4, 0, 1e-7), (4, 0, -1e-7)], [(0, 1)])
        self.assert_at(self.touch([(0.5, 1.0), (0.5, -0.5)])[1], 0.5, 0.0)

    def test_curves_far_apart_in_size_are_felt_alike(self):
        for size in (1e-6, 1e6):
            self.lines([(-4 * size, 0, 0), (4 * size, 0, 0)], [(0, 1)])
            out = self.touch([(0.0, size), (0.0, -size)])
            self.assertAlmostEqual(out[1]["force_y"], STIFFNESS * size, delta=STIFFNESS * PLACE * size)


class Refusals(PlaneTest):
    def refuse(self, *options, files=("lines.vtp",), saying):
        self.refused("touch", *files, "--two-d", "--path", "path.csv", "--csv", "out.csv", *options, saying=saying)

    def setUp(self):
        super().setUp()
        self.lines([(-4, 0, 0), (4, 0, 0)], [(0, 1)])
        self.write_path([(0.0, 0.0, 1.0, 0.0)])

    def test_a_hand_out_of_the_plane(self):
        self.write_path([(0.0, 0.0, 1.0, 0.0), (0.001, 0.0, 1.0, 0.5)])
        self.refuse(saying=["path.csv", "row 2", "z = 0.5"])

    def test_lines_out_of_the_plane(self):
        self.lines([(-4, 0, 0), (4, 0, 3)], [(0, 1)])
        self.refuse(saying=["lines.vtp", "point 1", "3 scene units", "z = 0"])

    def test_polygons(self):
        self.write("faces.vtp", vtp_text(SQUARE_POINTS, SQUARE_FACES))
        self.refuse(files=("lines.vtp", "faces.vtp"), saying=["faces.vtp", "lines"])

    def test_images(self):
        self.write("image.vti", vti_text(3, lambda i, j, k: i))
        self.refuse(files=("image.vti",), saying=["image.vti", "Image Curves"])

    def test_lines_without_length(self):
        self.lines([(1, 1, 0), (1, 1, 0)], [(0, 1)])
        self.refuse(saying=["lines.vtp"])

    def test_options_that_mean_nothing_among_lines(self):
        for option in (("--line-radius", "1"), ("--iso", "1"), ("--shading",), ("--stiffness-array", "a")):
            self.refuse(*option, saying=["--two-d", "omit"])


class Check(PlaneTest):
    def test_a_plane_world_is_called_one(self):
        self.lines(*wedge(1.0))
        text = self.succeed("check", "lines.vtp").stdout
        self.assertIn("a plane world: 2 segments in the plane z = 0", text)
        self.assertTrue(json.loads(self.succeed("check", "lines.vtp", "--json").stdout)["plane_world"])

    def test_its_size_is_that_of_its_lines(self):
        self.lines([(-4, 0, 0), (4, 2, 0)], [(0, 1)])
        for radius in (0, 3):
            self.assertIn("size      8 x 2 x 0 scene units, from (-4, 0, 0)",
                          self.succeed("check", "lines.vtp", "--radius", radius).stdout)
            found = json.loads(self.succeed("check", "lines.vtp", "--radius", radius, "--json").stdout)
            self.assertEqual((found["low_u"], found["high_u"]), ([-4, 0, 0], [4, 2, 0]))
            self.assertEqual(found["plan"]["scale_u_per_m"], 8 / 0.1)  # its longest side is taken to be 100 mm

    def test_it_says_of_a_disc_what_touching_says(self):
        count, radius = 4000, 3.0  # segments a thousandth of the disc long: more than a tick can look at
        step = radius / 1000
        points = [(step * n, step * (n % 2), 0) for n in range(count + 1)]
        self.lines(points, [tuple(range(count + 1))])
        self.write_path([(0.0, 6.0, 6.0, 0.0)])
        touched = self.succeed("touch", "lines.vtp", "--two-d", "--radius", radius, "--path", "path.csv", "--csv", "out.csv")
        said = json.loads(self.succeed("check", "lines.vtp", "--radius", radius, "--json").stdout)["radius"]
        self.assertFalse(said["kept"])
        self.assertIn(f"palpate: --radius: {said['sentence']};", touched.stderr)

    def test_lines_finer_than_a_hand_feels_are_named_with_what_stands_for_them(self):
        count = 20000  # segments of 0.016 mm where the ring is 100 mm wide
        ring = [(math.cos(2 * math.pi * n / count), math.sin(2 * math.pi * n / count), 0) for n in range(count)]
        self.lines(ring, [(*range(count), 0)])
        found = json.loads(self.succeed("check", "lines.vtp", "--json").stdout)
        kept = int(found["choice"].split()[0])
        self.assertEqual(unsaid(found["choice"], f"{kept} of {count} segments", "proven"), [])
        unnoticed = 0.07 * 1e-3 * 2 / 0.1  # 7 % of a depth of 1 mm, in scene units
        longest = 2 * math.acos(1 - unnoticed)  # whose sagitta that is
        self.assertLessEqual(kept, 2 * (2 * math.pi / longest) + 1)  # for runs are halved
        self.assertGreaterEqual(kept, 2 * math.pi / longest)
        self.assertIn(found["choice"], self.succeed("check", "lines.vtp").stdout)
        self.assertIn(f"{kept} segments feel the same", self.succeed("check", "lines.vtp", "--simplify").stdout)

    def test_coarse_lines_are_felt_as_they_are(self):
        self.lines(*wedge(math.radians(60)))
        self.assertIn("all 2 segments are used (coarser lines are worthwhile from 64 segments shorter than",
                      self.succeed("check", "lines.vtp").stdout)

    def test_arrays_of_materials_mean_nothing_among_lines(self):
        self.lines(*wedge(1.0))
        self.refused("check", "lines.vtp", "--stiffness-array", "nope", saying=["lines.vtp", "arrays of materials"])

    def test_a_surface_is_not(self):
        self.write_off("plane.off", SQUARE_POINTS, SQUARE_FACES)
        self.assertFalse(json.loads(self.succeed("check", "plane.off", "--json").stdout)["plane_world"])

    def test_lines_in_space_are_refused_with_the_point(self):
        self.lines([(-4, 0, 0), (4, 0, 3)], [(0, 1)])
        self.refused("check", "lines.vtp", saying=["lines.vtp", "point 1"])


if __name__ == "__main__":
    unittest.main()
