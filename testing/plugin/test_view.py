# SPDX-License-Identifier: GPL-3.0-or-later
"""The plugin in pvpython: its proxies touch the data of a view, in virtual time, without Qt."""

import pathlib
import sys
import tempfile
import unittest

from paraview import simple

from displays import move
from haptic_proxies import put
from view_fixture import DEPTH, FORCE, ViewTest
from says import unsaid

DEFAULT_SCALE = 1000.0  # u/m


class TouchInAView(ViewTest):
    def setUp(self):
        super().setUp()
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def test_a_face_pushes_with_stiffness_times_depth(self):
        self.show(simple.Box())
        self.assertTrue(self.follow())
        self.press(0.5 - DEPTH, 0.1, 0.1)
        self.assertAlmostEqual(self.session.GetForce()[0], FORCE, delta=1e-9)
        self.assertEqual(self.session.GetStateText(), "engaged")
        self.assertIn("Touching Box1.", self.scene.GetReport())

    def test_nothing_is_handed_over_when_only_the_camera_and_the_colour_change(self):
        display = self.show(simple.Box())
        self.assertTrue(self.follow())
        simple.GetActiveCamera().Azimuth(30)
        display.DiffuseColor = [1.0, 0.0, 0.0]
        simple.Render(self.view)
        self.assertFalse(self.follow())

    def write_stl(self, name, *heights):
        """An ASCII file of a triangle a height, whose third corner is that high."""
        path = pathlib.Path(self.folder.name, name)
        corners = (f"vertex 0 {i} 0\nvertex 1 {i} 0\nvertex 0 {i} {height}" for i, height in enumerate(heights))
        facets = "".join(f"facet normal 0 1 0\nouter loop\n{three}\nendloop\nendfacet\n" for three in corners)
        path.write_text(f"solid s\n{facets}endsolid s\n", encoding="utf-8")
        return str(path)

    def test_a_damaged_file_is_named_with_what_is_wrong(self):
        bad = simple.STLReader(registrationName="bad.stl", FileNames=[self.write_stl("bad.stl", "nan", "inf")])
        self.show(bad)
        self.follow()
        self.assertEqual(self.session.GetSceneRefusal(),
            "bad.stl: none of its 2 triangles can be touched (all non-finite or without area)")
        simple.Delete(bad)
        self.show(simple.STLReader(registrationName="half.stl", FileNames=[self.write_stl("half.stl", "1", "nan", "2")]))
        self.follow()
        self.assertEqual(self.session.GetSceneRefusal(), "")
        self.assertTrue(self.session.GetSceneDamage().startswith("half.stl: 1 of 3 triangles are left out"))

    def test_a_source_that_gives_nothing_is_said_to_be_damaged_not_to_be_drawn_wrongly(self):
        nothing = simple.Threshold(registrationName="none.vtu", Input=simple.Wavelet(), LowerThreshold=1e6, UpperThreshold=2e6)
        self.show(nothing)
        self.follow()
        self.assertIn("none.vtu: the source has no points", self.scene.GetRefusal())

    def test_an_array_is_felt_and_a_change_of_it_or_of_its_range_is_noticed(self):
        height = simple.Elevation(Input=simple.Box(), LowPoint=[0.0, -0.5, 0.0], HighPoint=[0.0, 0.5, 0.0])
        self.show(height)
        put(self.proxy, "StiffnessArray", "Elevation")
        put(self.proxy, "StiffnessFeltRange", 50.0, 150.0)
        self.assertTrue(self.follow())
        self.assertFalse(self.follow())
        self.assertIn("Elevation", self.scene.GetArrayNames().split())
        self.assertIn("stiffness from 'Elevation', 0 to 1 as 50 to 150 N/m", self.session.GetSceneReport())
        y, slope = 0.1, 100.0  # N/m per u
        self.press(0.5 - DEPTH, y, 0.1)
        wall = 50.0 + slope * (y + 0.5)
        self.assertAlmostEqual(self.session.GetForce()[0], wall * DEPTH, delta=1e-6)  # the array has single precision
        self.assertAlmostEqual(self.session.GetForce()[1], -0.5 * slope * DEPTH**2, delta=1e-6)
        put(self.proxy, "StiffnessFeltRange", 80.0, 80.0)
        self.assertTrue(self.follow())
        self.session.Step(1000)
        self.assertAlmostEqual(self.session.GetForce()[0], 80.0 * DEPTH, delta=1e-6)
        put(self.proxy, "StiffnessFeltRange", 40.0, 140.0)
        height.HighPoint = [0.0, 1.5, 0.0]
        height.ScalarRange = [0.0, 2.0]
        put(self.proxy, "StiffnessDataRange", 0.0, 1.0)
        simple.Render(self.view)
        self.assertTrue(self.follow())
        self.session.Step(1000)
        self.assertAlmostEqual(self.session.GetForce()[0], (40.0 + 100.0 * (y + 0.5)) * DEPTH, delta=1e-6)

    def test_a_moved_scaled_and_mirrored_actor_is_touched_where_it_is_seen(self):
        display = self.show(simple.Box())
        move(display, [3.0, 0.0, 0.0])
        display.Scale = [-2.0, 1.0, 1.0]
        simple.Render(self.view)
        self.follow()
        self.press(3.0 + 2.0 * 0.5 - DEPTH, 0.1, 0.1)
        self.assertAlmostEqual(self.session.GetForce()[0], FORCE, delta=1e-9)

    def test_a_change_of_the_pipeline_is_noticed(self):
        box = simple.Box()
        self.show(box)
        self.follow()
        box.XLength = 3.0
        simple.Render(self.view)
        self.assertTrue(self.follow())
        self.press(1.5 - DEPTH, 0.1, 0.1)
        self.assertAlmostEqual(self.session.GetForce()[0], FORCE, delta=1e-9)

    def test_hiding_while_pressing_ends_the_force(self):
        box = simple.Box()
        self.show(box)
        self.follow()
        self.press(0.5 - DEPTH, 0.1, 0.1)
        simple.Hide(box, self.view)
        self.assertTrue(self.follow())
        self.session.Step(500)
        self.session.Update()
        self.assertEqual(self.session.GetForceMagnitude(), 0.0)

    def test_deleting_while_pressing_ends_the_force(self):
        box = simple.Box()
        self.show(box)
        self.follow()
        self.press(0.5 - DEPTH, 0.1, 0.1)
        simple.Delete(box)
        self.assertTrue(self.follow())
        self.session.Step(500)
        self.session.Update()
        self.assertEqual(self.session.GetForceMagnitude(), 0.0)

    def test_two_surfaces_are_both_touched(self):
        self.show(simple.Box())
        self.show(simple.Box(Center=[5.0, 0.0, 0.0]))
        self.follow()
        self.assertEqual(self.scene.GetNumberOfSurfaces(), 2)
        self.press(5.5 - DEPTH, 0.1, 0.1)
        self.assertAlmostEqual(self.session.GetForce()[0], FORCE, delta=1e-9)

    def refusal(self, representation):
        display = self.show(simple.Wavelet(WholeExtent=[-2, 2, -2, 2, -2, 2]))
        display.SetRepresentationType(representation)
        simple.Render(self.view)
        self.follow()
        self.assertEqual(self.scene.GetNumberOfSurfaces(), 0)
        return self.scene.GetReport()

    def test_a_volume_is_refused_with_what_to_do(self):
        said = self.refusal("Volume")
        self.assertIn("a volume has no surface; choose it in the pipeline browser and press Touch", said)
        self.assertIn("or apply the filter Contour", said)

    def test_an_outline_is_refused_with_what_to_do(self):
        self.assertEqual(unsaid(self.refusal("Outline"), "outline", "edges", "representation Surface"), [])

    def test_what_is_drawn_as_lines_is_refused_with_what_helps(self):
        self.show(simple.Line())
        self.follow()
        self.assertEqual(unsaid(self.scene.GetReport(), "drawn as lines", "Radius of lines"), [])
        self.assertEqual(self.scene.GetRefusal(), self.scene.GetReport().strip().removeprefix("Not touched: "))
        put(self.proxy, "LineRadius", 0.1)  # the remedy helps
        self.assertTrue(self.follow())
        self.assertEqual((self.scene.GetNumberOfSurfaces(), self.scene.GetRefusal()), (1, ""))

    def test_points_are_refused_with_the_filter_that_makes_balls_of_them(self):
        points = simple.PointSource(NumberOfPoints=5, Radius=1.0)
        self.show(points)
        self.follow()
        self.assertEqual(unsaid(self.scene.GetReport(), "drawn as points", "Radius of points", "Glyph", "Sphere"), [])
        simple.Hide(points, self.view)
        self.show(simple.Glyph(Input=points, GlyphType="Sphere", GlyphMode="All Points"))  # the remedy helps
        self.follow()
        self.assertEqual(self.scene.GetNumberOfSurfaces(), 1)

    def test_what_is_fully_transparent_is_not_felt(self):
        display = self.show(simple.Box())
        self.assertTrue(self.follow())
        self.assertEqual(self.scene.GetNumberOfSurfaces(), 1)
        display.Opacity = 0.0
        simple.Render(self.view)
        self.assertTrue(self.follow())
        self.assertEqual(self.scene.GetNumberOfSurfaces(), 0)
        self.assertEqual(unsaid(self.scene.GetReport(), "transparent", "opacity"), [])
        display.Opacity = 0.01
        simple.Render(self.view)
        self.follow()
        self.assertEqual(self.scene.GetNumberOfSurfaces(), 1)

    def test_whoever_hears_that_touch_was_asked_for_finds_the_session_touching(self):
        """Also where the hand is fitted first, which sets properties of its own while others are on their way."""
        self.show(simple.Sphere(Radius=3.0))
        self.follow()
        put(self.proxy, "FitOnTouch", 1)
        put(self.proxy, "Scale", DEFAULT_SCALE)  # another choice of the person stays
        heard = []
        tag = self.proxy.AddObserver("UpdateEvent", lambda proxy, _: heard.append(
            (proxy.GetProperty("Touching").GetElement(0) == 1, self.session.GetTouching())))
        put(self.proxy, "Touching", 1)
        self.assertNotEqual(self.session.GetSetting("Scale"), DEFAULT_SCALE, "it was not fitted")
        put(self.proxy, "Touching", 0)
        self.proxy.RemoveObserver(tag)
        self.assertEqual(set(heard), {(True, True), (False, False)})

    def test_a_view_that_is_no_render_view_is_refused(self):
        chart = simple.CreateView("XYChartView")
        put(self.scene_proxy, "View", chart.SMProxy)
        self.follow()
        self.assertIn("not a 3D render view", self.scene.GetReport())
        simple.Delete(chart)

    def test_a_deleted_view_leaves_nothing_to_touch(self):
        self.show(simple.Box())
        self.follow()
        put(self.scene_proxy, "View", None)
        self.assertTrue(self.follow())
        self.assertIn("No view is active", self.scene.GetReport())


if __name__ == "__main__":
    # A SystemExit would skip pvpython's own ending, which closes views before the display.
    if not unittest.main(exit=False).result.wasSuccessful():
        sys.exit(1)
