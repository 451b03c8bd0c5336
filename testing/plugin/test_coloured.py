# SPDX-License-Identifier: GPL-3.0-or-later
"""Results of the plugin's filters and readers are coloured by the array that a person asked for as soon as they are shown."""

import os
import sys
import unittest

from paraview import simple

simple.LoadPlugin(os.environ["PALPATE_PLUGIN"], remote=False, ns=globals())

RECORDING = os.path.join(os.environ["PALPATE_SOURCE_DIR"], "testing/haptics/recording/fixtures/format-8-solid.palpate")


class Coloured(unittest.TestCase):
    def setUp(self):
        self.view = simple.CreateView("RenderView")
        simple.SetActiveView(self.view)

    def tearDown(self):
        for source in list(simple.GetSources().values()):
            simple.Delete(source)
        simple.Delete(self.view)

    def assert_coloured_by(self, array, shown):
        display = simple.Show(shown, self.view)
        simple.Render(self.view)
        self.assertEqual(list(display.ColorArrayName), ["POINTS", array])
        self.assertEqual(display.LookupTable.VectorMode, "Magnitude")
        display.RescaleTransferFunctionToDataRange()
        points = display.LookupTable.RGBPoints
        return points[0], points[-4]

    def compared(self, surface):
        # A box, and a plane at z = 0.25: the corners at x, y = 3 are 2 u from the nearest edge along both.
        box = simple.Box(XLength=2.0, YLength=2.0, ZLength=2.0)
        return simple.CompareSurfaces(Input=surface, Reference=box)

    def plane(self):
        return simple.Plane(Origin=[-3, -3, 0.25], Point1=[3, -3, 0.25], Point2=[-3, 3, 0.25], XResolution=12, YResolution=12)

    def test_a_comparison_by_the_distance_also_where_the_surface_was_coloured_by_another_array(self):
        elevation = simple.Elevation(Input=self.plane(), LowPoint=[-3, 0, 0], HighPoint=[3, 0, 0])
        surface = simple.ExtractSurface(Input=elevation)
        simple.ColorBy(simple.Show(surface, self.view), ("POINTS", "Elevation"))
        low, high = self.assert_coloured_by("Distance", self.compared(surface))
        self.assertAlmostEqual(low, 0.0, delta=1e-6)  # points at x = 1
        self.assertAlmostEqual(high, 8.0 ** 0.5, delta=1e-6)

    def test_a_comparison_says_mean_root_mean_square_and_maximum_to_python_and_to_the_information_panel(self):
        compared = self.compared(self.plane())
        compared.UpdatePipeline()
        compared.SMProxy.UpdatePropertyInformation()
        self.assertIn("maximum 2.828 u", compared.GetPropertyValue("Text"))
        fields = compared.GetFieldDataInformation()
        values = [fields.GetArray(name).GetRange()[0] for name in ("MeanDistance", "RMSDistance", "MaximumDistance")]
        self.assertEqual(values, sorted(values))
        self.assertAlmostEqual(values[2], 8.0 ** 0.5, delta=1e-6)

    def test_a_recording_by_the_magnitude_of_the_force_over_its_whole_path(self):
        reader = simple.OpenDataFile(RECORDING)
        for port in range(2):
            low, high = self.assert_coloured_by("Force", simple.OutputPort(reader, port))
        reader.UpdatePipeline()
        largest = reader[1].PointData["Force"].GetRange(-1)[1]
        self.assertGreater(largest, 0.0)
        self.assertAlmostEqual(low, 0.0, delta=1e-9)
        self.assertAlmostEqual(high, largest, delta=1e-9)


if __name__ == "__main__":
    # A SystemExit would skip pvpython's own ending, which closes views before the display.
    if not unittest.main(exit=False).result.wasSuccessful():
        sys.exit(1)
