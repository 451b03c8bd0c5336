# SPDX-License-Identifier: GPL-3.0-or-later
"""Each tutorial of the guide runs as it stands there and leaves a picture; its state file opens and is touched."""

import math
import os
import re
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
os.environ.setdefault("PALPATE_DATA", os.path.join(os.environ["PALPATE_SOURCE_DIR"], "data/cache"))

from paraview import servermanager, simple  # noqa: E402

import tutorials  # noqa: E402
from palpate.simple import GetHapticSession, HapticState, LetGo, SetHaptics, Touch  # noqa: E402

PUSHED_N = 0.5  # the scripts stop there
FELT_N = 0.1  # a hand feels that something is there
STEPS = 400  # of a path of at most 100 mm, each of 5 ms: 50 mm/s
# Software draws a skull for half a minute.
DRAWN = {"skull", "brain"} & set(tutorials.present() if "PALPATE_TEST_FULL" in os.environ else ())


class Tutorials(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)

    def play(self, name, first, last):
        """The forces that it prints [N]; its picture is looked at, and its state touched on the path between two places."""
        self.said = tutorials.play(name, self.folder)
        forces_N = [float(number) for number in re.findall(r"(-?[\d.]+) N\b", self.said)]
        self.assertGreater((self.folder / f"{name}.png").stat().st_size, 10_000)
        LetGo()
        self.clear()
        simple.LoadState(str(self.folder / f"{name}.pvsm"))
        SetHaptics(DeviceName="fed", VirtualTime=1)
        hand = GetHapticSession()
        hand.SetHandPosition(*first)
        Touch(simple.GetActiveViewOrCreate("RenderView"))
        hand.Step(1200)
        self.assertEqual(HapticState()["StateText"], "engaged")
        self.assertGreater(self.most_N(hand, first, last), FELT_N)
        LetGo()
        self.clear()
        return forces_N

    @staticmethod
    def most_N(hand, first, last):
        """The largest force on the straight path, in as many steps as keep a hand slow."""
        most_N = 0.0
        for step in range(1, STEPS + 1):
            hand.SetHandPosition(*(start + (end - start) * step / STEPS for start, end in zip(first, last)))
            hand.Step(5)
            hand.FinishField()
            most_N = max(most_N, HapticState()["ForceMagnitude"])
        return most_N

    @staticmethod
    def clear():
        for view in simple.GetViews():
            simple.Delete(view)
        simple.ResetSession()

    def test_flow(self):
        # 1.5 mm of the hand off its streamline, at 500 N/m, in both numbers.
        forces_N = self.play("flow", (1.5, 0, 0), (1.53, 0, 0))
        self.assertEqual(len(forces_N), 2)
        for force_N, sign in zip(forces_N, (1, -1)):  # how strong, and back along x
            self.assertAlmostEqual(force_N, sign * 500 * 1.5e-3, delta=0.02)

    def test_labyrinth(self):
        start = servermanager.Fetch(simple.HapticLabyrinth(World="chartres")).GetFieldData().GetArray("Start").GetTuple(0)
        forces_N = self.play("labyrinth", (*start[:2], 0), (start[0], start[1] + 10, 0))
        self.assertEqual(len(forces_N), 1)
        self.assertGreaterEqual(forces_N[0], PUSHED_N)
        # The way in leads to the fifth ring, which ends at the circle of radius 9; a ball of 0.3 stops before, and at
        # 300 N/m and 10 mm a unit the hand goes on to 0.5 N, found in steps of 0.05 and printed to 0.01.
        stopped = -math.sqrt(9**2 - start[0]**2) - 0.3 - start[1] + PUSHED_N / 300 / 10e-3
        led = float(re.search(r"([\d.]+) from the start", self.said)[1])
        self.assertGreaterEqual(led, stopped - 0.02)  # a circle is drawn of pieces
        self.assertLessEqual(led, stopped + 0.05 + 0.02)

    def test_spatula(self):
        # Between spatula and rib the liver is compressed.
        first, second = self.play("spatula", (0, 0, 20), (0, 0, 11))
        self.assertGreaterEqual(first, 0.8 * 0.05)  # it yields on while it comes to rest
        self.assertGreaterEqual(second, 0.8 * 0.4)
        contacts = [line for line in self.said.splitlines() if " at (" in line]
        touched = {line.split(" at (")[0] for line in contacts}
        self.assertEqual(touched, {"liver", "rib on liver"})
        for line in contacts:
            x, y, z = (float(number) for number in re.search(r"at \((.*)\) u", line)[1].split(", "))
            if line.startswith("rib"):
                self.assertAlmostEqual(math.hypot(x, z + 21.5), 6, delta=0.3, msg=line)  # on the rod
            else:
                self.assertLessEqual(abs(x), 7.5, line)  # below the spatula
                self.assertLessEqual(abs(y), 20.5, line)

    def test_stone(self):
        # A box of 32 x 28 x 18 mm that slides without a turn: friction times weight, on the floor as on the table. On
        # the side it is lifted against both, less where it stands on the floor with its other edge.
        friction, weight_N = 0.3, 2600 * 0.032 * 0.028 * 0.018 * 9.81
        slides_N = friction * weight_N
        floor, side, table = self.play("stone", (-30, 0, 13), (-10, 0, 13))
        self.assertAlmostEqual(floor, slides_N, delta=0.25 * slides_N)  # on the spring it still swings
        slope = math.atan(6 / 13) + math.atan(friction)
        self.assertGreater(side, 1.5 * slides_N)
        self.assertLess(side, 1.5 * math.tan(slope) * weight_N)
        # The ball pulls the box up or down, by as much as its friction holds.
        self.assertGreaterEqual(table, slides_N / (1 + friction**2))
        self.assertLessEqual(table, math.hypot(1, friction) * slides_N / (1 - friction**2))

    def test_wire(self):
        # The work of bending: half of E I / R^2 for each length that goes round, with a radius within that of the tube less the
        # wire's clearance. At either end of the bend a straight wire fits between inner and outer wall.
        bending_Nmm2, clearance = 6e4 * math.pi * 0.5**4 / 64, 2 - 0.25  # 60 GPa, .5 mm
        round_mm, straight_mm = 70 - 15, math.sqrt(4 * 25 * clearance)
        free, rubs, wall = self.play("wire", (0, 0, 0), (60, 0, 0))
        work, with_friction = (float(number) for number in re.findall(r"([\d.]+) mJ", self.said))
        self.assertGreater(work, 0.5 * bending_Nmm2 / (25 + clearance) ** 2 * (round_mm - 2 * straight_mm))
        self.assertLess(work, 0.5 * bending_Nmm2 / (25 - clearance) ** 2 * round_mm)
        self.assertGreater(with_friction, 1.1 * work)
        self.assertGreater(rubs, 1.2 * free)
        self.assertLess(rubs, math.exp(2 * 0.2 * math.pi) * free)  # a rope on both sides of half a turn
        x, y, z = (float(number) for number in re.search(r"at \((.*)\) mm", self.said)[1].split(", "))
        self.assertAlmostEqual(math.hypot(math.hypot(x, y - 25) - 25, z), 2, delta=0.1)  # on the tube
        self.assertGreater(wall, 0.0)

    if "soft-brain" in tutorials.present():

        def test_soft_brain(self):
            # From 20 mm above the volume: a ball of 15 mm is well within the brain at half of its height.
            forces_N = self.play("soft-brain", *self.from_above(self.bounds("brain.nii.gz"), [20, -20], 20))
            self.assertGreaterEqual(forces_N[0], 0.8 * PUSHED_N)  # it yields on while it comes to rest
            self.assertIn("points are outside the tetrahedra", self.said)
            self.assertIn("Poisson's ratio 0.4 (assumed)", self.said)

    if "skull" in DRAWN:

        def test_skull(self):
            bounds = self.bounds("skull.vtp")
            forces_N = self.play("skull", *self.from_above(bounds, [0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3])]))
            self.assertEqual(len(forces_N), 1)
            self.assertGreaterEqual(forces_N[0], PUSHED_N)

    if "brain" in DRAWN:

        def test_brain(self):
            forces_N = self.play("brain", *self.from_above(self.bounds("brain.nii.gz"), [20, -20]))
            self.assertEqual(len(forces_N), 3)
            self.assertGreaterEqual(min(forces_N[:2]), PUSHED_N)
            self.assertGreater(forces_N[0], forces_N[2])  # the value 90 lies below 60

    @staticmethod
    def bounds(file):
        source = simple.OpenDataFile(os.path.join(os.environ["PALPATE_DATA"], file))
        source.UpdatePipeline()
        return source.GetDataInformation().GetBounds()

    @staticmethod
    def from_above(bounds, place, above=5):
        """A path down to the middle."""
        return (*place, bounds[5] + above), (*place, 0.5 * (bounds[4] + bounds[5]))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
