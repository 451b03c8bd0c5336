#!/usr/bin/env pvpython
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes an abdominal wall in front of a liver, a needle's path through both, and the scene file that joins them.

    pvpython data/abdomen.py LIVER FOLDER [EDGE] [--skin SURFACE] [--side xmin|xmax|ymin|ymax|zmin|zmax]

LIVER is the file that `data/get liver` prints, or another label image in millimetres. FOLDER gets liver.vtu (tetrahedra of
EDGE mm, 20 without), wall.vtu, abdomen.json and way.csv for `palpate touch`. The wall is a shell of 18 mm under an outer
surface, held at its rim: 90 mm of SURFACE (a mesh in millimetres, as `data/get skin` prints) about the middle of one of its
sides (zmax), or without it a dome over the liver's lower side. All strengths and stiffnesses are assumed. Needs PYTHONPATH and
PV_PLUGIN_PATH as the README says.
"""

import argparse
import csv
import json
import pathlib
import sys

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import reference, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkStaticCellLocator, vtkStructuredGrid
from vtkmodules.vtkFiltersGeneral import vtkDataSetTriangleFilter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter

from palpate.vtkHapticPipeline import vtkHapticFileReader, vtkHapticNIfTIReader, vtkHapticSoftBody

THICK, GAP, BEND = 18.0, 6.0, 12.0  # mm: of the wall, from the wall to the liver, bend of a dome's rim
PATCH = 90.0  # mm: of a skin, along both sides
CELLS = 10, 10, 2  # of the wall
NEEDLE = 150.0  # mm
BEFORE, INTO, SPEED = 10.0, 15.0, 40.0  # mm before the wall, mm into the liver, mm/s
ON_EDGES = 1e-3  # mm: lines through an edge meet one of its faces
SIDES = "xmin", "xmax", "ymin", "ymax", "zmin", "zmax"
UNTURNED = 1.0, 0.0, 0.0, 0.0


def fail(text):
    sys.exit(f"abdomen: {text}")


def write(grid, path):
    writer = vtkXMLUnstructuredGridWriter()
    writer.SetInputData(grid)
    writer.SetFileName(str(path))
    if not writer.Write():
        fail(f"cannot write {path}: is there room, and may you write there?")


def filled(image, edge):
    reader, body = vtkHapticNIfTIReader(), vtkHapticSoftBody()
    reader.SetFileName(str(image))
    body.SetInputConnection(reader.GetOutputPort())
    body.SetEdgeLength(edge)
    body.SetFixed("zmax")
    body.Update()
    grid = body.GetOutput()
    if grid.GetNumberOfCells() == 0:
        fail(f"{image} has no labels to be filled with tetrahedra of {edge} mm")
    return grid


def dome(box):
    """The outer surface of a wall below the box, a parabola along both sides."""
    (x0, x1), (y0, y1) = box[0:2], box[2:4]
    v, u = numpy.meshgrid(*(numpy.linspace(-1.0, 1.0, n + 1) for n in CELLS[1::-1]), indexing="ij")
    return numpy.stack([0.5 * (x0 + x1 + (x1 - x0) * u), 0.5 * (y0 + y1 + (y1 - y0) * v), BEND * (u * u + v * v)], axis=-1)


class Lines:
    """How far along straight lines a data set is met first [mm]."""

    def __init__(self, data):
        self.locator = vtkStaticCellLocator()
        self.locator.SetDataSet(data)
        self.locator.BuildLocator()

    def first(self, begin, end):
        """None: nowhere."""
        t, cell, part, hit, local = reference(0.0), reference(0), reference(0), [0.0] * 3, [0.0] * 3
        met = self.locator.IntersectWithLine(begin, end, ON_EDGES, t, hit, local, part, cell)
        return float(t) * numpy.linalg.norm(numpy.subtract(end, begin)) if met else None


def skin(path, side, box):
    """The outer surface of a wall below the box: the first hits of lines from that side on a surface, turned so that they go up."""
    reader = vtkHapticFileReader()
    reader.SetFileName(str(path))
    reader.Update()
    surface = reader.GetOutput()
    if surface.GetNumberOfCells() == 0:
        fail(f"{path} has no surface for a wall")
    lines, bounds = Lines(surface), numpy.reshape(surface.GetBounds(), (3, 2))
    along, far = SIDES.index(side) // 2, SIDES.index(side) % 2
    across = ((along + 1) % 3, (along + 2) % 3)[::-1 if far else 1]
    inward = bounds[along, 1 - far] - bounds[along, far]
    middle = 0.5 * (box[0] + box[1]), 0.5 * (box[2] + box[3])

    def place(du, dv):
        begin = bounds.mean(axis=1)
        begin[list(across)] += du, dv
        begin[along] = bounds[along, far] - 0.01 * inward
        end = begin.copy()
        end[along] += 1.02 * inward
        height = lines.first(begin, end)
        if height is None:
            fail(f"{path} has nothing {du:g}, {dv:g} mm from the middle of its side {side}: name another side, or a larger surface")
        return middle[0] + du, middle[1] + dv, height

    ways = [numpy.linspace(-0.5 * PATCH, 0.5 * PATCH, n + 1) for n in CELLS[:2]]
    outer = numpy.array([[place(du, dv) for du in ways[0]] for dv in ways[1]])
    if max(abs(numpy.diff(outer[..., 2], axis=axis)).max() for axis in (0, 1)) > 2.0 * PATCH / min(CELLS[:2]):
        fail(f"{path} is no even skin on its side {side}: name another side")
    return outer


def wall(outer, box):
    """A shell of even thickness above an outer surface, all of it below the box."""
    inward = numpy.cross(numpy.gradient(outer, axis=1), numpy.gradient(outer, axis=0))
    inward *= THICK / numpy.linalg.norm(inward, axis=-1, keepdims=True)
    places = numpy.stack([outer + inward * layer / CELLS[2] for layer in range(CELLS[2] + 1)])
    places[..., 2] += box[4] - GAP - places[..., 2].max()
    points, grid, cut = vtkPoints(), vtkStructuredGrid(), vtkDataSetTriangleFilter()
    points.SetData(numpy_to_vtk(numpy.ascontiguousarray(places.reshape(-1, 3)), deep=True))
    grid.SetDimensions([n + 1 for n in CELLS])
    grid.SetPoints(points)
    cut.SetInputData(grid)
    cut.Update()
    return cut.GetOutput()


def scene():
    # As wide as a dent that a linear body follows.
    soft = {"kind": "soft", "poisson": 0.4, "model": "linear", "tip_diameter": 20}
    return {
        "format": "palpate mechanism", "version": 1, "unit_m": 0.001,
        "bodies": [
            {"name": "needle", "kind": "held", "length": NEEDLE, "diameter": 1.2},
            {"name": "wall", **soft, "file": "wall.vtu", "fixed": "xmin,xmax,ymin,ymax", "young_Pa": 100000},
            {"name": "liver", **soft, "file": "liver.vtu", "fixed": "zmax", "young_Pa": 20000}],
        "laws": [
            {"name": "skin", "kind": "puncture", "a": "needle", "b": "wall", "strength_N": 1.5, "dry_friction_N": 0.4, "friction": 1},
            {"name": "capsule", "kind": "puncture", "a": "needle", "b": "liver", "strength_N": 0.8, "dry_friction_N": 0.2, "friction": 1}]}


def way(shell, liver):
    """Of the hand, in a straight line up and back, a row a millisecond."""
    box = liver.GetBounds()
    middle = 0.5 * (box[0] + box[1]), 0.5 * (box[2] + box[3])
    met = Lines(liver).first((*middle, box[4] - 1.0), (*middle, box[5] + 1.0))
    if met is None:
        fail("the liver has a hole above its middle: a needle would meet nothing")
    low, high = shell.GetBounds()[4] - BEFORE - NEEDLE, box[4] - 1.0 + met + INTO - NEEDLE
    steps = int(1000.0 * (high - low) / SPEED)
    for i in range(2 * steps):
        there = min(i, 2 * steps - i) / steps
        yield i / 1000.0, *middle, low + (high - low) * there, *UNTURNED


def asked():
    parser = argparse.ArgumentParser(prog="abdomen", description=__doc__.split("\n")[0])
    parser.add_argument("liver", metavar="LIVER", type=pathlib.Path)
    parser.add_argument("folder", metavar="FOLDER", type=pathlib.Path)
    parser.add_argument("edge", metavar="EDGE", nargs="?", type=float, default=20.0, help="of the liver's tetrahedra [mm], 20")
    parser.add_argument("--skin", metavar="SURFACE", type=pathlib.Path, help="the outer side of the wall [mm]")
    parser.add_argument("--side", choices=SIDES, default="zmax", help="of the skin that is taken, zmax")
    return parser.parse_args()


def main():
    given = asked()
    for name, path in ("liver", given.liver), ("skin", given.skin):
        if path is not None and not path.is_file():
            fail(f"there is no file {path}: run `data/get {name}` and give the file that it prints")
    given.folder.mkdir(parents=True, exist_ok=True)
    liver = filled(given.liver, given.edge)
    box = liver.GetBounds()
    shell = wall(skin(given.skin, given.side, box) if given.skin else dome(box), box)
    write(liver, given.folder / "liver.vtu")
    write(shell, given.folder / "wall.vtu")
    (given.folder / "abdomen.json").write_text(json.dumps(scene(), indent=2) + "\n", encoding="utf-8")
    with open(given.folder / "way.csv", "w", newline="", encoding="utf-8") as file:
        rows = csv.writer(file, lineterminator="\n")
        rows.writerow(["t", "x", "y", "z", "qw", "qx", "qy", "qz"])
        rows.writerows([f"{value:.9g}" for value in row] for row in way(shell, liver))


if __name__ == "__main__":
    main()
