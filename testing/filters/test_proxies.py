# SPDX-License-Identifier: GPL-3.0-or-later
"""The filters and the session as ParaView proxies: pipeline, properties, read-outs, state files."""

import builtins
import gzip
import math
import os
import struct
import sys
import tempfile
import unittest

import paraview.simple as pv
from paraview import servermanager

from blocks import of_first_rank
import palpate.vtkHapticInteraction  # noqa: F401 (before the first session: gives its client-side object methods)

pv.LoadPlugin(os.environ["PALPATE_PLUGIN"], remote=False, ns={})

TICKS_TO_ENGAGE = 1100  # arming, the ramp of 1 s, and some to spare

JOYSTICK_STIFFNESS = 200.0  # N/m, usual for the simulated joystick


def proxy_manager():
    return servermanager.ActiveConnection.Session.GetSessionProxyManager()


def read(proxy, name, index=0):
    proxy.UpdatePropertyInformation()
    return proxy.GetProperty(name).GetElement(index)


def write(proxy, name, *values):
    helper = servermanager.vtkSMPropertyHelper(proxy, name)
    for index, value in enumerate(values):
        helper.Set(index, value)
    proxy.UpdateVTKObjects()


def nifti_bytes():
    """NIfTI-1 by its public description: 3 x 2 x 2 voxels of 16 bits, x mirrored, each value 10 more than its number."""
    header = bytearray(352)
    struct.pack_into("<i", header, 0, 348)
    struct.pack_into("<4h", header, 40, 3, 3, 2, 2)
    struct.pack_into("<2h", header, 70, 4, 16)
    struct.pack_into("<3f", header, 108, 352, 1, 10)
    struct.pack_into("<h", header, 254, 1)
    struct.pack_into("<12f", header, 280, -2, 0, 0, 90, 0, 2, 0, -126, 0, 0, 2, -72)
    header[344:348] = b"n+1\0"
    return bytes(header) + struct.pack("<12h", *range(12))


class Readers(unittest.TestCase):
    def test_paraview_opens_a_packed_nifti_image_by_its_name_and_puts_it_in_its_place(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "sub-01.T1w.nii.gz")
            with gzip.open(path, "wb") as file:
                file.write(nifti_bytes())
            image = pv.OpenDataFile(path)
            self.assertEqual(image.GetXMLName(), "HapticNIfTIReader")
            output = servermanager.Fetch(image)
        self.assertEqual(output.GetDimensions(), (3, 2, 2))
        values = output.GetPointData().GetArray("NIFTI")
        self.assertEqual([values.GetTuple1(i) for i in range(12)], [10.0 + i for i in range(12)])
        place = [0.0, 0.0, 0.0]
        output.TransformIndexToPhysicalPoint([2, 1, 1], place)
        self.assertEqual(place, [86.0, -124.0, -70.0])
        pv.Delete(image)


    def test_paraview_opens_a_recording_as_a_way_in_its_time(self):
        recordings = os.path.join(os.environ["PALPATE_SOURCE_DIR"], "testing", "haptics", "recording", "fixtures")
        for name in ("format-8-solid.palpate", "format-8-plane.palpate"):
            recording = pv.OpenDataFile(os.path.join(recordings, name))
            self.assertEqual(recording.GetXMLName(), "HapticRecordingReader")
            pv.UpdatePipeline(proxy=recording)
            times = list(recording.TimestepValues)
            sixtieths = [math.floor(60 * time + 1e-6) for time in times]
            self.assertEqual(sixtieths, sorted(set(sixtieths)))  # one picture in each at most
            path = servermanager.Fetch(recording, idx=1)
            count = path.GetNumberOfPoints() // 2
            pv.UpdatePipeline(times[3], recording)
            moment = recording.GetClientSideObject().GetOutputDataObject(0)  # fetching would ask for no time
            time = path.GetPointData().GetArray("Time")
            now = builtins.max(i for i in range(count) if time.GetValue(i) <= times[3])
            self.assertEqual(moment.GetPoint(0), path.GetPoint(now))
            self.assertEqual(moment.GetPoint(1), path.GetPoint(count + now))
            way = math.dist(moment.GetPoint(0), moment.GetPoint(1))
            self.assertAlmostEqual(moment.GetPointData().GetArray("Depth").GetValue(0), way)
            for array in ("Force", "Lateness", "Contacts"):
                self.assertEqual(moment.GetPointData().GetArray(array).GetTuple(1), path.GetPointData().GetArray(array).GetTuple(now))
            pv.Delete(recording)


