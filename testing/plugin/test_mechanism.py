# SPDX-License-Identifier: GPL-3.0-or-later
"""A mechanism held in pvpython as a person holds it: a needle through a wall, felt, seen, changed, kept in a state."""

import json
import math
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_STRING
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersGeneral import vtkDataSetTriangleFilter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter

simple.LoadPlugin(os.environ["PALPATE_PLUGIN"], remote=False, ns=globals())
from palpate.simple import (AddConstraint, BreakConstraint, GetHapticSession, HapticRefusal, HapticState, HoldMechanism, Constraints,  # noqa: E402
                            LetGo, PlaceWire, PutBack, RemoveConstraint, SetHaptics, Touch)
from displays import move
from says import unsaid

SCENES = pathlib.Path(os.environ["PALPATE_SOURCE_DIR"]) / "data" / "mechanisms"
SCALE, STIFFNESS = 1000.0, 500.0  # u/m, N/m
TICKS_TO_ENGAGE = 1500
TIP, FACE = 150.0, -8.0  # u: of the needle before the hand, of the wall's lower side
LARGEST_STEP = 0.2  # N in a tick, whatever becomes of the mechanism
ASIDE = 2.0  # u, of a hand in the process that a state is loaded in
CLAMP = {"name": "clamp", "kind": "spring", "a": "needle", "b": "wall", "axis_b": [1, 0, 0], "stiffness_N_per_m": 100}
JOINED = {"format": "palpate mechanism", "version": 1, "unit_m": 0.001, "bodies": [
    {"name": "needle", "kind": "held", "length": 40, "diameter": 1},
    {"name": "tissue", "kind": "soft", "file": "tissue.vtu", "fixed": "zmax", "young_Pa": 30000, "poisson": 0.4, "model": "linear",
     "tip_diameter": 18.75}],
    "laws": [{"name": "thread", "kind": "attachment", "a": "needle", "b": "tissue", "point_a": [0, 0, 40], "point_b": [0, 0, 40]}]}


def lead(x, y, tip):
    GetHapticSession().SetHandPosition(x, y, tip - TIP)


