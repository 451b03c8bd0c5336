# SPDX-License-Identifier: GPL-3.0-or-later
"""Data of a server, felt as a field. The judge is the same hand in the same data of the built-in server."""

import os
import sys
import unittest

from paraview import simple

from haptic_proxies import put
from pvserver import server
from view_fixture import ViewTest

PLUGIN = [f"--plugin-search-paths={os.environ['PV_PLUGIN_PATH']}", "--plugins=Palpate"]


class Hand(ViewTest):
    """A hand in the data of whatever server is connected."""

    def __init__(self):
        super().__init__("forces")

    def at(self, x):
        self.session.SetHandPosition(x, 0.3, -0.7)
        self.session.Step(1)
        self.scene.Update()
        self.session.FinishField()

    def forces(self):
        """Along a path that is longer than a block, and again once the data are others."""
        wavelet = simple.Wavelet(registrationName="Waves", WholeExtent=[-80, 80, -80, 80, -80, 80])
        display = self.show(wavelet)
        display.SetRepresentationType("Outline")
        put(self.proxy, "Scale", 1000.0)
        put(self.proxy, "FieldSmoothing", 0)
        self.session.SetHandPosition(-75.0, 0.3, -0.7)
        assert self.feel(FieldArray="RTData", FieldDetent=0.2, FieldDetentSpacing=100.0, FieldIsosurface=1, FieldIsovalue=150.0), \
            self.session.GetFieldText()
        put(self.proxy, "Touching", 1)
        self.session.Step(1200)
        felt = []
        for i in range(1, 151):
            self.at(-75.0 + i)
            felt.append(tuple(self.session.GetForce()))
        bricks = self.session.GetFieldText()
        wavelet.XFreq = 20.0
        simple.Render(self.view)
        self.at(75.0)
        self.session.Step(500)
        felt.append(tuple(self.session.GetForce()))
        return felt, bricks, self.scene.GetReport(), wavelet.SMProxy.GetClientSideObject()


def felt():
    hand = Hand()
    hand.setUp()
    try:
        return hand.forces()
    finally:
        hand.tearDown()


class FieldOnAServer(unittest.TestCase):
    def test_forces_are_those_of_the_built_in_server_and_the_data_stay_where_they_are(self):
        expected, bricks, _, _ = felt()
        self.assertIn("u around the hand", bricks)  # more than one block
        self.assertGreater(max(abs(f[0]) for f in expected), 0.05)
        with server(os.environ, PLUGIN) as (port, _):
            simple.Connect("localhost", port)
            found, _, report, here = felt()
            simple.Disconnect()
        self.assertIsNone(here)
        self.assertIn("Feeling Waves: RTData", report)
        self.assertEqual(len(found), len(expected))
        for i, (one, other) in enumerate(zip(found, expected)):
            for a, b in zip(one, other):
                self.assertAlmostEqual(a, b, delta=1e-9, msg=str(i))
        self.assertNotEqual(found[-1], found[-2])


if __name__ == "__main__":
    # A SystemExit would skip pvpython's own ending, which closes views before the display.
    if not unittest.main(exit=False, argv=sys.argv[:1] + ["FieldOnAServer"]).result.wasSuccessful():
        sys.exit(1)
