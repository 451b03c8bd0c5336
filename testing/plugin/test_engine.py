# SPDX-License-Identifier: GPL-3.0-or-later
"""data/engine.py leads a probe into a gap and forward: its ball stops at a block in place of the engine, and the state holds it."""

import csv
import math
import os
import pathlib
import subprocess
import tempfile
import unittest

from paraview import simple

simple.LoadPlugin(os.environ["PALPATE_PLUGIN"], remote=False, ns=globals())
from palpate.simple import HapticState, LetGo, Touch  # noqa: E402

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "data" / "engine.py"
FACE = 0.8  # m, where the block ends that stands for the engine
BLOCK = [(x, y, z) for x in (0.5, FACE) for y in (-0.12, 0.2) for z in (0.2, 0.5)]  # the ball is beside it, the rod is not
SIDES = [(1, 2, 4, 3), (5, 7, 8, 6), (1, 5, 6, 2), (3, 4, 8, 7), (1, 3, 7, 5), (2, 6, 8, 4)]
RADIUS, TO_BALL = 0.006, 0.3 - 0.006  # m
CORNERS, PARTS = 24, 12  # of the ball, around it and from its end to the rod
ROUNDED = 1e-6  # m


def write_block(path):
    lines = [f"v {x} {y} {z}" for x, y, z in BLOCK] + ["f " + " ".join(map(str, side)) for side in SIDES]
    path.write_text("\n".join(lines) + "\n")


def ball_x(row):
    """Of the ball's middle, along y from the hand: x of the place and of the turned axis y."""
    w, x, y, z = (float(row[f"proxy_q{name}"]) for name in "wxyz")
    return float(row["proxy_x"]) + TO_BALL * 2.0 * (x * y - w * z)


class Engine(unittest.TestCase):
    def test_the_ball_stops_at_what_stands_before_it_and_the_state_holds_the_probe(self):
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            write_block(folder / "block.obj")
            subprocess.run(["pvpython", str(SCRIPT), str(folder / "block.obj"), str(folder)], check=True)
            subprocess.run([os.environ["PALPATE_PROGRAM"], "touch", str(folder / "block.obj"), "--tool", str(folder / "probe.vtp"),
                            "--path", str(folder / "way.csv"), "--csv", str(folder / "out.csv"), "--scale", "1"], check=True)
            with open(folder / "out.csv", newline="", encoding="utf-8") as file:
                rows = list(csv.DictReader(file))
            self.check_way(rows)
            simple.LoadState(str(folder / "engine.pvsm"))
            Touch()
            self.assertIn("Probe", HapticState()["ToolText"])
            LetGo()
        for proxy in [*simple.GetSources().values(), *simple.GetRenderViews()]:
            simple.Delete(proxy)

    def check_way(self, rows):
        for row in rows:
            if float(row["device_x"]) > FACE + RADIUS:
                self.assertEqual([float(row[f"force_{axis}"]) for axis in "xyz"], [0.0] * 3)
        flattest = RADIUS * math.cos(math.pi / CORNERS) * math.cos(math.pi / (2.0 * PARTS))  # the middle of a facet
        self.assertLessEqual(ball_x(rows[-1]), FACE + RADIUS + ROUNDED)
        self.assertGreaterEqual(ball_x(rows[-1]), FACE + flattest - ROUNDED)
        self.assertGreater(float(rows[-1]["force_x"]), 0.0)


if __name__ == "__main__":
    unittest.main()
