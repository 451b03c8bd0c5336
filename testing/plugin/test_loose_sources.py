# SPDX-License-Identifier: GPL-3.0-or-later
"""Sources of the pipeline as loose bodies: pushed, drawn, put back, saved, refused. A process of its own: the session is registered.
Judges: Newton's law and statics of a block whose volume is known."""

import os
import tempfile
import unittest

import numpy
from paraview import simple
from vtkmodules.vtkCommonMath import vtkMatrix4x4

simple.LoadPlugin(os.environ["PALPATE_PLUGIN"], remote=False, ns=globals())
from palpate.simple import (GetHapticSession, HapticRefusal, HapticState, HapticUpdate, HoldTool, LetGo, PressBody, PutBack,  # noqa: E402
                            SetHaptics, SetSource, Touch, Touched)

SIZE = (60.0, 40.0, 20.0)  # mm
DENSITY, GRAVITY, FRICTION = 2500.0, 9.81, 0.3  # kg/m^3, m/s^2
MASS = DENSITY * 1e-9 * SIZE[0] * SIZE[1] * SIZE[2]  # kg
RADIUS, STIFFNESS = 5.0, 2000.0  # mm, N/m
BEHIND = -SIZE[0] / 2 - RADIUS - 1  # mm


class LooseSources(unittest.TestCase):
    def setUp(self):
        self.view = simple.CreateView("RenderView")
        self.view.ViewSize = [120, 100]
        simple.SetActiveView(self.view)
        SetHaptics(DeviceName="fed", VirtualTime=1, Stiffness=STIFFNESS, Scale=1000, Radius=RADIUS, FitOnTouch=0,
                   FrictionStatic=FRICTION, FrictionKinetic=FRICTION)
        self.table = simple.Box(registrationName="table", XLength=600, YLength=600, ZLength=20, Center=[0, 0, -10])
        self.stone = simple.Box(registrationName="stone", XLength=SIZE[0], YLength=SIZE[1], ZLength=SIZE[2], Center=[0, 0, SIZE[2] / 2])
        simple.Show(self.table, self.view)
        self.shown = simple.Show(self.stone, self.view)
        self.hand = GetHapticSession()
        self.hand.SetHandPosition(BEHIND, 0, SIZE[2] / 2)

    def tearDown(self):
        LetGo()
        HoldTool(None)
        PressBody(None)
        SetHaptics(SourcesText="", SceneUnit=0, Gravity=[0, 0, -GRAVITY])
        for source in list(simple.GetSources().values()):
            simple.Delete(source)
        simple.Delete(self.view)

    def touch(self):
        Touch()
        self.hand.Step(1500)  # as long as force takes to be let through

    def pushed(self, acceleration, ticks=400, last=60):
        """Mean force along x that a hand gives which accelerates from rest [m/s^2], over the last ticks."""
        forces = []
        for tick in range(ticks):
            self.hand.SetHandPosition(BEHIND + 1 + 1e3 * acceleration * (1e-3 * tick) ** 2 / 2, 0, SIZE[2] / 2)
            self.hand.Step(1)
            self.hand.Update()
            forces.append(-self.hand.GetForce()[0])
        return numpy.mean(forces[-last:])

    def drawn(self):
        """Where the corner of the box's data at x, y, z = 0 is drawn: its display's matrix, as rows."""
        HapticUpdate()
        matrix = self.shown.SMProxy.GetClientSideObject().GetActiveRepresentation().GetActor().GetMatrix()
        return numpy.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])

    def test_the_ball_feels_mass_times_acceleration_and_friction(self):
        Touched(self.stone, "loose", density=DENSITY, unit="mm")
        self.touch()
        self.assertEqual(HapticState()["LooseText"], f"stone: loose, {MASS:.3g} kg\n")
        for acceleration in (0.5, 1.0):
            with self.subTest(acceleration=acceleration):
                for place in ((0, 0, 100), (2 * BEHIND, 0, 100), (BEHIND, 0, SIZE[2] / 2)):  # around the stone
                    self.hand.SetHandPosition(*place)
                    self.hand.Step(1000)
                PutBack()
                self.hand.Step(500)
                expected = MASS * (acceleration + FRICTION * GRAVITY)
                self.assertAlmostEqual(self.pushed(acceleration), expected, delta=0.03 * expected)

    def test_it_is_drawn_where_it_is_and_its_data_and_the_scene_stay(self):
        Touched(self.stone, "loose", density=DENSITY, unit="mm")
        self.touch()
        numpy.testing.assert_allclose(self.drawn(), numpy.identity(4), atol=1e-3)
        plan = HapticState()["Ticks"]
        self.pushed(1.0)
        way = vtkMatrix4x4()
        moved = self.drawn()
        self.assertTrue(self.hand.GetSight().GetLooseWay("stone", way))
        self.assertAlmostEqual(moved[0, 3], 1e3 * 0.4 ** 2 / 2, delta=2)  # as far as the hand went
        self.assertEqual([moved[0, 3], moved[1, 3]], [way.GetElement(0, 3), way.GetElement(1, 3)])
        self.assertEqual(list(self.shown.Position), [0, 0, 0], "the display's properties stay")
        before = moved[0, 3]
        for _ in range(5):  # a look at the view begins no other scene, which would put the stone back
            HapticUpdate()
            self.hand.FinishScene()
            self.hand.Step(20)
        self.assertGreater(self.drawn()[0, 3], before - 1)
        self.assertGreater(HapticState()["Ticks"], plan)
        LetGo()
        numpy.testing.assert_array_equal(self.drawn(), numpy.identity(4))

    def test_the_floor_bears_a_pressed_one_and_put_back_is_where_its_data_are(self):
        Touched("stone", "loose", density=DENSITY, unit="mm")
        self.touch()
        self.pushed(1.0)
        self.hand.SetHandPosition(0, 0, 200)
        self.hand.Step(1500)
        PutBack()
        self.hand.Step(500)
        numpy.testing.assert_allclose(self.drawn(), numpy.identity(4), atol=1e-3)
        deep = 0.5  # mm
        for height in (2, 0, -deep):
            self.hand.SetHandPosition(1, 2, SIZE[2] + RADIUS + height)
            self.hand.Step(800)
        self.hand.Update()
        self.assertAlmostEqual(self.hand.GetForce()[2], STIFFNESS * 1e-3 * deep, delta=0.01 * STIFFNESS * 1e-3 * deep)

    def test_a_source_that_falls_out_of_the_scene_is_named_with_a_remedy_and_comes_back(self):
        Touched("stone", "loose", density=DENSITY, unit="mm")
        self.touch()
        self.assertNotIn("stone", HapticState()["Warning"])
        simple.Hide(self.table, self.view)
        HapticUpdate()
        self.hand.FinishScene()
        diagonal = 1e-3 * numpy.linalg.norm(SIZE)  # m, at the least: ball and stone are the mechanism
        self.hand.Step(int(1e3 * numpy.sqrt(2 * 40 * diagonal / 9.81)))
        self.hand.Update()
        self.assertRegex(HapticState()["Warning"], "^stone has fallen out of the scene: .*Put Back")
        self.assertIn("has fallen", HapticState()["LooseText"])
        simple.Show(self.table, self.view)
        HapticUpdate()
        self.hand.FinishScene()
        PutBack()
        self.hand.Step(300)
        self.hand.Update()
        self.assertNotIn("stone", HapticState()["Warning"])
        numpy.testing.assert_allclose(self.drawn(), numpy.identity(4), atol=1e-3)

    def test_an_edit_of_another_source_is_no_error_and_the_stone_is_loose_again_once_that_rests(self):
        Touched("stone", "loose", density=DENSITY, unit="mm")
        self.touch()
        self.table.XLength = 500  # its vertices go there: a surface that deforms meanwhile
        HapticUpdate()
        self.hand.FinishScene()
        self.hand.Update()
        self.assertEqual(HapticState()["Problem"], "")
        for _ in range(5):
            self.hand.Step(300)
            self.hand.Update()
            HapticUpdate()
            self.hand.FinishScene()
        self.assertEqual(HapticState()["Problem"], "")
        self.assertEqual(HapticState()["LooseText"], f"stone: loose, {MASS:.3g} kg\n")

    def test_fixed_is_the_default_and_ends_loose(self):
        Touched(self.stone, "loose", density=DENSITY, unit="mm")
        Touched(self.stone)
        self.touch()
        self.assertEqual(HapticState()["LooseText"], "")
        self.assertGreater(self.pushed(1.0), 1.0)  # a wall
        numpy.testing.assert_array_equal(self.drawn(), numpy.identity(4))

    def test_the_unit_may_be_that_of_the_files_and_without_any_the_source_stays_fixed_and_says_so(self):
        Touched(self.stone, "loose", density=DENSITY)
        with self.assertRaisesRegex(HapticRefusal, "stone cannot be loose: .*unit of lengths.*SceneUnit"):
            Touch()
        self.assertIn("unit of lengths", HapticState()["LooseText"])
        SetHaptics(SceneUnit=3)  # mm
        self.assertEqual(HapticState()["LooseText"], f"stone: loose, {MASS:.3g} kg\n")
        SetHaptics(SceneUnit=0)
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "table.stl")  # whose unit is taken for mm
            simple.SaveData(file, proxy=simple.ExtractSurface(Input=self.table))
            simple.Show(simple.OpenDataFile(file), self.view)
            simple.Hide(self.table, self.view)
            simple.Render(self.view)
            HapticUpdate()
            self.hand.FinishScene()
            self.assertEqual(HapticState()["LooseText"], f"stone: loose, {MASS:.3g} kg\n")

    def test_the_state_text_has_the_density_and_older_texts_are_read(self):
        SetSource(self.stone, friction=(0.5, 0.25))
        old = self.hand.GetSettingText("SourcesText")
        self.assertEqual(old, "Source,Touched,Stiffness,FrictionStatic,FrictionKinetic\nstone,1,inf,0.5,0.25\n")
        Touched(self.stone, "loose", density=DENSITY)
        text = self.hand.GetSettingText("SourcesText")
        self.assertEqual(text, "Source,Touched,Stiffness,FrictionStatic,FrictionKinetic,Density\nstone,1,inf,0.5,0.25,2500\n")
        SetHaptics(SourcesText=old)
        self.assertEqual(self.hand.GetMechanism().GetDensity("stone"), 0)
        SetHaptics(SourcesText=text)
        self.assertEqual(self.hand.GetMechanism().GetDensity("stone"), DENSITY)

    def test_bad_requests_are_one_sentence_that_names_the_source(self):
        for arguments, said in (((self.stone, "floating"), "stone is touched as 'fixed', 'loose' or 'soft'"),
                                ((self.stone, "loose"), "stone: a loose source needs a density"),
                                ((self.stone, "loose", 0), "stone: a loose source needs a density"),
                                ((self.stone, "loose", float("nan")), "stone: a loose source needs a density"),
                                ((self.stone, "loose", float("inf")), "stone: a loose source needs a density"),
                                ((self.stone, "loose", "2500"), "stone: a loose source needs a density"),
                                ((self.stone, "loose", True), "stone: a loose source needs a density"),
                                ((self.stone, "loose", numpy.True_), "stone: a loose source needs a density"),
                                ((self.stone, "loose", numpy.float32("nan")), "stone: a loose source needs a density"),
                                ((self.stone, "fixed", 2500), "only a loose source has a density"),
                                ((self.stone, "loose", 2500, "inch"), "A unit of lengths is one of"),
                                ((self.stone, "soft"), "stone cannot be a soft body"),
                                (("nothing", "loose", 2500), "has no source 'nothing'")):
            with self.subTest(said=said), self.assertRaisesRegex(HapticRefusal, said):
                Touched(*arguments)
                Touch()
            PressBody(None)
            self.assertEqual(self.hand.GetMechanism().GetDensity("stone"), 0)
        HoldTool(self.stone)
        with self.assertRaisesRegex(HapticRefusal, "stone is the tool in the hand"):
            Touched(self.stone, "loose", density=DENSITY)

    def test_a_surface_that_is_open_is_refused_by_its_name_while_it_is_touched(self):
        sheet = simple.Plane(registrationName="sheet", Origin=[100, 0, 5], Point1=[150, 0, 5], Point2=[100, 50, 5])
        self.touch()
        simple.Show(sheet, self.view)
        simple.Render(self.view)
        with self.assertRaisesRegex(HapticRefusal, "sheet cannot be loose: the mesh is open.*it is touched as fixed now; repair"):
            Touched(sheet, "loose", density=DENSITY, unit="mm")
        Touched(sheet)
        with self.assertRaisesRegex(HapticRefusal, "stone cannot be loose beside sheet: the mesh is open.*hide sheet"):
            Touched(self.stone, "loose", density=DENSITY)
        simple.Hide(sheet, self.view)
        HapticUpdate()
        self.hand.FinishScene()
        self.assertEqual(HapticState()["LooseText"], f"stone: loose, {MASS:.3g} kg\n")

    def test_one_of_many_triangles_is_loose_once_a_simpler_surface_has_replaced_it(self):
        radius = 20.0
        ball = simple.Sphere(registrationName="ball", Radius=radius, ThetaResolution=460, PhiResolution=220, Center=[0, 100, radius])
        simple.Show(ball, self.view)
        SetHaptics(Simplify=2)  # on
        Touched(ball, "loose", density=DENSITY, unit="mm")
        with self.assertRaisesRegex(HapticRefusal, "ball cannot be loose: the mesh has 20[0-9]{4} triangles, .* 20000; .*simplify"):
            Touch()
        self.assertTrue(self.hand.FinishSimplification())
        self.hand.Step(100)
        said = HapticState()["LooseText"]
        self.assertRegex(said, "ball: loose, ")
        mass = 4 / 3 * numpy.pi * radius ** 3 * 1e-9 * DENSITY
        self.assertAlmostEqual(float(said.split("loose, ")[1].split(" kg")[0]), mass, delta=0.02 * mass)
        SetHaptics(Simplify=0)

    def test_one_that_is_deleted_while_it_is_pressed_leaves_the_hand_without_a_jump(self):
        Touched(self.stone, "loose", density=DENSITY, unit="mm")
        self.touch()
        deep = 0.5
        for height in (2, 0, -deep):
            self.hand.SetHandPosition(0, 0, SIZE[2] + RADIUS + height)
            self.hand.Step(800)
        self.hand.Update()
        before = self.hand.GetForce()[2]
        self.assertGreater(before, 0.5)
        most = 2 * before / 30  # the force fades in 30 ms
        simple.Delete(self.stone)
        HapticUpdate()
        self.hand.FinishScene()
        for _ in range(300):
            self.hand.Step(1)
            self.hand.Update()
            self.assertLess(abs(self.hand.GetForce()[2] - before), most)
            before = self.hand.GetForce()[2]
        self.assertLess(before, 1e-3)

    def test_numbers_of_numpy_are_densities(self):
        for kind in (numpy.int64, numpy.uint16, numpy.float32, numpy.float64):
            Touched(self.stone, "loose", density=kind(DENSITY))
            self.assertEqual(self.hand.GetMechanism().GetDensity("stone"), DENSITY, kind)
            Touched(self.stone)

    def test_one_that_is_not_felt_says_its_own_cause_and_the_remedy(self):
        Touched(self.stone, "loose", density=DENSITY, unit="mm")
        self.assertRegex(HapticState()["LooseText"], "stone: to be loose, .*press Touch\n$")
        self.touch()
        for change, back, said in ((lambda: SetSource(self.stone, touched=False), lambda: SetSource(self.stone, touched=True),
                                    "stone: is not touched; switch it on in Active source"),
                                   (lambda: HoldTool(self.stone), lambda: (HoldTool(None), simple.Show(self.stone, self.view)),
                                    "stone: is the tool in the hand; release it first"),
                                   (lambda: simple.Hide(self.stone, self.view), lambda: simple.Show(self.stone, self.view),
                                    "stone: to be loose, but not among the touched surfaces; show the source, and press Touch"),
                                   (lambda: simple.RenameSource("pebble", self.stone), lambda: simple.RenameSource("stone", self.stone),
                                    "stone: no source is called stone; remove it from SourcesText, or give a source that name"),
                                   (lambda: simple.Delete(self.stone), lambda: None,
                                    "stone: no source is called stone; remove it from SourcesText, or give a source that name")):
            with self.subTest(said=said):
                change()
                self.look()
                self.assertEqual(HapticState()["LooseText"], said + "\n")
                back()
                self.look()
        self.assertNotIn("kg", HapticState()["LooseText"])

    def look(self):
        simple.Render(self.view)
        HapticUpdate()
        self.hand.FinishScene()
        HapticUpdate()

    def test_one_with_a_weight_beyond_all_limits_says_its_unit(self):
        Touched(self.stone, "loose", density=DENSITY, unit="m")
        self.touch()
        self.assertRegex(HapticState()["LooseText"], r"stone.*beyond 1e6 N\): one unit is taken as 1 m; choose the unit of lengths \(SceneUnit\)\n$")

    def test_the_answer_is_of_the_source_that_was_asked(self):
        block = simple.Box(registrationName="inner", XLength=40, YLength=40, ZLength=40, Center=[0, 150, 20])
        soft = simple.SoftBody(registrationName="soft", Input=block, Unit=0.001, Fixed="zmin")
        simple.Show(soft, self.view)
        PressBody(soft)
        Touch()
        self.hand.GetMechanism().SetDensity("soft", DENSITY)
        with self.assertRaisesRegex(HapticRefusal, "^stone cannot be a soft body"):
            Touched(self.stone, "soft")

    def test_where_it_overlaps_another_one_as_it_begins_the_text_names_both(self):
        other = simple.Box(registrationName="other", XLength=40, YLength=40, ZLength=40, Center=[45, 0, 20])
        simple.Show(other, self.view)
        Touched(self.stone, "loose", density=DENSITY, unit="mm")
        self.touch()
        self.assertRegex(HapticState()["LooseText"], "stone: loose.*overlaps other where it begins.*move one of them")


if __name__ == "__main__":
    unittest.main()
