# SPDX-License-Identifier: GPL-3.0-or-later
"""`palpate check` says whether a mesh is fine enough for a hand, in words and as JSON."""

import json
import math
import unittest

from palpate_cli import SQUARE_FACES, SQUARE_POINTS, CommandLineTest, vtp_text
from says import unsaid


def tube(radius, length, around):
    """Points and faces of an open tube along z of `around` flat strips."""
    points = [(radius * math.cos(2 * math.pi * i / around), radius * math.sin(2 * math.pi * i / around), z)
              for z in (0, length) for i in range(around)]
    faces = []
    for i in range(around):
        j = (i + 1) % around
        faces += [(i, j, around + j), (i, around + j, around + i)]
    return points, faces


# A box of 4 x 4 x 1, two triangles a side, turned outwards.
BOX_POINTS = [(x, y, z) for z in (0, 1) for y in (0, 4) for x in (0, 4)]
BOX_FACES = [(0, 2, 1), (1, 2, 3), (4, 5, 6), (5, 7, 6), (0, 1, 4), (1, 5, 4),
             (2, 6, 3), (3, 6, 7), (0, 4, 2), (2, 4, 6), (1, 3, 5), (3, 7, 5)]


class Faults(CommandLineTest):
    def faults_of(self, faces, *options):
        self.write_off("a.off", BOX_POINTS, faces)
        return json.loads(self.succeed("check", "a.off", "--json", *options).stdout)["faults"]

    def test_a_good_box_has_none(self):
        self.assertEqual(self.faults_of(BOX_FACES, "--thin", 0.9), {"holes": [], "flipped": [], "thin": []})
        said = self.succeed("check", "a.off").stdout
        for word in ("holes", "flipped", "thin"):
            self.assertNotIn(word, said)

    def test_the_rim_of_a_missing_triangle_has_its_points(self):
        holes = self.faults_of(BOX_FACES[1:])["holes"]
        self.assertEqual([hole["points"] for hole in holes], [[0, 1, 2]])
        self.assertAlmostEqual(holes[0]["length_u"], 8 + math.sqrt(32))
        self.assertIn("points 0 1 2", self.succeed("check", "a.off").stdout)

    def test_a_turned_triangle_and_a_box_inside_out_are_named(self):
        turned = [*BOX_FACES[:3], BOX_FACES[3][::-1], *BOX_FACES[4:]]
        self.assertEqual([part["triangles"] for part in self.faults_of(turned)["flipped"]], [[3]])
        inside_out = self.faults_of([face[::-1] for face in BOX_FACES])["flipped"]
        self.assertEqual([part["triangles"] for part in inside_out], [list(range(12))])

    def test_thin_walls_are_those_below_the_length_asked_for(self):
        thin = self.faults_of(BOX_FACES, "--thin", 1.5)["thin"]
        self.assertEqual(sorted(place["triangle"] for place in thin), [0, 1, 2, 3])
        self.assertTrue(all(place["thickness_u"] == 1.0 for place in thin))


class Help(CommandLineTest):
    def test_every_kind_of_file_that_can_be_read_is_named(self):
        self.write("a.xyz", "nonsense")
        read = self.run_palpate("check", "a.xyz").stderr  # "... valid extensions: vtp, vtu, ..."
        kinds = [kind for kind in ("vtp", "vtu", "stl", "ply", "obj", "off", "vti", "nii", "nii.gz", "svg", "png") if kind in read]
        self.assertEqual(len(kinds), 11, read)
        said = " ".join(self.succeed("check", "--help").stdout.split())
        for kind in kinds:
            self.assertIn(kind, said)
        for kind in ("svg", "png"):
            self.assertIn(kind, self.succeed("touch", "--help").stdout)


