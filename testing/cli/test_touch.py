# SPDX-License-Identifier: GPL-3.0-or-later
"""`palpate touch`: the numbers of OUT.csv, each expected value derived from the coupling F = K (proxy - device) / scale."""

import gzip
import json
import math
import os
import re
import unittest
from pathlib import Path

from palpate_cli import SQUARE_FACES, SQUARE_POINTS, CommandLineTest, nifti_bytes, obj_text, vti_text, vtp_text

HEADER = ("t,device_x,device_y,device_z,proxy_x,proxy_y,proxy_z,force_x,force_y,force_z,contacts,cost_us")
# Dyadic numbers: the sums and products of an expected value are exact.
STIFFNESS = 512.0
# A point rests a few units in the last place off a plane; THE BAR (row 11) allows 1e-12 scene units.
PLACE = 1e-12
FORCE = STIFFNESS * PLACE
# Settings that say how numbers in space are felt.
OF_A_FIELD = ("--eigenvector", "--component", "--smoothing", "--first-level", "--between-levels", "--levels-click", "--snap-reach",
              "--compare-full", "--full-length", "--compare-with", "--levels")
# Settings of things that this scene and path lack: an array, a tool, a soft body.
OF_OTHERS = ("--low-rate", "--lever", "--torque-stiffness", *(f"--{of}-{part}" for of in ("stiffness", "friction", "texture")
                                                             for part in ("array", "component", "range", "to")))
WALL_POINTS = [(0, -8, -8), (0, 8, -8), (0, 8, 8), (0, -8, 8)]


def descent(depths, x=0.5, y=0.25):
    """Straight down to each depth below z = 0 in turn, a tick every 1/1024 s."""
    return [(n / 1024, x, y, -depth) for n, depth in enumerate([-1.0, *depths])]


