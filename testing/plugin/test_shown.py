# SPDX-License-Identifier: GPL-3.0-or-later
"""What is drawn without polygons of its own is felt as it is seen: 3-D glyphs, image slices; and which of two views."""

import sys
import unittest

from paraview import simple

from haptic_proxies import put
from view_fixture import DEPTH, FORCE, STIFFNESS, ViewTest


class Shown(ViewTest):
    def glyphs(self):
        """Boxes of 0.5 u at both ends of a line along x, scaled by 2 for each unit of Size: 1 u at x = 0, 2 u at x = 4."""
        line = simple.Line(Point1=[0, 0, 0], Point2=[4, 0, 0], Resolution=1)
        sized = simple.Calculator(Input=line, ResultArrayName="Size", Function="1 + coordsX / 4")
        display = self.show(sized)
        display.SetRepresentationType("3D Glyphs")
        display.GlyphType = "Box"
        display.GlyphType.XLength = display.GlyphType.YLength = display.GlyphType.ZLength = 0.5
        display.Orient = 0
        display.Scaling = 1
        display.ScaleMode = "Magnitude"
        display.SelectScaleArray = "Size"
        display.ScaleFactor = 2.0
        simple.Render(self.view)
        return display

    def test_each_3d_glyph_is_felt_where_and_as_large_as_it_is_drawn(self):
        display = self.glyphs()
        self.assertTrue(self.follow())
        self.assertIn("Touching Calculator1.", self.scene.GetReport())
        self.press(4.0 + 0.5 * 2.0 - DEPTH, 0.1, 0.1)
        self.assertAlmostEqual(self.session.GetForce()[0], FORCE, delta=1e-6)
        self.assertTrue(self.session.InspectContact())
        self.assertEqual(self.session.GetContactPoint(), 1)  # of the line, not of the box
        self.assertAlmostEqual(self.session.GetContactValue("Size"), 2.0, delta=1e-12)
        put(self.proxy, "Touching", 0)
        self.press(0.5 * 1.0 - DEPTH, 0.1, 0.1)
        self.assertAlmostEqual(self.session.GetForce()[0], FORCE, delta=1e-6)
        put(self.proxy, "Touching", 0)
        display.Position = [0.0, 0.0, 10.0]
        simple.Render(self.view)
        self.assertTrue(self.follow())
        self.press(4.0 + 0.5 * 2.0 - DEPTH, 0.1, 10.1)
        self.assertAlmostEqual(self.session.GetForce()[0], FORCE, delta=1e-6)

    def test_glyphs_are_handed_over_anew_once_their_shape_has_changed_and_not_before(self):
        display = self.glyphs()
        self.assertTrue(self.follow())
        display.DiffuseColor = [1.0, 0.0, 0.0]
        simple.GetActiveCamera().Azimuth(30)
        simple.Render(self.view)
        self.assertFalse(self.follow())
        display.ScaleFactor = 1.0
        simple.Render(self.view)
        self.assertTrue(self.follow())
        self.press(4.0 + 0.5 * 1.0 - DEPTH, 0.1, 0.1)
        self.assertAlmostEqual(self.session.GetForce()[0], FORCE, delta=1e-6)

    def slice_of_x(self):
        """The slice z = 1 of an image whose values are x, from -2 to 2."""
        image = simple.Wavelet(WholeExtent=[-2, 2, -2, 2, -2, 2])
        values = simple.Calculator(Input=image, ResultArrayName="x", Function="coordsX")
        display = self.show(values)
        display.SetRepresentationType("Slice")
        simple.ColorBy(display, ("POINTS", "x"))
        display.Slice = 3
        simple.Render(self.view)
        return display

    def test_an_image_slice_is_felt_by_the_contour_of_what_colours_it(self):
        radius = 0.05
        put(self.proxy, "LineRadius", radius)
        display = self.slice_of_x()
        self.assertTrue(self.follow())
        self.assertFalse(self.follow())
        self.press(radius - DEPTH, 0.3, 1.0)  # of the line x = 0, z = 1, half way between the values' ends
        self.assertAlmostEqual(self.session.GetForce()[0], STIFFNESS * (DEPTH + 1e-3 * radius), delta=1e-6)
        put(self.proxy, "Touching", 0)
        display.Slice = 4
        simple.Render(self.view)
        self.assertTrue(self.follow())
        self.press(radius - DEPTH, 0.3, 2.0)
        self.assertAlmostEqual(self.session.GetForce()[0], STIFFNESS * (DEPTH + 1e-3 * radius), delta=1e-6)

    def test_an_image_slice_without_lines_that_count_or_without_a_colour_says_what_to_do(self):
        display = self.slice_of_x()
        self.follow()
        self.assertIn("give lines a radius", self.scene.GetReport())
        put(self.proxy, "LineRadius", 0.05)
        simple.ColorBy(display, None)
        simple.Render(self.view)
        self.follow()
        self.assertIn("colour it by an array of points", self.scene.GetReport())

    def test_of_two_views_the_one_that_is_followed_is_felt_and_the_other_is_not(self):
        self.show(simple.Box())
        other = simple.CreateView("RenderView")
        other.ViewSize = [120, 100]
        self.addCleanup(simple.Delete, other)
        far = simple.Box(Center=[5.0, 0.0, 0.0])
        simple.Show(far, other)
        simple.Render(other)
        self.follow()
        self.assertEqual(self.scene.GetNumberOfSurfaces(), 1)
        self.press(0.5 - DEPTH, 0.1, 0.1)
        self.assertAlmostEqual(self.session.GetForce()[0], FORCE, delta=1e-9)
        put(self.scene_proxy, "View", other.SMProxy)
        self.assertTrue(self.follow())
        self.session.Step(1000)
        self.assertAlmostEqual(self.session.GetForceMagnitude(), 0.0, delta=1e-9)
        put(self.proxy, "Touching", 0)
        self.press(5.5 - DEPTH, 0.1, 0.1)
        self.assertAlmostEqual(self.session.GetForce()[0], FORCE, delta=1e-9)
        simple.Show(far, self.view)  # in both: once felt
        simple.Render(self.view)
        self.assertFalse(self.follow())
        put(self.scene_proxy, "View", self.view.SMProxy)
        self.assertTrue(self.follow())
        self.assertEqual(self.scene.GetNumberOfSurfaces(), 2)


if __name__ == "__main__":
    # A SystemExit would skip pvpython's own ending, which closes views before the display.
    if not unittest.main(exit=False).result.wasSuccessful():
        sys.exit(1)
