# SPDX-License-Identifier: GPL-3.0-or-later
"""Drawing a million triangles beside the servo: what a tick costs at most against one that is not drawn beside, every period
accounted for, and what touching costs the GUI's thread a frame. Side by side in one run; with PALPATE_TEST_FULL a minute."""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest
from xml.sax.saxutils import quoteattr

HERE = pathlib.Path(__file__).resolve().parent
SECONDS = 15 if os.environ.get("PALPATE_TEST_FULL") else 3  # a part; there are four of each kind
MOST_COST_RATIO = 3.0


def event(command, arguments):
    return f'  <pqevent object="pqClientMainWindow" command="{command}" arguments={quoteattr(str(arguments))}/>\n'


def python(*statements):
    return "".join(event("hapticPython", statement) for statement in statements)


def events(report):
    lines = python("import render_load; load = render_load.RenderLoad()")
    lines += python("load.touch()") + event("hapticWait", 4000) + event("hapticWait", SECONDS * 1000)
    lines += python("load.note_cost('still')", "load.let_go()")
    for _ in range(4):
        lines += python("load.begin()") + event("hapticWait", SECONDS * 1000) + python("load.end('free')")
        lines += python("load.touch()") + event("hapticWait", 4000) + python("load.begin()")
        lines += event("hapticWait", SECONDS * 1000) + python("load.end('touched')", "load.note_cost('drawn')", "load.let_go()")
    return "<pqevents>\n" + lines + python(f"load.report({str(report)!r})") + "</pqevents>\n"


class RenderLoad(unittest.TestCase):
    def test_ticks_cost_no_more_than_three_times_as_much_beside_drawing_and_no_period_is_lost(self):
        with tempfile.TemporaryDirectory() as folder:
            script, report = pathlib.Path(folder, "load.xml"), pathlib.Path(folder, "report.json")
            script.write_text(events(report), encoding="utf-8")
            environment = os.environ | {"PYTHONPATH": f"{HERE}:{os.environ['PYTHONPATH']}", "HOME": folder, "XDG_CONFIG_HOME": folder}
            run = subprocess.run(["paraview", "--dr", "--plugin-search-paths=" + os.environ["PV_PLUGIN_PATH"], "--plugins=Palpate",
                f"--test-script={script}", "--exit"], env=environment, capture_output=True, text=True, check=False)
            self.assertEqual(run.returncode, 0, run.stdout[-2000:] + run.stderr[-4000:])
            found = json.loads(report.read_text(encoding="utf-8"))
        print(json.dumps(found))
        self.assertGreater(found["frames"]["touched"], 10)
        self.assertGreater(found["cost_us"]["drawn"][2], 0.5, "seconds of contact")
        self.assertLessEqual(found["cost_us"]["drawn"][1], MOST_COST_RATIO * found["cost_us"]["still"][1])


if __name__ == "__main__":
    unittest.main()
