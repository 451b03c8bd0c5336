# SPDX-License-Identifier: GPL-3.0-or-later
"""Shared by the tests of the program: running it in an empty folder, and making its input files by hand."""

import csv
import os
import struct
import subprocess
import tempfile
import unittest
from pathlib import Path

PROGRAM = os.environ["PALPATE_PROGRAM"]

SQUARE_POINTS = [(-8, -8, 0), (8, -8, 0), (8, 8, 0), (-8, 8, 0)]
SQUARE_FACES = [(0, 1, 2), (0, 2, 3)]


class CommandLineTest(unittest.TestCase):
    """One temporary folder a test; the program runs inside it."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="palpate-cli-")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def run_palpate(self, *arguments):
        return subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, capture_output=True, text=True, timeout=60)

    def succeed(self, *arguments):
        run = self.run_palpate(*arguments)
        self.assertEqual(run.returncode, 0, run.stderr)
        return run

    def refused(self, *arguments, saying):
        """Exit code 2, nothing on stdout, and one line on stderr that holds every word of `saying`."""
        run = self.run_palpate(*arguments)
        self.assertEqual(run.returncode, 2, (run.stdout, run.stderr))
        self.assertEqual(run.stderr.count("\n"), 1, run.stderr)
        self.assertTrue(run.stderr.startswith("palpate: "), run.stderr)
        for word in saying:
            self.assertIn(word, run.stderr)
        return run

    def write(self, name, content):
        path = self.folder / name
        if isinstance(content, bytes):
            path.write_bytes(content)
        else:
            path.write_text(content)
        return path

    def write_off(self, name, points, faces):
        return self.write(name, off_text(points, faces))

    def write_path(self, rows, name="path.csv", header="t,x,y,z"):
        return self.write(name, header + "\n" + "".join(",".join(map(repr, row)) + "\n" for row in rows))

    def read_rows(self, name="out.csv"):
        with open(self.folder / name, newline="") as file:
            return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]


def off_text(points, faces):
    lines = ["OFF", f"{len(points)} {len(faces)} 0"]
    lines += [" ".join(map(str, point)) for point in points]
    lines += [f"{len(face)} " + " ".join(map(str, face)) for face in faces]
    return "\n".join(lines) + "\n"


def obj_text(points, faces):
    return "".join(f"v {x} {y} {z}\n" for x, y, z in points) + "".join(
        "f " + " ".join(str(i + 1) for i in face) + "\n" for face in faces)


def ply_text(points, faces, promised=None):
    header = ["ply", "format ascii 1.0", f"element vertex {promised or len(points)}"]
    header += [f"property double {axis}" for axis in "xyz"]
    header += [f"element face {len(faces)}", "property list uchar int vertex_indices", "end_header"]
    body = [" ".join(map(str, point)) for point in points]
    body += [f"{len(face)} " + " ".join(map(str, face)) for face in faces]
    return "\n".join(header + body) + "\n"


def stl_bytes(points, faces, promised=None):
    body = b"".join(struct.pack("<3f", 0, 0, 1) + b"".join(struct.pack("<3f", *points[i]) for i in face) + b"\0\0"
                    for face in faces)
    return b"made by a test".ljust(80) + struct.pack("<I", promised or len(faces)) + body


def stl_text(points, faces):
    facets = "".join(" facet normal 0 0 1\n  outer loop\n" + "".join(
        "   vertex {} {} {}\n".format(*points[i]) for i in face) + "  endloop\n endfacet\n" for face in faces)
    return f"solid square\n{facets}endsolid square\n"


def cell_arrays(cells):
    corners = " ".join(str(i) for cell in cells for i in cell)
    offsets = " ".join(str(sum(map(len, cells[:n + 1]))) for n in range(len(cells)))
    return f"""<DataArray type="Int64" Name="connectivity" format="ascii">{corners}</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">{offsets}</DataArray>"""


def vtp_text(points, cells, promised=None, kind="Polys", point_data="", cell_data=""):
    """Poly data of one kind of cells, `Polys` or `Lines`, with the elements of its data arrays."""
    counts = " ".join(f'NumberOf{each}="{len(cells) if each == kind else 0}"' for each in ("Verts", "Lines", "Strips", "Polys"))
    numbers = " ".join(str(value) for point in points for value in point)
    return f"""<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian"><PolyData>
<Piece NumberOfPoints="{promised or len(points)}" {counts}>
<PointData>{point_data}</PointData><CellData>{cell_data}</CellData>
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">{numbers}</DataArray></Points>
<{kind}>{cell_arrays(cells)}</{kind}>
</Piece></PolyData></VTKFile>
"""


def vtu_text(points, faces, promised=None, cell_type=5):
    numbers = " ".join(str(value) for point in points for value in point)
    types = " ".join([str(cell_type)] * len(faces))
    return f"""<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian"><UnstructuredGrid>
<Piece NumberOfPoints="{promised or len(points)}" NumberOfCells="{len(faces)}">
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">{numbers}</DataArray></Points>
<Cells>{cell_arrays(faces)}
<DataArray type="UInt8" Name="types" format="ascii">{types}</DataArray></Cells>
</Piece></UnstructuredGrid></VTKFile>
"""


def vti_text(size, value, origin=(0, 0, 0), with_scalars=True, extent=None):
    """An image of size^3 points at spacing 1; value(i, j, k) gives its scalar."""
    whole = extent or f"0 {size - 1} 0 {size - 1} 0 {size - 1}"
    numbers = " ".join(str(value(i, j, k)) for k in range(size) for j in range(size) for i in range(size))
    data = f"""<PointData Scalars="s"><DataArray type="Float64" Name="s" format="ascii">{numbers}</DataArray></PointData>"""
    return f"""<VTKFile type="ImageData" version="0.1" byte_order="LittleEndian">
<ImageData WholeExtent="{whole}" Origin="{origin[0]} {origin[1]} {origin[2]}" Spacing="1 1 1">
<Piece Extent="{whole}">{data if with_scalars else ""}</Piece></ImageData></VTKFile>
"""


def nifti_bytes(size, value, affine=None, slope=1.0, intercept=0.0, promised=None):
    """A NIfTI-1 file of size^3 voxels of float32; `affine`: three rows of the sform [scene units per voxel]."""
    rows = affine or [(1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0)]
    header = bytearray(348)
    struct.pack_into("<i", header, 0, 348)
    side = promised or size
    struct.pack_into("<8h", header, 40, 3, side, side, side, 1, 1, 1, 1)
    struct.pack_into("<2h", header, 70, 16, 32)
    struct.pack_into("<8f", header, 76, 1, 1, 1, 1, 1, 1, 1, 1)
    struct.pack_into("<3f", header, 108, 352, slope, intercept)
    struct.pack_into("<2h", header, 252, 0, 2)
    for n, row in enumerate(rows):
        struct.pack_into("<4f", header, 280 + 16 * n, *row)
    header[344:348] = b"n+1\0"
    voxels = [value(i, j, k) for k in range(size) for j in range(size) for i in range(size)]
    return bytes(header) + b"\0\0\0\0" + struct.pack(f"<{len(voxels)}f", *voxels)
