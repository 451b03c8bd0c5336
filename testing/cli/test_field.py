# SPDX-License-Identifier: GPL-3.0-or-later
"""`palpate touch --field`: forces of numbers in space along a path, each expected value derived from a formula. The files
are written by hand here, so no reader or writer of VTK's is judge of itself."""

import itertools
import math
import unittest

from palpate_cli import CommandLineTest, SQUARE_FACES, SQUARE_POINTS, nifti_bytes, vtp_text, vtu_text
from says import unsaid

STIFFNESS = 512.0
SIZE = 17


def image_text(size, arrays, spacing=1.0, origin=(0.0, 0.0, 0.0)):
    """A vti of size^3 points; `arrays`: name, components and value(x, y, z) of each."""
    places = [[o + spacing * i for o, i in zip(origin, (i, j, k))]
              for k in range(size) for j in range(size) for i in range(size)]
    data = ""
    for name, components, value in arrays:
        numbers = " ".join(repr(v) for p in places for v in (value(*p) if components > 1 else [value(*p)]))
        data += (f'<DataArray type="Float32" Name="{name}" NumberOfComponents="{components}" format="ascii">'
                 f"{numbers}</DataArray>")
    whole = f"0 {size - 1} " * 3
    return f"""<VTKFile type="ImageData" version="0.1" byte_order="LittleEndian">
<ImageData WholeExtent="{whole}" Origin="{origin[0]} {origin[1]} {origin[2]}" Spacing="{spacing} {spacing} {spacing}">
<Piece Extent="{whole}"><PointData>{data}</PointData></Piece></ImageData></VTKFile>
"""


def tetrahedra(size):
    """Cubes of size^3 whole points, each cut into six tetrahedra round its diagonal."""
    points = [(i, j, k) for k in range(size) for j in range(size) for i in range(size)]
    cells = []
    for low in (p for p in points if max(p) < size - 1):
        for order in itertools.permutations(range(3)):
            corner, cell = list(low), [low]
            for axis in order:
                corner[axis] += 1
                cell.append(tuple(corner))
            cells.append([points.index(p) for p in cell])
    return points, cells


