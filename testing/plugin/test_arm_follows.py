# SPDX-License-Identifier: GPL-3.0-or-later
"""Haptic Arm with Follow Hand: the drawn tip is the hand of the session, at any map, and nothing of the arm is touched."""

import json
import math
import os
import pathlib
import sys
import tempfile
import unittest

from paraview import servermanager, simple

from haptic_proxies import HapticArm, put  # the plugin adds the source to that namespace
from view_fixture import ViewTest

ARMS = pathlib.Path(os.environ["PALPATE_SOURCE_DIR"]) / "data" / "arms"
SCALE = 300.0  # u/m
OFFSET = (4.0, -3.0, 2.0)  # u
TURN = (0.5, 0.5, 0.5, 0.5)  # x of the device is y of the scene, y is z, z is x
PATH = [(0.01 * math.sin(0.3 * i), 0.012 * math.cos(0.2 * i), 0.002 * i - 0.01) for i in range(11)]  # m, in the work space


def to_scene(x, y, z):
    return [o + SCALE * p for o, p in zip(OFFSET, (z, x, y))]


class Follows(ViewTest):
    def setUp(self):
        super().setUp()
        put(self.proxy, "FitOnTouch", 0)
        put(self.proxy, "Scale", SCALE)
        put(self.proxy, "Rotation", *TURN)
        put(self.proxy, "Offset", *OFFSET)
        self.show(simple.Sphere(registrationName="Ball", Center=[50, 0, 0], Radius=5))

    def arm(self, name, follows=1):
        source = HapticArm(registrationName="Arm", Arm=name, FollowHand=follows)
        self.show(source)
        return source

    def touch(self, *hand):
        self.session.SetHandPosition(*to_scene(*hand))
        self.follow()
        put(self.proxy, "Touching", 1)
        self.session.Step(10)
        self.look()

    def look(self):
        """As the panel does for each picture."""
        self.session.Update()
        self.follow()
        simple.Render(self.view)

    def links(self, source):
        drawn = servermanager.Fetch(source)
        return [[drawn.GetPoint(drawn.GetCell(c).GetPointId(i)) for i in range(drawn.GetCell(c).GetNumberOfPoints())]
                for c in range(drawn.GetNumberOfCells())]

    def test_the_drawn_tip_is_where_the_hand_of_the_session_is_after_any_ticks(self):
        for name in ("woodenhaptics-2015", "falcon"):
            with self.subTest(arm=name):
                source = self.arm(name)
                self.touch(*PATH[0])
                for place in PATH:
                    self.session.SetHandPosition(*to_scene(*place))
                    self.session.Step(7)
                    self.look()
                    hand = self.session.GetHandPosition()
                    self.assertLess(math.dist(hand, to_scene(*place)), 1e-9 * SCALE)
                    for line in self.links(source):
                        self.assertLess(math.dist(line[-1], hand), 1e-9 * math.hypot(*hand))
                put(self.proxy, "Touching", 0)
                simple.Delete(source)

    def test_its_links_have_their_lengths_in_the_unit_of_the_scene(self):
        file = json.loads((ARMS / "woodenhaptics-2015.json").read_text())
        source = self.arm("woodenhaptics-2015")
        self.touch(*PATH[3])
        (line,) = self.links(source)
        for length, a, b in zip((file["column_m"], file["upper_m"], file["fore_m"]), line, line[1:]):
            self.assertAlmostEqual(math.dist(a, b), SCALE * length, delta=1e-9 * SCALE)

    def test_a_clutch_moves_the_arm_and_leaves_its_tip(self):
        speed, ticks = 0.02, 100  # m/s along the device's x, which is the scene's y
        source = self.arm("woodenhaptics-2015")
        put(self.proxy, "DeviceName", "simulated-ideal")
        self.session.ClearStrokePoints()
        for x in (-0.03, 0.03):
            self.session.AddStrokePoint(*to_scene(x, 0, 0))
        self.session.SetSetting("StrokeSpeed", speed)
        self.touch(0, 0, 0)
        self.session.Step(300)
        put(self.proxy, "Clutch", 1)
        self.look()
        self.session.Step(1)
        self.look()
        (before,) = self.links(source)
        self.session.Step(ticks)
        self.look()
        (after,) = self.links(source)
        self.assertLess(math.dist(after[-1], self.session.GetHandPosition()), 1e-9 * SCALE)
        self.assertLess(math.dist(after[-1], before[-1]), 1e-9 * SCALE)
        way = [b - a for a, b in zip(before[0], after[0])]
        self.assertAlmostEqual(way[1], -SCALE * speed * ticks / 1000, delta=0.1 * SCALE * speed * ticks / 1000)
        self.assertLess(math.hypot(way[0], way[2]), 0.01 * abs(way[1]))

    def test_it_is_at_its_typed_hand_before_and_after_the_touch_and_without_follow_hand(self):
        source = self.arm("woodenhaptics-2015")
        typed = self.links(source)
        self.touch(*PATH[2])
        self.assertNotEqual(self.links(source), typed)
        put(self.proxy, "Touching", 0)
        self.scene.ShowHanded()
        simple.Render(self.view)
        self.assertEqual(self.links(source), typed)
        source.FollowHand = 0
        self.touch(*PATH[2])
        self.assertEqual(self.links(source), typed)

    def test_neither_its_links_nor_what_a_filter_makes_of_them_is_touched(self):
        source = self.arm("falcon")
        put(self.proxy, "LineRadius", 0.5)
        self.show(simple.Tube(registrationName="Tube", Input=source, Radius=0.5))
        self.touch(*PATH[0])
        for name in ("Arm", "Tube"):
            self.assertIn(f"Not touched: {name}: the arm follows the hand", self.scene.GetReport())
        self.assertEqual(self.scene.GetNumberOfSurfaces(), 1)
        self.session.SetHandPosition(*to_scene(*PATH[1]))
        self.session.Step(5)
        self.assertFalse(self.follow(), "an arm that moves makes no other scene")
        source.FollowHand = 0
        self.look()
        self.assertEqual(self.scene.GetNumberOfSurfaces(), 3)

    def test_a_state_file_keeps_it(self):
        self.arm("woodenhaptics-2015")
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "arm.pvsm")
            simple.SaveState(file)
            simple.Delete(simple.FindSource("Arm"))
            simple.LoadState(file)
        self.assertEqual(simple.FindSource("Arm").FollowHand, 1)
        for view in simple.GetRenderViews()[1:]:
            simple.Delete(view)


if __name__ == "__main__":
    # A SystemExit would skip pvpython's own ending, which closes views before the display.
    if not unittest.main(exit=False).result.wasSuccessful():
        sys.exit(1)