def write_block(file, cells, low=40):
    """Of tetrahedra, 60 x 60 x 15 mm above z = low: so many cells along x."""
    image = vtkImageData()
    image.SetDimensions(cells + 1, cells + 1, cells // 4 + 1)
    image.SetSpacing(*[60 / cells] * 3)
    image.SetOrigin(-30, -30, low)
    cut = vtkDataSetTriangleFilter()
    cut.SetInputData(image)
    writer = vtkXMLUnstructuredGridWriter()
    writer.SetInputConnection(cut.GetOutputPort())
    writer.SetFileName(str(file))
    writer.Write()


def largest(data, array):
    return data.GetPointData().GetArray(array).GetMaxNorm()


def loaded(state):
    """In a process of its own: constraints and force of a state file that was loaded."""
    simple.LoadState(state)
    lead(ASIDE, 0, FACE - 5)
    Touch()
    GetHapticSession().Step(TICKS_TO_ENGAGE)
    lead(ASIDE, 0, FACE + 1.0)
    GetHapticSession().Step(200)
    told = HapticState()
    print("told:" + json.dumps({"laws": Constraints(), "force": list(told["Force"]), "text": told["MechanismText"]}))


class Held(unittest.TestCase):
    def setUp(self):
        self.view = simple.CreateView("RenderView")
        SetHaptics(DeviceName="fed", VirtualTime=1, FitOnTouch=0, Scale=SCALE, Stiffness=STIFFNESS, Passivity=0)

    def tearDown(self):
        LetGo()
        SetHaptics(MechanismSource="", MechanismConstraints="")
        for proxy in [*simple.GetSources().values(), *simple.GetRenderViews()]:
            simple.Delete(proxy)

    def hold(self, name="needle.json", tip=FACE - 5):
        source = HapticMechanism(FileName=str(SCENES / name))  # noqa: F821  of the plugin
        simple.RenameSource("Mechanism", source)
        simple.Show(source, self.view)
        self.lead(tip)
        HoldMechanism(source)
        Touch()
        GetHapticSession().Step(TICKS_TO_ENGAGE)
        return source

    def lead(self, tip):
        lead(0, 0, tip)

    def press(self, tip, ticks=200):
        self.lead(tip)
        GetHapticSession().Step(ticks)
        return HapticState()

    def steps(self, ticks=1000):
        """The force after so many ticks in which it has nowhere gone further than it may."""
        before = list(GetHapticSession().GetForce())
        for tick in range(ticks):
            GetHapticSession().Step(1)
            now = list(GetHapticSession().GetForce())
            self.assertLessEqual(sum((a - b) ** 2 for a, b in zip(now, before)) ** 0.5, LARGEST_STEP, tick)
            before = now
        return GetHapticSession().GetForceMagnitude()


class Mechanism(Held):
    def test_a_needle_presses_pierces_and_drags_and_its_table_and_picture_say_so(self):
        source = self.hold()
        self.assertIn("2 constraints", HapticState()["MechanismText"])
        self.assertEqual([law["Constraint"] for law in Constraints()], ["skin", "capsule"])
        self.assertEqual(HapticState()["ForceMagnitude"], 0.0)
        pressed = self.press(FACE + 1.0)
        self.assertLess(pressed["Force"][2], 0.0)
        self.assertEqual(Constraints()[0]["Phase"], "closed")
        self.assertAlmostEqual(Constraints()[0]["Force"], -pressed["Force"][2], delta=1e-6)
        for depth in range(2, 14):
            self.press(FACE + depth, 20)
        inside = self.press(FACE + 14)
        self.assertEqual(Constraints()[0]["Phase"], "inside")
        self.assertAlmostEqual(-inside["Force"][2], 0.4, delta=1e-3)
        simple.Render(self.view)
        top = servermanager.Fetch(source).GetBounds()[5]
        self.assertAlmostEqual(top, 58.0, delta=1e-3)  # of the liver: the needle has come along
        low = servermanager.Fetch(source).GetBounds()[4]
        self.assertAlmostEqual(low, FACE + 14 - TIP, delta=2.0)

    def test_laws_are_added_taken_away_and_broken_and_a_state_keeps_them(self):
        self.hold("suture.json", TIP)  # the hand at the origin, 40 before the knot
        self.assertEqual([law["Kind"] for law in Constraints()], ["break"])
        self.press(TIP + 1.0)
        self.assertEqual(Constraints()[0]["Phase"], "closed")
        BreakConstraint("thread")
        self.assertLess(self.press(TIP + 1.0, 1000)["ForceMagnitude"], 1e-6)
        self.assertEqual(Constraints()[0]["Phase"], "gone")
        AddConstraint(name="tape", kind="attachment", a="needle", b="tissue", point_a=[0, 0, 40], point_b=[0, 0, 40])
        self.assertEqual([law["Constraint"] for law in Constraints()], ["thread", "tape"])
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "mechanism.pvsm")
            simple.SaveState(file)
            self.assertIn("tape", pathlib.Path(file).read_text())
        RemoveConstraint("thread")
        self.assertEqual([law["Constraint"] for law in Constraints()], ["tape"])
        for call, words in ((lambda: RemoveConstraint("nothing"), "there is no constraint"), (lambda: BreakConstraint("nothing"), "there is no constraint"),
                            (lambda: AddConstraint(name="x", kind="weld", a="needle", b="tissue"), "valid kinds: contact")):
            with self.assertRaisesRegex(HapticRefusal, words):
                call()

    def test_a_stone_that_was_pushed_away_is_put_back(self):
        def stone():
            HapticState()  # the picture follows the session
            simple.Render(self.view)
            points = vtk_to_numpy(servermanager.Fetch(source).GetPoints().GetData())
            bodies = vtk_to_numpy(servermanager.Fetch(source).GetPointData().GetArray("Body"))
            return points[bodies == 1].mean(axis=0)

        scene = {"format": "palpate mechanism", "version": 1, "unit_m": 0.001, "contacts": "found", "friction": 0.3, "bodies": [
            {"name": "tool", "kind": "held", "file": "stone.obj"},
            {"name": "stone", "kind": "rigid", "half_size": [10, 10, 10], "at": [60, 0, 10], "density": 2600},
            {"name": "table", "kind": "world", "half_size": [200, 200, 10], "at": [0, 0, -10]}]}
        with tempfile.TemporaryDirectory() as folder:
            shutil.copy(SCENES / "stone.obj", folder)
            file = pathlib.Path(folder) / "push.json"
            file.write_text(json.dumps(scene))
            source = self.hold(file, TIP + 25)
            first = stone()
            for step in range(1000):
                lead(0.04 * step, 0, TIP + 25)
                GetHapticSession().Step(1)
            self.assertGreater(stone()[0] - first[0], 5.0)
            with self.assertRaisesRegex(HapticRefusal, "the hand is where stone would be put back: move the hand away first"):
                PutBack()
            lead(0, 0, TIP + 25)
            GetHapticSession().Step(1)
            PutBack()
            GetHapticSession().Step(TICKS_TO_ENGAGE)
            self.assertLess(numpy.abs(stone() - first).max(), 1e-3)
            SetHaptics(MechanismSource="")
            with self.assertRaisesRegex(HapticRefusal, "no mechanism is held"):
                PutBack()

    def test_a_wire_is_pushed_round_the_bend_turned_seen_and_put_back(self):
        def skin():
            HapticState()  # the picture follows the session
            simple.Render(self.view)
            data = servermanager.Fetch(source)
            points, bodies = vtk_to_numpy(data.GetPoints().GetData()), vtk_to_numpy(data.GetPointData().GetArray("Body"))
            return points[bodies == 0]

        tube = simple.Tube(Input=simple.Line(Point1=[-5, 0, 0], Point2=[60, 0, 0], Resolution=65), Radius=2.0, NumberofSides=24, Capping=0)
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "wire.json")
            source = PlaceWire(tube, file, length=100, beams=24, tip="angled", tip_length=5, friction=0.1)
            self.assertEqual(json.loads(pathlib.Path(file).read_text())["bodies"][0]["young_Pa"], 6e10)
            simple.Show(source, self.view)
            GetHapticSession().SetHandPosition(0, 0, 0)
            HoldMechanism(source, turning=0.01)
            Touch()
            GetHapticSession().Step(TICKS_TO_ENGAGE)
            self.assertAlmostEqual(skin()[:, 0].max(), 0.0, delta=0.5)  # its tip is at the mouth
            for step in range(301):
                GetHapticSession().SetHandPosition(0.1 * step, 0, 0)
                GetHapticSession().Step(1)
            GetHapticSession().Step(100)
            state = HapticState()
            self.assertAlmostEqual(state["WirePushed"], 30.0, delta=0.2)
            self.assertGreater(state["WireWallForce"], 0.0)
            # Its bent tip presses a wall that is 2 from the middle.
            self.assertAlmostEqual(numpy.hypot(*state["WireWallPosition"][1:]), 2.0, delta=0.05)
            self.assertIn("pushed out 3", state["MechanismText"])
            self.assertAlmostEqual(skin()[:, 0].max(), 30.0, delta=1.5)
            SetHaptics(WireTurn=90)
            GetHapticSession().Step(600)
            self.assertAlmostEqual(HapticState()["WireTurned"], 90.0, delta=15.0)  # friction holds it back
            with tempfile.TemporaryDirectory() as other:
                state_file = os.path.join(other, "wire.pvsm")
                simple.SaveState(state_file)
                self.assertIn("WireTurn", pathlib.Path(state_file).read_text())
            SetHaptics(WireTurn=0)
            PutBack()
            GetHapticSession().Step(100)
            self.assertAlmostEqual(HapticState()["WirePushed"], 0.0, delta=0.01)
            with self.assertRaisesRegex(HapticRefusal, "thicker than the vessel"):
                HoldMechanism(PlaceWire(tube, os.path.join(folder, "thick.json"), diameter=5))

    def test_a_wire_of_no_number_or_without_a_folder_is_one_sentence_and_no_file(self):
        tube = simple.Tube(Input=simple.Line(Point1=[-5, 0, 0], Point2=[60, 0, 0]), Radius=2.0)
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "wire.json")
            for key, value in (("length", math.nan), ("diameter", math.inf), ("mouth", (0, math.nan, 0)), ("unit", math.nan), ("friction", -math.inf)):
                with self.subTest(key):
                    with self.assertRaisesRegex(HapticRefusal, f"The {key} of a wire cannot be .*: give a finite number"):
                        PlaceWire(tube, file, **{key: value})
                    self.assertFalse(os.path.exists(file))
            with self.assertRaisesRegex(HapticRefusal, f"There is no folder {folder}/none: make it"):
                PlaceWire(tube, os.path.join(folder, "none", "wire.json"))
            os.mkdir(file)
            with self.assertRaisesRegex(HapticRefusal, "wire.json cannot be written: choose another folder"):
                PlaceWire(tube, file)

    def test_a_body_that_finds_no_place_to_rest_is_said_in_the_line_of_the_mechanism(self):
        feet = ((10, 0, -10), (-10, 10, -10), (-10, -10, -10))
        scene = {"format": "palpate mechanism", "version": 1, "unit_m": 0.001,
                 "bodies": [{"name": "needle", "kind": "held", "length": TIP, "diameter": 1},
                            {"name": "sledge", "kind": "rigid", "half_size": [10, 10, 10], "at": [0, 0, 0],
                             "load_N": [0.1, 0, -1]}, {"name": "ice", "kind": "world"}],
                 "laws": [{"name": f"foot {i}", "kind": "contact", "a": "sledge", "b": "ice", "point_a": at, "point_b": at}
                          for i, at in enumerate(feet)]}
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "sledge.json"
            file.write_text(json.dumps(scene))
            self.hold(file)
            self.assertEqual(unsaid(HapticState()["MechanismText"], "not satisfied", "tick"), [])
            self.assertGreater(HapticState()["CappedTicks"], TICKS_TO_ENGAGE / 2)
            self.assertEqual(HapticState()["ForceMagnitude"], 0.0)

    def test_a_source_that_was_laid_down_without_a_look_is_held_again(self):
        source = self.hold()
        LetGo()
        SetHaptics(MechanismSource="")
        HoldMechanism(source)
        self.assertIn("2 constraints", HapticState()["MechanismText"])
        self.assertEqual([law["Constraint"] for law in Constraints()], ["skin", "capsule"])

    def test_a_law_that_nobody_can_meet_is_refused_and_a_needle_that_is_in_stays_in(self):
        source = self.hold()
        for depth in range(1, 14):
            self.press(FACE + depth, 20)
        self.assertEqual(Constraints()[0]["Phase"], "inside")
        before = self.press(FACE + 14)["ForceMagnitude"]
        bad = (dict(b="nobody"), '"nobody"'), (dict(b="needle"), "itself"), (dict(kind="break", strength_N=0), "0 N or less"), \
            (dict(point_a=[0, 0, 500]), 'outside of "needle"')
        for values, words in bad:
            law = {**CLAMP, **values}
            for call in (lambda law=law: AddConstraint(**law), lambda law=law: HoldMechanism(source, laws=[law])):
                with self.assertRaisesRegex(HapticRefusal, words):
                    call()
                self.assertEqual([one["Constraint"] for one in Constraints()], ["skin", "capsule"])
                self.assertAlmostEqual(self.press(FACE + 14, 10)["ForceMagnitude"], before, delta=1e-4)
                self.assertEqual(Constraints()[0]["Phase"], "inside")
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "mechanism.pvsm")
            simple.SaveState(file)
            self.assertNotIn("clamp", pathlib.Path(file).read_text())
        LetGo()  # and without a servo that has the bodies
        HoldMechanism(None)
        HoldMechanism(source)
        with self.assertRaisesRegex(HapticRefusal, '"nobody"'):
            HoldMechanism(source, laws=[{**CLAMP, "b": "nobody"}])
        HoldMechanism(source, laws=[CLAMP])
        self.assertEqual([law["Constraint"] for law in Constraints()], ["clamp"])

    def test_one_that_is_drawn_elsewhere_than_its_file_has_it_is_refused_or_said(self):
        source = self.hold()
        self.assertNotIn("not of the display", HapticState()["MechanismText"])
        move(simple.GetDisplayProperties(source, self.view), [100, 0, 0])
        simple.Render(self.view)
        HapticState()
        self.assertEqual(unsaid(HapticState()["MechanismText"], "scene file", "not of the display"), [])
        move(simple.GetDisplayProperties(source, self.view), [0, 0, 0])
        HapticState()
        self.assertNotIn("not of the display", HapticState()["MechanismText"])
        moved = simple.Transform(registrationName="Moved", Input=source)
        HoldMechanism(moved)
        self.assertIn("2 constraints", HapticState()["MechanismText"])  # nothing has been moved yet
        moved.Transform.Translate = [100, 0, 0]
        HapticState()
        self.assertEqual(unsaid(HapticState()["MechanismText"], "Moved cannot be held", "moved away", "scene file"), [])
        HoldMechanism(None)
        with self.assertRaisesRegex(HapticRefusal, "Moved cannot be held: .*scene file"):
            HoldMechanism(moved)

    def test_a_row_says_what_its_law_is_and_what_joins_two_points_is_never_open(self):
        self.hold()
        self.assertEqual(Constraints()[0]["Numbers"], "1.5 N, drags 0.4 N, friction 1")
        HoldMechanism(None)
        simple.Delete(simple.FindSource("Mechanism"))
        LetGo()
        self.hold("suture.json", TIP)
        self.assertLess(HapticState()["ForceMagnitude"], 1e-6)
        self.assertEqual(Constraints()[0]["Phase"], "closed")

    def test_a_source_that_is_deleted_while_it_is_held_lets_the_hand_go(self):
        source = self.hold()
        self.assertGreater(self.press(FACE + 1.0)["ForceMagnitude"], 0.2)
        simple.Delete(source)
        HapticState()
        self.assertLess(self.steps(), 1e-6)
        self.assertIn("does not exist", HapticState()["MechanismText"])

    def test_a_body_that_is_pressed_is_seen_to_bend_and_all_are_as_at_first_when_they_are_laid_down(self):
        source = self.hold()
        self.assertEqual(largest(servermanager.Fetch(source), "Displacement"), 0.0)
        pressed = self.press(FACE + 1.5)
        self.assertGreater(pressed["ForceMagnitude"], 0.2)
        simple.Render(self.view)
        shown = servermanager.Fetch(source)
        at = [i for i in range(shown.GetNumberOfPoints()) if shown.GetPointData().GetArray("Body").GetValue(i) == 1]
        tip = pressed["ToolPose"][2] + TIP
        lowest = min(at, key=lambda i: abs(shown.GetPoint(i)[0]) + abs(shown.GetPoint(i)[1]) + abs(shown.GetPoint(i)[2] - tip))
        self.assertAlmostEqual(shown.GetPoint(lowest)[2], tip, delta=1e-6)  # the wall has a vertex at the tip
        went = sum(shown.GetPointData().GetArray(name).GetTuple3(lowest)[2] for name in ("Displacement", "Dent"))
        self.assertAlmostEqual(went, tip - FACE, delta=1e-6)
        self.assertGreater(tip - FACE, 0.3)
        LetGo()
        simple.Render(self.view)
        laid = servermanager.Fetch(source)
        self.assertEqual(largest(laid, "Displacement"), 0.0)
        self.assertAlmostEqual(laid.GetBounds()[4], FACE, delta=1e-5)  # the needle is at the origin again

    def test_a_state_file_gives_another_process_the_same_laws_and_the_same_force(self):
        self.hold()
        AddConstraint(**CLAMP)
        RemoveConstraint("capsule")
        lead(ASIDE, 0, FACE - 5)
        GetHapticSession().Step(300)
        lead(ASIDE, 0, FACE + 1.0)
        GetHapticSession().Step(200)
        here = HapticState()
        self.assertGreater(abs(here["Force"][0]), 0.05)  # of the clamp
        self.assertGreater(abs(here["Force"][2]), 0.05)  # of the skin
        laws = Constraints()
        self.assertEqual([law["Constraint"] for law in laws], ["skin", "clamp"])
        LetGo()
        with tempfile.TemporaryDirectory() as folder:
            state = os.path.join(folder, "mechanism.pvsm")
            simple.SaveState(state)
            run = subprocess.run(["pvpython", "--dr", __file__, "--loaded", state], capture_output=True, text=True, check=False)
        said = [line for line in run.stdout.splitlines() if line.startswith("told:")]
        self.assertEqual(len(said), 1, run.stdout + run.stderr)
        there = json.loads(said[0][len("told:"):])
        self.assertEqual(there["text"], here["MechanismText"])
        for one, other in zip(laws, there["laws"], strict=True):
            for name in ("Constraint", "Kind", "A", "B", "Phase"):
                self.assertEqual(other[name], one[name])
            self.assertAlmostEqual(other["Force"], one["Force"], delta=1e-6)
        for one, other in zip(here["Force"], there["force"], strict=True):
            self.assertAlmostEqual(other, one, delta=1e-6)


