# SPDX-License-Identifier: GPL-3.0-or-later
"""data/implant.py fills a hole by the other side: of a round shell, whose plug has a known volume."""

import math
import pathlib
import subprocess
import tempfile
import unittest

from vtkmodules.vtkCommonDataModel import vtkCylinder, vtkImplicitBoolean, vtkSphere
from vtkmodules.vtkFiltersCore import vtkContourFilter, vtkFeatureEdges, vtkMassProperties, vtkReverseSense
from vtkmodules.vtkImagingHybrid import vtkSampleFunction
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "data" / "implant.py"
CENTRE, OUTER, INNER = (125.0, -107.0, 80.0), 87.0, 79.0  # mm; of a shell as large as a head
AXIS, RADIUS = (94.0, 104.0), 9.0  # x and z of a drill that goes through the shell from the front


def ball(radius):
    sphere = vtkSphere()
    sphere.SetCenter(CENTRE)
    sphere.SetRadius(radius)
    return sphere


def drill():
    cylinder = vtkCylinder()
    cylinder.SetCenter(AXIS[0], 0.0, AXIS[1])
    cylinder.SetRadius(RADIUS)
    return cylinder


def depths(x, z):
    """Where a line from the front enters and leaves the front wall of the shell [mm]."""
    across = (x - CENTRE[0]) ** 2 + (z - CENTRE[2]) ** 2
    return (CENTRE[1] - math.sqrt(radius ** 2 - across) for radius in (OUTER, INNER))


def plug(radius, step=0.1):
    """Volume of the plug that a round column cuts out of that wall [mm^3]."""
    places = [(i + 0.5) * step for i in range(round(-radius / step), round(radius / step))]
    inside = ((x, z) for x in places for z in places if x * x + z * z < radius * radius)
    ways = (depths(AXIS[0] + x, AXIS[1] + z) for x, z in inside)
    return sum((inner - outer) * step * step for outer, inner in ways)


def shell_with_hole(path):
    solid, sample, surface, writer = vtkImplicitBoolean(), vtkSampleFunction(), vtkContourFilter(), vtkXMLPolyDataWriter()
    solid.SetOperationTypeToDifference()
    for part in (ball(OUTER), ball(INNER), drill()):
        solid.AddFunction(part)
    sample.SetImplicitFunction(solid)
    sample.SetModelBounds(*(c + side * (OUTER + 5.0) for c in CENTRE for side in (-1, 1)))
    sample.SetSampleDimensions(47, 47, 47)
    sample.ComputeNormalsOff()
    surface.SetInputConnection(sample.GetOutputPort())
    surface.SetValue(0, 0.0)
    outward = vtkReverseSense()  # the contour of values that grow outwards has its front inside
    outward.SetInputConnection(surface.GetOutputPort())
    writer.SetInputConnection(outward.GetOutputPort())
    writer.SetFileName(str(path))
    writer.Write()


class Implant(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_script(self, *arguments):
        return subprocess.run(["pvpython", SCRIPT, *map(str, arguments)], capture_output=True, text=True, check=False)

    def test_the_plug_of_a_shell_is_closed_and_as_large_as_its_hole_less_the_play(self):
        skull, made, play = self.folder / "skull.vtp", self.folder / "implant.vtp", 1.0
        shell_with_hole(skull)
        run = self.run_script(skull, made, play, 2.0)
        self.assertEqual(run.returncode, 0, run.stderr)
        reader, edges, mass = vtkXMLPolyDataReader(), vtkFeatureEdges(), vtkMassProperties()
        reader.SetFileName(str(made))
        edges.FeatureEdgesOff()
        edges.SetInputConnection(reader.GetOutputPort())
        edges.Update()
        self.assertEqual(edges.GetOutput().GetNumberOfCells(), 0)
        mass.SetInputConnection(reader.GetOutputPort())
        mass.Update()
        self.assertAlmostEqual(mass.GetVolume() / plug(RADIUS - play), 1.0, delta=0.15)  # corners are cut by grids of 4 and 2 mm
        middle = [(low + high) / 2.0 for low, high in zip(*[iter(reader.GetOutput().GetBounds())] * 2)]
        outer, inner = depths(*AXIS)
        self.assertLess(math.dist(middle, (AXIS[0], (outer + inner) / 2.0, AXIS[1])), 1.5)

    def test_what_is_no_skull_is_refused_in_a_line(self):
        self.assertIn("data/get skull", self.run_script(self.folder / "none.vtp", self.folder / "made.vtp").stderr)
        self.assertIn("numbers of mm", self.run_script("a.vtp", "b.vtp", "much").stderr)
        self.assertIn("SKULL and OUTPUT", self.run_script().stderr)


if __name__ == "__main__":
    unittest.main()
