# SPDX-License-Identifier: GPL-3.0-or-later
"""A session in a state file. A process of its own: loading a state replaces views."""

import os
import sys
import tempfile
import unittest

from paraview import simple

from haptic_proxies import manager, put


class StateFile(unittest.TestCase):
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
        manager().RegisterProxy("haptics", "HapticSession", proxy)
        with tempfile.TemporaryDirectory() as folder:
            state = os.path.join(folder, "state.pvsm")
            simple.SaveState(state)
            manager().UnRegisterProxy("haptics", "HapticSession", proxy)
            simple.LoadState(state)
        loaded = manager().GetProxy("haptics", "HapticSession").GetClientSideObject()
        self.assertEqual((loaded.GetStiffness(), loaded.GetRadius()), (345.0, 1.25))
        self.assertEqual((loaded.GetFrictionStatic(), loaded.GetFrictionKineticUsed()), (0.75, 0.5))
        self.assertEqual((loaded.GetStiffnessArray(), loaded.GetFrictionArray(), loaded.GetTextureArray()), ("E", "mu", ""))
        self.assertEqual((loaded.GetStiffnessComponent(), loaded.GetFrictionComponent()), (1, -1))
        self.assertEqual((tuple(loaded.GetStiffnessDataRange()), tuple(loaded.GetStiffnessFeltRange())),
                         ((-2.0, 3.0), (50.0, 250.0)))
        self.assertEqual(tuple(loaded.GetTextureFeltRange()), (-0.5, 0.25))
        self.assertEqual((loaded.GetPassivity(), loaded.GetLimitStiffness(), loaded.GetHand()), (False, True, "light"))
        self.assertEqual((loaded.GetLinesAsWalls(), loaded.GetHoldWalls(), loaded.GetPlaneGuide()), (2, False, False))
        self.assertEqual(loaded.GetWallRate(), 50.0)
        self.assertFalse(loaded.GetTouching())


if __name__ == "__main__":
    # A SystemExit would skip pvpython's own ending, which closes views before the display.
    if not unittest.main(exit=False).result.wasSuccessful():
        sys.exit(1)
