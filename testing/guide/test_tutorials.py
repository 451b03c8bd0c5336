# SPDX-License-Identifier: GPL-3.0-or-later
"""Each tutorial of the guide runs as it stands there and leaves a picture; its state file opens and is touched."""

import os
import re
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
os.environ.setdefault("PALPATE_DATA", os.path.join(os.environ["PALPATE_SOURCE_DIR"], "data/cache"))

from paraview import simple  # noqa: E402

import tutorials  # noqa: E402
from palpate.simple import GetHapticSession, HapticState, LetGo, SetHaptics, Touch  # noqa: E402

PUSHED_N = 0.5  # the scripts stop there
FULL = "PALPATE_TEST_FULL" in os.environ  # software draws a skull for half a minute


class Tutorials(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)

    def play(self, name):
        """The forces that it prints [N]; its picture and its state are looked at."""
        forces_N = [float(number) for number in re.findall(r"([\d.]+) N\b", tutorials.play(name, self.folder))]
        self.assertGreater((self.folder / f"{name}.png").stat().st_size, 10_000)
        LetGo()
        self.clear()
        simple.LoadState(str(self.folder / f"{name}.pvsm"))
        SetHaptics(DeviceName="fed", VirtualTime=1)
        hand = GetHapticSession()
        hand.SetHandPosition(0, 0, 0)
        Touch(simple.GetActiveViewOrCreate("RenderView"))
        hand.Step(1200)
        self.assertEqual(HapticState()["StateText"], "engaged")
        LetGo()
        self.clear()
        return forces_N

    @staticmethod
    def clear():
        for view in simple.GetViews():
            simple.Delete(view)
        simple.ResetSession()

    def test_flow(self):
        # 1.5 mm of the hand off its streamline, at 500 N/m, in both numbers.
        for force_N in self.play("flow"):
            self.assertAlmostEqual(force_N, 500 * 1.5e-3, delta=0.02)

    def test_labyrinth(self):
        self.assertGreaterEqual(self.play("labyrinth")[0], PUSHED_N)

    def test_skull_and_brain(self):
        for name in set(tutorials.present()) & {"skull", "brain"} if FULL else ():
            forces_N = self.play(name)
            self.assertGreaterEqual(min(forces_N[:2]), PUSHED_N)
            self.assertGreater(forces_N[0], forces_N[-1] if name == "brain" else 0.0)  # the value 90 lies below 60


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
