# SPDX-License-Identifier: GPL-3.0-or-later
"""The filter Haptic Wire in pvpython: a wire in the vessel that the pipeline has, without any file."""

import json
import os
import pathlib
import tempfile
import unittest

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkFiltersGeneral import vtkOBBTree

simple.LoadPlugin(os.environ["PALPATE_PLUGIN"], remote=False, ns=globals())
from palpate.simple import (GetHapticSession, HapticRefusal, HapticState, HapticUpdate, HoldMechanism,  # noqa: E402
                            LetGo, PlaceWire, PutBack, SetHaptics, SoftText, Touch)

RADIUS, BEND = 2.0, 25.0  # u: of the tube, and of its middle line behind 10 u that are straight
STIFFNESS = 1000.0  # N/m
TICKS_TO_ENGAGE = 1500


def middle_line():
    """Points on a line along x that turns by a quarter of a circle towards y."""
    straight = [(x, 0.0, 0.0) for x in numpy.linspace(-10, 0, 11)]
    turns = numpy.linspace(0, numpy.pi / 2, 40)[1:]
    return straight + [(BEND * numpy.sin(t), BEND * (1 - numpy.cos(t)), 0.0) for t in turns]


class WireSource(unittest.TestCase):
    def setUp(self):
        self.view = simple.CreateView("RenderView")
        self.view.ViewSize = [120, 100]
        simple.SetActiveView(self.view)
        SetHaptics(DeviceName="fed", VirtualTime=1, Stiffness=STIFFNESS, Scale=1000, FitOnTouch=0)
        line = simple.PolyLineSource(registrationName="line", Points=[x for p in middle_line() for x in p])
        self.tube = simple.Tube(registrationName="tube", Input=line, Radius=RADIUS, NumberofSides=32, Capping=0)
        self.hand = GetHapticSession()
        self.hand.SetHandPosition(0, 0, 0)

    def tearDown(self):
        LetGo()
        HoldMechanism(None)
        for source in list(simple.GetSources().values()):
            simple.Delete(source)
        simple.Delete(self.view)

    def wire(self, **keys):
        wire = PlaceWire(self.tube, length=60, beams=20, mouth=(-8, 0, 0), **keys)
        simple.Show(wire, self.view)
        return wire

    def on_wall(self, inside, outside):
        """The first place of the tube's wall on that line."""
        wall, data = vtkOBBTree(), servermanager.Fetch(self.tube)
        wall.SetDataSet(data)
        wall.BuildLocator()
        places = vtkPoints()
        wall.IntersectWithLine(inside, outside, places, None)
        return numpy.array(places.GetPoint(0))

    def pushed(self, wire, steps=301):
        """Force on the hand in each tick of 0.1 u."""
        HoldMechanism(wire)
        self.hand.SetHandPosition(0, 0, 0)
        Touch()
        self.hand.Step(TICKS_TO_ENGAGE)
        forces = []
        for step in range(steps):
            self.hand.SetHandPosition(0.1 * step, 0, 0)
            self.hand.Step(1)
            self.hand.Update()
            forces.append(list(self.hand.GetForce()))
        return numpy.array(forces)

    def test_the_wire_goes_round_the_bend_of_a_tube_that_no_file_has(self):
        wire = self.wire(friction=0.1)
        forces = self.pushed(wire)
        self.hand.Step(100)
        state = HapticState()
        self.assertAlmostEqual(state["WirePushed"], 30.0, delta=0.3)
        self.assertGreater(state["WireWallForce"], 0.0)
        self.assertGreater(-forces[-1, 0], 0.0)  # the wall resists
        self.assertAlmostEqual(self.hand.GetDepth(), 1000 * state["ForceMagnitude"] / STIFFNESS, delta=1e-9)  # u: of the spring
        bounds = [0.0] * 6
        self.assertTrue(self.hand.GetSceneBounds(bounds))
        self.assertAlmostEqual(bounds[0], -10.0, delta=0.01)  # those of the tube, not of the sheath
        # The tip is where 30 u along the tube are, up to the clearance to the wall.
        simple.Render(self.view)
        data = servermanager.Fetch(wire)
        points = vtk_to_numpy(data.GetPoints().GetData())[vtk_to_numpy(data.GetPointData().GetArray("Body")) == 0]
        turn = (30.0 - 8.0) / BEND
        tip = numpy.array([BEND * numpy.sin(turn), BEND * (1 - numpy.cos(turn)), 0.0])
        self.assertLess(numpy.linalg.norm(points - tip, axis=1).min(), RADIUS)
        self.assertLess(numpy.linalg.norm(points[points[:, 1] > 5] - [0, BEND, 0], axis=1).max(), BEND + RADIUS + 0.05)
        PutBack()

    def test_the_scene_file_that_it_writes_is_felt_as_the_filter_is(self):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "wire.json")
            felt = self.pushed(self.wire(friction=0.1, tip="angled", tip_length=5, file=file))
            LetGo()
            body = json.loads(pathlib.Path(file).read_text())["bodies"][0]
            self.assertEqual((body["young_Pa"], body["tip"], body["friction"], body["beams"]), (6e10, "angled", 0.1, 20))
            read = servermanager.sources.HapticMechanism(FileName=file)
            servermanager.ParaViewPipelineController().RegisterPipelineProxy(read, "read")
            simple.Show(read, self.view)
            numpy.testing.assert_allclose(self.pushed(read), felt, atol=1e-9)
        self.assertGreater(numpy.abs(felt).max(), 0.05)

    def test_a_mouth_that_was_picked_on_the_wall_goes_to_the_middle_of_the_vessel(self):
        for t, towards in ((-8.0, (1, 0, 0)), (20.0, (numpy.cos(0.8), numpy.sin(0.8), 0))):
            middle = numpy.array([t, 0, 0]) if t < 0 else numpy.array([BEND * numpy.sin(0.8), BEND * (1 - numpy.cos(0.8)), 0])
            for turn in numpy.radians((10, 100, 215)):
                aside = numpy.cos(turn) * numpy.array([0, 0, 1]) + numpy.sin(turn) * numpy.cross([0, 0, 1], towards)
                for away in (0.0, 0.4, 0.9):  # of the radius, from the wall
                    picked = self.on_wall(middle, middle + 2 * RADIUS * aside)
                    mouth = picked + away * (middle - picked)
                    with tempfile.TemporaryDirectory() as folder:
                        file = os.path.join(folder, "wire.json")
                        PlaceWire(self.tube, file=file, length=20, mouth=mouth, direction=towards, centred=True)
                        placed = json.loads(pathlib.Path(file).read_text())["bodies"][0]["mouth"]
                    numpy.testing.assert_allclose(placed, middle, atol=0.02 * RADIUS)
                    numpy.testing.assert_allclose(numpy.dot(placed - mouth, towards), 0.0, atol=1e-9)

    def test_a_mouth_without_a_wall_all_around_stays(self):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "wire.json")
            PlaceWire(self.tube, file=file, length=20, mouth=(0, 9, 0), direction=(1, 0, 0), centred=True)
            self.assertEqual(json.loads(pathlib.Path(file).read_text())["bodies"][0]["mouth"], [0, 9, 0])

    def test_the_material_is_an_assumption_that_is_said(self):
        wire = self.wire()
        self.assertIn("6e+10 Pa is assumed for NiTi", SoftText(wire))
        simple.SetProperties(wire, Material="Other", YoungsModulus=1e10)
        self.assertNotIn("assumed", SoftText(wire))

    def test_a_vessel_that_becomes_too_narrow_is_refused_and_the_wire_comes_back_with_it(self):
        self.pushed(self.wire(), steps=50)
        self.tube.Radius = 0.2  # thinner than the wire's .25
        simple.Render(self.view)
        HapticUpdate()
        self.hand.Step(200)
        self.assertIn("thicker than the vessel", HapticState()["Problem"])
        self.assertEqual(HapticState()["ForceMagnitude"], 0.0)
        self.tube.Radius = RADIUS
        simple.Render(self.view)
        HapticUpdate()
        self.hand.Step(200)
        self.assertEqual(HapticState()["Problem"], "")

    def test_each_bad_input_is_a_sentence(self):
        with tempfile.TemporaryDirectory() as folder:
            missing = os.path.join(folder, "nowhere", "wire.json")
            for keys, said in (({"diameter": float("nan")}, "diameter"), ({"length": -1}, "length"), ({"diameter": 5}, "thicker"),
                               ({"direction": (0, 0, 0)}, "direction"), ({"tip": "hook"}, "tip"), ({"young_Pa": 0}, "young_Pa|stiff"),
                               ({"unit": 0}, "unit_m"), ({"tip": "bent"}, "no tip of a wire"), ({"colour": 1}, "no key of a wire"),
                               ({"file": missing}, "no folder")):
                with self.subTest(keys), self.assertRaisesRegex(HapticRefusal, said):
                    HoldMechanism(PlaceWire(self.tube, **keys))
            with self.assertRaisesRegex(HapticRefusal, "cannot be opened as a vessel"):
                PlaceWire(os.path.join(folder, "none.vtp"))


if __name__ == "__main__":
    unittest.main()
