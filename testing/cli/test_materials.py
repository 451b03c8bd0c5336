# SPDX-License-Identifier: GPL-3.0-or-later
"""`palpate touch` and `check` with arrays of the data: stiffness, friction and texture by their formulas."""

import json
import unittest

from palpate_cli import SQUARE_FACES, SQUARE_POINTS, CommandLineTest, vtp_text
from says import unsaid

HALF = 8.0  # scene units, of the square
STIFFNESS = 512.0  # N/m, of the coupling
DEPTH = 0.5  # scene units
PLACES = [-7.5, -6.0, -1.5, 0.5, 3.0, 7.0]


def array(name, values, components=1):
    return (f'<DataArray type="Float64" Name="{name}" NumberOfComponents="{components}" format="ascii">'
            f'{" ".join(map(str, values))}</DataArray>')


class Materials(CommandLineTest):
    def setUp(self):
        super().setUp()
        x = [point[0] for point in SQUARE_POINTS]
        y = [point[1] for point in SQUARE_POINTS]
        self.write("square.vtp", vtp_text(
            SQUARE_POINTS, SQUARE_FACES,
            point_data=array("x", x) + array("y", y) + array("v", [c for point in SQUARE_POINTS for c in point], 3) +
            array("holes", [x[0], "nan", "nan", x[3]]),
            cell_data=array("c", [3.0, 3.0])))

    def touch(self, rows, *options, files=("square.vtp",)):
        self.write_path(rows)
        self.succeed("touch", *files, "--path", "path.csv", "--csv", "out.csv", "--stiffness", STIFFNESS, *options)
        return self.read_rows()

    def pressed(self, *options):
        """Down to DEPTH at each place and at rest there: the row at each."""
        rows = []
        for place in PLACES:
            rows += [(place, 0.25, 1.0), (place, 0.25, -DEPTH), (place, 0.25, -DEPTH)]
        return self.touch([(n / 1024, *row) for n, row in enumerate(rows)], *options)[2::3]

    def assert_force(self, row, expected):
        for axis, value in zip("xyz", expected):
            self.assertAlmostEqual(row[f"force_{axis}"], value, delta=STIFFNESS * 1e-12)

    def test_stiffness_follows_an_array_at_every_place(self):
        slope = (400.0 - 80.0) / (2.0 * HALF)
        for row, place in zip(self.pressed("--stiffness-array", "x", "--stiffness-to", "80,400"), PLACES):
            wall = 80.0 + slope * (place + HALF)
            self.assert_force(row, (-0.5 * slope * DEPTH**2, 0.0, wall * DEPTH))

    def test_the_scale_of_the_hand_divides_all_of_it(self):
        slope = (400.0 - 80.0) / (2.0 * HALF)
        options = ("--stiffness-array", "x", "--stiffness-to", "80,400", "--scale", "4")
        for row, place in zip(self.pressed(*options), PLACES):
            wall = 80.0 + slope * (place + HALF)
            self.assert_force(row, (-0.5 * slope * DEPTH**2 / 4, 0.0, wall * DEPTH / 4))

    def test_a_range_of_the_data_and_a_component(self):
        options = ("--stiffness-array", "v", "--stiffness-component", "0", "--stiffness-range", "-1,1",
                   "--stiffness-to", "100,300")
        for row, place in zip(self.pressed(*options), PLACES):
            # The corners, at -8 and 8, lie beyond the range; between them their stiffness is interpolated.
            wall = 100.0 + 200.0 * (place + HALF) / (2.0 * HALF)
            self.assertAlmostEqual(row["force_z"], wall * DEPTH, delta=STIFFNESS * 1e-12)

    def test_of_a_ramp_beyond_the_coupling_the_data_are_felt_up_to_it(self):
        slope = (5000.0 - 100.0) / (2.0 * HALF)
        for row, place in zip(self.pressed("--stiffness-array", "x", "--stiffness-to", "100,5000"), PLACES):
            wall = 100.0 + slope * (place + HALF)
            expected = (-0.5 * slope * DEPTH**2, 0.0, wall * DEPTH) if wall < STIFFNESS else (0.0, 0.0, STIFFNESS * DEPTH)
            self.assert_force(row, expected)

    def test_texture_is_the_force_of_its_potential(self):
        slope = 0.2 / HALF
        for height in ("-0.2,0.2", "0,0.4"):  # the highest texture is the surface
            for row, place in zip(self.pressed("--texture-array", "x", "--texture-to", height), PLACES):
                deep = STIFFNESS * (DEPTH + slope * (place - HALF))
                self.assert_force(row, (-slope * deep, 0.0, deep))

    def test_a_loop_over_a_texture_from_one_height_to_another_gives_no_work(self):
        corners = [(7.0, 0.25, 0.125), (7.0, 0.25, -0.125), (-7.0, 0.25, -0.125), (-7.0, 0.25, 0.125)]
        steps, rows = 1024, []
        for begin, end in zip(corners, corners[1:] + corners[:1]):
            rows += [tuple(b + (e - b) * i / steps for b, e in zip(begin, end)) for i in range(steps)]
        rows.append(corners[0])
        out = self.touch([(n / 1024, *row) for n, row in enumerate(rows)], "--texture-array", "x")
        forces = [tuple(row[f"force_{axis}"] for axis in "xyz") for row in out]
        work = sum(0.5 * (f + g) * (b - a) for here, there, before, after in zip(rows, rows[1:], forces, forces[1:])
                   for a, b, f, g in zip(here, there, before, after))
        # Where a step straddles the end of a hollow the mean of its forces is wrong by K (1 + slope) step^2 / 2 at most.
        self.assertLess(abs(work), 4 * STIFFNESS * max(0.25, 14.0 / 16.0) ** 2 / steps**2)

    def test_tubes_feel_the_arrays_of_their_lines(self):
        tube, ball = 2.0, 0.25
        self.write("line.vtp", vtp_text([(-HALF, 0, 0), (HALF, 0, 0)], [(0, 1)], kind="Lines",
                                        point_data=array("x", [-HALF, HALF])))
        rows = [(n / 1024, place, 0.0, tube + ball + height) for n, (place, height) in
                enumerate((place, height) for place in PLACES for height in (1.0, -DEPTH, -DEPTH))]
        options = ("--line-radius", tube, "--radius", ball, "--stiffness-array", "x", "--stiffness-to", "80,400", "--scale", "4")
        slope = (400.0 - 80.0) / (2.0 * HALF)
        for row, place in zip(self.touch(rows, *options, files=("line.vtp",))[2::3], PLACES):
            wall = 80.0 + slope * (place + HALF)
            self.assert_force(row, (-0.5 * slope * DEPTH**2 / 4, 0.0, wall * DEPTH / 4))

    def test_an_array_that_lines_lack_is_refused_unless_another_file_has_it(self):
        self.write("line.vtp", vtp_text([(-2, 0, 5), (2, 0, 5)], [(0, 1)], kind="Lines"))
        self.write_path([(0.0, 0.0, 0.0, 1.0)])
        touch = ("--path", "path.csv", "--csv", "out.csv", "--line-radius", 0.5, "--stiffness-array", "x")
        self.refused("touch", "line.vtp", *touch, saying=["line.vtp", "no array 'x'"])
        run = self.succeed("touch", "line.vtp", "square.vtp", *touch)
        self.assertEqual(unsaid(run.stderr, "line.vtp (lines): its own stiffness", "no array 'x'"), [])

    def test_friction_follows_an_array(self):
        rows = [(0.0, -4.0, 2.0, 1.0)] + [(n / 1024, -4.0 + n / 32, 2.0, -DEPTH) for n in range(1, 200)]
        out = self.touch(rows, "--friction-array", "y", "--friction-to", "0,0.5")
        mu = 0.5 * (2.0 + HALF) / (2.0 * HALF)
        self.assertAlmostEqual(out[-1]["force_x"], -mu * STIFFNESS * DEPTH, delta=1e-9)
        self.assertAlmostEqual(out[-1]["force_z"], STIFFNESS * DEPTH, delta=1e-9)

    def test_points_without_a_number_are_counted_and_feel_like_the_surface(self):
        self.write_path([(0.0, 7.0, 0.0, 1.0), (1 / 1024, 7.0, 0.0, -DEPTH), (2 / 1024, 7.0, 0.0, -DEPTH)])
        run = self.succeed("touch", "square.vtp", "--path", "path.csv", "--csv", "out.csv", "--stiffness", STIFFNESS,
                           "--stiffness-array", "holes", "--stiffness-to", "64,64")
        self.assertIn("2 points without a number", run.stderr)
        share = (7.0 + HALF) / (2.0 * HALF)
        wall = 64.0 + share * (STIFFNESS - 64.0)
        self.assertAlmostEqual(self.read_rows()[-1]["force_z"], wall * DEPTH, delta=1e-9)

    def test_an_array_of_text_that_ends_with_nan_is_said_to_be_what_vtk_cannot_read(self):
        self.write("nan.vtp", vtp_text(SQUARE_POINTS, SQUARE_FACES, point_data=array("a", [1, 2, 3, "nan"])))
        self.refused("check", "nan.vtp", saying=["nan.vtp", "damaged", "ends with nan"])

    def test_check_says_what_an_array_gives(self):
        text = self.succeed("check", "square.vtp", "--friction-array", "c", "--friction-to", "0.25,0.75").stdout
        self.assertIn("friction from 'c', 3 to 3 as 0.25 to 0.75", text)
        described = json.loads(self.succeed("check", "square.vtp", "--texture-array", "x", "--json").stdout)
        self.assertIn("texture from 'x', -8 to 8 as 0 to 1 scene units", described["material"])

    def test_one_of_many_files_may_be_without_the_array(self):
        self.write_off("other.off", [(x, y, z - 2.0) for x, y, z in SQUARE_POINTS], SQUARE_FACES)
        self.write_path([(0.0, 0.0, 0.5, 1.0)])
        run = self.succeed("touch", "square.vtp", "other.off", "--path", "path.csv", "--csv", "out.csv",
                           "--stiffness-array", "x")
        self.assertEqual(unsaid(run.stderr, "other.off: its own stiffness", "no array 'x'"), [])

    def test_what_the_coupling_cuts_off_is_said(self):
        self.write_path([(0.0, 0.0, 0.0, 1.0)])
        touch = ("touch", "square.vtp", "--path", "path.csv", "--csv", "out.csv", "--stiffness", 512, "--stiffness-array", "x")
        said = "at most 512 N/m is rendered"
        self.assertIn(said, self.succeed(*touch, "--stiffness-to", "100,513").stderr)
        self.assertNotIn(said, self.succeed(*touch, "--stiffness-to", "100,512").stderr)

    def test_what_only_an_array_makes_sense_of_is_refused_without_one(self):
        self.write_path([(0.0, 0.0, 0.0, 1.0)])
        for command in (("check", "square.vtp"), ("touch", "square.vtp", "--path", "path.csv", "--csv", "out.csv")):
            for option in ("--stiffness-to=1,2", "--friction-range=1,2", "--texture-component=0"):
                self.refused(*command, option, saying=[option.split("=")[0], option.split("-")[2] + "-array"])

    def test_an_array_that_cannot_be_used_is_refused_in_one_line(self):
        self.write_path([(0.0, 0.0, 0.0, 1.0)])
        touch = ("touch", "square.vtp", "--path", "path.csv", "--csv", "out.csv")
        self.refused(*touch, "--stiffness-array", "X", saying=["square.vtp", "no array 'X'", "'c', 'holes', 'v', 'x', 'y'"])
        self.refused("check", "square.vtp", "--texture-array", "v", "--texture-component", "3",
                     saying=["square.vtp", "'v' has 3 components"])
        self.refused(*touch, "--friction-array", "x", "--friction-to", "0,10.5", saying=["friction", "0 to 10"])
        self.refused(*touch, "--stiffness-array", "x", "--stiffness-to", "-1,5", saying=["stiffness"])
        self.refused(*touch, "--stiffness-array", "x", "--stiffness-to", "1", saying=["--stiffness-to"])
        self.assertFalse((self.folder / "out.csv").exists())


if __name__ == "__main__":
    unittest.main()
