# SPDX-License-Identifier: GPL-3.0-or-later
"""Data drawn without polygons of their own are felt as they are seen: 3-D glyphs, image slices; and which of two views."""

import sys
import unittest

from paraview import simple
from vtkmodules.vtkCommonCore import vtkFloatArray
from vtkmodules.vtkCommonDataModel import vtkImageData

from displays import move
from haptic_proxies import put
from view_fixture import DEPTH, FORCE, STIFFNESS, ViewTest
from says import unsaid


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
        self.assertAlmostEqual(self.session.GetInspection().GetValue("Size"), 2.0, delta=1e-12)
        put(self.proxy, "Touching", 0)
        self.press(0.5 * 1.0 - DEPTH, 0.1, 0.1)
        self.assertAlmostEqual(self.session.GetForce()[0], FORCE, delta=1e-6)
        put(self.proxy, "Touching", 0)
        move(display, [0.0, 0.0, 10.0])
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

    def image(self):
        """Of three arrays, i, j and k, each the index along one axis: from -1 to 3, -2 to 6, -3 to 2."""
        image = vtkImageData()
        image.SetExtent(-1, 3, -2, 6, -3, 2)
        image.SetSpacing(0.5, 1.0, 2.0)
        image.SetOrigin(0.1, 0.2, 0.3)
        e = image.GetExtent()
        indices = [(i, j, k) for k in range(e[4], e[5] + 1) for j in range(e[2], e[3] + 1) for i in range(e[0], e[1] + 1)]
        for axis, name in enumerate("ijk"):
            array = vtkFloatArray()
            array.SetName(name)
            for index in indices:
                array.InsertNextValue(index[axis])
            image.GetPointData().AddArray(array)
        producer = simple.TrivialProducer()
        producer.GetClientSideObject().SetOutput(image)
        return producer

    def leftmost_white(self, y):
        """x of the first white pixel at a height, seen along -z [u], and how wide a pixel is."""
        simple.ResetCamera(self.view)
        self.view.CameraParallelProjection = 1
        self.view.CameraPosition, self.view.CameraFocalPoint, self.view.CameraViewUp = [1, y, 50], [1, y, 0], [0, 1, 0]
        self.view.CameraParallelScale = 3.0
        simple.Render(self.view)
        picture = self.view.SMProxy.CaptureWindow(1)
        width, height, _ = picture.GetDimensions()
        bright = [x for x in range(width) if picture.GetScalarComponentAsDouble(x, height // 2, 0, 2) > 200]
        return 1 + (bright[0] - width / 2) * 2 * 3.0 / height, 2 * 3.0 / height

    def test_a_slice_that_is_drawn_in_the_plane_of_x_and_y_is_felt_where_it_is_drawn(self):
        radius, y = 0.05, 0.7
        put(self.proxy, "LineRadius", radius)
        self.view.UseColorPaletteForBackground, self.view.Background = 0, [1, 0, 0]
        self.view.OrientationAxesVisibility = 0
        display = self.show(self.image())
        display.SetRepresentationType("Slice")
        display.GetClientSideObject().GetActiveRepresentation().SetUseXYPlane(1)  # which no panel of ParaView shows
        # ParaView lays the first axis of the slice along x, that of y and z along x too, with the spacing of x: index
        # (lowest + highest) / 2 is at 0.1 + 0.5 x that.
        for mode, array, lowest, highest in (("XY Plane", "i", -1, 3), ("YZ Plane", "j", -2, 6), ("XZ Plane", "k", -3, 2)):
            middle = 0.5 * (lowest + highest)
            display.SliceMode = mode
            simple.ColorBy(display, ("POINTS", array))
            colours = simple.GetColorTransferFunction(array)
            colours.RGBPoints = [lowest, 0, 0, 0, middle, 0, 0, 0, middle + 1e-3, 1, 1, 1, highest, 1, 1, 1]
            display.SetScalarBarVisibility(self.view, False)
            line = 0.1 + 0.5 * middle
            drawn, pixel = self.leftmost_white(y)
            self.assertAlmostEqual(drawn, line, delta=0.5 + pixel, msg=mode)  # of a picture with a colour a point: a texel
            self.follow()
            self.press(line + radius - DEPTH, y, 0.0)
            self.assertAlmostEqual(self.session.GetForce()[0], STIFFNESS * (DEPTH + 1e-3 * radius), delta=1e-6, msg=mode)
            put(self.proxy, "Touching", 0)

    def test_an_image_slice_without_lines_that_count_or_without_a_colour_says_what_to_do(self):
        display = self.slice_of_x()
        self.follow()
        self.assertIn("set Radius of lines", self.scene.GetReport())
        put(self.proxy, "LineRadius", 0.05)
        simple.ColorBy(display, None)
        simple.Render(self.view)
        self.follow()
        self.assertEqual(unsaid(self.scene.GetReport(), "slice", "colour", "point array"), [])

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
