# SPDX-License-Identifier: GPL-3.0-or-later
"""A mechanism held in pvpython as a person holds it: a needle through a wall, felt, seen, changed, kept in a state."""

import json
import os
import pathlib
import tempfile
import unittest

from paraview import servermanager, simple

simple.LoadPlugin(os.environ["PALPATE_PLUGIN"], remote=False, ns=globals())
from palpate.simple import (AddLaw, BreakLaw, GetHapticSession, HapticRefusal, HapticState, HoldMechanism, Laws,  # noqa: E402
                            LetGo, RemoveLaw, SetHaptics, Touch)

SCENES = pathlib.Path(os.environ["PALPATE_SOURCE_DIR"]) / "data" / "mechanisms"
SCALE, STIFFNESS = 1000.0, 500.0  # u/m, N/m
TICKS_TO_ENGAGE = 1500
TIP, FACE = 150.0, -8.0  # u: of the needle before the hand, of the wall's lower side


class Mechanism(unittest.TestCase):
    def setUp(self):
        self.view = simple.CreateView("RenderView")
        SetHaptics(DeviceName="fed", VirtualTime=1, FitOnTouch=0, Scale=SCALE, Stiffness=STIFFNESS, Passivity=0)

    def tearDown(self):
        LetGo()
        SetHaptics(MechanismSource="", MechanismLaws="")
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
        GetHapticSession().SetHandPosition(0, 0, tip - TIP)

    def press(self, tip, ticks=200):
        self.lead(tip)
        GetHapticSession().Step(ticks)
        return HapticState()

    def test_a_needle_presses_pierces_and_drags_and_its_table_and_picture_say_so(self):
        source = self.hold()
        self.assertIn("2 laws", HapticState()["MechanismText"])
        self.assertEqual([law["Law"] for law in Laws()], ["skin", "capsule"])
        self.assertEqual(HapticState()["ForceMagnitude"], 0.0)
        pressed = self.press(FACE + 1.0)
        self.assertLess(pressed["Force"][2], 0.0)
        self.assertEqual(Laws()[0]["Phase"], "closed")
        self.assertAlmostEqual(Laws()[0]["Force"], -pressed["Force"][2], delta=1e-6)
        for depth in range(2, 14):
            self.press(FACE + depth, 20)
        inside = self.press(FACE + 14)
        self.assertEqual(Laws()[0]["Phase"], "inside")
        self.assertAlmostEqual(-inside["Force"][2], 0.4, delta=1e-3)
        simple.Render(self.view)
        top = servermanager.Fetch(source).GetBounds()[5]
        self.assertAlmostEqual(top, 58.0, delta=1e-3)  # of the liver: the needle has come along
        low = servermanager.Fetch(source).GetBounds()[4]
        self.assertAlmostEqual(low, FACE + 14 - TIP, delta=2.0)

    def test_laws_are_added_taken_away_and_broken_and_a_state_keeps_them(self):
        self.hold("suture.json", TIP)  # the hand at the origin, 40 before the knot
        self.assertEqual([law["Kind"] for law in Laws()], ["break"])
        self.press(TIP + 1.0)
        self.assertEqual(Laws()[0]["Phase"], "closed")
        BreakLaw("thread")
        self.assertLess(self.press(TIP + 1.0, 1000)["ForceMagnitude"], 1e-6)
        self.assertEqual(Laws()[0]["Phase"], "gone")
        AddLaw(name="tape", kind="attachment", a="needle", b="tissue", point_a=[0, 0, 40], point_b=[0, 0, 40])
        self.assertEqual([law["Law"] for law in Laws()], ["thread", "tape"])
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "mechanism.pvsm")
            simple.SaveState(file)
            self.assertIn("tape", pathlib.Path(file).read_text())
        RemoveLaw("thread")
        self.assertEqual([law["Law"] for law in Laws()], ["tape"])
        for call, words in ((lambda: RemoveLaw("nothing"), "there is no law"), (lambda: BreakLaw("nothing"), "there is no law"),
                            (lambda: AddLaw(name="x", kind="weld", a="needle", b="tissue"), "there are contact")):
            with self.assertRaisesRegex(HapticRefusal, words):
                call()

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
            self.assertIn("not met within a tick's work", HapticState()["MechanismText"])
            self.assertGreater(HapticState()["CappedTicks"], TICKS_TO_ENGAGE / 2)
            self.assertEqual(HapticState()["ForceMagnitude"], 0.0)

    def test_a_source_that_is_deleted_while_it_is_held_lets_the_hand_go(self):
        source = self.hold()
        self.assertGreater(self.press(FACE + 1.0)["ForceMagnitude"], 0.0)
        simple.Delete(source)
        HapticState()
        self.assertLess(self.press(FACE + 1.0, 1000)["ForceMagnitude"], 1e-6)
        self.assertIn("is not there", HapticState()["MechanismText"])


if __name__ == "__main__":
    unittest.main()
