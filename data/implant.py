#!/usr/bin/env pvpython
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes an implant for the frontal defect of the skull: the bone that the other side of the head has and this one lacks.

    pvpython data/implant.py SKULL OUTPUT [PLAY [SPACING]]

SKULL is the file that `data/get skull` prints; OUTPUT a .vtp. PLAY, 0.5 by default, is how far the implant stays from the
bone; SPACING, 1 by default, how far apart the distances are that its shape is made of [mm]. The skull is mirrored and laid
on itself (Besl and McKay 1992), and both are sampled as signed distances around the defect. The implant is the largest
piece that is inside of the mirrored bone, further than PLAY from the real one, and can be put in straight from the front.
"""

import sys

from paraview.modules.vtkRemotingCore import vtkPVSession  # noqa: F401  ParaView's own VTK, not another one
from vtkmodules.vtkCommonDataModel import vtkBox, vtkIterativeClosestPointTransform
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import (
    vtkArrayCalculator,
    vtkCleanPolyData,
    vtkContourFilter,
    vtkImplicitPolyDataDistance,
    vtkPolyDataConnectivityFilter,
    vtkReverseSense,
    vtkTriangleFilter,
)
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.vtkImagingHybrid import vtkSampleFunction
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

DEFECT = (80.0, 108.0, -200.0, -163.0, 88.0, 132.0)  # mm; a box around the hole in the forehead, above the eye
LANDMARKS = 600


def fail(text):
    sys.exit(f"implant: {text}")


def largest_part(algorithm):
    """Clean triangles of the largest connected part of a surface."""
    triangles, part, clean = vtkTriangleFilter(), vtkPolyDataConnectivityFilter(), vtkCleanPolyData()
    part.SetExtractionModeToLargestRegion()
    triangles.SetInputConnection(algorithm.GetOutputPort())
    part.SetInputConnection(triangles.GetOutputPort())
    clean.SetInputConnection(part.GetOutputPort())
    clean.Update()
    return clean.GetOutput()


def moved(surface, transform):
    filter_ = vtkTransformPolyDataFilter()
    filter_.SetTransform(transform)
    filter_.SetInputData(surface)
    filter_.Update()
    return filter_.GetOutput()


def other_side(bone):
    """The surface mirrored left to right, turned right side out, and laid on itself."""
    middle = bone.GetCenter()[0]
    mirror = vtkTransform()
    mirror.Translate(middle, 0.0, 0.0)
    mirror.Scale(-1.0, 1.0, 1.0)
    mirror.Translate(-middle, 0.0, 0.0)
    reverse = vtkReverseSense()
    reverse.SetInputData(moved(bone, mirror))
    reverse.Update()
    fit = vtkIterativeClosestPointTransform()
    fit.SetSource(reverse.GetOutput())
    fit.SetTarget(bone)
    fit.GetLandmarkTransform().SetModeToRigidBody()
    fit.SetMaximumNumberOfLandmarks(LANDMARKS)
    fit.SetMaximumNumberOfIterations(60)
    return moved(reverse.GetOutput(), fit)


def sampled(function, spacing):
    """Values of an implicit function on a grid that holds the box of the defect."""
    sample = vtkSampleFunction()
    sample.SetImplicitFunction(function)
    sample.SetModelBounds(*(side + spacing * (1 if i % 2 else -1) for i, side in enumerate(DEFECT)))
    sample.SetSampleDimensions(*(round((DEFECT[2 * i + 1] - DEFECT[2 * i]) / spacing) + 3 for i in range(3)))
    sample.ComputeNormalsOff()
    sample.SetOutputScalarTypeToDouble()
    sample.Update()
    return sample.GetOutput()


def distance(surface):
    """Signed, of a closed surface [mm]: negative inside."""
    function = vtkImplicitPolyDataDistance()
    function.SetInput(surface)
    return function


def on_the_way_in(grid, name):
    """In place of each value of an array the smallest on the way to it from the front: nothing wider inside can be put in."""
    width, depth, height = grid.GetDimensions()
    values = grid.GetPointData().GetArray(name)
    for column in range(width * height):
        first = column // width * width * depth + column % width
        least = values.GetValue(first)
        for i in range(first, first + width * depth, width):
            least = min(least, values.GetValue(i))
            values.SetValue(i, least)


def box():
    function = vtkBox()
    function.SetBounds(DEFECT)
    return function


def implant(bone, play, spacing):
    """The closed surface of the bone that is mirrored only."""
    solid, border = vtkArrayCalculator(), vtkContourFilter()
    grid = sampled(distance(other_side(bone)), spacing)
    grid.GetPointData().GetScalars().SetName("mirrored")
    for name, function in (("bone", distance(bone)), ("box", box())):
        values = sampled(function, spacing).GetPointData().GetScalars()
        values.SetName(name)
        grid.GetPointData().AddArray(values)
    on_the_way_in(grid, "bone")
    for name in ("mirrored", "bone", "box"):
        solid.AddScalarArrayName(name)
    solid.SetInputData(grid)
    solid.SetFunction(f"max(box, max(mirrored, {play} - bone))")
    solid.SetResultArrayName("solid")
    border.SetInputConnection(solid.GetOutputPort())
    border.SetInputArrayToProcess(0, 0, 0, 0, "solid")
    border.SetValue(0, 0.0)
    return largest_part(border)


def main(arguments):
    if not 2 <= len(arguments) <= 4:
        fail("needs SKULL and OUTPUT, and PLAY and SPACING in mm if others than 0.5 and 1: data/implant.py skull.vtp implant.vtp")
    try:
        play, spacing = (float(text) for text in (arguments[2:] + ["0.5", "1.0"][len(arguments) - 2:]))
    except ValueError:
        fail(f"PLAY and SPACING are numbers of mm, not {' '.join(arguments[2:])!r}")
    if not (play >= 0.0 and spacing > 0.0):
        fail("PLAY is at least 0 and SPACING more")
    reader = vtkXMLPolyDataReader()
    if not reader.CanReadFile(arguments[0]):
        fail(f"{arguments[0]} is no .vtp file: run data/get skull, which prints where the skull is")
    reader.SetFileName(arguments[0])
    made = implant(largest_part(reader), play, spacing)
    if made.GetNumberOfCells() == 0:
        fail(f"nothing is left with {play} mm of play")
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(arguments[1])
    writer.SetInputData(made)
    if not writer.Write():
        fail(f"{arguments[1]} cannot be written")
    print(f"{arguments[1]}: {made.GetNumberOfCells()} triangles, {made.GetNumberOfPoints()} points")


if __name__ == "__main__":
    main(sys.argv[1:])