class Plan(CommandLineTest):
    def plan_of(self, points, faces):
        self.write_off("a.off", points, faces)
        return json.loads(self.succeed("check", "a.off", "--json").stdout)["plan"]

    def test_the_sagitta_of_a_tube_at_the_hand(self):
        radius, around = 10.0, 32
        plan = self.plan_of(*tube(radius, 40.0, around))
        sagitta = radius * (1 - math.cos(math.pi / around))
        self.assertAlmostEqual(plan["deviation_u"], sagitta, delta=0.01 * sagitta)
        self.assertAlmostEqual(plan["scale_u_per_m"], 40.0 / 0.1)  # its longest side is taken to be 100 mm
        self.assertAlmostEqual(plan["deviation_m"], plan["deviation_u"] * 0.1 / 40.0)
        self.assertAlmostEqual(plan["force_error"], plan["deviation_m"] / plan["penetration_m"])
        self.assertTrue(plan["felt"])
        needed = 2 * around * plan["force_error"] / 0.07
        self.assertAlmostEqual(plan["triangles_needed"], needed, delta=1.0)
        self.assertIn(str(plan["triangles_needed"]), plan["sentence"])

    def test_a_fine_tube_and_a_plane_feel_smooth(self):
        self.assertFalse(self.plan_of(*tube(10.0, 40.0, 400))["felt"])
        plane = self.plan_of(SQUARE_POINTS, SQUARE_FACES)
        self.assertEqual((plane["felt"], plane["deviation_u"], plane["sharp_edges"]), (False, 0.0, 0))

    def test_the_sentence_of_a_session_is_said_for_a_file(self):
        points, faces = tube(10.0, 40.0, 32)
        self.write_off("a.off", points, faces)
        said = (f"all {len(faces)} triangles are used (simpler surfaces are worthwhile from 50000 triangles on), "
                "by a point (no radius is set) without friction (none is set), "
                "through a tree of boxes (lists of more than 8 triangles are slower)")
        self.assertIn(said, self.succeed("check", "a.off").stdout)
        self.assertEqual(json.loads(self.succeed("check", "a.off", "--json").stdout)["choice"], said)

    def test_what_a_person_asks_for_is_in_the_sentence_with_what_came_of_it(self):
        self.write_off("a.off", SQUARE_POINTS, SQUARE_FACES)
        choice = lambda *options: json.loads(self.succeed("check", "a.off", "--json", *options).stdout)["choice"]  # noqa: E731
        few = choice("--radius", 1000, "--mu-static", 0.5, "--mu-kinetic", 0.25)
        self.assertEqual(unsaid(few, "sphere of 1e+03 u", "any size", "tick"), [])
        self.assertEqual(unsaid(few, "friction 0.5 at rest, 0.25 sliding"), [])
        self.assertEqual(unsaid(few, "list", "8 triangles"), [])
        self.write_off("a.off", *tube(10.0, 40.0, 4000))
        self.assertEqual(unsaid(choice("--radius", 9.5), " u (9.5 u is set", "work of a tick"), [])
        forced = choice("--radius", 9.5, "--force-radius")
        self.assertEqual(unsaid(forced, "sphere of 9.5 u", "forced; above "), [])

    def test_friction_that_cannot_be_felt_is_refused_by_check_as_by_touch(self):
        self.write_off("a.off", SQUARE_POINTS, SQUARE_FACES)
        self.write_path([(0.0, 0.0, 0.0, 1.0)])
        more = ["--mu-static, --mu-kinetic", "static one, which is at most 10"]
        for friction, saying in ((("--mu-static", 11), ["--mu-static: must be a finite number, 0 to 10, not 11"]),
                                 (("--mu-kinetic", 0.5), more), (("--mu-static", 0.3, "--mu-kinetic", 0.5), more)):
            for command in (("check", "a.off"), ("touch", "a.off", "--path", "path.csv", "--csv", "out.csv")):
                self.refused(*command, *friction, saying=saying)
        self.assertIn("friction 0.3 at rest, 0.3 sliding", self.succeed("check", "a.off", "--mu-static", 0.3).stdout)

    def test_a_simpler_surface_that_is_asked_for_is_in_the_sentence(self):
        self.write_off("a.off", *tube(10.0, 40.0, 400))
        found = json.loads(self.succeed("check", "a.off", "--simplify", "--json").stdout)
        self.assertGreater(found["simplified"]["triangles"], 0)
        self.assertIn(f"{found['simplified']['triangles']} of 800 triangles are used (proven", found["choice"])

    def test_nobody_is_said_to_look_for_a_simpler_surface_that_was_not_asked_for(self):
        self.write_off("a.off", *tube(10.0, 40.0, 30000))
        text = self.succeed("check", "a.off").stdout
        self.assertIn("all 60000 triangles are used (pass --simplify to look for a simpler surface)", text)
        self.assertNotIn("meanwhile", text)

    def test_no_line_of_the_report_says_otherwise_than_what_was_chosen(self):
        self.write_off("a.off", *tube(10.0, 40.0, 400))
        self.assertNotIn("not simplified", self.succeed("check", "a.off", "--simplify").stdout)
        self.write_off("a.off", SQUARE_POINTS, SQUARE_FACES)
        text = self.succeed("check", "a.off").stdout
        self.assertIn("through a list", text)
        self.assertNotIn("through a tree", text)

    def test_a_person_reads_it_with_units(self):
        self.write_off("a.off", *tube(10.0, 40.0, 32))
        text = self.succeed("check", "a.off").stdout
        for part in ("facets", "1 mm deep at 1000 N/m", "%", "felt", "triangles would feel smooth"):
            self.assertIn(part, text)

    def test_a_ball_of_any_size_fits_a_few_triangles_and_a_huge_one_not_a_fine_mesh(self):
        self.write_off("a.off", SQUARE_POINTS, SQUARE_FACES)
        few = json.loads(self.succeed("check", "a.off", "--radius", 1000, "--json").stdout)["radius"]
        self.assertEqual((few["asked_u"], few["largest_u"], few["kept"]), (1000.0, None, True))
        self.write_off("a.off", *tube(10.0, 40.0, 4000))
        text = self.succeed("check", "a.off", "--radius", 9.5).stdout
        self.assertIn("may run out of a tick's work", text)
        fine = json.loads(self.succeed("check", "a.off", "--json").stdout)["radius"]
        self.assertTrue(fine["kept"])  # a point
        self.assertLess(fine["largest_u"], 9.5)


