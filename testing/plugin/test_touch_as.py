# SPDX-License-Identifier: GPL-3.0-or-later
"""A source is touched as the kind of thing that is named, or the most likely one. A process of its own: the session is registered."""

import os
import sys
import unittest

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

simple.LoadPlugin(os.environ["PALPATE_PLUGIN"], remote=False, ns=globals())
from palpate.simple import GetHapticSession, HapticRefusal, LetGo, SetHaptics, Touch, TouchAs  # noqa: E402

NEEDLE = os.path.join(os.environ["PALPATE_SOURCE_DIR"], "data", "mechanisms", "needle.json")
NAMES = ("ToolSource", "SoftSource", "MechanismSource", "FeltSource", "FieldArray", "FieldVectors", "SourcesText")


class Kinds(unittest.TestCase):
    def setUp(self):
        self.view = simple.CreateView("RenderView")
        self.view.ViewSize = [120, 100]
        simple.SetActiveView(self.view)
        SetHaptics(DeviceName="fed", VirtualTime=1)

    def tearDown(self):
        LetGo()
        SetHaptics(**dict.fromkeys(NAMES, ""), LineRadius=0, FieldIsosurface=0, FieldIsovalue=0, FieldFollow=0, ToolHandle=0)
        for source in list(simple.GetSources().values()):
            simple.Delete(source)
        simple.Delete(self.view)

    def show(self, source, representation=None, array=None):
        display = simple.Show(source, self.view)
        if array:
            simple.ColorBy(display, ("POINTS", array))
        if representation:
            display.SetRepresentationType(representation)
        simple.Render(self.view)
        return display

    def text(self, name):
        return GetHapticSession().GetSettingText(name)

    def number(self, name):
        return GetHapticSession().GetSetting(name)

    def test_a_box_is_most_likely_touched_as_surface(self):
        self.show(simple.Box(registrationName="box"))
        self.assertEqual(TouchAs("box"), "box is touched as surface.")
        Touch()
        self.assertIn("box: kept", GetHapticSession().GetSceneReport())

    def test_a_volume_that_is_touched_as_surface_is_drawn_as_one(self):
        display = self.show(simple.Wavelet(registrationName="volume"), "Outline")
        TouchAs("volume", "surface")
        self.assertEqual(display.Representation, "Surface")
        Touch()
        self.assertIn("volume: kept", GetHapticSession().GetSceneReport())

    def test_lines_get_a_hundredth_of_their_longest_side_as_radius(self):
        line = simple.Line(registrationName="line", Point1=[0, 0, 0], Point2=[50, 10, 0])
        self.show(line)
        with self.assertRaises(HapticRefusal):
            Touch()
        self.assertEqual(TouchAs(line), "line is touched as lines with a radius of 0.5 u.")
        self.assertEqual(self.number("LineRadius"), 0.5)
        Touch()
        self.assertIn("(lines): kept", GetHapticSession().GetSceneReport())

    def test_a_radius_that_was_set_is_kept(self):
        self.show(simple.Line(registrationName="line"))
        SetHaptics(LineRadius=0.125)
        TouchAs("line", "lines")
        self.assertEqual(self.number("LineRadius"), 0.125)

    def test_a_volume_is_felt_at_half_of_the_largest_opacity_of_the_array_that_colours_it(self):
        volume = simple.Calculator(registrationName="volume", Input=simple.Wavelet(), Function="2 * RTData", ResultArrayName="Double")
        self.show(volume, "Volume", "Double")
        simple.GetColorTransferFunction("Double").RescaleTransferFunction(100.0, 500.0)
        simple.GetOpacityTransferFunction("Double").Points = [100.0, 0.0, 0.5, 0.0, 200.0, 0.0, 0.5, 0.0, 500.0, 0.6, 0.5, 0.0]
        said = TouchAs("volume")
        half = 200.0 + 0.5 * (500.0 - 200.0)
        self.assertIn("isosurface at Double = 350", said)
        self.assertEqual((self.text("FeltSource"), self.text("FieldArray")), ("volume", "Double"))
        self.assertTrue(self.number("FieldIsosurface"))
        self.assertAlmostEqual(self.number("FieldIsovalue"), half, delta=1e-9)
        Touch()
        self.assertEqual(GetHapticSession().GetFieldName(), "volume")

    def test_a_volume_whose_middle_level_is_open_at_its_border_is_felt_at_a_closed_one(self):
        wavelet = simple.Wavelet(registrationName="wavelet")
        self.show(wavelet, "Volume", "RTData")
        data = servermanager.Fetch(wavelet)
        values = vtk_to_numpy(data.GetPointData().GetArray("RTData")).astype(float).reshape(21, 21, 21)
        inside = values[1:-1, 1:-1, 1:-1]
        border = numpy.ma.masked_array(values, numpy.zeros(values.shape, bool))
        border.mask[1:-1, 1:-1, 1:-1] = True
        middle, highest = 0.5 * (values.min() + values.max()), values.max()
        self.assertGreater((border > middle).sum(), 0.02 * border.count())
        self.assertGreater(inside.max(), border.max())
        said = TouchAs("wavelet")
        level = self.number("FieldIsovalue")
        self.assertAlmostEqual(level, 0.5 * (border.max() + highest), delta=1e-6 * highest)
        self.assertEqual((border > level).sum(), 0)
        self.assertIn("is open where the data end", said)

    def test_a_volume_without_a_closed_level_is_felt_at_its_middle(self):
        ramp = simple.Calculator(registrationName="ramp", Input=simple.Wavelet(), Function="coordsX", ResultArrayName="x")
        self.show(ramp, "Volume", "x")
        said = TouchAs("ramp")
        self.assertAlmostEqual(self.number("FieldIsovalue"), 0.0, delta=1e-9)
        self.assertNotIn("is open", said)

    def test_a_flow_that_is_coloured_by_its_vectors_leads_the_hand(self):
        flow = simple.KnownFlow(registrationName="flow", Flow="Lamb-Oseen", Cells="Image")
        self.show(flow, "Outline", "Velocity")
        TouchAs("flow", "field")
        self.assertEqual((self.text("FieldVectors"), self.text("FieldArray")), ("Velocity", ""))
        self.assertEqual(self.number("FieldFollow"), 2.0)

    def test_a_peg_is_a_tool_held_at_its_origin_and_its_hole_a_surface(self):
        peg, hole = (simple.HapticTool(registrationName=name, Shape=name.title()) for name in ("peg", "hole"))
        shown = self.show(peg)
        self.show(hole)
        self.assertEqual(TouchAs("hole"), "hole is touched as surface.")
        self.assertEqual(TouchAs("peg"), "peg is held as tool.")
        self.assertEqual((self.text("ToolSource"), self.number("ToolHandle"), shown.Visibility), ("peg", 1, 0))
        Touch()
        self.assertIn("hole: kept", GetHapticSession().GetSceneReport())

    def test_a_tool_and_tissue_are_touched_together_and_let_go_for_a_mechanism(self):
        self.show(simple.Box(registrationName="box"))
        body = simple.SoftBody(registrationName="block", Input=simple.Tetrahedralize(Input=simple.Wavelet(WholeExtent=[-2, 2, -2, 2, 0, 2])), Fixed="zmin")
        self.show(body)
        TouchAs("box", "tool")
        self.assertEqual(TouchAs("block"), "block is pressed as tissue.")
        self.assertEqual((self.text("SoftSource"), self.text("ToolSource")), ("block", "box"))
        self.show(simple.HapticMechanism(registrationName="needle", FileName=NEEDLE))
        self.assertEqual(TouchAs("needle"), "needle is held as mechanism. box is let go. block is let go.")
        self.assertEqual((self.text("SoftSource"), self.text("ToolSource"), self.text("MechanismSource")), ("", "", "needle"))
        self.assertEqual(TouchAs("box", "tool"), "box is held as tool. needle is let go.")

    def test_a_source_is_touched_in_one_kind_at_a_time(self):
        shown = self.show(simple.Box(registrationName="box"))
        TouchAs("box", "tool")
        TouchAs("box", "not at all")
        self.assertEqual((self.text("ToolSource"), GetHapticSession().GetSourceTouched("box")), ("", False))
        TouchAs("box", "surface")
        self.assertEqual((GetHapticSession().GetSourceTouched("box"), shown.Visibility), (True, 1))

    def test_a_kind_that_does_not_fit_is_refused_with_the_name_and_changes_nothing(self):
        self.show(simple.Line(registrationName="line"))
        self.show(simple.Box(registrationName="box"))
        TouchAs("box", "tool")
        for kind, part in (("tool", "no faces"), ("field", "no cells that fill space"), ("tissue", "Soft Body"), ("mechanism", "Haptic Mechanism"), ("soup", "the kinds are")):
            with self.subTest(kind=kind), self.assertRaisesRegex(HapticRefusal, "^line .*" + part):
                TouchAs("line", kind)
        with self.assertRaisesRegex(HapticRefusal, "^box has no lines"):
            TouchAs("box", "lines")
        self.assertEqual((self.text("ToolSource"), self.number("LineRadius")), ("box", 0.0))


if __name__ == "__main__":
    # A SystemExit would skip pvpython's own ending, which closes views before the display.
    if not unittest.main(exit=False).result.wasSuccessful():
        sys.exit(1)
