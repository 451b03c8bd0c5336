# SPDX-License-Identifier: GPL-3.0-or-later
"""Every spelling of a mesh that the readers promise gives the same square of side 16 in the plane z = 0."""

import json
import struct
import unittest

from palpate_cli import SQUARE_FACES, SQUARE_POINTS, CommandLineTest, off_text, obj_text, ply_text, vtu_text

POINTS_TEXT = "-8 -8 0\n8 -8 0\n8 8 0\n-8 8 0\n"
QUAD = [(0, 1, 2, 3)]


class Spellings(CommandLineTest):
    def square(self, name, content):
        self.write(name, content)
        run = self.succeed("check", name, "--json")
        report = json.loads(run.stdout)
        self.assertEqual((report["low_u"], report["high_u"]), ([-8, -8, 0], [8, 8, 0]))
        self.assertEqual((report["triangles_out"], report["vertices_out"], report["boundary_edges"]), (2, 4, 4))
        self.assertEqual(run.stderr, "")


class OFF(Spellings):
    def test_the_keyword_may_share_a_line_with_the_counts_or_be_left_out(self):
        body = POINTS_TEXT + "3 0 1 2\n3 0 2 3\n"
        self.square("a.off", "OFF 4 2 5\n" + body)
        self.square("b.off", "4 2 5\n" + body)
        self.square("c.off", "OFF\n4 2\n" + body)

    def test_comments_blank_lines_and_other_line_ends(self):
        text = "# made by hand\nOFF # a square\n\n4 2 0\n" + POINTS_TEXT + "\n# faces\n3 0 1 2\n3 0 2 3"
        self.square("a.off", text)
        self.square("b.off", text.replace("\n", "\r\n"))

    def test_colours_and_normals_are_read_over(self):
        points = POINTS_TEXT.replace(" 0\n", " 0 255 128 0 255\n")
        self.square("a.off", "COFF\n4 2 0\n" + points + "3 0 1 2 0.5 0.5 0.5\n3 0 2 3 7\n")
        normals = POINTS_TEXT.replace(" 0\n", " 0 0 0 1\n")
        self.square("b.off", "NOFF\n4 2 0\n" + normals + "3 0 1 2\n3 0 2 3\n")

    def test_a_quadrilateral(self):
        self.square("a.off", off_text(SQUARE_POINTS, QUAD))

    def test_what_is_another_kind_of_off_is_refused(self):
        for keyword in ("4OFF", "nOFF", "HOFF", "OFF BINARY"):
            self.write("a.off", keyword + "\n4 1 0\n" + POINTS_TEXT + "4 0 1 2 3\n")
            self.refused("check", "a.off", saying=["a.off", "OFF"])


class OBJ(Spellings):
    def test_indices_may_count_from_the_end_and_carry_texture_and_normal(self):
        points = "".join(f"v {x} {y} {z}\n" for x, y, z in SQUARE_POINTS)
        self.square("a.obj", points + "vt 0 0\nvn 0 0 1\nf 1/1/1 2//1 3/1\nf -4 -2 -1\n")

    def test_names_materials_weights_and_lines_are_read_over(self):
        points = "".join(f"v {x} {y} {z} 1.0\n" for x, y, z in SQUARE_POINTS)
        self.square("a.obj", f"mtllib a.mtl\no square\n{points}g all\nusemtl grey\ns off\nf 1 2 \\\n3 4\nl 1 2\n")

    def test_an_index_of_zero_and_free_form_surfaces_are_refused(self):
        self.write("a.obj", obj_text(SQUARE_POINTS, []) + "f 0 1 2\n")
        self.refused("check", "a.obj", saying=["a.obj", "counted from 1"])
        self.write("b.obj", obj_text(SQUARE_POINTS, SQUARE_FACES) + "surf 0 1 0 1 1 2 3 4\n")
        self.refused("check", "b.obj", saying=["b.obj", "'surf'"])