class Filters(unittest.TestCase):
    def test_touch_along_path_offers_the_arrays_of_its_inputs_and_chooses_none_by_itself(self):
        height = pv.Elevation(Input=pv.Plane())
        cells = pv.PointDatatoCellData(Input=height)
        line = pv.Line(Point1=[0.1, 0.1, 0.5], Point2=[0.1, 0.1, -0.1])
        when = pv.Calculator(Input=line, ResultArrayName="t", Function="coordsZ")
        cells.UpdatePipeline()
        when.UpdatePipeline()
        touch = pv.TouchAlongPath(Input=cells, Path=when)
        for name in ("StiffnessArray", "FrictionArray", "TextureArray"):
            self.assertEqual(touch.GetPropertyValue(name), "")
            self.assertLessEqual({"", "Elevation"}, set(touch.GetProperty(name).Available))
            self.assertNotIn("t", touch.GetProperty(name).Available)
        self.assertEqual((touch.TimeArray, list(touch.GetProperty("TimeArray").Available)), ("", ["", "t"]))
        bare = pv.Triangulate(Input=pv.CleantoGrid(Input=pv.PassArrays(Input=line)))
        bare.UpdatePipeline()
        self.assertIsNotNone(pv.TouchAlongPath(Input=bare, Path=bare))

    def test_force_along_a_line_into_a_plane(self):
        plane = pv.Plane(Origin=[-5, -5, 0], Point1=[5, -5, 0], Point2=[-5, 5, 0])
        line = pv.Line(Point1=[1, 2, 1], Point2=[1, 2, -1], Resolution=40)
        touch = pv.TouchAlongPath(Input=plane, Path=line, Stiffness=300.0)
        output = servermanager.Fetch(touch)
        self.assertEqual(output.GetNumberOfPoints(), 41)
        force, depth = output.GetPointData().GetArray("Force"), output.GetPointData().GetArray("Depth")
        for i in range(41):
            expected = builtins.max(0.0, -(1.0 - 2.0 * i / 40))
            # vtkLineSource makes points in single precision
            self.assertAlmostEqual(depth.GetValue(i), expected, delta=1e-6)
            self.assertAlmostEqual(force.GetComponent(i, 2), 300.0 * expected, delta=300.0 * 1e-6)
        pv.Delete(touch)

    def test_stiffness_follows_an_array_of_the_surface(self):
        plane = pv.Plane(Origin=[-5, -5, 0], Point1=[5, -5, 0], Point2=[-5, 5, 0])
        height = pv.Elevation(Input=plane, LowPoint=[-5, 0, 0], HighPoint=[5, 0, 0])
        line = pv.Line(Point1=[1, 2, 1], Point2=[1, 2, -1], Resolution=40)
        touch = pv.TouchAlongPath(Input=height, Path=line, StiffnessArray="Elevation", StiffnessFeltRange=[100.0, 300.0])
        force = servermanager.Fetch(touch).GetPointData().GetArray("Force")
        slope = 200.0 / 10.0  # N/m per scene unit
        for i in range(41):
            depth = builtins.max(0.0, -(1.0 - 2.0 * i / 40))
            # vtkLineSource and vtkElevationFilter make single precision
            self.assertAlmostEqual(force.GetComponent(i, 2), (100.0 + slope * 6.0) * depth, delta=1e-3)
            self.assertAlmostEqual(force.GetComponent(i, 0), -0.5 * slope * depth**2, delta=1e-3)
        for proxy in (touch, line, height, plane):
            pv.Delete(proxy)

    def test_a_stroke_over_a_sphere_presses_all_along(self):
        sphere = pv.Sphere(Radius=50.0, ThetaResolution=60, PhiResolution=60)
        stroke = pv.HapticStroke(Input=sphere, Depth=1.0, Lift=5.0)
        touch = pv.TouchAlongPath(Input=sphere, Path=stroke, Stiffness=1.0)
        contacts = servermanager.Fetch(touch).GetPointData().GetArray("Contacts")
        count = contacts.GetNumberOfTuples()
        self.assertEqual(contacts.GetValue(0), 0)
        self.assertTrue(all(contacts.GetValue(i) > 0 for i in range(1, count)))
        pv.Delete(touch)

    def test_curves_of_an_image_stay_within_the_tolerance_asked_for(self):
        image = pv.Wavelet(WholeExtent=[-10, 10, -10, 10, 0, 0])
        curves = pv.ImageCurves(Input=image, Tolerance=0.1)
        output = servermanager.Fetch(curves)
        self.assertGreater(output.GetNumberOfLines(), 0)
        self.assertLessEqual(output.GetCellData().GetArray("Error").GetRange()[1], 0.1)
        self.assertEqual(output.GetFieldData().GetArray("Tolerance").GetValue(0), 0.1)
        by_feel = pv.ImageCurves(Input=image, SimplifyBy="Feel", LeastForce=0.1, Stiffness=500.0, Scale=1000.0)
        asked = servermanager.Fetch(by_feel).GetFieldData().GetArray("Tolerance").GetValue(0)
        self.assertAlmostEqual(asked, 0.1 / 500.0 * 1000.0)
        for proxy in (by_feel, curves, image):
            pv.Delete(proxy)


