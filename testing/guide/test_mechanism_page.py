# SPDX-License-Identifier: GPL-3.0-or-later
"""Every command of docs/mechanisms.md runs as it stands there, one after the other, and the needle pierces as the page says."""

import csv
import os
import shlex
import subprocess
import sys
import tempfile
import unittest
from contextlib import chdir
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

from page_commands import commands  # noqa: E402
from paraview import simple  # noqa: E402

from palpate.simple import GetHapticSession, HapticState, Constraints, LetGo, SetHaptics  # noqa: E402

ROOT = os.environ["PALPATE_SOURCE_DIR"]
TICKS_TO_ENGAGE = 1500
TIP, FACE, DRAG = 150, -8, 0.4  # of data/mechanisms/needle.json: u, u, N


class MechanismPage(unittest.TestCase):
    def test_a_needle_through_a_wall(self):
        view = simple.CreateView("RenderView")
        simple.SetActiveView(view)
        SetHaptics(DeviceName="fed", VirtualTime=1, FitOnTouch=0, Scale=1000, Stiffness=500)
        hand = GetHapticSession()
        hand.SetHandPosition(0, 0, FACE - 5 - TIP)
        printed = []
        said = {"print": printed.append}
        blocks = commands("mechanisms.md", "A needle through a wall").split("print(Constraints())")
        with chdir(ROOT):
            exec(compile(blocks[0], "mechanisms.md", "exec"), said)  # the page itself is the program
            hand.Step(TICKS_TO_ENGAGE)
            for depth in range(15):
                hand.SetHandPosition(0, 0, FACE + depth - TIP)
                hand.Step(40)
            hand.Step(200)
            self.assertAlmostEqual(HapticState()["ForceMagnitude"], DRAG, delta=0.02 * DRAG)
            changes, broken = blocks[1].split("\nBreakConstraint")
            exec(compile("print(Constraints())" + changes, "mechanisms.md", "exec"), said)
            hand.Step(200)
            exec(compile("BreakConstraint" + broken, "mechanisms.md", "exec"), said)
        self.assertEqual([law["Constraint"] for law in printed[0]], ["skin", "capsule"])
        self.assertEqual(printed[0][0]["Phase"], "inside")
        hand.Step(200)
        self.assertEqual(Constraints()[0]["Phase"], "gone")
        LetGo()
        SetHaptics(MechanismSource="", MechanismConstraints="")
        for proxy in [*simple.GetSources().values(), *simple.GetRenderViews()]:
            simple.Delete(proxy)

    def test_a_source_that_is_loose_is_pushed_with_the_force_that_the_page_names(self):
        view = simple.CreateView("RenderView")
        simple.SetActiveView(view)
        SetHaptics(DeviceName="fed", VirtualTime=1, FitOnTouch=0, Scale=1000, Stiffness=2000)
        hand = GetHapticSession()
        behind, middle, speed = -36, 10, 0.05  # mm, mm, mm a tick
        hand.SetHandPosition(behind, 0, middle)
        printed = []
        page = commands("mechanisms.md", "A source that is loose").split("build/bin/palpate")[0]
        exec(compile(page, "mechanisms.md", "exec"), {"print": printed.append})
        self.assertEqual(printed, ["stone: loose, 0.12 kg\n"])
        hand.Step(TICKS_TO_ENGAGE)
        forces = []
        for tick in range(800):
            hand.SetHandPosition(behind + speed * tick, 0, middle)
            hand.Step(1)
            hand.Update()
            forces.append(-hand.GetForce()[0])
        self.assertAlmostEqual(sum(forces[-300:]) / 300, 0.353, delta=0.01)
        LetGo()
        SetHaptics(SourcesText="", SceneUnit=0, FrictionStatic=0, FrictionKinetic=0)
        for proxy in [*simple.GetSources().values(), *simple.GetRenderViews()]:
            simple.Delete(proxy)

    def test_the_program_checks_and_touches_it(self):
        with tempfile.TemporaryDirectory() as folder:
            way = Path(folder) / "way.csv"
            way.write_text("t,x,y,z\n" + "".join(f"{i / 1000},0,0,{FACE - 1 - TIP + 0.02 * i}\n" for i in range(1200)))
            out = Path(folder) / "out.csv"
            for line in commands("mechanisms.md", "Without a device").splitlines():
                words = [{"way.csv": str(way), "out.csv": str(out)}.get(word, word) for word in shlex.split(line)]
                self.assertEqual(words[0], "build/bin/palpate")
                subprocess.run([os.environ["PALPATE_PROGRAM"], *words[1:]], check=True, cwd=ROOT)
            with open(out, newline="", encoding="utf-8") as file:
                self.assertAlmostEqual(float(list(csv.DictReader(file))[-1]["force_z"]), -DRAG, delta=0.02 * DRAG)


if __name__ == "__main__":
    unittest.main()
