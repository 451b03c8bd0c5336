# SPDX-License-Identifier: GPL-3.0-or-later
"""Where two touches differ: as text for a person, as data for ParaView."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

from palpate.testing.feel import Refused

MOST_STRETCHES = 5
ROW = "{:>11}  {:>13}  {:>29}  {:>9}  {:>9}  {:>8}  {:>7}"


def text_of(found, baseline, differences, how_to_accept):
    """The result, the worst stretches, and the remedy for an intended change."""
    rows = int(found.beyond.sum())
    lines = [f"the surface does not feel as it did: {rows} of {len(found.jnd)} places differ by more than {found.tolerance:g} "
             f"just noticeable differences (JND), at most by {found.jnd.max():.3g}" if rows else
             "the surface feels the same along the path of the hand, but differs elsewhere",
             f"baseline: {baseline.file} (scene {baseline.scene}, in {baseline.unit}, Palpate {baseline.version})"]
    if rows:
        lines.append(ROW.format("rows", "t [s]", f"worst at [{baseline.unit}]", "then [N]", "now [N]", "turn [°]", "JND"))
    lines += _first(found.stretches(), lambda stretch: _stretch(found, *stretch))
    lines += _first(found.changed, str)
    if found.coverage:
        lines.append(found.coverage.text())
    if differences:
        lines.append(f"where, to be shown in ParaView: {differences}")
    lines.append(f"if this is how it shall feel: {how_to_accept}")
    return "\n".join(lines)


def _first(things, text):
    """Of each of the first few things its text, and how many more there are."""
    more = len(things) - MOST_STRETCHES
    return [text(thing) for thing in things[:MOST_STRETCHES]] + ([f"and {more} more"] if more > 0 else [])


def _stretch(found, first, last):
    worst = first + int(np.argmax(found.jnd[first:last + 1]))
    before, now = (np.linalg.norm(force[worst]) for force in (found.before_N, found.now_N))
    turn_rad = np.arctan2(np.linalg.norm(np.cross(found.before_N[worst], found.now_N[worst])),
                          found.before_N[worst] @ found.now_N[worst]) if before > 0 and now > 0 else 0.0
    place = ", ".join(f"{coordinate:.4g}" for coordinate in found.path[worst, 1:])
    return ROW.format(f"{first}-{last}", f"{found.path[first, 0]:.4g}-{found.path[last, 0]:.4g}", f"({place})", f"{before:.4g}",
                      f"{now:.4g}", f"{np.degrees(turn_rad):.1f}", f"{found.jnd[worst]:.3g}")


def write_differences(found, file):
    """The path of the hand as a polyline with the point arrays Before [N], Now [N] and JND."""
    points, lines, way = vtkPoints(), vtkCellArray(), vtkPolyData()
    points.SetDataTypeToDouble()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(found.path[:, 1:]), deep=True))
    lines.InsertNextCell(len(found.path), range(len(found.path)))
    way.SetPoints(points)
    way.SetLines(lines)
    for name, values in (("Before", found.before_N), ("Now", found.now_N), ("JND", found.jnd)):
        array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
        array.SetName(name)
        way.GetPointData().AddArray(array)
    writer = vtkXMLPolyDataWriter()
    writer.SetInputData(way)
    writer.SetFileName(str(file))
    if not writer.Write():
        raise Refused(f"{file}: the differences cannot be written there.")