class Measuring(unittest.TestCase):
    def test_a_surface_is_checked_and_what_is_wrong_are_blocks_by_name(self):
        checked = pv.CheckSurface(Input=pv.Plane(XResolution=1, YResolution=1))
        blocks = of_first_rank(checked)
        self.assertEqual(list(blocks), ["Surface", "Holes", "Flipped", "Thin"])
        self.assertEqual(blocks["Holes"].GetNumberOfLines(), 4)
        self.assertAlmostEqual(blocks["Holes"].GetCellData().GetArray("Length").GetValue(0), 4.0)

    def test_a_surface_is_compared_with_a_closed_one(self):
        box = pv.Box(XLength=2.0, YLength=2.0, ZLength=2.0)
        plane = pv.Plane(Origin=[-3, -3, 0.25], Point1=[3, -3, 0.25], Point2=[-3, 3, 0.25], XResolution=12, YResolution=12)
        output = servermanager.Fetch(pv.CompareSurfaces(Input=plane, Reference=box))
        distance = output.GetPointData().GetArray("SignedDistance")
        for i in range(output.GetNumberOfPoints()):
            outside = [builtins.max(0.0, abs(c) - 1.0) for c in output.GetPoint(i)]
            inside = builtins.max(abs(c) - 1.0 for c in output.GetPoint(i))
            self.assertAlmostEqual(distance.GetValue(i), math.hypot(*outside) if inside > 0 else inside, delta=1e-6)

    def test_the_way_between_marks_of_a_table_goes_over_the_surface(self):
        box = pv.Box(XLength=2.0, YLength=2.0, ZLength=2.0)
        marks = pv.TouchMarks(Text="Source,X,Y,Z,depth\nbox,-1,-1,-1,0.5\nbox,1,1,1,nan\n")
        for port in (0, 1):
            way = pv.WayoverSurface(Input=box, Marks=pv.OutputPort(marks, port))
            length = servermanager.Fetch(way).GetCellData().GetArray("Length").GetValue(0)
            self.assertAlmostEqual(length, 2.0 * math.sqrt(5.0), delta=1e-6)
        self.assertEqual(servermanager.Fetch(pv.OutputPort(marks, 0)).GetPointData().GetArray("depth").GetValue(0), 0.5)

    def test_a_label_map_becomes_a_block_a_label(self):
        cells = pv.ProgrammableSource(OutputDataSetType="vtkImageData", ScriptRequestInformation="""
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline
self.GetExecutive().GetOutputInformation(0).Set(Pipeline.WHOLE_EXTENT(), 0, 9, 0, 9, 0, 9)""", Script="""
from vtkmodules.vtkCommonCore import vtkShortArray
image = self.GetOutput()
image.SetDimensions(10, 10, 10)
labels = vtkShortArray()
labels.SetName("labels")
for i in range(1000):
    x, y, z = i % 10, i // 10 % 10, i // 100
    labels.InsertNextValue(0 if not (2 <= y <= 6 and 2 <= z <= 6) else 3 if 1 <= x <= 4 else 8 if 5 <= x <= 7 else 0)
image.GetPointData().SetScalars(labels)""")
        output = servermanager.Fetch(pv.SurfacesofLabels(Input=cells, Smoothing=0))
        self.assertEqual(output.GetNumberOfBlocks(), 2)
        self.assertEqual(output.GetBlock(0).GetBounds(), (0.5, 4.5, 1.5, 6.5, 1.5, 6.5))
        self.assertEqual(output.GetBlock(1).GetBounds(), (4.5, 7.5, 1.5, 6.5, 1.5, 6.5))


