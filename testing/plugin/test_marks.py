# SPDX-License-Identifier: GPL-3.0-or-later
"""Marks as things: named, removed, read back, and drawn as large at any distance. A process of its own: the session is registered."""

import os
import sys
import tempfile
import unittest

from paraview import simple

simple.LoadPlugin(os.environ["PALPATE_PLUGIN"], remote=False, ns=globals())
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter  # noqa: E402

from palpate.simple import (AddMark, ClearMarks, GetHapticSession, GetMarks, HapticRefusal, LoadMarks, Marks, RemoveMark, RenameMark,  # noqa: E402
                            SaveMarks, SetHaptics)
from palpate.vtkHapticInteraction import vtkHapticMarkProps  # noqa: E402


class MarkList(unittest.TestCase):
    def setUp(self):
        ClearMarks()

    def text(self):
        return GetHapticSession().GetSettingText("MarksText")

    def test_a_mark_has_a_name_and_a_position_and_can_be_renamed_and_removed(self):
        self.assertEqual(AddMark("apex", (1, 2, 3)), ("apex", (1.0, 2.0, 3.0)))
        AddMark(position=(4, 5, 6))
        AddMark("third", (7, 8, 9))
        RenameMark(2, "base, left")
        RemoveMark("apex")
        self.assertEqual(Marks(), [("base, left", (4.0, 5.0, 6.0)), ("third", (7.0, 8.0, 9.0))])
        self.assertEqual(GetHapticSession().GetInspection().GetMarkState(0), 1)  # a place in space never becomes stale

    def test_the_setting_of_the_session_follows_and_has_no_column_for_names_without_a_name(self):
        AddMark("", (1, 2, 3))
        self.assertEqual(self.text(), "Source,X,Y,Z\n,1,2,3\n")
        RenameMark(1, "apex")
        self.assertEqual(self.text(), "Source,X,Y,Z,Name\n,1,2,3,apex\n")
        SetHaptics(MarksText="Source,X,Y,Z,Name\n,1,2,3,other\n")
        self.assertEqual(Marks(), [("other", (1.0, 2.0, 3.0))])

    def test_a_file_of_named_and_unnamed_marks_is_read_back(self):
        AddMark('the "upper", left one', (0.1, -2e-30, 3e30))
        AddMark("", (4, 5, 6))
        before = Marks()
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "marks.csv")
            SaveMarks(file)
            ClearMarks()
            LoadMarks(file)
            self.assertEqual(Marks(), before)
            self.assertEqual(GetHapticSession().GetInspection().GetSavedMarks(), self.text())

    def test_a_file_from_before_names_is_read(self):
        with tempfile.NamedTemporaryFile("w", suffix=".csv") as file:
            file.write("Source,X,Y,Z,Force\nbox,1,2,3,0.5\n")
            file.flush()
            LoadMarks(file.name)
        self.assertEqual(Marks(), [("", (1.0, 2.0, 3.0))])
        self.assertEqual((GetMarks()[0]["Source"], GetMarks()[0]["Force"]), ("box", 0.5))

    def test_marks_and_files_that_are_not_there_are_refused_and_the_marks_stay(self):
        AddMark("apex", (1, 2, 3))
        for refused in (lambda: RemoveMark(2), lambda: RemoveMark(0), lambda: RenameMark("base", "x"), lambda: AddMark("x", (1, 2)),
                        lambda: AddMark("x", (1, 2, float("nan"))), lambda: LoadMarks("/nowhere/marks.csv")):
            with self.assertRaises(HapticRefusal):
                refused()
        self.assertEqual(Marks(), [("apex", (1.0, 2.0, 3.0))])


class MarkPicture(unittest.TestCase):
    def yellow(self, window):
        window.Render()
        picture = vtkWindowToImageFilter()
        picture.SetInput(window)
        picture.ReadFrontBufferOff()
        picture.Update()
        pixels = picture.GetOutput().GetPointData().GetScalars()
        colours = (pixels.GetTuple3(i) for i in range(pixels.GetNumberOfTuples()))
        return sum(red > 100 and blue < 0.4 * red for red, _, blue in colours)

    def test_marks_are_numbered_and_as_large_on_the_screen_from_any_distance(self):
        ClearMarks()
        AddMark("apex", (0, 0, 0))
        AddMark("", (1, 0, 0))
        window, renderer = vtkRenderWindow(), vtkRenderer()
        window.SetOffScreenRendering(1)
        window.SetSize(200, 200)
        window.SetMultiSamples(0)
        window.AddRenderer(renderer)
        props = vtkHapticMarkProps()
        props.SetRenderer(renderer)
        props.UpdateFrom(GetHapticSession())
        self.assertEqual([props.GetLabel(mark) for mark in range(3)], ["1 apex", "2", ""])
        RemoveMark("apex")
        props.UpdateFrom(GetHapticSession())
        self.assertEqual([props.GetLabel(mark) for mark in range(2)], ["1", ""])
        camera = renderer.GetActiveCamera()
        counts = []
        for distance in (10.0, 100.0):
            camera.SetFocalPoint(1, 0, 0)
            camera.SetPosition(1, 0, distance)
            renderer.ResetCameraClippingRange(0, 2, -1, 1, -1, 1)
            counts.append(self.yellow(window))
        self.assertGreater(counts[0], 60)  # of a disc 12 pixels wide, 113
        self.assertLess(abs(counts[0] - counts[1]), 12)
        props.SetRenderer(None)
        self.assertEqual(self.yellow(window), 0)


if __name__ == "__main__":
    # A SystemExit would skip pvpython's own ending, which closes views before the display.
    if not unittest.main(exit=False).result.wasSuccessful():
        sys.exit(1)