class OnAPlane(CommandLineTest):
    def setUp(self):
        super().setUp()
        self.write_off("plane.off", SQUARE_POINTS, SQUARE_FACES)

    def touch(self, rows, *options, files=("plane.off",)):
        self.write_path(rows)
        self.succeed("touch", *files, "--path", "path.csv", "--csv", "out.csv", *options)
        return self.read_rows()

    def assert_proxy(self, row, expected):
        for axis, value in zip("xyz", expected):
            self.assertAlmostEqual(row[f"proxy_{axis}"], value, delta=PLACE)

    def assert_force(self, row, expected):
        for axis, value in zip("xyz", expected):
            self.assertAlmostEqual(row[f"force_{axis}"], value, delta=FORCE)

    def test_the_header_is_the_one_scripts_rely_on(self):
        self.touch(descent([0.5]))
        self.assertEqual((self.folder / "out.csv").read_text().splitlines()[0], HEADER)

    def test_each_row_answers_one_input_row(self):
        rows = descent([0.25, 0.5, -0.25, 1.0])
        out = self.touch(rows)
        self.assertEqual([(row["t"], row["device_x"], row["device_y"], row["device_z"]) for row in out], rows)

    def test_the_force_on_a_plane_is_stiffness_times_depth(self):
        depths = [0.125, 0.25, 0.5, 2.0, 0.0625]
        out = self.touch(descent(depths), "--stiffness", STIFFNESS)
        self.assertEqual((out[0]["force_x"], out[0]["force_y"], out[0]["force_z"], out[0]["contacts"]), (0, 0, 0, 0))
        for row, depth in zip(out[1:], depths):
            self.assert_proxy(row, (0.5, 0.25, 0.0))
            self.assert_force(row, (0.0, 0.0, STIFFNESS * depth))
            self.assertEqual(row["contacts"], 1)

    def test_the_stiffness_is_1000_newtons_per_metre_unless_given(self):
        self.assertAlmostEqual(self.touch(descent([0.5]))[1]["force_z"], 1000 * 0.5, delta=1000 * PLACE)

    def test_the_force_is_the_coupling_of_the_row_it_stands_in(self):
        # K (proxy - device) / scale of the printed numbers: one division and one product round, each by half an ulp
        out = self.touch([(n / 1000, 0.1, 0.3, 1.0 - n / 10) for n in range(30)], "--stiffness", 700, "--scale", 30)
        self.assertGreater(out[-1]["force_z"], 0)
        for row in out:
            expected = 700 * (row["proxy_z"] - row["device_z"]) / 30
            self.assertAlmostEqual(row["force_z"], expected, delta=4 * math.ulp(expected))

    def test_the_force_does_not_depend_on_how_long_a_tick_is(self):
        slow = self.touch([(0.0, 0, 0, 1.0), (10.0, 0, 0, -0.5)], "--stiffness", STIFFNESS)
        quick = self.touch([(0.0, 0, 0, 1.0), (1e-6, 0, 0, -0.5)], "--stiffness", STIFFNESS)
        self.assertEqual(slow[1]["force_z"], quick[1]["force_z"])

    def test_the_kinetic_friction_is_the_static_one_unless_it_is_given(self):
        depth, static, way = 0.5, 0.5, 0.4  # the displacement is beyond the cone, whose half width is 0.25
        rows = [(0, 0.25, 0.25, 1.0), (1 / 1024, 0.25, 0.25, -depth), (2 / 1024, 0.25 + way, 0.25, -depth)]
        for given, trails in (((), static), (("--mu-kinetic", 0.25), 0.25)):
            out = self.touch(rows, "--stiffness", STIFFNESS, "--mu-static", static, *given)
            self.assert_force(out[2], (-STIFFNESS * trails * depth, 0.0, STIFFNESS * depth))

    def test_a_scale_that_is_not_a_power_of_two_keeps_17_digits_of_the_device(self):
        rows = [(0.0, 0.1, 0.2, 1.0), (0.001, 0.1, 0.2, -0.3)]
        out = self.touch(rows, "--scale", 1000)
        self.assertEqual([(row["device_x"], row["device_y"], row["device_z"]) for row in out], [row[1:] for row in rows])
        self.assertAlmostEqual(out[1]["force_z"], 1000 * 0.3 / 1000, delta=PLACE)

    def test_the_help_lists_its_options_in_groups(self):
        groups = re.split(r"^([A-Z][\w ]*):$", self.succeed("touch", "--help").stdout, flags=re.MULTILINE)
        options = dict(zip(map(str.capitalize, groups[1::2]), groups[2::2]))  # some releases of CLI11 write the first two in capitals
        self.assertEqual(list(options), ["Positionals", "Options", "Input", "Contact", "Material", "Field", "Tool", "Loose body", "Soft body", "Mechanism", "Output"])
        for group, option in (("Input", "--path"), ("Contact", "--radius"), ("Material", "--mu-static"), ("Material", "--friction-array"),
                              ("Field", "--snap-reach"), ("Field", "--mode"), ("Tool", "--lever"), ("Soft body", "--poisson"),
                              ("Mechanism", "--torque-stiffness"), ("Output", "--csv")):
            self.assertRegex(options[group], rf"\n +{re.escape(option)}\b", group)

    def test_every_setting_of_the_page_is_an_option_with_that_default_and_is_felt(self):
        # The page is written from the table of settings, and plugin.properties compares the two.
        page = (Path(os.environ["PALPATE_SOURCE_DIR"]) / "docs/program.md").read_text(encoding="utf-8")
        options = re.findall(r"^\| `(--[\w-]+)(| V| LOW,HIGH| X,Y,Z)` \| (.*); (.*) \|$", page, re.MULTILINE)
        self.assertGreater(len(options), 8)
        help_text = " ".join(self.succeed("touch", "--help").stdout.split())
        rows = [(0.0, 0.0, 0.25, 0.5)] + [(n / 1024, n / 64, 0.25, -0.5) for n in range(1, 9)]
        plain = self.touch(rows)
        felt = [{key: value for key, value in row.items() if key != "cost_us"} for row in plain]
        for option, value, sentence, default in options:
            with self.subTest(option=option):
                self.assertIn(re.split(r";|\. ", sentence)[0], help_text)
                if option in OF_A_FIELD + OF_OTHERS:  # test_field.py, test_materials.py, test_soft.py and test_tool.py feel them
                    self.write_path(rows)
                    given = {"": [], " LOW,HIGH": ["1,2"]}.get(value, ["1"])
                    self.refused("touch", "plane.off", "--path", "path.csv", "--csv", "out.csv", option, *given,
                                 saying=[option, "--field"] if option in OF_A_FIELD else
                                 ["no array '1'"] if option.endswith("-array") else [option])
                    continue
                if not value:
                    self.touch(rows, option)
                    continue
                numbers = [] if default == "none" else [float(n) for n in re.findall(r"-?[\d.]+(?=[ ,]|$)", default)]
                self.touch(rows, option, ",".join(map(repr, numbers)))
                self.assertEqual(felt, [{key: row[key] for key in felt[0]} for row in self.read_rows()])
                self.write_path(rows)
                given = ",".join(repr(number + 0.125) for number in numbers)
                run = self.run_palpate("touch", "plane.off", "--path", "path.csv", "--csv", "out.csv", option, given)
                if run.returncode != 0:
                    self.assertTrue(option in run.stderr, run.stderr)  # needs a thing that this scene or path lacks
                else:
                    self.assertNotEqual(felt, [{key: row[key] for key in felt[0]} for row in self.read_rows()])

    def test_two_files_make_one_scene(self):
        self.write_off("wall.off", WALL_POINTS, SQUARE_FACES)
        rows = [(0.0, 1.0, 0.25, 1.0), (0.001, -0.5, 0.25, -0.25)]
        out = self.touch(rows, "--stiffness", STIFFNESS, files=("plane.off", "wall.off"))
        self.assert_proxy(out[1], (0.0, 0.25, 0.0))
        self.assert_force(out[1], (STIFFNESS * 0.5, 0, STIFFNESS * 0.25))
        self.assertEqual(out[1]["contacts"], 2)

    def test_coplanar_triangles_count_as_one_contact(self):
        # the diagonal of the square passes through x = y
        out = self.touch([(0.0, 0.5, 0.5, 1.0), (0.001, 0.5, 0.5, -0.5)])
        self.assertEqual(out[1]["contacts"], 1)

    def test_columns_in_another_order_and_an_orientation_change_nothing(self):
        plain = self.touch(descent([0.5, 0.25]))
        rows = [(z, y, x, t, 1.0, 0.0, 0.0, 0.0) for t, x, y, z in descent([0.5, 0.25])]
        self.write_path(rows, header="z,y,x,t,qw,qx,qy,qz")
        self.succeed("touch", "plane.off", "--path", "path.csv", "--csv", "out.csv")
        columns = HEADER.split(",")[:-1]
        self.assertEqual([[row[c] for c in columns] for row in self.read_rows()], [[row[c] for c in columns] for row in plain])

    def test_two_runs_agree_bit_for_bit_in_all_but_cost(self):
        rows = [(n / 1024, math.sin(n / 7), math.cos(n / 5), 0.3 - n / 100) for n in range(100)]
        texts = []
        for _ in range(2):
            self.touch(rows, "--radius", 0.125)
            texts.append([line.rsplit(",", 1)[0] for line in (self.folder / "out.csv").read_text().splitlines()])
        self.assertEqual(texts[0], texts[1])

    def test_the_cost_of_a_tick_is_never_negative(self):
        for row in self.touch(descent([0.5] * 50)):
            self.assertGreaterEqual(row["cost_us"], 0.0)

    def test_an_output_that_was_there_is_replaced_and_nothing_is_left_beside_it(self):
        self.write("out.csv", "old")
        self.touch(descent([0.5]))
        self.assertTrue((self.folder / "out.csv").read_text().startswith(HEADER))
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["out.csv", "path.csv", "plane.off"])

    def test_what_cleaning_dropped_is_said_on_stderr(self):
        self.write_off("holes.off", SQUARE_POINTS + [(float("nan"), 0, 0)], SQUARE_FACES + [(0, 1, 4)])
        self.write_path(descent([0.5]))
        run = self.succeed("touch", "holes.off", "--path", "path.csv", "--csv", "out.csv")
        self.assertIn("holes.off", run.stderr)
        self.assertIn("1 dropped: non-finite", run.stderr)


