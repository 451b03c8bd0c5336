# SPDX-License-Identifier: GPL-3.0-or-later
"""Events that a test writes and ParaView plays, with the plugin loaded and settings of its own."""

import json
import os
import pathlib
import subprocess
import tempfile
from xml.sax.saxutils import quoteattr

HERE = pathlib.Path(__file__).resolve().parent
PLUGIN = ["--plugin-search-paths=" + os.environ["PV_PLUGIN_PATH"], "--plugins=Palpate"]


def event(command, arguments, widget="pqClientMainWindow"):
    return f'  <pqevent object="{widget}" command="{command}" arguments={quoteattr(str(arguments))}/>\n'


def python(*statements):
    return "".join(event("hapticPython", statement) for statement in statements)


def wait(time_ms):
    return event("hapticWait", time_ms)


def environment(folder):
    return os.environ | {"PYTHONPATH": f"{HERE}:{os.environ['PYTHONPATH']}", "HOME": str(folder), "XDG_CONFIG_HOME": str(folder)}


def play(events, folder):
    """The process that has ended, its output as text. Its modules are those beside this file."""
    script = pathlib.Path(folder, "played.xml")
    script.write_text(f"<pqevents>\n{events}</pqevents>\n", encoding="utf-8")
    return subprocess.run(["paraview", "--dr", *PLUGIN, f"--test-script={script}", "--exit"], env=environment(folder),
        capture_output=True, text=True, check=False)


def report_of(events):
    """The JSON that the events wrote: they are made by events(path), and must all succeed."""
    with tempfile.TemporaryDirectory() as folder:
        report = pathlib.Path(folder, "report.json")
        run = play(events(report), folder)
        assert run.returncode == 0, run.stdout[-2000:] + run.stderr[-4000:]
        return json.loads(report.read_text(encoding="utf-8"))
