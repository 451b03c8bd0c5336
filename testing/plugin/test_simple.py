# SPDX-License-Identifier: GPL-3.0-or-later
"""Touching with functions as paraview.simple has them. A process of its own: the session is registered."""

import math
import os
import sys
import tempfile
import unittest

from paraview import servermanager, simple

simple.LoadPlugin(os.environ["PALPATE_PLUGIN"], remote=False, ns=globals())
from displays import move  # noqa: E402
from palpate.simple import (ClearMarks, FitHand, GetHapticSession, GetMarks, HapticRefusal, HapticState, HoldTool, LetGo, MapContact, Mark,  # noqa: E402
                            PressBody, SaveMarks, SetHaptics, SetSource, TakeColorRange, Touch)

TICKS_TO_ENGAGE = 1100  # arming, the ramp of 1 s, and some to spare
STIFFNESS = 400.0  # N/m
SCALE = 1000.0  # u/m
DEPTH = 2.0  # u
FORCE = STIFFNESS * DEPTH / SCALE  # N


class Functions(unittest.TestCase):
    def setUp(self):
        self.view = simple.CreateView("RenderView")
        self.view.ViewSize = [120, 100]
        simple.SetActiveView(self.view)
        SetHaptics(DeviceName="fed", VirtualTime=1, Stiffness=STIFFNESS, FitOnTouch=0, Scale=SCALE, Offset=[0, 0, 0])

    def tearDown(self):
        LetGo()
        ClearMarks()
        SetHaptics(SourcesText="", ToolSource="", SoftSource="")
        for source in list(simple.GetSources().values()):
            simple.Delete(source)
        simple.Delete(self.view)

    def press_box(self):
        """2 u into the face x = 50 of a box."""
        box = simple.Box(XLength=100, YLength=100, ZLength=100)
        simple.Show(box, self.view)
        self.press_face(20)
        return box

    def press_face(self, z):
        """2 u into the face x = 50 of the shown box, at this height."""
        session = GetHapticSession()
        session.SetHandPosition(60, 10, z)
        Touch()
        session.Step(TICKS_TO_ENGAGE)
        session.SetHandPosition(50 - DEPTH, 10, z)
        session.Step(300)

    def test_touch_feels_what_the_view_shows_and_let_go_ends_it(self):
        self.press_box()
        state = HapticState()
        self.assertEqual(state["StateText"], "engaged")
        self.assertAlmostEqual(state["Force"][0], FORCE, delta=1e-9)
        self.assertAlmostEqual(state["Depth"], DEPTH, delta=1e-9)
        LetGo()
        self.assertFalse(GetHapticSession().GetTouching())

    def test_a_volume_that_is_drawn_is_felt_as_a_field_once_its_array_is_named(self):
        wavelet = simple.Wavelet()
        simple.Show(wavelet, self.view).SetRepresentationType("Outline")
        SetHaptics(FieldArray="RTData", FieldIsosurface=1, FieldIsovalue=200.0, FieldSmoothing=0, Scale=100.0)
        self.addCleanup(SetHaptics, FieldArray="", FieldIsosurface=0, FieldSmoothing=-1)
        GetHapticSession().SetHandPosition(1.0, 2.0, 3.0)
        Touch()
        session = GetHapticSession()
        self.assertEqual(session.GetFieldName(), "Wavelet1")
        session.Step(TICKS_TO_ENGAGE)
        session.Update()
        probe = simple.ProbeLocation(Input=wavelet, ProbeType="Fixed Radius Point Source")
        probe.ProbeType.Center = [1.0, 2.0, 3.0]
        probed = servermanager.Fetch(probe).GetPointData().GetArray("RTData").GetTuple1(0)
        self.assertAlmostEqual(session.GetFieldValue(), probed, delta=1e-4 * probed)  # both of single precision

    def test_what_a_colour_map_shows_low_and_high_feels_low_and_high(self):
        display = simple.Show(simple.Wavelet(), self.view)
        display.SetRepresentationType("Volume")
        simple.ColorBy(display, ("POINTS", "RTData"))
        simple.GetColorTransferFunction("RTData").RescaleTransferFunction(50.0, 250.0)
        simple.GetOpacityTransferFunction("RTData").Points = [50.0, 0.0, 0.5, 0.0, 100.0, 0.0, 0.5, 0.0, 250.0, 0.6, 0.5, 0.0]
        with self.assertRaisesRegex(HapticRefusal, "coloured by"):
            TakeColorRange(self.view)
        SetHaptics(FieldArray="RTData", StiffnessArray="RTData")
        self.assertIn("RTData", TakeColorRange(self.view))
        session = GetHapticSession()
        self.assertAlmostEqual(session.GetSetting("FieldIsovalue"), 175.0)  # half of 0.6, half way from 100 to 250
        self.assertAlmostEqual(session.GetSetting("FieldDetentOrigin"), 50.0)
        self.assertAlmostEqual(session.GetSetting("FieldDetentSpacing"), 25.0)  # an eighth of 200
        self.assertEqual(tuple(session.GetSettingNumbers("StiffnessDataRange")), (50.0, 250.0))
        SetHaptics(FieldArray="", StiffnessArray="")

    def test_a_mark_says_where_it_is_and_is_saved(self):
        self.press_box()
        mark = Mark()
        self.assertIn("Box", mark["Source"])
        for axis, place in zip("XYZ", (50.0, 10.0, 20.0)):
            self.assertAlmostEqual(mark[axis], place, delta=1e-5)
        self.assertAlmostEqual(mark["Thickness"], 100.0, delta=1e-4)
        self.assertEqual(GetMarks(), [mark])
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "marks.csv")
            SaveMarks(file)
            with open(file, encoding="utf-8") as text:
                self.assertTrue(text.readline().startswith("Source,X,Y,Z,"))
            with self.assertRaisesRegex(HapticRefusal, "csv or vtp"):
                SaveMarks(os.path.join(folder, "marks.doc"))
        ClearMarks()
        self.assertEqual(GetMarks(), [])

    def test_a_map_around_the_contact_is_shown_in_place_of_the_source_wherever_the_source_is_drawn(self):
        with self.assertRaisesRegex(HapticRefusal, "touch a surface first"):
            MapContact()
        box = simple.Box(XLength=100, YLength=100, ZLength=100)
        move(simple.Show(box, self.view), [0.0, 0.0, 30.0])
        self.press_face(50)
        with self.assertRaisesRegex(HapticRefusal, "'Thickness' or 'Curvature'"):
            MapContact("Height")
        vars(simple).pop("MapAroundContact", None)  # a script may have loaded the plugin into its own namespace alone
        for quantity, expected in (("Thickness", 100.0), ("Curvature", 0.0)):
            made = MapContact(quantity, radius=10.0)
            for found, place in zip(made.Centre, (50.0, 10.0, 20.0)):
                self.assertAlmostEqual(found, place, delta=1e-4)
            display = simple.GetDisplayProperties(made, self.view)
            self.assertEqual((display.Visibility, list(display.ColorArrayName)), (1, ["POINTS", quantity]))
            self.assertEqual(simple.GetDisplayProperties(box, self.view).Visibility, 0)
            points = servermanager.Fetch(made)
            values = points.GetPointData().GetArray(quantity)
            known = [i for i in range(points.GetNumberOfPoints()) if not math.isnan(values.GetValue(i))]
            self.assertIn(len(known), (3, 4))  # corners of one or two triangles of the touched face
            for i in known:
                self.assertAlmostEqual(points.GetPoint(i)[0], 50.0, delta=1e-4)
                self.assertAlmostEqual(values.GetValue(i), expected, delta=1e-4)

    def test_a_map_of_cells_in_space_is_refused_with_the_remedy(self):
        cells = simple.Tetrahedralize(Input=simple.Box(XLength=100, YLength=100, ZLength=100))
        simple.Show(simple.AppendDatasets(Input=cells), self.view)
        self.press_face(20)
        with self.assertRaisesRegex(HapticRefusal, "ExtractSurface"):
            MapContact()

    def test_refusals_are_raised_in_words_each_time(self):
        for _ in range(2):
            with self.assertRaisesRegex(HapticRefusal, "No data are visible"):
                Touch()
            with self.assertRaisesRegex(HapticRefusal, "stiffness"):
                SetHaptics(Stiffness=-1.0)
            with self.assertRaisesRegex(HapticRefusal, "touch a surface first"):
                Mark()
            with self.assertRaisesRegex(HapticRefusal, "Stiffnes is not a setting"):
                SetHaptics(Stiffnes=1.0)
        self.assertEqual(GetHapticSession().GetSetting("Stiffness"), STIFFNESS)

    def test_a_source_in_the_hand_is_not_touched_but_touches(self):
        """A box of 20 u whose middle is held 8 u above a floor: pressed in by 2 u."""
        floor = simple.Plane(Origin=[-50, -50, 0], Point1=[50, -50, 0], Point2=[-50, 50, 0])
        box = simple.Box(XLength=20, YLength=20, ZLength=20, Center=[0, 0, 100])
        for source in (floor, box):
            simple.Show(source, self.view)
        HoldTool(box)
        session = GetHapticSession()
        session.SetHandPosition(0, 0, 15)
        Touch()
        session.Step(TICKS_TO_ENGAGE)
        session.SetHandPosition(0, 0, 10 - DEPTH)
        session.Step(1000)
        state = HapticState()
        self.assertAlmostEqual(state["Force"][2], FORCE, delta=1e-3)
        self.assertAlmostEqual(state["ToolPose"][2], 10 - 100, delta=1e-3)  # of the origin of its data
        self.assertIn(" contacts", state["ToolText"])
        self.assertNotIn("Box", session.GetSceneReport())
        simple.Delete(box)
        HapticState()
        self.assertIn("does not exist", HapticState()["ToolText"])
        with self.assertRaisesRegex(HapticRefusal, "has no source"):
            HoldTool("Drill")
        HoldTool(None)
        self.assertEqual(HapticState()["ToolText"], "")

    def test_a_soft_body_gives_way_and_bends_in_the_view(self):
        """A block of 100 x 100 x 50 mm, 20 kPa, fixed below; a ball of 10 mm is 8 mm deep in the middle of its top."""
        wavelet = simple.Wavelet(WholeExtent=[-4, 4, -4, 4, 0, 4])
        block = simple.Transform(Input=wavelet)
        block.Transform.Scale = [12.5, 12.5, 12.5]
        soft = SoftBody(  # noqa: F821  of the plugin
            Input=simple.Tetrahedralize(Input=block), Unit=0.001, Fixed="zmin")
        simple.Show(soft, self.view)
        session = GetHapticSession()
        SetHaptics(Radius=10)
        self.addCleanup(SetHaptics, Radius=0)
        session.SetHandPosition(0, 0, 70)
        PressBody(soft)
        Touch()
        session.Step(TICKS_TO_ENGAGE)
        session.SetHandPosition(0, 0, 60 - 8)
        session.Step(400)
        state = HapticState()
        rigid = STIFFNESS * 8 / SCALE
        self.assertGreater(state["Force"][2], 0.05 * rigid)
        self.assertLess(state["Force"][2], 0.8 * rigid)
        for word in ("assumed", "neo-Hookean", "solves per second", "largest strain"):
            self.assertIn(word, state["SoftText"])
        simple.Render(self.view)
        bent = servermanager.Fetch(soft)
        moved = bent.GetPointData().GetArray("Displacement").GetFiniteRange(2)
        self.assertLess(moved[0], -0.5)
        self.assertGreater(bent.GetCellData().GetArray("Stress").GetFiniteRange(-1)[1], 0.0)
        self.assertAlmostEqual(bent.GetBounds()[4], 0.0)
        session.Step(200)
        self.assertAlmostEqual(HapticState()["Force"][2], state["Force"][2], delta=0.02 * state["Force"][2])
        PressBody(None)
        session.SetHandPosition(0, 0, 70)
        session.Step(100)
        simple.Render(self.view)
        self.assertEqual(servermanager.Fetch(soft).GetPointData().GetArray("Displacement").GetFiniteRange(-1)[1], 0.0)
        with self.assertRaisesRegex(HapticRefusal, "apply the filter Soft Body"):
            PressBody(wavelet)

    def test_a_source_is_softer_than_the_others_or_not_touched(self):
        box = self.press_box()
        SetSource(box, stiffness=50.0)
        HapticState()
        GetHapticSession().FinishScene()
        GetHapticSession().Step(2000)
        self.assertAlmostEqual(HapticState()["Force"][0], 50.0 * DEPTH / SCALE, delta=1e-9)
        SetSource(box, touched=False)
        HapticState()
        GetHapticSession().FinishScene()
        GetHapticSession().Step(2000)
        self.assertEqual(HapticState()["ForceMagnitude"], 0.0)
        with self.assertRaisesRegex(HapticRefusal, "friction"):
            SetSource(box, friction=(0.25, 0.5))

    def test_what_is_of_another_kind_is_refused_in_a_sentence_and_changes_nothing(self):
        box = simple.Box()
        for said, call in (
            ("no source 'Nope'; name one of these: Box1", lambda: SetSource("Nope", touched=False)),
            ("no source 5", lambda: SetSource(5, touched=False)),
            ("touched is True or False, not 'no'", lambda: SetSource(box, touched="no")),
            ("stiffness is a number .N/m., not 'soft'", lambda: SetSource(box, stiffness="soft")),
            ("friction is two numbers", lambda: SetSource(box, friction=0.5)),
            ("friction is two numbers", lambda: SetSource(box, friction=(0.5, 0.4, 0.3))),
            ("Stiffness takes a number .*, not 'soft'", lambda: SetHaptics(Stiffness="soft")),
            ("Stiffness takes a number .*, not None", lambda: SetHaptics(Stiffness=None)),
            ("Offset takes 3 numbers, not .1, 2.", lambda: SetHaptics(Offset=[1, 2])),
            ("Offset takes 3 numbers, not .1, 'b', 'c'.", lambda: SetHaptics(Offset=[1, "b", "c"])),
            ("DeviceName takes a text, not 5", lambda: SetHaptics(DeviceName=5)),
            ("Passivity takes 1 or 0 .on or off., not 'off'", lambda: SetHaptics(Passivity="off")),
            ("Delay takes a whole number .0 to 16., not 1.5", lambda: SetHaptics(Delay=1.5)),
            ("Force is not a setting", lambda: SetHaptics(Force=[0, 0, 1])),
            ("'x' is not a view; pass the result of CreateView", lambda: Touch("x")),
            ("is not a view", lambda: FitHand(box)),
            ("5 is not a file name; use a name that ends in .csv", lambda: SaveMarks(5)),
        ):
            with self.assertRaisesRegex(HapticRefusal, said):
                call()
        session = GetHapticSession()
        self.assertEqual(session.GetSettingText("SourcesText"), "")
        self.assertEqual((session.GetSetting("Stiffness"), session.GetSetting("Delay"), session.GetSettingText("DeviceName")), (STIFFNESS, 0, "fed"))
        self.assertEqual(tuple(session.GetSettingNumbers("Offset")), (0.0, 0.0, 0.0))

    def test_what_is_shown_is_fitted_to_before_it_is_touched_and_nothing_is_refused(self):
        with self.assertRaisesRegex(HapticRefusal, "No data are visible: open a file"):
            FitHand()
        box = simple.Box(XLength=100, YLength=100, ZLength=100)
        simple.Show(box, self.view)
        SetHaptics(DeviceName="mouse")
        scales = []
        for length in (100, 200):
            box.XLength = box.YLength = box.ZLength = length
            FitHand()
            scales.append(GetHapticSession().GetSetting("Scale"))
        self.assertAlmostEqual(scales[1], 2.0 * scales[0], delta=1e-9 * scales[1])
        simple.Hide(box, self.view)
        with self.assertRaisesRegex(HapticRefusal, "No data are visible"):
            FitHand()
        self.assertEqual(GetHapticSession().GetSetting("Scale"), scales[1])

    def test_the_hand_is_fitted_to_what_is_shown(self):
        self.press_box()
        SetHaptics(DeviceName="mouse")
        FitHand()
        scale = GetHapticSession().GetSetting("Scale")
        self.assertTrue(math.isfinite(scale) and scale != SCALE)


if __name__ == "__main__":
    # A SystemExit would skip pvpython's own ending, which closes views before the display.
    if not unittest.main(exit=False).result.wasSuccessful():
        sys.exit(1)