class Files(Held):
    """A body's file changes while it is joined to the held body."""

    def setUp(self):
        super().setUp()
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.body = pathlib.Path(self.folder.name) / "tissue.vtu"
        self.scene = pathlib.Path(self.folder.name) / "joined.json"
        self.scene.write_text(json.dumps(JOINED))
        write_block(self.body, 8)
        self.errors = []

    def hold_joined(self):
        self.source = self.hold(self.scene, TIP)  # the hand at the origin
        note = lambda _object, _event, text: self.errors.append(text)  # noqa: E731
        note.CallDataType = VTK_STRING
        self.source.SMProxy.GetClientSideObject().AddObserver("ErrorEvent", note)
        self.press(TIP + 1.0, 500)
        return self.steps(10)

    def read_again(self):
        self.source.ReadAgain()
        HapticState()

    def fresh(self):
        """The force on a hand there that takes the mechanism as its files are now."""
        LetGo()
        Touch()
        GetHapticSession().Step(TICKS_TO_ENGAGE)
        self.lead(TIP + 0.0)
        GetHapticSession().Step(500)
        self.press(TIP + 1.0, 1000)
        return GetHapticSession().GetForceMagnitude()

    def test_one_that_is_meshed_anew_is_felt_as_it_is_then_without_a_step(self):
        coarse = self.hold_joined()
        write_block(self.body, 12)
        self.read_again()
        fine = self.steps()
        self.assertGreater(abs(fine - coarse), 1e-3)
        self.assertEqual(self.errors, [])
        self.assertAlmostEqual(fine, self.fresh(), delta=1e-6)

    def test_one_that_is_elsewhere_by_now_is_refused_once_by_the_law_that_it_is_joined_with(self):
        self.hold_joined()
        write_block(self.body, 8, low=200)
        self.read_again()
        self.assertLess(self.steps(), 1e-6)
        self.assertEqual(len(self.errors), 1, self.errors)
        self.assertIn('"thread"', self.errors[0])
        self.assertIn("tissue", self.errors[0])

    def test_one_that_is_gone_changes_nothing_until_the_scene_is_read_again_then_is_said_once_and_lets_the_hand_go(self):
        held = self.hold_joined()
        kept = pathlib.Path(self.folder.name) / "kept.vtu"
        shutil.move(self.body, kept)
        AddConstraint(name="tape", kind="spring", a="needle", b="tissue", point_a=[0, 0, 40], point_b=[0, 0, 40], stiffness_N_per_m=1)
        self.assertAlmostEqual(self.steps(), held, delta=1e-3)
        self.assertEqual([law["Constraint"] for law in Constraints()], ["thread", "tape"])
        self.read_again()
        self.assertLess(self.steps(), 1e-6)
        for _ in range(3):
            simple.Render(self.view)
            state = HapticState()
        self.assertEqual(len(self.errors), 1, self.errors)
        self.assertEqual(unsaid(self.errors[0], "joined.json: bodies[1]: tissue", "soft body"), [])
        self.assertIn(str(self.body), self.errors[0])
        self.assertEqual(unsaid(state["MechanismText"], "joined.json: bodies[1]: tissue", "soft body"), [])
        self.assertNotIn("\n", state["MechanismText"])
        shutil.move(kept, self.body)
        self.read_again()
        self.assertAlmostEqual(self.steps(), held, delta=1e-3)
        self.assertEqual([law["Constraint"] for law in Constraints()], ["thread", "tape"])