class OnAnImage(CommandLineTest):
    def touch(self, name, rows, *options):
        self.write_path(rows)
        self.succeed("touch", name, "--path", "path.csv", "--csv", "out.csv", "--stiffness", STIFFNESS, *options)
        return self.read_rows()

    @staticmethod
    def half_space(i, j, k):
        """Falls along k: the value 4 - k is 2 on the plane k = 2 and linear in between."""
        return 4.0 - k

    def test_the_iso_surface_of_a_linear_image_is_a_plane_at_its_place(self):
        # iso 1.5 lies at k = 2.5; the origin moves it to z = 12.5
        self.write("a.vti", vti_text(5, self.half_space, origin=(-2, -2, 10)))
        out = self.touch("a.vti", [(0.0, 0.125, 0.25, 16.0), (0.001, 0.125, 0.25, 12.0)], "--iso", 1.5)
        self.assertAlmostEqual(out[1]["force_z"], STIFFNESS * 0.5, delta=1e-9)

    def test_nifti_values_are_rescaled_as_the_header_says(self):
        # stored s means 2 s + 10: iso 13 is stored 1.5, hence k = 2.5
        content = nifti_bytes(5, self.half_space, slope=2.0, intercept=10.0)
        for name, data in (("a.nii", content), ("a.nii.gz", gzip.compress(content))):
            self.write(name, data)
            out = self.touch(name, [(0.0, 2.125, 2.25, 4.0), (0.001, 2.125, 2.25, 2.0)], "--iso", 13)
            self.assertAlmostEqual(out[1]["force_z"], STIFFNESS * 0.5, delta=1e-6)

    def test_nifti_stands_where_its_matrix_puts_it_and_left_stays_left(self):
        # x = 20 - i: a mirrored axis. The value falls along i, so the plane i = 2.5 is at x = 17.5.
        content = nifti_bytes(5, lambda i, j, k: 4.0 - i, affine=[(-1, 0, 0, 20), (0, 1, 0, -2), (0, 0, 1, -2)])
        self.write("a.nii", content)
        out = self.touch("a.nii", [(0.0, 16.0, 0.125, 0.25), (0.001, 18.0, 0.125, 0.25)], "--iso", 1.5)
        self.assertAlmostEqual(out[1]["force_x"], -STIFFNESS * 0.5, delta=1e-6)

    def test_an_image_and_a_mesh_share_a_scene(self):
        self.write("a.vti", vti_text(5, self.half_space))
        self.write("wall.obj", obj_text([(2, -8, -8), (2, 8, -8), (2, 8, 8), (2, -8, 8)], SQUARE_FACES))
        self.write_path([(0.0, 3.0, 2.25, 4.0), (0.001, 1.5, 2.25, 2.0)])
        self.succeed("touch", "a.vti", "wall.obj", "--iso", 1.5, "--path", "path.csv", "--csv", "out.csv",
                     "--stiffness", STIFFNESS)
        row = self.read_rows()[1]
        self.assertAlmostEqual(row["force_x"], STIFFNESS * 0.5, delta=1e-9)
        self.assertAlmostEqual(row["force_z"], STIFFNESS * 0.5, delta=1e-9)