class Session(unittest.TestCase):
    def setUp(self):
        self.proxy = proxy_manager().NewProxy("haptics", "HapticSession")
        self.assertIsNotNone(self.proxy)
        self.proxy.UpdateVTKObjects()

    def tearDown(self):
        write(self.proxy, "Touching", 0)

    def test_a_hand_that_is_put_at_the_origin_first_is_there(self):
        write(self.proxy, "VirtualTime", 1)
        write(self.proxy, "Touching", 1)
        session = self.proxy.GetClientSideObject()
        session.Step(1)
        self.assertIn("no hand position yet", session.GetFaultText())
        write(self.proxy, "HandPosition", 0.0, 0.0, 0.0)
        session.Step(1)
        self.assertNotIn("no hand position yet", session.GetFaultText())

    def test_steps_in_virtual_time_and_reads_out(self):
        plane = pv.Plane(Origin=[-50, -50, 0], Point1=[50, -50, 0], Point2=[-50, 50, 0])
        session = self.proxy.GetClientSideObject()
        self.assertTrue(session.AddSurface("plane", servermanager.Fetch(plane), None))
        session.CommitScene()
        self.assertTrue(session.FinishScene())
        write(self.proxy, "VirtualTime", 1)
        write(self.proxy, "Stiffness", 400.0)
        write(self.proxy, "HandPosition", 0.0, 0.0, 5.0)
        write(self.proxy, "Touching", 1)
        session.Step(TICKS_TO_ENGAGE)
        self.assertEqual(read(self.proxy, "StateText"), "engaged")
        write(self.proxy, "HandPosition", 0.0, 0.0, -2.0)
        session.Step(200)
        self.assertAlmostEqual(read(self.proxy, "ForceMagnitude"), 400.0 * 2.0 / 1000.0, delta=1e-12)
        self.assertAlmostEqual(read(self.proxy, "Depth"), 2.0, delta=1e-12)
        self.assertEqual(read(self.proxy, "Contacts"), 1)
        # One jump from free air to 2 mm: no force acted meanwhile, so no work filled the spring.
        self.assertEqual(read(self.proxy, "DeliveredEnergy"), 0.0)
        self.assertAlmostEqual(read(self.proxy, "PeakExcessEnergy"), 0.5 * 400.0 * 0.002**2, delta=1e-12)
        self.assertEqual(read(self.proxy, "StiffnessUsed"), 400.0)
        self.assertEqual(read(self.proxy, "StabiliserForce"), 0.0)  # "fed" pushes nobody
        self.assertEqual(read(self.proxy, "PeakStabiliserForce"), 0.0)
        self.assertEqual(read(self.proxy, "FrictionText"), "")  # the default is none
        self.assertEqual(read(self.proxy, "Ticks"), TICKS_TO_ENGAGE + 200)
        self.assertEqual(read(self.proxy, "Missed"), 0)
        self.assertIn("plane: ", read(self.proxy, "SceneReport"))

    def test_says_what_is_at_the_contact_and_keeps_it_as_a_mark_that_becomes_a_source(self):
        sphere = pv.Sphere(Radius=50.0, ThetaResolution=90, PhiResolution=90)
        height = pv.Elevation(Input=sphere, LowPoint=[0, 0, -50], HighPoint=[0, 0, 50], ScalarRange=[-50, 50])
        session = self.proxy.GetClientSideObject()
        self.assertTrue(session.AddSurface("ball", servermanager.Fetch(height), None))
        session.CommitScene()
        self.assertTrue(session.FinishScene())
        write(self.proxy, "VirtualTime", 1)
        write(self.proxy, "HandPosition", 3.0, 4.0, 55.0)
        write(self.proxy, "Touching", 1)
        session.Step(TICKS_TO_ENGAGE)
        write(self.proxy, "HandPosition", 3.0, 4.0, 48.0)
        session.Step(200)
        self.proxy.InvokeCommand("InspectContact")
        self.assertEqual(read(self.proxy, "ContactSource"), "ball")
        self.assertGreaterEqual(read(self.proxy, "ContactCell"), 0)
        place = [read(self.proxy, "ContactPosition", i) for i in range(3)]
        self.assertAlmostEqual(math.hypot(*place), 50.0, delta=0.05)  # facets of 4 degrees
        self.assertAlmostEqual(read(self.proxy, "ContactCurvature"), 1 / 50.0, delta=0.05 / 50.0)
        self.assertAlmostEqual(read(self.proxy, "ContactThickness"), 100.0, delta=1.0)
        self.assertAlmostEqual(session.GetInspection().GetValue("Elevation"), place[2], delta=1e-3)
        self.proxy.InvokeCommand("AddMark")
        self.assertEqual(read(self.proxy, "NumberOfMarks"), 1)
        marks = pv.TouchMarks(Text=read(self.proxy, "MarksText"))
        points = servermanager.Fetch(pv.OutputPort(marks, 0))
        self.assertEqual(list(points.GetPoint(0)), place)
        self.assertEqual(points.GetPointData().GetAbstractArray("Source").GetValue(0), "ball")

    def test_says_how_stiff_the_chosen_device_can_be_before_it_is_touched(self):
        self.assertEqual(read(self.proxy, "LargestStiffness"), math.inf)  # "fed" pushes nobody
        self.assertIn("renders no force", read(self.proxy, "StabilityText"))
        write(self.proxy, "DeviceName", "simulated-joystick")
        self.assertEqual(read(self.proxy, "LargestStiffness"), JOYSTICK_STIFFNESS)
        self.assertIn("the device's own limit", read(self.proxy, "StabilityText"))

    def test_a_device_is_pushed_no_stiffer_than_it_can_hold(self):
        write(self.proxy, "VirtualTime", 1)
        write(self.proxy, "DeviceName", "simulated-joystick")
        write(self.proxy, "Stiffness", 4.0 * JOYSTICK_STIFFNESS)
        write(self.proxy, "StrokePoints", 0.0, 0.0, 0.0)
        write(self.proxy, "Touching", 1)
        self.proxy.GetClientSideObject().Step(1)
        self.assertEqual(read(self.proxy, "StiffnessUsed"), JOYSTICK_STIFFNESS)
        self.assertEqual(read(self.proxy, "StiffnessLimited"), 1)
        write(self.proxy, "LimitStiffness", 0)
        self.proxy.GetClientSideObject().Step(1)
        self.assertEqual(read(self.proxy, "StiffnessUsed"), 4.0 * JOYSTICK_STIFFNESS)
        self.assertEqual(read(self.proxy, "StiffnessLimited"), 0)

    def test_is_saved_in_the_state_file_but_not_the_touching(self):
        write(self.proxy, "Stiffness", 321.5)
        write(self.proxy, "Radius", 0.75)
        write(self.proxy, "LimitRadius", 0)
        write(self.proxy, "FrictionStatic", 0.5)
        write(self.proxy, "FrictionKinetic", 0.25)
        write(self.proxy, "ForceShading", 1)
        write(self.proxy, "Simplify", 2)
        write(self.proxy, "Scale", 250.0)
        write(self.proxy, "Passivity", 0)
        write(self.proxy, "LimitStiffness", 0)
        write(self.proxy, "VelocityMethod", 1)
        write(self.proxy, "Delay", 3)
        write(self.proxy, "Hand", "firm")
        write(self.proxy, "DeviceName", "simulated-ideal")
        write(self.proxy, "StrokePoints", 0.0, 1.0, 2.0, 3.0, 4.0, 5.0)
        write(self.proxy, "Touching", 1)
        self.assertEqual(self.proxy.GetClientSideObject().GetNumberOfStrokePoints(), 2)
        proxy_manager().RegisterProxy("haptics", "HapticSession", self.proxy)
        with tempfile.TemporaryDirectory() as folder:
            state = os.path.join(folder, "touch.pvsm")
            pv.SaveState(state)
            write(self.proxy, "Touching", 0)
            proxy_manager().UnRegisterProxy("haptics", "HapticSession", self.proxy)
            pv.ResetSession()
            pv.LoadState(state)
        loaded = proxy_manager().GetProxy("haptics", "HapticSession")
        self.assertIsNotNone(loaded)
        value = lambda name: servermanager.vtkSMPropertyHelper(loaded, name).GetAsDouble()  # noqa: E731
        self.assertEqual(value("Stiffness"), 321.5)
        self.assertEqual(value("Radius"), 0.75)
        self.assertEqual(value("Scale"), 250.0)
        session = loaded.GetClientSideObject()
        self.assertEqual(session.GetSetting("Stiffness"), 321.5)
        self.assertEqual(session.GetSettingText("DeviceName"), "simulated-ideal")
        self.assertEqual((session.GetSetting("FrictionStatic"), session.GetSetting("FrictionKinetic")), (0.5, 0.25))
        self.assertEqual(session.GetFrictionKineticUsed(), 0.25)
        self.assertFalse(session.IsOn("LimitRadius"))
        self.assertEqual((session.GetRadiusUsed(), session.GetRadiusLimit()), (0.75, float("inf")))
        self.assertTrue(session.IsOn("ForceShading"))
        self.assertEqual(session.GetSetting("Simplify"), session.On)
        self.assertFalse(session.IsOn("Passivity"))
        self.assertFalse(session.IsOn("LimitStiffness"))
        self.assertEqual(session.GetSetting("VelocityMethod"), session.LowPass)
        self.assertEqual((session.GetSetting("Delay"), session.GetSettingText("Hand")), (3, "firm"))
        self.assertEqual(session.GetNumberOfStrokePoints(), 2)
        self.assertFalse(session.GetTouching())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