class Curves(CommandLineTest):
    """Lines that lie in no plane: they are touched as tubes."""

    def setUp(self):
        super().setUp()
        points = [(0, 0, 0), (4, 0, 0), (4, 4, 1), (0, 4, 3)]
        self.write("lines.vtp", vtp_text(points, [(0, 1, 2, 3)], kind="Lines"))

    def test_without_a_radius_tubes_are_named(self):
        self.refused("check", "lines.vtp", saying=["plane z = 0", "tubes", "--line-radius"])

    def test_tubes_are_counted_and_their_radius_is_said(self):
        text = self.succeed("check", "lines.vtp", "--line-radius", 0.25).stdout
        for said in ("kept 3 of 3 segments", "4 x 4 x 3 scene units", "all 3 segments are used",
                     "3 segments, touched as tubes of 0.25 scene units"):
            self.assertIn(said, text)
        self.assertNotIn("facets", text)
        found = json.loads(self.succeed("check", "lines.vtp", "--line-radius", 0.25, "--json").stdout)
        self.assertEqual((found["touchable"], found["plane_world"], found["tube_radius_u"]), (True, False, 0.25))

    def test_lines_beside_polygons_are_checked_with_them(self):
        both = vtp_text(SQUARE_POINTS, SQUARE_FACES).replace(
            'NumberOfLines="0"', 'NumberOfLines="1"').replace("<Polys>", """<Lines>
<DataArray type="Int64" Name="connectivity" format="ascii">0 2</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">2</DataArray></Lines><Polys>""")
        self.write("both.vtp", both)
        text = self.succeed("check", "both.vtp", "--line-radius", 0.25).stdout
        for said in ("kept 2 of 2 triangles", "kept 1 of 1 segments", "all 3 triangles and segments are used", "tubes of 0.25"):
            self.assertIn(said, text)
        found = json.loads(self.succeed("check", "both.vtp", "--line-radius", 0.25, "--json").stdout)
        self.assertEqual((found["triangles_in"], found["lines"]["triangles_in"]), (2, 1))

    def test_a_radius_that_cannot_be_is_refused(self):
        for bad in ("-1", "nan", "inf"):
            self.refused("check", "lines.vtp", "--line-radius", bad, saying=["--line-radius", "0 or more"])
        self.write_off("a.off", SQUARE_POINTS, SQUARE_FACES)
        self.write_path([(0.0, 0.0, 0.0, 1.0)])
        for command in (("check", "a.off"), ("touch", "a.off", "--path", "path.csv", "--csv", "out.csv")):
            self.refused(*command, "--line-radius", 1, saying=["a.off", "no lines", "--line-radius"])


if __name__ == "__main__":
    unittest.main()
