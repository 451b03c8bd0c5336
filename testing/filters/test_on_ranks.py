# SPDX-License-Identifier: GPL-3.0-or-later
"""Filters that need all of their data where each of two ranks has a half: what they find is that of the whole.

The plugin is loaded on both by PV_PLUGIN_PATH. The script runs on the first rank alone.
"""

import math
import sys
import unittest

from paraview import servermanager, simple
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource

from palpate.vtkHapticPipeline import vtkImageCurves

RADIUS = 50.0  # u
DEPTH = 2.0  # u
FACETS = RADIUS * (1 - math.cos(math.pi / 40))  # how far the middle of a facet may lie inside, in each of two directions


def of_first_rank(source):
    """What it has made of blocks: to be fetched, blocks of several ranks become blocks of a rank each."""
    return servermanager.Fetch(source).GetBlock(0)


class OnRanks(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        ranks = servermanager.vtkProcessModule.GetProcessModule().GetNumberOfLocalPartitions()
        assert ranks == 2
        # The sphere source deals its meridians out: the half with y > 0 is on one rank, that with y < 0 on the other.
        cls.sphere = simple.Sphere(Radius=RADIUS, ThetaResolution=40, PhiResolution=41)
        # A solid whose triangles are dealt out as they are.
        cls.halves = simple.RedistributeDataSet(Input=simple.HapticTool(Shape="Peg", Radius=5.0, Length=20.0))

    def forces(self, y):
        """Along a hand that comes in along y to DEPTH below the sphere's surface."""
        path = simple.Line(Point1=[0.0, y * (RADIUS + 10.0), 0.0], Point2=[0.0, y * (RADIUS - DEPTH), 0.0], Resolution=200)
        felt = servermanager.Fetch(simple.TouchAlongPath(Input=self.sphere, Path=path, Stiffness=500.0))
        array = felt.GetPointData().GetArray("Force")
        return [array.GetTuple(i) for i in range(felt.GetNumberOfPoints())]

    def test_both_halves_push_alike(self):
        one, other = self.forces(1.0), self.forces(-1.0)
        self.assertEqual((len(one), len(other)), (201, 201))
        self.assertGreater(one[-1][1], 0.5 * 500.0 * DEPTH)
        for f, g in zip(one, other):
            self.assertAlmostEqual(f[1], -g[1], delta=1e-9)

    def test_a_solid_has_no_hole_along_the_seam_of_the_ranks(self):
        blocks = of_first_rank(simple.CheckSurface(Input=self.halves))
        found = {blocks.GetMetaData(i).Get(blocks.NAME()): blocks.GetBlock(i) for i in range(blocks.GetNumberOfBlocks())}
        self.assertEqual(found["Holes"].GetNumberOfCells(), 0)
        self.assertEqual(found["Flipped"].GetNumberOfCells(), 0)
        self.assertGreater(found["Surface"].GetNumberOfCells(), 100)

    def test_planes_are_compared_with_all_of_a_solid(self):
        # A peg of radius 5 hangs below z = 0: above it and just inside, its upper end is what is nearest.
        for z in (10.0, -1.0):
            plane = simple.Plane(Origin=[-2, -2, z], Point1=[2, -2, z], Point2=[-2, 2, z], XResolution=12, YResolution=12)
            measured = servermanager.Fetch(simple.CompareSurfaces(Input=plane, Reference=self.halves))
            distance = measured.GetPointData().GetArray("SignedDistance")
            self.assertEqual(measured.GetNumberOfPoints(), 13 * 13)
            for i in range(measured.GetNumberOfPoints()):
                self.assertAlmostEqual(distance.GetValue(i), z, delta=1e-6)

    def test_the_way_from_one_half_to_the_other_goes_over_the_seam(self):
        marks = simple.TouchMarks(Text=f"Source,X,Y,Z\nball,0,{RADIUS},0\nball,0,{-RADIUS},0\n")
        way = servermanager.Fetch(simple.WayoverSurface(Input=self.sphere, Marks=simple.OutputPort(marks, 0)))
        self.assertEqual(way.GetNumberOfCells(), 1)
        length = way.GetCellData().GetArray("Length").GetValue(0)
        self.assertLessEqual(length, math.pi * RADIUS)
        self.assertGreaterEqual(length, math.pi * (RADIUS - 2 * FACETS))

    def test_a_stroke_goes_from_one_half_to_the_other(self):
        stroke = servermanager.Fetch(simple.HapticStroke(Input=self.sphere, Depth=1.0, Lift=5.0, Reach=0.6))
        self.assertEqual(stroke.GetNumberOfCells(), 1)
        low, high = stroke.GetBounds()[2:4]
        # Where the sphere is no cliff, y <= 3 z, the middle 0.6 of that, a step and the depth less.
        reached = 0.6 * RADIUS * 3 / math.sqrt(10) - 2.0
        self.assertLess(low, -reached)
        self.assertGreater(high, reached)

    def test_curves_and_labels_are_those_of_the_whole_image(self):
        source, alone = vtkRTAnalyticSource(), vtkImageCurves()
        source.SetWholeExtent(-10, 10, -10, 10, 0, 0)
        alone.SetInputConnection(source.GetOutputPort())
        alone.SetTolerance(0.1)
        alone.Update()
        image = simple.Wavelet(WholeExtent=[-10, 10, -10, 10, 0, 0])
        curves = servermanager.Fetch(simple.ImageCurves(Input=image, Tolerance=0.1))
        self.assertGreater(alone.GetOutput().GetNumberOfCells(), 0)
        self.assertEqual((curves.GetNumberOfCells(), curves.GetNumberOfPoints()),
                         (alone.GetOutput().GetNumberOfCells(), alone.GetOutput().GetNumberOfPoints()))
        halves = simple.Calculator(Input=simple.Wavelet(), Function="if(coordsZ > 0.5, 2, 1)", ResultArrayName="label")
        labels = simple.SurfacesofLabels(Input=halves, Smoothing=0)
        blocks = of_first_rank(labels)
        surfaces = [blocks.GetBlock(i) for i in range(blocks.GetNumberOfBlocks())]
        self.assertEqual([surface.GetBounds() for surface in surfaces],
                         [(-10.5, 10.5, -10.5, 10.5, -10.5, 0.5), (-10.5, 10.5, -10.5, 10.5, 0.5, 10.5)])


if __name__ == "__main__":
    if not unittest.main(exit=False).result.wasSuccessful():
        sys.exit(1)
