# SPDX-License-Identifier: GPL-3.0-or-later
"""Filters that need all of their data where each of two ranks has a half: their results are those of the whole.

The plugin is loaded on both by PV_PLUGIN_PATH. The script runs on the first rank alone.
"""

import math
import os
import sys
import unittest

from paraview import servermanager, simple
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource

from blocks import of_first_rank
from palpate.vtkHapticPipeline import vtkImageCurves

RADIUS = 50.0  # u
DEPTH = 2.0  # u
FACETS = RADIUS * (1 - math.cos(math.pi / 40))  # how far the middle of a facet may lie inside, in each of two directions


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

    @staticmethod
    def counted(script):
        """The counts of the script, which both ranks run, on the first."""
        counted = simple.ProgrammableSource(OutputDataSetType="vtkTable", Script=script)
        table = servermanager.Fetch(counted)
        return [table.GetColumnByName("cells").GetValue(i) for i in range(table.GetNumberOfRows())]

    def test_a_rank_whose_piece_is_as_it_was_or_empty_does_not_keep_the_others_waiting(self):
        cells = self.counted("""
from vtkmodules.vtkCommonCore import vtkIdTypeArray
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkParallelCore import vtkMultiProcessController
from palpate.vtkHapticPipeline import vtkHapticNeighbourhood
rank = vtkMultiProcessController.GetGlobalController().GetLocalProcessId()
piece, ball = vtkPolyData(), vtkSphereSource()
ball.SetRadius(50.0)
ball.SetThetaResolution(20)
ball.SetPhiResolution(20)
ball.Update()
part = vtkHapticNeighbourhood()
part.SetInputDataObject(piece)
part.SetLimit(100)
part.SetReach(20.0)
part.SetCentre(0.0, 0.0, 50.0)
cells = vtkIdTypeArray()
cells.SetName("cells")
for filled in ((), (0,), (0, 1), (1,)):
    if rank in filled and piece.GetNumberOfCells() == 0:
        piece.ShallowCopy(ball.GetOutput())
    elif rank not in filled and piece.GetNumberOfCells() > 0:
        piece.Initialize()
    part.Modified()
    part.Update()
    cells.InsertNextValue(part.GetOutput().GetNumberOfCells())
if rank == 0:
    self.GetOutputDataObject(0).AddColumn(cells)
""")
        alone = cells[1]
        self.assertEqual(cells[0], 0)
        self.assertGreater(alone, 10)
        self.assertEqual(cells[3], alone)  # the same half ball, on the other rank
        self.assertGreater(cells[2], 10)

    def test_a_soft_body_and_its_skin_are_one_on_the_first_rank(self):
        cells = simple.Tetrahedralize(Input=simple.Wavelet(WholeExtent=[-4, 4, -4, 4, -4, 4]))  # five of each voxel
        body = simple.SoftBody(Input=cells, Fixed="zmin")
        made = servermanager.Fetch(body)
        self.assertEqual((made.GetNumberOfPoints(), made.GetNumberOfCells()), (9 ** 3, 5 * 8 ** 3))
        ball = simple.Sphere(Radius=3.0, ThetaResolution=20, PhiResolution=21)
        skin = servermanager.Fetch(simple.SoftSkin(Input=ball, Body=body))
        self.assertEqual(skin.GetNumberOfCells(), 2 * 20 + 2 * 20 * 18)
        self.assertEqual(skin.GetPointData().GetArray("Displacement").GetRange(-1), (0.0, 0.0))
        ground = simple.HapticTool(Shape="Peg", Radius=5.0, Length=20.0)  # on both ranks or dealt out: one solid
        filled = servermanager.Fetch(simple.SoftBody(Input=ground, EdgeLength=3.0, Fixed="zmin"))
        self.assertGreater(filled.GetNumberOfCells(), 100)

    def test_a_soft_body_is_felt_along_a_path(self):
        body = simple.SoftBody(Input=simple.Tetrahedralize(Input=simple.Wavelet(WholeExtent=[-2, 2, -2, 2, -2, 2])),
                               Fixed="zmin", Unit=0.01)  # of 20 kPa
        path = simple.Line(Point1=[0.1, 0.2, 4.0], Point2=[0.1, 0.2, 2.0], Resolution=100)
        felt = servermanager.Fetch(simple.TouchAlongPath(Input=body, Path=path, Radius=1.0, Stiffness=500.0, Scale=100.0))
        force = felt.GetPointData().GetArray("Force").GetTuple(felt.GetNumberOfPoints() - 1)
        # A unit into a soft body: less than the spring of a wall, 5 N.
        self.assertGreater(force[2], 0.5)
        self.assertLess(force[2], 4.9)

    def test_surfaces_are_compared_over_the_area_of_all_ranks(self):
        slope = simple.Plane(Origin=[0, 0, 1], Point1=[1, 0, 2], Point2=[0, 1, 1], XResolution=7, YResolution=5)
        dealt = simple.ExtractSurface(Input=simple.RedistributeDataSet(Input=slope))
        ground = simple.Plane(Origin=[-9, -9, 0], Point1=[9, -9, 0], Point2=[-9, 9, 0])
        compared = simple.CompareSurfaces(Input=dealt, Reference=ground)
        compared.UpdatePipeline()
        fields = compared.GetFieldDataInformation()
        # The height x + 1 over x from 0 to 1.
        for name, expected in (("MeanDistance", 1.5), ("RMSDistance", math.sqrt(7.0 / 3.0)), ("MaximumDistance", 2.0)):
            for end in fields.GetArray(name).GetRange():  # of both ranks
                self.assertAlmostEqual(end, expected, delta=1e-6)

    def test_a_map_on_the_half_of_one_rank_finds_the_wall_on_the_other(self):
        top = (0.0, RADIUS, 0.0)
        made = simple.MapAroundContact(Input=self.sphere, Quantity="Thickness", Centre=top, Radius=10.0)
        ball = servermanager.Fetch(made)
        values = ball.GetPointData().GetArray("Thickness")
        near = [i for i in range(ball.GetNumberOfPoints()) if math.dist(ball.GetPoint(i), top) < 10.0]
        self.assertGreater(len(near), 4)
        for i in near:
            self.assertAlmostEqual(values.GetValue(i), 2.0 * RADIUS, delta=4.0 * FACETS)

    def test_what_fails_on_the_first_rank_keeps_no_other_waiting(self):
        path = simple.Line(Point1=[0.1, 0.2, 4.0], Point2=[0.1, 0.2, 2.0], Resolution=10)
        cells = simple.Tetrahedralize(Input=simple.Wavelet(WholeExtent=[-2, 2, -2, 2, -2, 2]))
        for body in (simple.SoftBody(Input=cells, Fixed="no such array"), simple.HapticMechanism(FileName="no such file.json"),
                     simple.SoftSkin(Input=simple.Sphere(), Body=cells)):
            felt = simple.TouchAlongPath(Input=body, Path=path)
            felt.UpdatePipeline()
            self.assertEqual(felt.GetDataInformation().GetNumberOfPoints(), 0)

    def test_a_mechanism_is_there_once(self):
        scene = os.path.join(os.environ["PALPATE_SOURCE_DIR"], "data", "mechanisms", "needle.json")
        shapes = servermanager.Fetch(simple.HapticMechanism(FileName=scene))
        which = shapes.GetCellData().GetArray("Body")
        bodies = [int(which.GetValue(i)) for i in range(shapes.GetNumberOfCells())]
        # The borders of 10 x 10 x 2 and of 8 x 8 x 4 voxels, two triangles each of their squares.
        self.assertEqual((bodies.count(1), bodies.count(2)), (2 * 2 * (100 + 20 + 20), 2 * 2 * (64 + 32 + 32)))

    def test_both_halves_push_alike(self):
        one, other = self.forces(1.0), self.forces(-1.0)
        self.assertEqual((len(one), len(other)), (201, 201))
        self.assertGreater(one[-1][1], 0.5 * 500.0 * DEPTH)
        for f, g in zip(one, other):
            self.assertAlmostEqual(f[1], -g[1], delta=1e-9)

    def test_a_solid_has_no_hole_along_the_seam_of_the_ranks(self):
        found = of_first_rank(simple.CheckSurface(Input=self.halves))
        self.assertEqual(found["Holes"].GetNumberOfCells(), 0)
        self.assertEqual(found["Flipped"].GetNumberOfCells(), 0)
        self.assertGreater(found["Surface"].GetNumberOfCells(), 100)

    def test_planes_are_compared_with_all_of_a_solid(self):
        # A peg of radius 5 hangs below z = 0: above it and just inside, its upper end is nearest.
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
        self.assertEqual([surface.GetBounds() for surface in of_first_rank(labels).values()],
                         [(-10.5, 10.5, -10.5, 10.5, -10.5, 0.5), (-10.5, 10.5, -10.5, 10.5, 0.5, 10.5)])


if __name__ == "__main__":
    if not unittest.main(exit=False).result.wasSuccessful():
        sys.exit(1)