class PLY(Spellings):
    HEADER = ("ply\nformat {format} 1.0\ncomment a square\nobj_info none\nelement vertex 4\nproperty uchar red\n"
              "property float x\nproperty float32 y\nproperty double z\nelement face 2\nproperty uchar flags\n"
              "property list uint8 int32 vertex_index\nelement edge 1\nproperty int vertex1\nend_header\n")

    def binary(self, order):
        points = b"".join(struct.pack(order + "Bffd", 7, *point) for point in SQUARE_POINTS)
        faces = b"".join(struct.pack(order + "BB3i", 9, 3, *face) for face in SQUARE_FACES)
        return points + faces + struct.pack(order + "i", 0)

    def test_binary_of_either_byte_order(self):
        self.square("a.ply", self.HEADER.format(format="binary_little_endian").encode() + self.binary("<"))
        self.square("b.ply", self.HEADER.format(format="binary_big_endian").encode() + self.binary(">"))

    def test_text_with_other_properties_between(self):
        points = "".join("7 {} {} {}\n".format(*point) for point in SQUARE_POINTS)
        faces = "".join("9 3 {} {} {}\n".format(*face) for face in SQUARE_FACES)
        self.square("a.ply", self.HEADER.format(format="ascii") + points + faces + "0\n")

    def test_binary_cut_short_at_any_place(self):
        content = self.HEADER.format(format="binary_little_endian").encode() + self.binary("<")
        for length in [*range(1, len(content), 7), len(content) - 1]:
            self.write("a.ply", content[:length])
            self.refused("check", "a.ply", saying=["a.ply"])

    def test_a_quadrilateral(self):
        self.square("a.ply", ply_text(SQUARE_POINTS, QUAD))

    STRIPS = ("ply\nformat {format} 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
              "element tristrips 1\nproperty list int int vertex_indices\nend_header\n")

    def test_triangle_strips(self):
        text = self.STRIPS.format(format="ascii") + POINTS_TEXT
        self.square("one.ply", text + "4 0 1 3 2\n")
        self.square("two.ply", text + "8 0 1 2 -1 0 2 3 -1\n")
        self.square("short.ply", text + "10 -1 0 1 -1 3 2 0 1 -1 2\n")  # one or two points are no triangle
        points = b"".join(struct.pack("<3f", *point) for point in SQUARE_POINTS)
        self.square("binary.ply", self.STRIPS.format(format="binary_little_endian").encode() + points +
                    struct.pack("<5i", 4, 0, 1, 3, 2))

    def test_a_strip_that_names_no_point_is_refused(self):
        for indices in ("3 0 1 4", "3 0 1 -2", "4 0 1 3"):
            self.write("a.ply", self.STRIPS.format(format="ascii") + POINTS_TEXT + indices + "\n")
            self.refused("check", "a.ply", saying=["a.ply"])

    def test_lists_beside_the_faces_and_header_lines_of_no_meaning(self):
        text = ("ply\nformat ascii 1.0\nCreated by nobody\n\nelement vertex 4\nproperty float x\nproperty float y\n"
                "property float z\nproperty list uchar int marks\nelement face 2\nproperty list float float texcoord\n"
                "property list uchar int vertex_indices\nproperty list uchar int vertex_index\nend_header\n")
        points = POINTS_TEXT.replace(" 0\n", " 0 2 7 7\n")
        self.square("a.ply", text + points + "2 0.5 0.5 3 0 1 2 2 7 7\n0 3 0 2 3 0\n")
        self.write("b.ply", text + points + "1.5 0.5 3 0 1 2 0\n0 3 0 2 3 0\n")
        self.refused("check", "b.ply", saying=["b.ply", "not whole"])
        self.write("c.ply", "ply\nformat ascii 1.0\nproperty float x\nend_header\n")
        self.refused("check", "c.ply", saying=["c.ply", "belongs to no element"])


class VTU(Spellings):
    def test_a_quadrilateral_cell(self):
        self.square("a.vtu", vtu_text(SQUARE_POINTS, QUAD, cell_type=9))

    def test_the_skin_of_two_tetrahedra_has_no_inner_face(self):
        points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1)]
        self.write("a.vtu", vtu_text(points, [(0, 1, 2, 3), (1, 2, 3, 4)], cell_type=10))
        report = json.loads(self.succeed("check", "a.vtu", "--json").stdout)
        self.assertEqual((report["triangles_out"], report["boundary_edges"]), (2 * 4 - 2, 0))


if __name__ == "__main__":
    unittest.main()