class Wrong(Held):
    """A scene file that is none."""

    def test_what_is_wrong_with_a_file_is_said_when_it_is_held_and_when_a_held_one_becomes_so(self):
        with tempfile.TemporaryDirectory() as folder:
            wrong = pathlib.Path(folder) / "wrong.json"
            wrong.write_text("[]")
            source = HapticMechanism(registrationName="Wrong", FileName=str(wrong))  # noqa: F821  of the plugin
            simple.Show(source, self.view)
            said = f"Wrong cannot be held: {wrong}: must be an object"
            with self.assertRaises(HapticRefusal) as refused:
                HoldMechanism(source)
            self.assertIn(said, str(refused.exception))
            self.assertTrue(HapticState()["MechanismText"].startswith(said), HapticState()["MechanismText"])
            source.FileName = str(SCENES / "needle.json")
            HapticState()
            self.assertIn("2 constraints", HapticState()["MechanismText"])
            for file, words in ((wrong, "must be an object"), (pathlib.Path(folder) / "none.json", "cannot be read")):
                source.FileName = str(file)
                HapticState()
                self.assertIn(f"Wrong cannot be held: {file}: {words}", HapticState()["MechanismText"])


if __name__ == "__main__":
    if "--loaded" in sys.argv:
        loaded(sys.argv[-1])
    else:
        unittest.main()