class LargeBall(CommandLineTest):
    """A ball too large for its mesh is told of on one line and goes on: no tick moves it where it is not free."""

    def test_is_warned_of_and_one_that_fits_is_not(self):
        n = 64  # 8192 triangles: more than a tick may look at in every sweep
        points = [(i - n / 2, j - n / 2, 0) for j in range(n + 1) for i in range(n + 1)]
        faces = [f for j in range(n) for i in range(n) for v in [j * (n + 1) + i]
                 for f in ((v, v + 1, v + n + 1), (v + 1, v + n + 2, v + n + 1))]
        self.write_off("fine.off", points, faces)
        for radius, warned in ((1.0, False), (500.0, True)):
            self.write_path([(0.0, 0.25, 0.5, radius + 1.0), (0.001, 0.25, 0.5, radius - 0.5)])
            result = self.succeed("touch", "fine.off", "--path", "path.csv", "--csv", "out.csv", "--radius", radius,
                                  "--stiffness", STIFFNESS)
            self.assertEqual("--radius" in result.stderr, warned)
            self.assertEqual(len(result.stderr.splitlines()), int(warned))
            self.assertAlmostEqual(self.read_rows()[1]["force_z"], STIFFNESS * 0.5, delta=1e-9)


class Check(CommandLineTest):
    def test_the_report_counts_what_was_repaired(self):
        # of 6 triangles: 2 good ones, one repeated, one without area, one twice the same corner, one with NaN
        faces = SQUARE_FACES + [(2, 1, 0), (4, 5, 6), (0, 0, 1), (0, 1, 7)]
        points = SQUARE_POINTS + [(0, 0, 1), (1, 0, 1), (2, 0, 1), (0, 0, float("nan"))]
        self.write_off("a.off", points, faces)
        report = json.loads(self.succeed("check", "a.off", "--json").stdout)
        self.assertTrue(report["touchable"])
        self.assertEqual((report["triangles_in"], report["triangles_out"]), (6, 2))
        self.assertEqual(report["dropped"], {"non_finite": 1, "collinear": 2, "duplicate": 1})
        self.assertEqual((report["boundary_edges"], report["non_manifold_edges"]), (4, 0))
        self.assertEqual((report["low_u"], report["high_u"]), ([-8, -8, 0], [8, 8, 0]))

    def test_the_report_for_a_person_has_units_and_a_plan(self):
        self.write_off("a.off", SQUARE_POINTS, SQUARE_FACES)
        text = self.succeed("check", "a.off").stdout
        self.assertIn("16 x 16 x 0 scene units", text)
        self.assertIn("work", text)

    def test_polygons_are_cut_into_triangles(self):
        self.write_off("quad.off", SQUARE_POINTS, [(0, 1, 2, 3)])
        report = json.loads(self.succeed("check", "quad.off", "--json").stdout)
        self.assertEqual(report["triangles_out"], 2)


if __name__ == "__main__":
    unittest.main()
