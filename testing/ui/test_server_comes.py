# SPDX-License-Identifier: GPL-3.0-or-later
"""A server is connected while a hand presses, and left again: no force stays, the panel says why there is none, and the next touch of the
built-in server presses as before. (Of a server that dies ParaView asks the person in a dialog of its own; nothing touches by then.)"""

import os
import pathlib
import shutil
import socket
import subprocess
import tempfile
import unittest
from xml.sax.saxutils import quoteattr

HERE = pathlib.Path(__file__).resolve().parent
STATUS = "pqClientMainWindow/pqHapticPanel/scroll/qt_scrollarea_viewport/body/mainGroup/status"


def event(command, arguments, widget="pqClientMainWindow"):
    return f'  <pqevent object="{widget}" command="{command}" arguments={quoteattr(str(arguments))}/>\n'


def python(statement, wait_ms=0):
    return event("hapticPython", statement) + (event("hapticWait", wait_ms) if wait_ms else "")


def pressing():
    return python("trial.press()", 1500) + python("trial.go_in()", 800) + python("trial.check_pressing()")


def events(port):
    lines = python("import server_comes; trial = server_comes.ServerComes()") + pressing()
    lines += python(f"trial.connect({port})", 1500) + python("trial.check_free()")
    lines += event("hapticHas", "only the built-in server can be touched", STATUS)
    lines += python("trial.leave()", 1500) + python("trial.check_free()")
    return "<pqevents>\n" + lines + pressing() + "</pqevents>\n"


def free_port():
    with socket.socket() as probe:
        probe.bind(("localhost", 0))
        return probe.getsockname()[1]


class ServerComes(unittest.TestCase):
    def test_a_server_that_comes_and_goes_while_a_hand_presses_leaves_no_force_and_says_so(self):
        with tempfile.TemporaryDirectory() as name:
            folder, port = pathlib.Path(name), free_port()
            script = folder / "comes.xml"
            script.write_text(events(port), encoding="utf-8")
            environment = os.environ | {"PYTHONPATH": f"{HERE}:{os.environ['PYTHONPATH']}", "HOME": name, "XDG_CONFIG_HOME": name}
            plugin = ["--plugin-search-paths=" + os.environ["PV_PLUGIN_PATH"], "--plugins=Palpate"]
            with subprocess.Popen([shutil.which("pvserver"), f"--server-port={port}", *plugin], env=environment,
                    stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True) as server:
                while "Accepting" not in (line := server.stdout.readline()):
                    self.assertTrue(line, "the server did not start")
                try:
                    run = subprocess.run(["paraview", "--dr", *plugin, f"--test-script={script}", "--exit"], env=environment,
                        capture_output=True, text=True, check=False)
                finally:
                    server.kill()
            self.assertEqual(run.returncode, 0, run.stdout[-3000:] + run.stderr[-6000:])


if __name__ == "__main__":
    unittest.main()
