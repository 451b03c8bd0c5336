# SPDX-License-Identifier: GPL-3.0-or-later
"""`palpate turn`: a value along a path is felt by turning; the force is that of the formula."""

import csv
import subprocess
import unittest

from palpate_cli import PROGRAM, CommandLineTest

# Down by 3 in 30 mm, then up by 2 in 30 mm: the steeper one draws with the force that was set.
PLACES = [(-0.03, 4.0), (0.0, 1.0), (0.03, 3.0)]
HARDEST = 0.3


def downhill(s):
    """-dV/ds of the piece in which s lies, in N; None near a kink, where the tick before counts."""
    scale = HARDEST / 100.0
    for (a, va), (b, vb) in zip(PLACES, PLACES[1:]):
        if a + 1e-3 < s < b - 1e-3:
            return scale * (va - vb) / (b - a)
    return None


class Turn(CommandLineTest):
    def write(self, text):
        path = self.folder / "world.csv"
        path.write_text(text)
        return str(path)

    def test_a_simulated_hand_feels_the_slope_of_the_value(self):
        world = self.write("s,value\n" + "".join(f"{s},{v}\n" for s, v in PLACES))
        out = self.folder / "felt.csv"
        command = [PROGRAM, "turn", world, "--hardest", str(HARDEST), "--seconds", "6", "--csv", str(out)]
        run = subprocess.run(command, capture_output=True, text=True, timeout=60)
        self.assertEqual(run.returncode, 0, run.stderr)
        with open(out, newline="", encoding="ascii") as file:
            rows = [{k: float(v) for k, v in row.items()} for row in csv.DictReader(file)]
        self.assertEqual(len(rows), 600)
        self.assertAlmostEqual(rows[-1]["t"], 6.0)
        compared = 0
        for row in rows:
            expected = downhill(row["s"])
            if row["t"] > 2.0 and expected is not None:  # the force has come
                self.assertAlmostEqual(row["force"], expected, 9)
                compared += 1
        self.assertGreater(compared, 200)

    def test_bad_input_is_named(self):
        self.refused("turn", "nowhere.csv", saying=["nowhere.csv", "cannot be read"])
        self.refused("turn", self.write("s,value\n0,1\n0,2\n"), saying=["world.csv", "line 3"])
        good = self.write("s,value\n0,1\n0.01,2\n")
        self.refused("turn", good, "--stop", "1e9", saying=["rendered stably"])
        self.refused("turn", good, "--device", "fed", saying=["fed", "no force"])
        self.refused("turn", good, "--hardest", "-1", saying=["--hardest"])


if __name__ == "__main__":
    unittest.main()
