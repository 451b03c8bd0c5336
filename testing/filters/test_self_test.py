# SPDX-License-Identifier: GPL-3.0-or-later
"""The check of a device from Python: its instructions, its result, its file."""

import os
import tempfile
import unittest

from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow

from palpate.vtkHapticInteraction import vtkHapticDeviceCheck, vtkHapticSession


class SelfTest(unittest.TestCase):
    def setUp(self):
        self.window = vtkStringOutputWindow()  # refusals are not printed
        vtkOutputWindow.SetInstance(self.window)
        folder = tempfile.TemporaryDirectory(prefix="palpate-calibration-")
        self.addCleanup(folder.cleanup)
        self.session = vtkHapticSession()
        self.session.SetSetting("VirtualTime", 1)
        self.session.GetDeviceCheck().SetCalibrationFolder(folder.name)

    def test_a_simulated_joystick_is_checked_and_what_was_found_is_kept(self):
        self.session.SetSetting("DeviceName", "simulated-joystick")
        self.session.GetDeviceCheck().Start()
        asked = []
        for _ in range(1000):
            if self.session.GetDeviceCheck().GetState() != vtkHapticDeviceCheck.CheckRuns:
                break
            if self.session.GetDeviceCheck().GetAsk() not in asked:
                asked.append(self.session.GetDeviceCheck().GetAsk())
            self.session.Step(100)
        self.assertEqual(self.session.GetDeviceCheck().GetState(), vtkHapticDeviceCheck.CheckPassed)
        self.assertEqual(len(asked), 1 + 4 + 1 + 1)  # still, four ends, the middle, pushes
        self.assertIn("The device works.", self.session.GetDeviceCheck().GetResult())
        self.assertTrue(self.session.GetDeviceCheck().KeepCalibration())
        self.assertEqual(os.listdir(self.session.GetDeviceCheck().GetCalibrationFolder()), ["simulated-joystick.calibration"])

    def test_poses_from_a_program_have_nothing_to_check(self):
        self.session.SetSetting("DeviceName", "fed")
        self.session.GetDeviceCheck().Start()
        self.assertEqual(self.session.GetDeviceCheck().GetState(), vtkHapticDeviceCheck.CheckNone)
        self.assertIn("no force", self.session.GetProblem())
        self.assertFalse(self.session.GetDeviceCheck().KeepCalibration())


if __name__ == "__main__":
    unittest.main()
