# SPDX-License-Identifier: GPL-3.0-or-later
"""Random edits of pipeline, views and states while a hand touches: no crash, no force that stays, no hand that is swallowed.

PALPATE_TEST_SEED and PALPATE_TEST_COUNT choose others. In full, a thousand of them, and they leave in memory not more than twice as
much as the same edits when nobody touches, and 40 MB.
"""

import os
import pathlib
import random
import re
import tempfile
import unittest

from played import event, play

FULL = bool(os.environ.get("PALPATE_TEST_FULL"))
SEED = int(os.environ.get("PALPATE_TEST_SEED", "1"))
COUNT = int(os.environ.get("PALPATE_TEST_COUNT", "1000" if FULL else "60"))
SETTLE = 60  # ms: some ticks and a look of the panel


def events(touching, report):
    """The script that ParaView plays."""
    chance = random.Random(SEED)
    lines = [event("hapticPython", f"import random_edits; edits = random_edits.Edits({SEED}, {touching})"), event("hapticWait", 500)]
    for i in range(COUNT):
        if chance.random() < 0.1:
            lines.append(event("hapticUndo", chance.choice((1, 2, 3, -1, -2))))
        else:
            lines.append(event("hapticPython", "edits.step()"))
        lines += [event("hapticWait", SETTLE), event("hapticPython", "edits.check()"), event("hapticWait", SETTLE),
                  event("hapticPython", "edits.check_side()")]
        if i % 20 == 19:
            lines += [event("hapticPython", "edits.free()"), event("hapticWait", 600), event("hapticPython", "edits.check_free()")]
        if i == COUNT // 4:
            lines += [event("hapticPython", "edits.clear()"), event("hapticWait", 1000), event("hapticPython", "edits.remember_memory()")]
    lines += [event("hapticPython", "edits.clear()"), event("hapticWait", 1000), event("hapticPython", f"edits.report({str(report)!r})")]
    return "".join(lines)


class RandomEdits(unittest.TestCase):
    def play(self, touching):
        """MB that the process grew by, how often there was a force, how often the proxy was compared with a body."""
        with tempfile.TemporaryDirectory() as folder:
            report = pathlib.Path(folder, "report.txt")
            run = play(events(touching, report), folder)
            self.assertEqual(run.returncode, 0, f"seed {SEED}:\n{run.stdout[-3000:]}{run.stderr[-6000:]}")
            said = report.read_text(encoding="utf-8")
        print(said, end="")
        return [float(number) for number in re.findall(r", ([-\d.]+)", said)]

    def test_no_edit_crashes_swallows_the_hand_or_leaves_a_force(self):
        grown, pressed, compared = self.play(True)
        self.assertGreater(pressed, COUNT / 10)
        self.assertGreater(compared, COUNT / 10)
        if FULL:
            self.assertLessEqual(grown, 2.0 * max(0.0, self.play(False)[0]) + 40.0)


if __name__ == "__main__":
    unittest.main()
