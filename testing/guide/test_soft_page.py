# SPDX-License-Identifier: GPL-3.0-or-later
"""Every command of docs/soft.md runs as it stands there, one after the other, and its bodies are pressed."""

import csv
import math
import os
import shlex
import subprocess
import sys
import tempfile
import unittest
from contextlib import chdir
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
os.environ.setdefault("PALPATE_DATA", os.path.join(os.environ["PALPATE_SOURCE_DIR"], "data/cache"))

from paraview import simple  # noqa: E402

from page_commands import commands  # noqa: E402
from palpate.simple import GetHapticSession, HapticState, LetGo, SetHaptics, SoftText  # noqa: E402

TICKS_TO_ENGAGE = 1200
YOUNG, POISSON, RADIUS, HEIGHT = 20e3, 0.4, 0.01, 0.05  # of the page's block: Pa, 1, m, m


def hertz(depth):
    """On a layer bonded below (Dimitriadis et al. 2002) [N]; lengths in metres."""
    chi = math.sqrt(RADIUS * depth) / HEIGHT
    a = -(1.2876 - 1.4678 * POISSON + 1.3442 * POISSON**2) / (1 - POISSON)
    layer = 1 - 2 * a / math.pi * chi + 4 * a**2 / math.pi**2 * chi**2
    return 4 / 3 * YOUNG / (1 - POISSON**2) * math.sqrt(RADIUS) * depth**1.5 * layer


class SoftPage(unittest.TestCase):
    def setUp(self):
        self.view = simple.CreateView("RenderView")
        simple.SetActiveView(self.view)
        SetHaptics(DeviceName="fed", VirtualTime=1, FitOnTouch=0, Scale=1000, Stiffness=400)
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.said = {"print": lambda *words: self.printed.append(" ".join(map(str, words)))}
        self.printed = []

    def tearDown(self):
        LetGo()
        SetHaptics(SoftSource="")
        for view in simple.GetViews():
            simple.Delete(view)
        simple.ResetSession()

    def run_page(self, title):
        exec(compile(commands("soft.md", title), "soft.md", "exec"), self.said)  # the page itself is the program

    def press(self, x, y, start, end):
        """From above, slowly, and until it rests: the proxy's height."""
        hand = GetHapticSession()
        hand.SetHandPosition(x, y, start)
        hand.Step(TICKS_TO_ENGAGE)
        for step in range(100):
            hand.SetHandPosition(x, y, start + (end - start) * (step + 1) / 100)
            hand.Step(4)
        hand.Step(400)
        simple.Render(self.view)
        return HapticState()["ProxyPosition"][2]

    def test_the_block_and_the_skin_on_it(self):
        GetHapticSession().SetHandPosition(2, 3, 70)
        self.run_page("A block")
        depth = 1e-3 * (50 + 10 - self.press(2, 3, 70, 58.5))
        self.assertGreater(depth, 2e-4)
        self.assertAlmostEqual(HapticState()["Force"][2] / hertz(depth), 1.0, delta=0.07)
        self.run_page("A fine surface on coarse tetrahedra")
        self.assertIn("0 of ", self.printed[-1])
        self.press(2, 3, 58.5, 50)
        self.assertGreater(HapticState()["Force"][2], 0.5)
        self.assertNotIn("skin", GetHapticSession().GetSceneReport().lower())
        picture = self.folder / "skin.png"
        simple.SaveScreenshot(str(picture), self.view, ImageResolution=[320, 240])
        self.assertGreater(picture.stat().st_size, 4_000)

    def test_a_path_over_the_block(self):
        block = simple.Transform(Input=simple.Wavelet(WholeExtent=[-4, 4, -4, 4, 0, 4]))
        block.Transform.Scale = [0.0125] * 3
        with chdir(self.folder):
            simple.SaveData("block.vtu", proxy=simple.Tetrahedralize(Input=block))
            with open("way.csv", "w", encoding="utf-8") as way:
                way.write("t,x,y,z\n")
                way.writelines(f"{i / 1000},0.002,0.003,{0.061 - 0.00002 * i}\n" for i in range(101))
            words = shlex.split(commands("soft.md", "Without a device"))
            self.assertEqual(words[0], "build/bin/palpate")
            subprocess.run([os.environ["PALPATE_PROGRAM"], *words[1:]], check=True)
            with open("out.csv", encoding="utf-8") as out:
                last = list(csv.DictReader(out))[-1]
        depth = HEIGHT + RADIUS - float(last["proxy_z"])
        self.assertAlmostEqual(float(last["force_z"]) / hertz(depth), 1.0, delta=0.07)

    if (Path(os.environ["PALPATE_DATA"]) / "liver.nii").is_file() and "PALPATE_TEST_FULL" in os.environ:

        def test_the_liver(self):
            with chdir(Path(os.environ["PALPATE_DATA"]).parents[1]):
                self.said.update({name: getattr(simple, name) for name in ("OpenDataFile", "SoftBody")})
                self.run_page("A liver")
            self.said["body"].UpdatePipeline()
            self.assertGreater(self.said["body"].GetDataInformation().GetNumberOfCells(), 1000)
            self.assertIn("assumed", SoftText(self.said["body"]))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
