# SPDX-License-Identifier: GPL-3.0-or-later
"""Paths of a hand: given as rows, files or poly data, or made as strokes over the six sides of a surface."""

import csv
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData

from palpate.testing.feel import Refused, faces_of, updated
from palpate.vtkHapticPipeline import vtkHapticStroke

TICK_S = 1e-3  # of rows without a time
STROKE_TICK_S = 1e-2  # a stroke over 200 mm at 130 mm/s: a hand that looks for something
SIDES = np.vstack([np.eye(3), -np.eye(3)])  # each beside the one before
OUTSIDE = 2.0  # diagonals of the box: from there the straight line to the side beside passes outside of the surface
PLACES = 150  # of a stroke, along the diagonal of the surface's box


def read_path(path):
    """Rows of t, x, y, z [s, scene units] from the argument of a test."""
    name = "the path of the hand"
    if isinstance(path, (str, Path)):
        name, path = path, _of_file(Path(path))
    elif isinstance(path, vtkPolyData):
        path = _of_line(path)
    try:
        rows = np.asarray(path, dtype=float)
    except (TypeError, ValueError):
        raise Refused(f"{name}: give rows of three or four numbers.") from None
    if rows.ndim != 2 or rows.shape[1] not in (3, 4) or not len(rows):
        raise Refused(f"{name}: give rows of x, y, z or t, x, y, z; it has the shape {rows.shape}.")
    if rows.shape[1] == 3:
        rows = np.column_stack([TICK_S * np.arange(len(rows)), rows])
    if not np.isfinite(rows).all() or not (np.diff(rows[:, 0]) > 0).all():
        raise Refused(f"{name}: every number has to be finite and the time has to rise from row to row.")
    return rows


def _of_line(way):
    """The points in the order of its one line, as the filter Touch Along Path goes, with the array t of the points if
    there is one; without a line in their own order."""
    lines = way.GetNumberOfLines()
    if lines > 1:
        raise Refused(f"the path of the hand: it has {lines} lines; join them into one polyline.")
    points = vtk_to_numpy(way.GetPoints().GetData()) if way.GetNumberOfPoints() else np.empty((0, 3))
    order = vtk_to_numpy(way.GetLines().GetConnectivityArray()) if lines else np.arange(len(points))
    if lines and not (len(order) and 0 <= order.min() and order.max() < len(points)):
        raise Refused("the path of the hand: its line names points that are not there.")
    times = way.GetPointData().GetArray("t")
    return (np.column_stack([vtk_to_numpy(times), points]) if times else points)[order]


def _of_file(file):
    """The columns t, x, y, z as the program `palpate touch` reads them."""
    try:
        with file.open(encoding="utf-8", newline="") as text:
            return [[float(row[column]) for column in "txyz"] for row in csv.DictReader(text)]
    except (OSError, KeyError, TypeError, ValueError) as problem:
        raise Refused(f"{file}: a path is a table with the columns t,x,y,z and numbers below ({problem!r}).") from None


def strokes(surface, touch):
    """A path that comes down on each of the six sides of a surface's box in turn, strokes over its middle 2 mm of the
    hand deep (2 % of the surface where that is less), and goes on outside of it. Sides that show no whole stroke are left
    out."""
    faces = faces_of(surface)
    low, high = (np.array(faces.GetBounds()[end::2]) for end in (0, 1))
    size_u = float(np.linalg.norm(high - low)) if faces.GetNumberOfPoints() else 0.0
    ways = [_over(faces, up, size_u, touch) for up in SIDES] if size_u > 0 else []
    ways = [way for way in ways if way is not None]
    if not ways:
        raise Refused("No side of the surface can be stroked: give the path of the hand.")
    # From one side to the opposite one the straight line would lead through the surface.
    aside = np.array(faces.GetCenter()) + OUTSIDE * size_u * np.eye(3)
    places = [ways[0]]
    for last, way in zip(ways, ways[1:]):
        across = way[0] - last[-1]
        if np.linalg.norm(across) > 1.5 * OUTSIDE * size_u:
            places.append(aside[[int(np.argmin(np.abs(across)))]])
        places.append(way)
    places = np.concatenate(places)
    return np.column_stack([STROKE_TICK_S * np.arange(len(places)), places])


def _over(faces, up, size_u, touch):
    """One side: from outside of the sphere round the box, over the surface and out again; None where nothing is."""
    stroke = vtkHapticStroke()
    stroke.SetInputData(faces)
    stroke.SetUp(*up)
    stroke.SetAlong(*np.roll(np.abs(up), 1))
    stroke.SetDepth(min(2e-3 * touch.scale, 0.02 * size_u))
    stroke.SetLift(0.05 * size_u)
    stroke.SetStep(size_u / PLACES)
    stroke.SetWindow(5 * size_u / PLACES)
    stroke.SetReach(0.8)
    try:
        points = updated(stroke).GetPoints()
    except Refused:
        return None
    places = vtk_to_numpy(points.GetData()).astype(float)
    centre = np.array(faces.GetCenter())
    outside = [place + (OUTSIDE * size_u - (place - centre) @ up) * up for place in (places[0], places[-1])]
    return np.vstack([outside[0], places, outside[1]])
