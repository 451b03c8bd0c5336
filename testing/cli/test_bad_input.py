# SPDX-License-Identifier: GPL-3.0-or-later
"""Bad input: exit code 2 and one line that names the file and the reason; an earlier output is untouched."""

import gzip
import json
import re
import unittest

import palpate
from palpate_cli import (SQUARE_FACES, SQUARE_POINTS, CommandLineTest, nifti_bytes, obj_text, off_text, ply_text,
                         stl_bytes, stl_text, vti_text, vtp_text, vtu_text)
from vtkmodules.vtkCommonCore import vtkVersion

NAN_POINTS = [(float("nan"), 0, 0), (1, 0, 0), (0, 1, 0)]
LINE_POINTS = [(0, 0, 0), (1, 1, 1), (2, 2, 2)]
ONE_FACE = [(0, 1, 2)]
BILLION = 1000000000


def makers():
    """Every mesh format as (name, function of points and faces)."""
    return [("a.off", off_text), ("a.obj", obj_text), ("a.ply", ply_text), ("a.stl", stl_bytes), ("t.stl", stl_text),
            ("a.vtp", vtp_text), ("a.vtu", vtu_text)]


def ball(i, j, k):
    """Squared distance from the middle of an 8^3 image, falling outwards."""
    return 100.0 - ((i - 3.5) ** 2 + (j - 3.5) ** 2 + (k - 3.5) ** 2)


