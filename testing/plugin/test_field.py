# SPDX-License-Identifier: GPL-3.0-or-later
"""Sources that a view shows, felt as fields whatever of them is drawn. The truth is ParaView's own probe."""

import sys
import unittest

from paraview import servermanager, simple

from displays import move
from haptic_proxies import put
from view_fixture import ViewTest
from says import unsaid


class FieldInAView(ViewTest):
    def show_wavelet(self, representation):
        wavelet = simple.Wavelet()
        display = self.show(wavelet)
        simple.ColorBy(display, ("POINTS", "RTData"))
        display.SetRepresentationType(representation)
        simple.Render(self.view)
        return wavelet

    def probe(self, source, point):
        located = simple.ProbeLocation(Input=source, ProbeType="Fixed Radius Point Source")
        located.ProbeType.Center = point
        return servermanager.Fetch(located).GetPointData().GetArray("RTData").GetValue(0)

    def test_a_volume_says_that_it_can_be_felt_as_a_field_and_then_is(self):
        self.show_wavelet("Volume")
        self.follow()
        self.assertIn("for its isosurface", self.scene.GetReport())
        self.assertTrue(self.feel(FieldArray="RTData", FieldIsosurface=1, FieldIsovalue=150.0))
        self.scene.Update()
        self.assertIn("Feeling Wavelet1: RTData on 21 x 21 x 21 points, 1 u apart", self.scene.GetReport())
        self.assertNotIn("no surface", self.scene.GetReport())

    def test_the_value_at_the_hand_is_what_paraview_probes_there(self):
        wavelet = self.show_wavelet("Outline")
        self.assertTrue(self.feel(FieldArray="RTData", FieldIsosurface=1, FieldIsovalue=1e6))
        for point in ((0.25, 3.5, -6.125), (-9.5, 9.75, 0.0)):
            self.session.SetHandPosition(*point)
            put(self.proxy, "Touching", 1)
            self.session.Step(10)
            self.assertAlmostEqual(self.session.GetFieldValue(), self.probe(wavelet, point), delta=1e-3)
            put(self.proxy, "Touching", 0)

    def test_another_array_and_a_changed_source_are_noticed(self):
        wavelet = self.show_wavelet("Outline")
        self.assertTrue(self.feel(FieldArray="RTData", FieldIsosurface=1))
        self.assertFalse(self.scene.Update(), "nothing of a surface changed")
        wavelet.WholeExtent = [-5, 5, -5, 5, -5, 5]
        simple.Render(self.view)
        self.follow()
        self.session.FinishField()
        self.assertIn("11 x 11 x 11", self.session.GetFieldText())
        put(self.proxy, "FieldArray", "")
        self.follow()
        self.assertFalse(self.session.FinishField())

    def test_a_source_that_is_not_shown_is_compared_with_and_snapped_to_by_its_name(self):
        self.show_wavelet("Outline")
        simple.Wavelet(registrationName="Finer", XFreq=30)
        simple.Line(registrationName="Core", Point1=[-5, 0, 0], Point2=[5, 0, 0])
        # Of the difference, 100 at most, no more than 1e-4 is felt: the drag is not to hold against the snap
        self.assertTrue(self.feel(FieldArray="RTData", FieldCompare=0.5, FieldCompareFull=1e6, CompareSource="Finer",
                                  FieldSnap=0.5, FieldSnapReach=4.0, SnapSource="Core"))
        self.assertNotIn("Not touched", self.scene.GetReport())
        self.session.SetHandPosition(3.0, 2.0, 0.0)
        put(self.proxy, "Scale", 1000.0)
        put(self.proxy, "Touching", 1)
        self.session.Step(1200)
        self.session.FinishField()
        self.session.Step(10)
        # Of a pull of 0.5 N half is left 2 u from the line
        force = self.session.GetForce()
        self.assertAlmostEqual(force[1], -0.25, delta=1e-4)
        self.assertAlmostEqual(force[0], 0.0, delta=1e-4)
        put(self.proxy, "Touching", 0)
        self.feel(SnapSource="Nobody")
        self.scene.Update()
        self.assertEqual(unsaid(self.scene.GetReport(), "Nobody: ", "no source"), [])
        self.feel(SnapSource="")

    def test_a_chosen_source_is_felt_whatever_is_shown_and_one_that_is_not_there_is_said(self):
        shown = self.show_wavelet("Outline")
        chosen = simple.Wavelet(registrationName="Chosen", WholeExtent=[-4, 4, -4, 4, -4, 4], XFreq=10)
        self.assertTrue(self.feel(FieldArray="RTData", FieldIsosurface=1, FieldIsovalue=1e6, FeltSource="Chosen"))
        self.assertIn("Chosen: RTData on 9 x 9 x 9", self.session.GetFieldText())
        point = (0.25, 3.5, -2.125)
        self.session.SetHandPosition(*point)
        put(self.proxy, "Touching", 1)
        self.session.Step(10)
        self.assertAlmostEqual(self.session.GetFieldValue(), self.probe(chosen, point), delta=1e-3)
        self.assertNotAlmostEqual(self.probe(shown, point), self.probe(chosen, point), delta=1.0)
        put(self.proxy, "Touching", 0)
        self.assertIn("RTData", self.scene.GetFieldNames(0))
        self.assertFalse(self.feel(FeltSource="Nobody"))
        self.scene.Update()
        self.assertEqual(unsaid(self.scene.GetReport(), "Nobody: ", "no source"), [])
        self.assertFalse(self.feel(FeltSource="Chosen", FieldArray="Other"))
        self.scene.Update()
        self.assertIn('Chosen has not "Other"', self.scene.GetReport())
        self.assertTrue(self.feel(FeltSource="", FieldArray="RTData"))
        self.assertIn("21 x 21 x 21", self.session.GetFieldText())

    def test_an_array_that_goes_while_it_is_felt_is_said(self):
        wavelet = self.show_wavelet("Outline")
        self.assertTrue(self.feel(FieldArray="RTData", FieldIsosurface=1, FieldIsovalue=150.0))
        put(self.proxy, "Touching", 1)
        self.session.Step(10)
        simple.Hide(wavelet, self.view)
        renamed = simple.PassArrays(Input=wavelet)
        renamed.PointDataArrays = []
        self.show(renamed)
        simple.Render(self.view)
        self.follow()
        self.session.Step(1)
        self.session.Update()
        self.assertIn("is missing", self.session.GetWarning())
        self.scene.Update()
        self.assertIn('has "RTData"', self.scene.GetReport())
        put(self.proxy, "Touching", 0)

    def test_what_is_drawn_elsewhere_than_its_numbers_or_is_not_to_be_touched_is_not_felt(self):
        self.show_wavelet("Outline")
        self.assertTrue(self.feel(FieldArray="RTData", FieldIsosurface=1))
        display = simple.GetDisplayProperties(view=self.view)
        move(display, [5.0, 0.0, 0.0])
        simple.Render(self.view)
        self.follow()
        self.assertFalse(self.session.FinishField())
        self.assertIn("Wavelet1 is transformed", self.scene.GetReport())
        self.assertIn("Transform", self.scene.GetReport())
        move(display, [0.0, 0.0, 0.0])
        simple.Render(self.view)
        self.follow()
        self.assertTrue(self.session.FinishField())
        self.session.SetSourceTouched("Wavelet1", False)
        self.follow()
        self.assertFalse(self.session.FinishField())

    def test_a_hidden_source_is_not_felt(self):
        wavelet = self.show_wavelet("Outline")
        self.assertTrue(self.feel(FieldArray="RTData", FieldIsosurface=1))
        simple.Hide(wavelet, self.view)
        simple.Render(self.view)
        self.follow()
        self.assertFalse(self.session.FinishField())


if __name__ == "__main__":
    # A SystemExit would skip pvpython's own ending, which closes views before the display.
    if not unittest.main(exit=False).result.wasSuccessful():
        sys.exit(1)
