# SPDX-License-Identifier: GPL-3.0-or-later
"""*Touch Along Path* where each of two ranks has half of the surface: what the other half holds is felt too.

The plugin is loaded on both by PV_PLUGIN_PATH.
"""

import sys
import unittest

from paraview import servermanager, simple

RADIUS = 50.0  # u
DEPTH = 2.0  # u


def forces(y):
    """Along a hand that comes in along y to DEPTH below the sphere's surface."""
    path = simple.Line(Point1=[0.0, y * (RADIUS + 10.0), 0.0], Point2=[0.0, y * (RADIUS - DEPTH), 0.0], Resolution=200)
    touch = simple.TouchAlongPath(Input=SPHERE, Path=path)
    touch.Stiffness = 500.0
    felt = servermanager.Fetch(touch)
    array = felt.GetPointData().GetArray("Force")
    return [array.GetTuple(i) for i in range(felt.GetNumberOfPoints())]


class OnRanks(unittest.TestCase):
    def test_both_halves_push_alike(self):
        # The sphere source deals its meridians out: the half with y > 0 is on one rank, that with y < 0 on the other.
        ranks = servermanager.vtkProcessModule.GetProcessModule().GetNumberOfLocalPartitions()
        self.assertEqual(ranks, 2)
        one, other = forces(1.0), forces(-1.0)
        self.assertEqual(len(one), 201)
        self.assertEqual(len(other), 201)
        self.assertGreater(one[-1][1], 0.5 * 500.0 * DEPTH / 1000.0)
        for f, g in zip(one, other):
            self.assertAlmostEqual(f[1], -g[1], delta=1e-9)


if __name__ == "__main__":
    SPHERE = simple.Sphere(Radius=RADIUS, ThetaResolution=40, PhiResolution=41)
    if not unittest.main(exit=False).result.wasSuccessful():
        sys.exit(1)