class InAField(CommandLineTest):
    def touch(self, rows, *options, files=("f.vti",)):
        self.write_path(rows)
        self.succeed("touch", *files, "--path", "path.csv", "--csv", "out.csv", "--stiffness", STIFFNESS, *options)
        return self.read_rows()

    def write_image(self, *arrays, **place):
        self.write("f.vti", image_text(SIZE, arrays, **place))

    def force(self, row):
        return [row[f"force_{axis}"] for axis in "xyz"]

    def assert_near(self, found, expected, delta):
        for one, other in zip(found, expected):
            self.assertAlmostEqual(one, other, delta=delta)

    def test_the_isosurface_of_a_linear_field_is_a_plane_and_pushes_along_its_normal(self):
        # floats hold f = 0.5 x + 0.25 y + z exactly on whole numbers, and trilinear values of it are itself
        normal = [c / math.sqrt(0.25 + 0.0625 + 1.0) for c in (0.5, 0.25, 1.0)]
        self.write_image(("f", 1, lambda x, y, z: 0.5 * x + 0.25 * y + z))
        start = (6.25, 7.5, 5.0)  # f = 10
        depths = [n / 64 for n in range(-32, 97)]
        rows = [(n / 1024, *(s - d * c for s, c in zip(start, normal))) for n, d in enumerate(depths)]
        out = self.touch(rows, "--field", "f", "--mode", "isosurface", "--iso", 10)
        for depth, row in zip(depths, out):
            self.assert_near(self.force(row), [STIFFNESS * max(0.0, depth) * c for c in normal], 1e-9)
            if depth > 1e-9:
                self.assert_near([row[f"proxy_{axis}"] for axis in "xyz"], start, 1e-11)
                self.assertEqual(row["contacts"], 1)

    def test_blocks_are_felt_as_the_whole_that_they_were_cut_from(self):
        def height(x, y, z):
            return 0.5 * x + z

        files = ""
        for n in range(2):  # in a block of blocks the second
            self.write(f"part{n}.vti", image_text(9, [("f", 1, height)], origin=(8.0 * n, 0.0, 0.0)))
            files += ("<Block>" if n else "") + f'<DataSet index="0" file="part{n}.vti"/>' + ("</Block>" if n else "")
        self.write("f.vtm", '<VTKFile type="vtkMultiBlockDataSet" version="1.0"><vtkMultiBlockDataSet>' + files
                   + "</vtkMultiBlockDataSet></VTKFile>")
        normal = [c / math.sqrt(1.25) for c in (0.5, 0.0, 1.0)]
        rows = [(0.0, 2.0, 4.0, 7.0), (1 / 1024, 2.0, 4.0, 3.5), (2 / 1024, 11.0, 4.0, 0.25)]  # f = 4.5, 5.75 at the hand
        out = self.touch(rows, "--field", "f", "--mode", "isosurface", "--iso", 6, files=("f.vtm",))
        for value, row in zip((4.5, 5.75), out[1:]):
            self.assert_near(self.force(row), [STIFFNESS * (6 - value) / math.sqrt(1.25) * c for c in normal], 1e-3)
        self.write("part1.vti", "cut short")
        self.refused("touch", "f.vtm", "--path", "path.csv", "--csv", "out.csv", "--field", "f", "--mode", "isosurface", "--iso", 6,
                     saying=["f.vtm: ", "its block part1.vti: "])

    def test_a_ball_of_sampled_distances_is_felt_inside_of_it_by_at_most_a_quarter_of_the_square_of_the_spacing(self):
        # r is convex, so trilinear values of it are not below it, and above by at most h^2 / 8 times its Laplacian 2 / r.
        radius, spacing, depth = 3.2, 0.5, 0.3
        most = spacing**2 / (4 * radius)
        self.write_image(("r", 1, lambda x, y, z: math.sqrt(x * x + y * y + z * z)), spacing=spacing, origin=(-4.1, -4, -3.9))
        rows = [(0.0, 0.8 * (radius + 0.5), 0.0, 0.6 * (radius + 0.5))]
        for n in range(1, 400):
            turn = 0.015 * n
            way = (0.8 * math.cos(turn), 0.8 * math.sin(turn), 0.6)
            rows.append((n / 1024, *((radius - depth) * c for c in way)))
        inside = []
        for row in self.touch(rows, "--field", "r", "--mode", "isosurface", "--iso", radius)[1:]:
            inside.append(radius - math.hypot(*(row[f"proxy_{axis}"] for axis in "xyz")))
            self.assertAlmostEqual(math.hypot(*self.force(row)), STIFFNESS * (depth - inside[-1]), delta=1e-2 * STIFFNESS * depth)
            self.assertEqual(row["contacts"], 1)  # also where the surfaces of several voxels hold
        self.assertGreaterEqual(min(inside), -1e-6)
        self.assertLessEqual(max(inside), 1.05 * most)
        self.assertGreaterEqual(max(inside), 0.7 * most)

    def test_a_membrane_gives_way_at_its_strength(self):
        self.write_image(("f", 1, lambda x, y, z: z))
        rows = [(n / 1024, 8.25, 8.5, 9.0 - n / 256) for n in range(512)]
        out = self.touch(rows, "--field", "f", "--mode", "isosurface", "--iso", 8, "--strength", 100)
        pushed = [row["force_z"] for row in out]
        self.assertLessEqual(max(pushed), 100 + 1e-9)
        self.assertGreater(max(pushed), 100 - STIFFNESS / 256)
        self.assertEqual(pushed[-1], 0.0)

    def test_a_vortex_leads_the_hand_round_on_its_circle(self):
        # v = (-y, x, 0) is linear, so a streamline is a circle to rounding; the hand is drawn outward by up to a fifth
        self.write_image(("v", 3, lambda x, y, z: (-y, x, 0.0)), origin=(-8.0, -8.0, -8.0))
        rows = [(0.0, 4.0, 0.0, 0.5)]
        for n in range(1, 2049):
            turn = 2 * math.pi * n / 1024
            rows.append((n / 1024, 4.2 * math.cos(turn), 4.2 * math.sin(turn), 0.5))
        out = self.touch(rows, "--field", "v", "--mode", "follow", "--strength", 1000)
        for row in out:
            self.assertAlmostEqual(math.hypot(row["proxy_x"], row["proxy_y"]), 4.0, delta=1e-6)
            self.assertAlmostEqual(row["proxy_z"], 0.5, delta=1e-9)

    def test_drag_is_its_strength_times_the_resistance_against_the_motion(self):
        self.write_image(("d", 1, lambda x, y, z: z / 16.0))
        rows = [(n / 1024, 2.0 + n / 128, 8.0, 4.0) for n in range(1024)]
        out = self.touch(rows, "--field", "d", "--mode", "drag", "--strength", 2)
        self.assert_near(self.force(out[-1]), (-2 * 4 / 16, 0, 0), 1e-9)

    def test_a_range_says_from_which_resistance_on_drag_rises_and_where_it_is_full(self):
        self.write_image(("d", 1, lambda x, y, z: z))
        for place, share in ((1.0, 0.0), (4.0, (4 - 2) / (10 - 2)), (12.0, 1.0)):
            rows = [(n / 1024, 2.0 + n / 128, 8.0, place) for n in range(1024)]
            out = self.touch(rows, "--field", "d", "--mode", "drag", "--strength", 2, "--range", "2,10")
            self.assert_near(self.force(out[-1]), (-2 * share, 0, 0), 1e-9)
            usual = self.touch(rows, "--field", "d", "--mode", "drag", "--strength", 2)  # over its values, 0 to 16
            self.assert_near(self.force(usual[-1]), (-2 * place / 16, 0, 0), 1e-9)

    def test_a_range_says_from_which_length_on_directions_push_and_are_followed(self):
        self.write_image(("v", 3, lambda x, y, z: (0.0, 3.0, 4.0)))
        for low, high in ((3, 7), (0, 5), (6, 8), (1, 2)):
            share = min(1.0, max(0.0, (5 - low) / (high - low)))
            between = ("--range", f"{low},{high}")
            out = self.touch([(n / 1024, 8.0, 8.0, 8.0) for n in range(4)], "--field", "v", "--mode", "push", "--strength", 0.5,
                             *between)
            self.assert_near(self.force(out[-1]), (0.0, 0.3 * share, 0.4 * share), 1e-9)
            # a hand that leaves its straight line is held with all of the strength
            out = self.touch([(n / 1024, 6.0 + n / 128, 8.0, 8.0) for n in range(512)], "--field", "v", "--mode", "follow",
                             "--strength", 2, *between)
            self.assert_near(self.force(out[-1]), (-2 * share, 0.0, 0.0), 1e-6)

    def test_a_push_has_its_strength_along_the_directions(self):
        self.write_image(("v", 3, lambda x, y, z: (0.0, 3.0, 4.0)))
        rows = [(n / 1024, 8.0, 8.0, 8.0) for n in range(4)]
        out = self.touch(rows, "--field", "v", "--mode", "push", "--strength", 0.5)
        self.assert_near(self.force(out[-1]), (0.0, 0.3, 0.4), 1e-9)

    def test_two_arrays_are_compared(self):
        self.write_image(("a", 1, lambda x, y, z: z), ("b", 1, lambda x, y, z: z + 0.5))
        rows = [(n / 1024, 2.0 + n / 128, 8.0, 8.0) for n in range(1024)]
        out = self.touch(rows, "--field", "a", "--mode", "compare", "--compare-with", "b", "--strength", 4)
        self.assert_near(self.force(out[-1]), (-2.0, 0, 0), 1e-9)  # half of the difference of 1 that has all of it

    def test_an_array_is_compared_with_one_of_another_file(self):
        self.write_image(("a", 1, lambda x, y, z: z))
        self.write("g.vti", image_text(SIZE, (("a", 1, lambda x, y, z: z - 0.25), ("b", 1, lambda x, y, z: z + 0.5))))
        rows = [(n / 1024, 2.0 + n / 128, 8.0, 8.0) for n in range(1024)]
        for options, difference in (((), 0.25), (("--with", "b"), 0.5)):
            out = self.touch(rows, "--field", "a", "--mode", "compare", "--with-data", "g.vti", "--strength", 4, *options)
            self.assert_near(self.force(out[-1]), (-4 * difference, 0, 0), 1e-9)

    def test_points_or_lines_of_a_file_draw_the_hand_and_are_not_touched(self):
        # the strength falls from all at the place itself to nothing at the reach of 5
        self.write_image(("f", 1, lambda x, y, z: z))
        self.write("points.vtp", vtp_text([(4, 8, 8), (12, 8, 8)], [(0,), (1,)], kind="Verts"))
        self.write("line.vtp", vtp_text([(4, 0, 8), (4, 16, 8)], [(0, 1)], kind="Lines"))
        self.write_off("plane.off", [(4, 0, 8), (4, 16, 8), (4, 0, 30)], [(0, 1, 2)])
        diagonal = 4 * (1 - math.sqrt(8) / 5) / math.sqrt(2)
        for kind, files, hand, force in (
            ("points", ("points.vtp",), (6, 8, 8), (-4 * (1 - 2 / 5), 0, 0)),
            ("points", ("points.vtp",), (11, 8, 8), (4 * (1 - 1 / 5), 0, 0)),
            ("lines", ("line.vtp",), (6, 5, 8), (-4 * (1 - 2 / 5), 0, 0)),
            ("points", ("line.vtp",), (6, 5, 8), (0, 0, 0)),
            ("points", ("line.vtp",), (6, 2, 8), (-diagonal, -diagonal, 0)),
            ("points", ("plane.off",), (6, 2, 8), (-diagonal, -diagonal, 0)),
            ("points", ("line.vtp", "points.vtp"), (11, 8, 8), (4 * (1 - 1 / 5), 0, 0)),
        ):
            with self.subTest(kind=kind, files=files, hand=hand):
                surfaces = [word for file in files for word in ("--surface", file)]
                out = self.touch([(n / 1024, *map(float, hand)) for n in range(2)], "--field", "f", "--mode", "snap",
                                 "--strength", 4, "--snap", kind, *surfaces)
                self.assert_near(self.force(out[1]), force, 1e-6)

    def test_the_other_names_of_options_mean_the_same(self):
        self.write_image(("f", 1, lambda x, y, z: z), ("g", 1, lambda x, y, z: z + 0.5))
        rows = [(n / 1024, 8.0, 8.0 + n / 256, 9.1 - n / 128) for n in range(512)]
        click = ("--mode", "detent", "--strength", 60, "--levels-click")
        for options, one, other, value in (
            (("--mode", "isosurface"), "--iso", "--value", 8),
            (click, "--levels", "--values", "6,8"),
            (click, "--between-levels", "--every", 1.5),
            (("--mode", "compare", "--strength", 4), "--compare-with", "--with", "g"),
        ):
            with self.subTest(other=other):
                felt = [[self.force(row) for row in self.touch(rows, "--field", "f", *options, name, value)]
                        for name in (one, other)]
                self.assertEqual(*felt)
                self.assertGreater(max(math.hypot(*force) for force in felt[0]), 1.0)

    def test_a_clicking_level_holds_up_to_its_strength(self):
        self.write_image(("f", 1, lambda x, y, z: z))
        rows = [(n / 1024, 8.0, 8.0, 7.2 + n / 512) for n in range(1024)]
        out = self.touch(rows, "--field", "f", "--mode", "detent", "--strength", 60, "--levels-click", "--between-levels", 1.5,
                         "--first-level", 0)
        pulled = [row["force_z"] for row in out]  # levels at 7.5 and 9
        self.assertGreaterEqual(min(pulled), -60 - 1e-9)
        self.assertLess(min(pulled), -60 + STIFFNESS / 512)
        self.assertEqual(sum(1 for now, after in zip(pulled, pulled[1:]) if now < -50 and after > -10), 2)

    def test_smooth_levels_that_are_asked_to_be_too_strong_hold_as_much_as_they_can_which_is_said(self):
        # Of values with a slope of 1 that do not bend: 0.9 k of the spring against 32 s / (3.0792 D) of the levels.
        distance = 1.5
        most = 0.9 * STIFFNESS * 3.0792014356780046 * distance / 32
        self.write_image(("f", 1, lambda x, y, z: z))
        self.write_path([(n / 1024, 8.0, 8.0, 6.0 + n / 1024) for n in range(1536)])
        command = ("touch", "f.vti", "--path", "path.csv", "--csv", "out.csv", "--stiffness", STIFFNESS, "--field", "f", "--mode",
                   "detent", "--between-levels", distance, "--first-level", 0, "--strength")
        self.assertEqual(self.succeed(*command, 0.9 * most).stderr, "")
        self.assertIn(f"and with at most {most:.2g} N", self.succeed(*command, 3 * most).stderr)
        pulled = [abs(row["force_z"]) for row in self.read_rows()]
        self.assertLessEqual(max(pulled), most * (1 + 1e-9))
        self.assertGreater(max(pulled), 0.99 * most)

    def test_smoothed_values_of_cells_are_felt_on_a_lattice_which_is_said(self):
        points, cells = tetrahedra(5)
        numbers = " ".join(str(p[0]) for p in points)
        values = f'<PointData><DataArray type="Float64" Name="f" format="ascii">{numbers}</DataArray></PointData>'
        self.write("f.vtu", vtu_text(points, cells, cell_type=10).replace("<Points>", values + "<Points>"))
        self.write_path([(0.0, 1.0, 2.0, 2.0), (0.001, 2.5, 2.0, 2.0)])
        command = ("touch", "f.vtu", "--path", "path.csv", "--csv", "out.csv", "--field", "f", "--mode", "isosurface", "--iso", 2)
        self.assertEqual(self.succeed(*command).stderr, "")
        self.assertEqual(unsaid(self.succeed(*command, "--smoothing", 1).stderr, "not from its own cells", "smoothed"), [])

    def test_chosen_levels_hold_and_what_is_between_them_does_not(self):
        self.write_image(("f", 1, lambda x, y, z: z))
        rows = [(n / 1024, 8.0, 8.0, 5.1 + n / 256) for n in range(1280)]
        out = self.touch(rows, "--field", "f", "--mode", "detent", "--strength", 60, "--levels-click", "--levels", "9,6")
        for row in out:
            beyond = min((row["device_z"] - level for level in (6, 9) if row["device_z"] > level), default=0.0)
            held = STIFFNESS * beyond
            if held < 60 - STIFFNESS / 128:  # up to its strength the level holds; a tick later it has let go
                self.assertAlmostEqual(row["force_z"], -held, delta=1e-9)
            elif held > 60 + STIFFNESS / 64:
                self.assertAlmostEqual(row["force_z"], 0.0, delta=1e-9)

    def test_a_tensor_leads_the_hand_along_its_largest_eigenvector(self):
        # 2 t t' + z z' with t round the axis: as the vortex does, whatever sign the eigenvectors come with
        def tensor(x, y, z):
            length = math.hypot(x, y) or 1.0
            t = (-y / length, x / length)
            return (2 * t[0] * t[0], 2 * t[1] * t[1], 1.0, 2 * t[0] * t[1], 0.0, 0.0)
        self.write_image(("t", 6, tensor), origin=(-8.0, -8.0, -8.0))
        rows = [(0.0, 5.0, 0.0, 0.5)]
        for n in range(1, 1025):
            turn = 2 * math.pi * n / 1024
            rows.append((n / 1024, 5.2 * math.cos(turn), 5.2 * math.sin(turn), 0.5))
        for row in self.touch(rows, "--field", "t", "--mode", "follow", "--strength", 1000):
            self.assertAlmostEqual(math.hypot(row["proxy_x"], row["proxy_y"]), 5.0, delta=0.02)

    def test_a_surface_in_a_field_is_felt_as_both_and_each_has_half_of_the_stiffness(self):
        self.write_image(("f", 1, lambda x, y, z: z), origin=(-8.0, -8.0, -8.0))
        self.write_off("plane.off", [(x, 0, y) for x, y, _ in SQUARE_POINTS], SQUARE_FACES)
        rows = [(0.0, 0.5, 1.0, 1.0), (1 / 1024, 0.5, -0.25, -0.5)]
        for files, beside in ((("plane.off", "f.vti"), ()), (("f.vti",), ("--surface", "plane.off"))):
            out = self.touch(rows, "--field", "f", "--mode", "isosurface", "--iso", 0, *beside, files=files)
            self.assert_near(self.force(out[1]), (0.0, STIFFNESS / 2 * 0.25, STIFFNESS / 2 * 0.5), 1e-9)
            self.assertEqual([row["contacts"] for row in out], [0, 2])

    def test_voxels_of_nifti_and_tetrahedra_are_felt_at_their_places(self):
        self.write("f.nii", nifti_bytes(9, lambda i, j, k: 1.0 * i, affine=[(-1, 0, 0, 20), (0, 1, 0, 0), (0, 0, 1, 0)]))
        out = self.touch([(0.0, 14.0, 4.0, 4.0), (0.001, 16.0, 4.0, 4.0)], "--field", "NIFTI", "--mode", "isosurface",
                         "--iso", 4.5, files=("f.nii",))  # at x = 15.5; the hand comes from x below
        self.assertAlmostEqual(out[1]["force_x"], -STIFFNESS * 0.5, delta=1e-6)
        points, cells = tetrahedra(5)
        numbers = " ".join(str(p[0]) for p in points)
        values = f'<PointData><DataArray type="Float64" Name="f" format="ascii">{numbers}</DataArray></PointData>'
        self.write("f.vtu", vtu_text(points, cells, cell_type=10).replace("<Points>", values + "<Points>"))
        out = self.touch([(0.0, 1.0, 2.0, 2.0), (0.001, 2.5, 2.0, 2.0)], "--field", "f", "--mode", "isosurface", "--iso", 2,
                         files=("f.vtu",))
        self.assertAlmostEqual(out[1]["force_x"], -STIFFNESS * 0.5, delta=1e-3)

    def test_what_a_ball_is_to_an_isosurface_and_what_noise_did_is_said(self):
        self.write_image(("f", 1, lambda x, y, z: z))
        self.write_path([(0.0, 8.0, 8.0, 9.0)])
        command = ("touch", "f.vti", "--path", "path.csv", "--csv", "out.csv", "--field", "f", "--mode", "isosurface", "--iso", 8)
        self.assertEqual(self.succeed(*command).stderr, "")
        self.refused(*command, "--radius", 1, saying=["--radius", "only a field"])
        self.write_off("plane.off", SQUARE_POINTS, SQUARE_FACES)
        self.assertIn("by a point", self.succeed(*command, "--radius", 0.5, "--surface", "plane.off").stderr)
        # Half a spacing up and down in turn along x alone is a wave, and the data
        self.write_image(("f", 1, lambda x, y, z: z + 0.5 * (-1) ** round(x)))
        self.assertEqual(self.succeed(*command).stderr, "")
        # In turn along every axis: smoothed by (1, 2, 1) / 4 nothing of it is left, so it is noise of half a spacing
        self.write_image(("f", 1, lambda x, y, z: z + 0.5 * (-1) ** round(x + y + z)))
        self.assertIn("noise of 0.5 of a spacing", self.succeed(*command).stderr)
        self.assertEqual(self.succeed(*command, "--smoothing", 0).stderr, "")

    def test_outside_of_the_values_there_is_no_force_and_inside_there_is(self):
        self.write_image(("f", 1, lambda x, y, z: z))
        rows = [(n / 1024, 8.0, 8.0, 40.0 - n / 16) for n in range(530)]
        out = self.touch(rows, "--field", "f", "--mode", "isosurface", "--iso", 8)
        for row in out:
            expected = STIFFNESS * (8 - row["device_z"]) if row["device_z"] < 8 else 0.0
            self.assertAlmostEqual(row["force_z"], expected, delta=1e-9)

    def test_what_no_mode_that_is_given_feels_is_refused(self):
        self.write_image(("f", 1, lambda x, y, z: z), ("v", 3, lambda x, y, z: (x, y, z)))
        self.write_off("plane.off", SQUARE_POINTS, SQUARE_FACES)
        self.write_path([(0.0, 1.0, 1.0, 1.0)])
        command = ("touch", "f.vti", "--path", "path.csv", "--csv", "out.csv", "--strength", 0.5)
        drag, push, detent = ("--field", "f", "--mode", "drag"), ("--field", "v", "--mode", "push"), ("--field", "f", "--mode", "detent")
        compare, snap = ("--field", "f", "--mode", "compare", "--with", "f"), ("--field", "f", "--mode", "snap")
        for options, words in (
            ((*drag, "--every", 1), ["--every", "detent"]),
            ((*drag, "--first-level", 1), ["--first-level", "detent"]),
            ((*drag, "--levels-click"), ["--levels-click", "detent"]),
            ((*drag, "--values", 1), ["--values", "detent"]),
            ((*detent, "--values", 1, "--every", 1), ["--levels", "--between-levels"]),
            ((*drag, "--snap-reach", 1), ["--snap-reach", "snap"]),
            ((*drag, "--snap", "points", "--surface", "plane.off"), ["--snap", "snap"]),
            ((*snap, "--snap", "points"), ["--snap", "--surface"]),
            ((*snap, "--snap", "faces", "--surface", "plane.off"), ["--snap faces", "points or lines"]),
            ((*snap, "--snap", "lines", "--surface", "plane.off"), ["plane.off", "no lines"]),
            ((*drag, "--compare-full", 1), ["--compare-full", "compare"]),
            ((*drag, "--with", "f"), ["--with", "compare"]),
            ((*drag, "--with-data", "f.vti"), ["--with-data", "compare"]),
            ((*compare, "--with-data", "gone.vti"), ["gone.vti"]),
            ((*drag, "--full-length", 1), ["--full-length", "follow or push"]),
            ((*drag, "--eigenvector", 1), ["--eigenvector", "follow or push"]),
            ((*push, "--component", 0), ["--component", "isosurface"]),
            ((*push, "--smoothing", 0), ["--smoothing", "isosurface"]),
            ((*detent, "--range", "0,1"), ["--range", "drag"]),
            ((*drag, "--range", "2,1"), ["--range", "below"]),
            ((*drag, "--range", "0,inf"), ["--range", "finite"]),
            ((*push, "--range", "-1,1"), ["--range", "lengths"]),
            ((*push, "--range", "0,1", "--full-length", 1), ["--range", "--full-length"]),
        ):
            with self.subTest(options=options):
                self.refused(*command, *options, saying=words)
                self.assertFalse((self.folder / "out.csv").exists())

    def test_bad_input_is_refused_in_one_line(self):
        self.write_image(("f", 1, lambda x, y, z: z), ("v", 3, lambda x, y, z: (x, y, z)))
        self.write_path([(0.0, 1.0, 1.0, 1.0)])
        command = ("touch", "f.vti", "--path", "path.csv", "--csv", "out.csv")
        for options, words in (
            (("--field", "f"), ["--mode"]),
            (("--mode", "drag", "--strength", 1), ["--field"]),
            (("--field", "f", "--mode", "isosurface"), ["--iso"]),
            (("--field", "f", "--mode", "isosurface", "--iso", "nan"), ["--iso"]),
            (("--field", "f", "--mode", "detent"), ["--strength"]),
            (("--field", "f", "--mode", "hum", "--strength", 1), ["hum", "isosurface"]),
            (("--field", "v", "--mode", "push", "--strength", 5), ["--strength", "0.5"]),
            (("--field", "gone", "--mode", "drag", "--strength", 1), ["f.vti", "gone"]),
            (("--field", "f", "--mode", "follow", "--strength", 1), ["directions"]),
            (("--field", "f", "--mode", "compare", "--strength", 1), ["--compare-with"]),
            (("--field", "f", "--field", "v", "--mode", "snap", "--strength", 1), ["--field"]),
            (("--field", "f", "--field", "v", "--mode", "snap", "--strength", 1, "--mode", "detent", "--strength", 1),
             ["choose one"]),
            (("--iso", 3, "--snap-reach", 2), ["--snap-reach", "--field"]),
            (("--field", "f", "--mode", "isosurface", "--iso", 99), ["f.vti", "0 to 16", "isovalue 99"]),
            (("--field", "f", "--mode", "detent", "--strength", 1, "--levels", "20,30"), ["0 to 16", "no level"]),
            (("--field", "f", "--mode", "detent", "--strength", 1, "--levels", "2,two"), ["--levels", "two"]),
            (("--field", "f", "--mode", "drag", "--strength", 1, "--levels", "2"), ["--levels", "detent"]),
            (("--field", "f", "--mode", "detent", "--strength", 1, "--iso", 3), ["--iso", "isosurface"]),
            (("--field", "f", "--mode", "drag", "--strength", 1, "--mode", "drag", "--strength", 2), ["drag", "more than once"]),
            (("--field", "f", "--mode", "drag", "--strength", 1, "--shading"), ["--shading", "surfaces"]),
            (("--field", "f", "--mode", "drag", "--strength", 1, "--line-radius", 1), ["--line-radius", "surfaces"]),
            (("--field", "f", "--mode", "drag", "--strength", 1, "--stiffness-array", "f"), ["stiffness", "surfaces"]),
        ):
            with self.subTest(options=options):
                self.refused(*command, *options, saying=words)
                self.assertFalse((self.folder / "out.csv").exists())
        self.write_path([(0.0, 50.0, 1.0, 1.0), (0.001, 51.0, 1.0, 1.0)])
        self.refused(*command, "--field", "f", "--mode", "drag", "--strength", 1, saying=["nowhere among its values"])
        self.write_off("plane.off", SQUARE_POINTS, SQUARE_FACES)
        self.refused("check", "plane.off", "--thin", "nan", saying=["--thin", "finite"])
        self.refused("touch", "plane.off", "--path", "path.csv", "--csv", "out.csv", "--field", "f", "--mode", "drag",
                     "--strength", 1, saying=["plane.off", "volume"])


if __name__ == "__main__":
    unittest.main()