class MeshFiles(CommandLineTest):
    def test_a_good_square_is_touchable_in_every_format(self):
        for name, make in makers():
            with self.subTest(name=name):
                self.write(name, make(SQUARE_POINTS, SQUARE_FACES))
                self.assertIn("kept 2 of 2 triangles", self.succeed("check", name).stdout)

    def test_a_missing_file(self):
        for extension in ("off", "obj", "ply", "stl", "vtp", "vtu"):
            self.refused("check", f"gone.{extension}", saying=[f"gone.{extension}", "no such file"])

    def test_a_folder_instead_of_a_file(self):
        (self.folder / "folder.off").mkdir()
        self.refused("check", "folder.off", saying=["folder.off", "not a regular file"])

    def test_an_empty_file(self):
        for extension in ("off", "obj", "ply", "stl", "vtp", "vtu", "vti", "nii", "nii.gz"):
            name = self.write(f"empty.{extension}", "").name
            self.refused("check", name, "--iso", 1, saying=[name, "empty"])

    def test_an_unknown_extension_lists_the_known_ones(self):
        self.write("a.xyz", "0 0 0\n")
        self.refused("check", "a.xyz", saying=["a.xyz", "'xyz'", "vtp", "vtu", "vti", "stl", "ply", "obj", "off", "nii.gz"])
        self.write("bare", "0 0 0\n")
        self.refused("check", "bare", saying=["bare", "no extension"])

    def test_a_file_cut_short_at_any_place_never_passes_as_whole(self):
        for name, make in makers():
            content = make(SQUARE_POINTS, SQUARE_FACES)
            whole = len(content.rstrip())
            if name.endswith(".obj"):
                whole = content.index("\nf ")  # nothing in an OBJ file tells how many faces follow
            if name == "t.stl":
                whole = content.index("endsolid")  # all that follows is a name
            for length in range(1, whole, max(1, whole // 23)):
                with self.subTest(name=name, length=length):
                    self.write(name, content[:length])
                    self.refused("check", name, saying=[name])

    def test_a_header_that_promises_a_billion_points(self):
        for name, make in (("a.ply", ply_text), ("a.stl", stl_bytes), ("a.vtp", vtp_text), ("a.vtu", vtu_text)):
            with self.subTest(name=name):
                self.write(name, make(SQUARE_POINTS, SQUARE_FACES, promised=BILLION))
                self.refused("check", name, saying=[name, "promises", str(BILLION)])
        self.write("a.off", f"OFF\n{BILLION} 1 0\n0 0 0\n")
        self.refused("check", "a.off", saying=["a.off", "promises", str(BILLION)])
        self.write("faces.off", f"OFF\n1 {BILLION} 0\n0 0 0\n")
        self.refused("check", "faces.off", saying=["faces.off", "promises", str(BILLION)])

    def test_more_than_the_header_promises(self):
        self.write("a.off", off_text(SQUARE_POINTS, SQUARE_FACES) + "3 0 1 2\n")
        self.refused("check", "a.off", saying=["a.off", "more in it"])
        self.write("a.ply", ply_text(SQUARE_POINTS, SQUARE_FACES) + "3 0 1 2\n")
        self.refused("check", "a.ply", saying=["a.ply", "more in it"])

    def test_points_that_are_not_numbers(self):
        for name, make in makers():
            with self.subTest(name=name):
                self.write(name, make(NAN_POINTS, ONE_FACE))
                self.refused("check", name, saying=[name])

    def test_a_nan_point_of_one_triangle_is_reported_as_repaired(self):
        self.write_off("a.off", SQUARE_POINTS + [(float("nan"), 0, 0)], SQUARE_FACES + [(0, 1, 4)])
        self.assertIn("1 dropped: non-finite", self.succeed("check", "a.off").stdout)

    def test_triangles_without_area(self):
        for name, make in makers():
            with self.subTest(name=name):
                self.write(name, make(LINE_POINTS, ONE_FACE))
                self.refused("check", name, saying=[name, "without area"])

    def test_polygons_without_area(self):
        line = [(0, 0, 0), (1, 1, 1), (2, 2, 2), (3, 3, 3)]
        self.write_off("all.off", line, [(0, 1, 2, 3)])
        self.refused("check", "all.off", saying=["all.off", "without area"])
        self.write_off("one.off", line + SQUARE_POINTS, [(0, 1, 2, 3), (4, 5, 6, 7)])
        self.assertIn("2 dropped: no area", self.succeed("check", "one.off").stdout)

    def test_a_polygon_with_a_nan_corner_is_said_as_a_hole_with_its_edges(self):
        points = SQUARE_POINTS + [(0, 0, 5), (1, 0, 5), (2, 1, 5), (1, 2, 5), (0, float("nan"), 5)]
        pentagon = (4, 5, 6, 7, 8)
        self.write_off("one.off", points, [(0, 1, 2, 3), pentagon])
        self.assertIn("1 hole of 5 edges", self.succeed("check", "one.off").stdout)
        self.assertEqual(json.loads(self.succeed("check", "one.off", "--json").stdout)["hole_edges"], [5])
        self.write_off("all.off", points, [pentagon])
        self.refused("check", "all.off", saying=["all.off", "1 hole of 5 edges"])

    def test_points_without_triangles(self):
        for name, make in (("a.off", off_text), ("a.obj", obj_text), ("a.ply", ply_text), ("a.vtp", vtp_text),
                           ("a.vtu", vtu_text)):
            with self.subTest(name=name):
                self.write(name, make(SQUARE_POINTS, []))
                self.refused("check", name, saying=[name, "4 points but no triangles"])

    def test_a_face_that_names_a_point_that_is_not_there(self):
        for name, make in (("a.off", off_text), ("a.obj", obj_text), ("a.ply", ply_text), ("a.vtp", vtp_text),
                           ("a.vtu", vtu_text)):
            with self.subTest(name=name):
                self.write(name, make(SQUARE_POINTS, [(0, 1, 9)]))
                self.refused("check", name, saying=[name, "names point"])
        self.write("negative.off", off_text(SQUARE_POINTS, [(0, 1, -1)]))
        self.refused("check", "negative.off", saying=["negative.off", "names point -1"])

    def test_a_cell_with_too_few_points_for_its_type(self):
        self.write("a.vtu", vtu_text(SQUARE_POINTS, ONE_FACE, cell_type=12))
        self.refused("check", "a.vtu", saying=["a.vtu", "type 12"])

    def test_iso_for_a_mesh(self):
        self.write_off("a.off", SQUARE_POINTS, SQUARE_FACES)
        self.refused("check", "a.off", "--iso", 1, saying=["a.off", "--iso"])

    def test_a_refusal_is_json_where_json_was_asked_for(self):
        run = self.run_palpate("check", "gone.off", "--json")
        self.assertEqual(run.returncode, 2)
        self.assertIn('"touchable": false', run.stdout)
        self.assertIn("no such file", run.stderr)


class ImageFiles(CommandLineTest):
    def images(self):
        return [("a.vti", vti_text(8, ball)), ("a.nii", nifti_bytes(8, ball)),
                ("a.nii.gz", gzip.compress(nifti_bytes(8, ball)))]

    def test_a_good_image_is_touchable_at_its_iso_value(self):
        for name, content in self.images():
            with self.subTest(name=name):
                self.write(name, content)
                self.succeed("check", name, "--iso", 95)

    def test_iso_missing_for_an_image(self):
        for name, content in self.images():
            with self.subTest(name=name):
                self.write(name, content)
                self.refused("check", name, saying=[name, "--iso"])

    def test_an_iso_value_that_meets_nothing_or_is_none(self):
        for name, content in self.images():
            self.write(name, content)
            self.refused("check", name, "--iso", 1000, saying=[name, "1000", "from 63.25 to 99.25"])
            self.refused("check", name, "--iso", "nan", saying=[name, "finite"])

    def test_an_image_without_a_scalar(self):
        self.write("a.vti", vti_text(4, ball, with_scalars=False))
        self.refused("check", "a.vti", "--iso", 1, saying=["a.vti", "no scalar"])

    def test_an_image_of_one_slice(self):
        self.write("a.vti", vti_text(1, ball))
        self.refused("check", "a.vti", "--iso", 1, saying=["a.vti"])

    def test_an_image_cut_short(self):
        for name, content in self.images():
            end = len(content) - (8 if name.endswith(".gz") else 0)  # the checksum at the end holds no data
            for length in range(1, end, end // 17):
                with self.subTest(name=name, length=length):
                    self.write(name, content[:length])
                    self.refused("check", name, "--iso", 95, saying=[name])

    def test_an_image_that_promises_too_much(self):
        self.write("a.vti", vti_text(2, ball, extent="0 999 0 999 0 999"))
        self.refused("check", "a.vti", "--iso", 1, saying=["a.vti", "promises"])
        self.write("a.nii", nifti_bytes(2, ball, promised=1000))
        self.refused("check", "a.nii", "--iso", 1, saying=["a.nii", "promises", "1000 x 1000 x 1000"])
        self.write("a.nii.gz", gzip.compress(nifti_bytes(2, ball, promised=1000)))
        self.refused("check", "a.nii.gz", "--iso", 1, saying=["a.nii.gz", "promises", "1000 x 1000 x 1000"])

    def test_voxels_that_are_no_real_numbers(self):
        content = bytearray(nifti_bytes(2, ball))
        content[70:72] = (128).to_bytes(2, "little")  # RGB
        self.write("a.nii", bytes(content))
        self.refused("check", "a.nii", "--iso", 1, saying=["a.nii", "type 128"])


class Paths(CommandLineTest):
    GOOD = [(0.0, 0.0, 0.0, 1.0), (0.001, 0.0, 0.0, -0.5)]

    def setUp(self):
        super().setUp()
        self.write_off("plane.off", SQUARE_POINTS, SQUARE_FACES)
        self.write_path(self.GOOD, name="good.csv")

    def refused_path(self, text, saying):
        self.write("out.csv", "kept")
        self.write("path.csv", text)
        self.refused("touch", "plane.off", "--path", "path.csv", "--csv", "out.csv", saying=["path.csv", *saying])
        self.assertEqual((self.folder / "out.csv").read_text(), "kept")
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()),
                         ["good.csv", "out.csv", "path.csv", "plane.off"])

    def test_a_missing_path(self):
        self.refused("touch", "plane.off", "--path", "gone.csv", "--csv", "out.csv", saying=["gone.csv", "no such file"])

    def test_an_empty_path(self):
        self.refused_path("", ["empty"])

    def test_no_rows(self):
        self.refused_path("t,x,y,z\n", ["no rows"])
        self.refused_path("t,x,y,z\n\n", ["no rows"])

    def test_a_missing_column(self):
        for header in ("t,x,y", "x,y,z", "t,x,z"):
            self.refused_path(header + "\n0,0,0\n", ["line 1", "is missing"])
        self.refused_path("t,x,y,z,qw,qx,qy\n0,0,0,0,1,0,0\n", ["line 1", "'qz'"])

    def test_a_column_that_is_not_known_or_there_twice(self):
        self.refused_path("t,x,y,z,force\n0,0,0,0,0\n", ["line 1", "'force'"])
        self.refused_path("t,x,y,z,x\n0,0,0,0,0\n", ["line 1", "'x'", "twice"])
        self.refused_path("0,0,0,0\n", ["line 1", "'0'"])

    def test_a_row_with_too_few_or_too_many_values(self):
        self.refused_path("t,x,y,z\n0,0,0\n", ["line 2", "3 values"])
        self.refused_path("t,x,y,z\n0,0,0,0,0\n", ["line 2", "5 values"])

    def test_something_that_is_not_a_finite_number(self):
        for text in ("one", "", "1.0.0", "nan", "inf", "-inf", "1e999", "0x10", "1 2"):
            with self.subTest(text=text):
                self.refused_path(f"t,x,y,z\n0,0,0,0\n1,0,{text},0\n", ["line 3", "y is", "not a finite number"])

    def test_time_that_does_not_increase(self):
        self.refused_path("t,x,y,z\n0,0,0,0\n0,0,0,0\n", ["line 3", "does not increase"])
        self.refused_path("t,x,y,z\n0,0,0,0\n1,0,0,0\n0.5,0,0,0\n", ["line 4", "does not increase"])

    def test_a_blank_line_between_rows(self):
        self.refused_path("t,x,y,z\n0,0,0,0\n\n1,0,0,0\n", ["line 3", "empty"])

    def test_a_quaternion_that_is_none(self):
        self.refused_path("t,x,y,z,qw,qx,qy,qz\n0,0,0,0,0,0,0,0\n", ["line 2", "quaternion"])


class Options(CommandLineTest):
    def setUp(self):
        super().setUp()
        self.write_off("plane.off", SQUARE_POINTS, SQUARE_FACES)
        self.write_path([(0.0, 0.0, 0.0, 1.0)])
        self.touch = ["touch", "plane.off", "--path", "path.csv", "--csv", "out.csv"]

    def test_numbers_that_make_no_sense(self):
        for option in ("--radius", "--stiffness", "--scale"):
            for value in ("-1", "nan", "inf", "-inf"):
                with self.subTest(option=option, value=value):
                    self.refused(*self.touch, option, value, saying=[option, "finite number"])
            self.refused(*self.touch, option, "abc", saying=[option])
        self.refused(*self.touch, "--scale", "0", saying=["--scale", "more than 0"])

    def test_friction_that_makes_no_sense(self):
        self.refused(*self.touch, "--mu-static", "-0.5", saying=["--mu-static", "a finite number, 0 to 10"])
        self.refused(*self.touch, "--mu-static", "nan", saying=["--mu-static"])
        self.refused(*self.touch, "--mu-static", "0.2", "--mu-kinetic", "0.5", saying=["kinetic", "static"])

    def test_nothing_is_ignored(self):
        self.refused(*self.touch, "--colour", "red", saying=["--colour"])
        self.refused("check", "plane.off", "path.csv", saying=["path.csv"])
        self.refused("devices", "--csv", "x", saying=["--csv"])
        self.refused(*self.touch, "--radius", "1", "--radius", "2", saying=["--radius"])
        self.refused("stroke", saying=["stroke"])
        self.refused(saying=["devices", "check", "touch", "replay"])

    def test_what_has_to_be_given(self):
        self.refused("check", saying=["FILE"])
        self.refused("touch", "plane.off", "--csv", "out.csv", saying=["--path"])
        self.refused("touch", "plane.off", "--path", "path.csv", saying=["--csv"])
        self.refused("touch", "--path", "path.csv", "--csv", "out.csv", saying=["FILE"])

    def test_iso_without_an_image(self):
        self.refused(*self.touch, "--iso", "1", saying=["plane.off", "--iso"])

    def test_an_output_that_cannot_be_written(self):
        (self.folder / "folder").mkdir()
        for target in ("gone/out.csv", "folder", "/dev/null"):
            with self.subTest(target=target):
                self.refused("touch", "plane.off", "--path", "path.csv", "--csv", target, saying=[target])

    def test_an_output_that_is_an_input_is_not_overwritten(self):
        for target in ("plane.off", "path.csv"):
            before = (self.folder / target).read_text()
            self.refused("touch", "plane.off", "--path", "path.csv", "--csv", target, saying=[target, "input"])
            self.assertEqual((self.folder / target).read_text(), before)

    def test_one_bad_surface_among_good_ones(self):
        self.write("bad.off", "OFF\n")
        self.write("out.csv", "kept")
        self.refused("touch", "plane.off", "bad.off", "--path", "path.csv", "--csv", "out.csv", saying=["bad.off"])
        self.assertEqual((self.folder / "out.csv").read_text(), "kept")

    def test_help_and_version_are_no_errors(self):
        self.assertIn("touch", self.succeed("--help").stdout)
        self.assertIn("--path", self.succeed("touch", "--help").stdout)

    def test_the_version_is_given_with_those_of_the_libraries(self):
        own, libraries = self.succeed("--version").stdout.strip().split("\n")
        self.assertEqual(own, palpate.__version__)
        self.assertRegex(libraries, r"^made with ParaView [0-9.]+ and Qt [56], runs with VTK " + re.escape(vtkVersion.GetVTKVersion()) + "$")


if __name__ == "__main__":
    unittest.main()
