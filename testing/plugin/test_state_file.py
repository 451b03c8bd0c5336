# SPDX-License-Identifier: GPL-3.0-or-later
"""A session in a state file. A process of its own: loading a state replaces views."""

import os
import sys
import tempfile
import unittest

from paraview import servermanager, simple
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

from haptic_proxies import manager, put
from says import unsaid


class StateFile(unittest.TestCase):
    def saved_and_loaded(self, proxy, change=lambda text: text):
        manager().RegisterProxy("haptics", "HapticSession", proxy)
        with tempfile.TemporaryDirectory() as folder:
            state = os.path.join(folder, "state.pvsm")
            simple.SaveState(state)
            with open(state, encoding="utf-8") as file:
                text = change(file.read())
            with open(state, "w", encoding="utf-8") as file:
                file.write(text)
            manager().UnRegisterProxy("haptics", "HapticSession", proxy)
            simple.LoadState(state)
        loaded = manager().GetProxy("haptics", "HapticSession")
        self.addCleanup(manager().UnRegisterProxy, "haptics", "HapticSession", loaded)
        return loaded.GetClientSideObject()

    def test_a_registered_session_comes_back_with_its_settings(self):
        proxy = manager().NewProxy("haptics", "HapticSession")
        put(proxy, "Stiffness", 345.0)
        put(proxy, "Radius", 1.25)
        put(proxy, "FrictionStatic", 0.75)
        put(proxy, "FrictionKinetic", 0.5)
        put(proxy, "StiffnessArray", "E")
        put(proxy, "StiffnessComponent", 1)
        put(proxy, "StiffnessDataRange", -2.0, 3.0)
        put(proxy, "StiffnessFeltRange", 50.0, 250.0)
        put(proxy, "FrictionArray", "mu")
        put(proxy, "TextureFeltRange", -0.5, 0.25)
        put(proxy, "Passivity", 0)
        put(proxy, "Hand", "light")
        put(proxy, "LinesAsWalls", 2)
        put(proxy, "HoldWalls", 0)
        put(proxy, "PlaneGuide", 0)
        put(proxy, "WallRate", 50.0)
        loaded = self.saved_and_loaded(proxy)
        self.assertEqual((loaded.GetSetting("Stiffness"), loaded.GetSetting("Radius")), (345.0, 1.25))
        self.assertEqual((loaded.GetSetting("FrictionStatic"), loaded.GetFrictionKineticUsed()), (0.75, 0.5))
        self.assertEqual((loaded.GetSettingText("StiffnessArray"), loaded.GetSettingText("FrictionArray"), loaded.GetSettingText("TextureArray")), ("E", "mu", ""))
        self.assertEqual((loaded.GetSetting("StiffnessComponent"), loaded.GetSetting("FrictionComponent")), (1, -1))
        self.assertEqual((tuple(loaded.GetSettingNumbers("StiffnessDataRange")), tuple(loaded.GetSettingNumbers("StiffnessFeltRange"))),
                         ((-2.0, 3.0), (50.0, 250.0)))
        self.assertEqual(tuple(loaded.GetSettingNumbers("TextureFeltRange")), (-0.5, 0.25))
        self.assertEqual((loaded.IsOn("Passivity"), loaded.IsOn("LimitStiffness"), loaded.GetSettingText("Hand")), (False, True, "light"))
        self.assertEqual((loaded.GetSetting("LinesAsWalls"), loaded.IsOn("HoldWalls"), loaded.IsOn("PlaneGuide")), (2, False, False))
        self.assertEqual(loaded.GetSetting("WallRate"), 50.0)
        self.assertFalse(loaded.GetTouching())

    def test_marks_and_what_was_said_of_single_sources_come_back_though_nobody_set_a_property(self):
        proxy = manager().NewProxy("haptics", "HapticSession")
        session = proxy.GetClientSideObject()
        ball = simple.Sphere(Radius=50.0, ThetaResolution=60, PhiResolution=60)
        session.SetSetting("VirtualTime", True)
        self.assertTrue(session.AddSurface("Ball", servermanager.Fetch(ball), None))
        session.CommitScene()
        self.assertTrue(session.FinishScene())
        session.SetHandPosition(0, 0, 55)
        put(proxy, "Touching", 1)
        session.Step(1100)
        session.SetHandPosition(0, 0, 48)
        session.Step(200)
        proxy.InvokeCommand("AddMark")
        session.SetSourceTouched("Ball", False)
        self.assertTrue(session.SetSourceMaterial("Bone", 300.0, 0.5, 0.25))
        put(proxy, "Touching", 0)
        put(proxy, "Stiffness", 150.0)  # another change does not undo it
        text = session.GetSettingText("MarksText")
        self.assertIn("Ball,", text)
        loaded = self.saved_and_loaded(proxy)
        self.assertEqual(loaded.GetSettingText("MarksText"), text)
        self.assertEqual(loaded.GetNumberOfMarks(), 1)
        self.assertFalse(loaded.GetSourceTouched("Ball"))
        material = [0.0, 0.0, 0.0]
        loaded.GetSourceMaterial("Bone", material)
        self.assertEqual(material, [300.0, 0.5, 0.25])

    def test_a_state_of_another_version_gives_what_is_known_and_says_what_cannot_be(self):
        proxy = manager().NewProxy("haptics", "HapticSession")
        put(proxy, "Stiffness", 345.0)
        put(proxy, "Radius", 1.25)
        put(proxy, "Hand", "light")
        put(proxy, "MarksText", "Source,X,Y,Z\nBall,1,2,3\n")

        def change(text):
            """As a later version could write it: a setting has another name, one is new, the list of marks has another
            form, a text is none of those known."""
            text = text.replace('name="Radius"', 'name="BallSize"')
            text = text.replace('<Property name="Stiffness"', '<Property name="Warmth" id="1.Warmth" number_of_elements="1">'
                                '<Element index="0" value="37"/></Property><Property name="Stiffness"')
            self.assertIn("Source,X,Y,Z", text)
            return text.replace("Source,X,Y,Z", "Id,Source,X").replace('value="light"', 'value="iron"')

        loaded = self.saved_and_loaded(proxy, change)
        self.assertEqual((loaded.GetSetting("Stiffness"), loaded.GetSetting("Radius")), (345.0, 0.0))
        self.assertEqual((loaded.GetSettingText("MarksText"), loaded.GetSettingText("Hand")), ("", "stylus"))
        self.assertEqual(unsaid(loaded.GetProblem(), "cannot be read", "columns", "Source, X, Y and Z"), [])

    def test_a_workspace_that_was_fitted_comes_back_as_it_was(self):
        proxy = manager().NewProxy("haptics", "HapticSession")
        put(proxy, "DeviceName", "simulated-joystick")
        session = proxy.GetClientSideObject()
        upright = vtkPolyData()  # lines across x, 60 u high: a joystick's plane is turned into theirs
        upright.SetPoints(vtkPoints())
        corners = [(5, -40, -30), (5, 40, -30), (5, 40, 30)]
        line = vtkCellArray()
        line.InsertNextCell(len(corners))
        for corner in corners:
            line.InsertCellPoint(upright.GetPoints().InsertNextPoint(corner))
        upright.SetLines(line)
        self.assertTrue(session.AddSurface("lines", upright, None))
        session.CommitScene()
        self.assertTrue(session.FinishScene())
        proxy.InvokeCommand("FitWorkspace")
        fitted = (session.GetSetting("Scale"), tuple(session.GetSettingNumbers("Rotation")), tuple(session.GetSettingNumbers("Offset")))
        self.assertEqual(fitted[2], (5.0, 0.0, 0.0))
        self.assertNotEqual(fitted[1], (1.0, 0.0, 0.0, 0.0))
        helper = lambda name: servermanager.vtkSMPropertyHelper(proxy, name)  # noqa: E731
        self.assertEqual(helper("Scale").GetAsDouble(), fitted[0])
        self.assertEqual(tuple(helper("Rotation").GetAsDouble(i) for i in range(4)), fitted[1])
        self.assertEqual(tuple(helper("Offset").GetAsDouble(i) for i in range(3)), fitted[2])
        put(proxy, "Stiffness", 150.0)  # another change does not undo it
        self.assertEqual((session.GetSetting("Scale"), tuple(session.GetSettingNumbers("Rotation")), tuple(session.GetSettingNumbers("Offset"))), fitted)
        loaded = self.saved_and_loaded(proxy)
        self.assertAlmostEqual(loaded.GetSetting("Scale"), fitted[0], delta=1e-9 * fitted[0])
        for got, wanted in zip(tuple(loaded.GetSettingNumbers("Rotation")) + tuple(loaded.GetSettingNumbers("Offset")), fitted[1] + fitted[2]):
            self.assertAlmostEqual(got, wanted, delta=1e-9)


if __name__ == "__main__":
    # A SystemExit would skip pvpython's own ending, which closes views before the display.
    if not unittest.main(exit=False).result.wasSuccessful():
        sys.exit(1)
