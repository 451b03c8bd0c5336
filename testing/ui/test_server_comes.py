# SPDX-License-Identifier: GPL-3.0-or-later
"""A server is connected while a hand presses, and left again: no force stays, the panel says why there is none, and the next touch of the
built-in server presses as before. So it is where the server is killed, once ParaView's dialog says that it is gone; the person may end
ParaView there. While events are played, releases after 5.11 end without that dialog, and the force ends with the process."""

import os
import pathlib
import subprocess
import tempfile
import unittest
from xml.sax.saxutils import quoteattr

from pvserver import server

HERE = pathlib.Path(__file__).resolve().parent
EXIT = "pqClientMainWindow/1QMessageBox0/qt_msgbox_buttonbox/1QPushButton1"
STATUS = "pqClientMainWindow/pqHapticPanel/panel/top/status"


def event(command, arguments, widget="pqClientMainWindow"):
    return f'  <pqevent object="{widget}" command="{command}" arguments={quoteattr(str(arguments))}/>\n'


def python(statement, wait_ms=0):
    return event("hapticPython", statement) + (event("hapticWait", wait_ms) if wait_ms else "")


def pressing():
    return python("trial.press()", 1500) + python("trial.go_in()", 800) + python("trial.check_pressing()")


def connected(port):
    return (python(f"trial.connect({port})", 1500) + python("trial.check_free()")
            + event("hapticHas", "No data are visible", STATUS))


def left():
    return python("trial.leave()", 1500) + python("trial.check_free()") + pressing()


def killed(server, died):
    """ParaView finds out with the next thing that is asked for."""
    lines = python(f"trial.die({server})") + python(f"open({str(died)!r}, 'w').close()") + event("activate", "menuSources", "pqClientMainWindow/menubar")
    lines += event("activate", "SphereSource", "pqClientMainWindow/menubar/menuSources/Alphabetical")
    return lines + event("hapticWait", 1500) + python("trial.check_free()")


def events(servers, died, done):
    (port, _), (port_of_killed, server) = servers
    lines = python("import server_comes; trial = server_comes.ServerComes()") + pressing()
    lines += connected(port) + left() + connected(port_of_killed) + killed(server, died) + left()
    lines += python(f"open({str(done)!r}, 'w').close()")
    return "<pqevents>\n" + lines + event("activate", "", EXIT) + "</pqevents>\n"


class ServerComes(unittest.TestCase):
    def test_a_server_that_comes_and_goes_or_dies_while_a_hand_presses_leaves_no_force_and_says_so(self):
        with tempfile.TemporaryDirectory() as name:
            script, died, done = (pathlib.Path(name) / one for one in ("comes.xml", "died", "done"))
            environment = os.environ | {"PYTHONPATH": f"{HERE}:{os.environ['PYTHONPATH']}", "HOME": name, "XDG_CONFIG_HOME": name}
            plugin = ["--plugin-search-paths=" + os.environ["PV_PLUGIN_PATH"], "--plugins=Palpate"]
            with server(environment, plugin) as one, server(environment, plugin) as other:
                script.write_text(events((one, other), died, done), encoding="utf-8")
                run = subprocess.run(["paraview", "--dr", *plugin, f"--test-script={script}", "--exit"], env=environment,
                    capture_output=True, text=True, check=False)
            said = run.stdout[-3000:] + run.stderr[-6000:]
            self.assertTrue(died.exists(), said)  # a check that fails ends the events
            if os.environ["PALPATE_PARAVIEW"] == "5.11":
                self.assertTrue(done.exists(), said)
            self.assertEqual(run.returncode, 255, said)  # so ParaView ends where a server is lost


if __name__ == "__main__":
    unittest.main()
