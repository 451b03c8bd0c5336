# SPDX-License-Identifier: GPL-3.0-or-later
"""The check of a device from Python: what a person reads while it runs, what was found, what is kept."""

import os
import tempfile
import unittest

from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow

from palpate.vtkHapticInteraction import vtkHapticSession


class SelfTest(unittest.TestCase):
    def setUp(self):
        self.window = vtkStringOutputWindow()  # what is refused is not printed
        vtkOutputWindow.SetInstance(self.window)
        folder = tempfile.TemporaryDirectory(prefix="palpate-calibration-")
        self.addCleanup(folder.cleanup)
        self.session = vtkHapticSession()
        self.session.VirtualTimeOn()
        self.session.SetCalibrationFolder(folder.name)

    def test_a_simulated_joystick_is_checked_and_what_was_found_is_kept(self):
        self.session.SetDeviceName("simulated-joystick")
        self.session.StartSelfTest()
        asked = []
        for _ in range(1000):
            if self.session.GetSelfTestState() != vtkHapticSession.CheckRuns:
                break
            if self.session.GetSelfTestAsk() not in asked:
                asked.append(self.session.GetSelfTestAsk())
            self.session.Step(100)
        self.assertEqual(self.session.GetSelfTestState(), vtkHapticSession.CheckPassed)
        self.assertEqual(len(asked), 1 + 4 + 1 + 1)  # still, four ends, the middle, pushes
        self.assertIn("The device works.", self.session.GetSelfTestResult())
        self.assertTrue(self.session.KeepCalibration())
        self.assertEqual(os.listdir(self.session.GetCalibrationFolder()), ["simulated-joystick.calibration"])

    def test_poses_from_a_program_have_nothing_to_check(self):
        self.session.SetDeviceName("fed")
        self.session.StartSelfTest()
        self.assertEqual(self.session.GetSelfTestState(), vtkHapticSession.CheckNone)
        self.assertIn("no force", self.session.GetProblem())
        self.assertFalse(self.session.KeepCalibration())


if __name__ == "__main__":
    unittest.main()
