#!/usr/bin/env pvpython
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes an abdominal wall in front of a liver, a needle's way through both, and the scene file that joins them.

    pvpython data/abdomen.py LIVER FOLDER [EDGE]

LIVER is the file that `data/get liver` prints, or another label image in millimetres. FOLDER gets liver.vtu (tetrahedra of
EDGE mm, 20 without), wall.vtu, abdomen.json and way.csv for `palpate touch`. The wall is a shell of 18 mm that bends around
the liver's lower side and is held at its rim. All strengths and stiffnesses are assumed. Needs PYTHONPATH and PV_PLUGIN_PATH
as the README says.
"""

import csv
import json
import pathlib
import sys

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkStructuredGrid
from vtkmodules.vtkFiltersGeneral import vtkDataSetTriangleFilter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter

from palpate.vtkHapticPipeline import vtkHapticNIfTIReader, vtkHapticSoftBody

THICK, GAP, BEND = 18.0, 6.0, 12.0  # mm: of the wall, from the wall to the liver, by what its rim comes forward
CELLS = 10, 10, 2  # of the wall
NEEDLE = 150.0  # mm
BEFORE, INTO, SPEED = 10.0, 15.0, 40.0  # mm before the wall, mm into the liver, mm/s
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


def wall(box):
    """A shell below the box, a parabola along both sides."""
    (x0, x1), (y0, y1), z = box[0:2], box[2:4], box[4] - GAP - THICK
    counts = [n + 1 for n in CELLS]
    w, v, u = numpy.meshgrid(*(numpy.linspace(-1.0, 1.0, n) for n in reversed(counts)), indexing="ij")
    places = numpy.stack([0.5 * (x0 + x1 + (x1 - x0) * u), 0.5 * (y0 + y1 + (y1 - y0) * v),
                          z + 0.5 * THICK * (w + 1.0) + BEND * (u * u + v * v - 1.0)], axis=-1).reshape(-1, 3)
    points, grid, cut = vtkPoints(), vtkStructuredGrid(), vtkDataSetTriangleFilter()
    points.SetData(numpy_to_vtk(numpy.ascontiguousarray(places), deep=True))
    grid.SetDimensions(counts)
    grid.SetPoints(points)
    cut.SetInputData(grid)
    cut.Update()
    return cut.GetOutput()


def scene():
    soft = {"kind": "soft", "poisson": 0.4, "model": "linear"}
    return {
        "format": "palpate mechanism", "version": 1, "unit_m": 0.001,
        "bodies": [
            {"name": "needle", "kind": "held", "length": NEEDLE, "diameter": 1.2},
            {"name": "wall", **soft, "file": "wall.vtu", "fixed": "xmin,xmax,ymin,ymax", "young_Pa": 100000},
            {"name": "liver", **soft, "file": "liver.vtu", "fixed": "zmax", "young_Pa": 20000}],
        "laws": [
            {"name": "skin", "kind": "puncture", "a": "needle", "b": "wall", "strength_N": 1.5, "dry_friction_N": 0.4, "friction": 1},
            {"name": "capsule", "kind": "puncture", "a": "needle", "b": "liver", "strength_N": 0.8, "dry_friction_N": 0.2, "friction": 1}]}


def way(box):
    """Of the hand, in a straight line up and back, a row a millisecond."""
    middle = 0.5 * (box[0] + box[1]), 0.5 * (box[2] + box[3])
    low, high = box[4] - GAP - THICK - BEND - BEFORE - NEEDLE, box[4] + INTO - NEEDLE
    steps = int(1000.0 * (high - low) / SPEED)
    for i in range(2 * steps):
        there = min(i, 2 * steps - i) / steps
        yield i / 1000.0, *middle, low + (high - low) * there, *UNTURNED


def main(arguments):
    if len(arguments) not in (2, 3):
        fail("needs LIVER and FOLDER: data/abdomen.py liver.nii out")
    image, folder = (pathlib.Path(text).absolute() for text in arguments[:2])
    if not image.is_file():
        fail(f"there is no file {image}: run `data/get liver` and give the file that it prints")
    edge = float(arguments[2]) if len(arguments) == 3 else 20.0
    folder.mkdir(parents=True, exist_ok=True)
    liver = filled(image, edge)
    box = liver.GetBounds()
    write(liver, folder / "liver.vtu")
    write(wall(box), folder / "wall.vtu")
    (folder / "abdomen.json").write_text(json.dumps(scene(), indent=2) + "\n", encoding="utf-8")
    with open(folder / "way.csv", "w", newline="", encoding="utf-8") as file:
        rows = csv.writer(file, lineterminator="\n")
        rows.writerow(["t", "x", "y", "z", "qw", "qx", "qy", "qz"])
        rows.writerows([f"{value:.9g}" for value in row] for row in way(box))


if __name__ == "__main__":
    main(sys.argv[1:])
