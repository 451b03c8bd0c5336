# SPDX-License-Identifier: GPL-3.0-or-later
"""The OFF reader as a VTK source, from Python."""

import tempfile
import unittest
from pathlib import Path

from vtkmodules.vtkCommonCore import vtkOutputWindow
from palpate.vtkHapticPipeline import vtkHapticFileReader

from palpate_cli import SQUARE_POINTS, off_text


class OFFReader(unittest.TestCase):
    def read(self, text):
        messages = []
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "a.off")
            path.write_text(text)
            reader = vtkHapticFileReader()
            reader.SetFileName(str(path))
            reader.AddObserver("ErrorEvent", lambda *_: messages.append(True))
            vtkOutputWindow.GetInstance().SetDisplayModeToNever()
            reader.Update()
        return reader.GetOutput(), messages

    def test_polygons_keep_their_corners(self):
        output, messages = self.read(off_text(SQUARE_POINTS, [(0, 1, 2, 3)]))
        self.assertEqual((output.GetNumberOfPoints(), output.GetNumberOfPolys()), (4, 1))
        self.assertEqual(output.GetBounds(), (-8.0, 8.0, -8.0, 8.0, 0.0, 0.0))
        self.assertEqual(messages, [])

    def test_a_damaged_file_is_an_error_and_leaves_the_output_empty(self):
        output, messages = self.read("OFF\n4 1 0\n0 0 0\n")
        self.assertEqual((output.GetNumberOfPoints(), output.GetNumberOfPolys()), (0, 0))
        self.assertEqual(len(messages), 1)


if __name__ == "__main__":
    unittest.main()
