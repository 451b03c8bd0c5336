# SPDX-License-Identifier: GPL-3.0-or-later
"""A server is connected while a hand presses, and left again: no force stays, the panel says why there is none, and the next touch of the
built-in server presses as before. So it is where the server is killed, once ParaView's dialog says that it is gone; the person may end
ParaView there. While events are played, releases after 5.11 end without that dialog, and the force ends with the process."""

import os
import pathlib
import tempfile
import unittest

from played import PLUGIN, environment, event, play, wait
from played import python as statements
from pvserver import server

EXIT = "pqClientMainWindow/1QMessageBox0/qt_msgbox_buttonbox/1QPushButton1"
STATUS = "pqClientMainWindow/pqHapticPanel/panel/top/status"


def python(statement, wait_ms=0):
    return statements(statement) + (wait(wait_ms) if wait_ms else "")


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
    return lines + wait(1500) + python("trial.check_free()")


def events(servers, died, done):
    (port, _), (port_of_killed, server) = servers
    lines = python("import server_comes; trial = server_comes.ServerComes()") + pressing()
    lines += connected(port) + left() + connected(port_of_killed) + killed(server, died) + left()
    lines += python(f"open({str(done)!r}, 'w').close()")
    return lines + event("activate", "", EXIT)


class ServerComes(unittest.TestCase):
    def test_a_server_that_comes_and_goes_or_dies_while_a_hand_presses_leaves_no_force_and_says_so(self):
        with tempfile.TemporaryDirectory() as name:
            died, done = (pathlib.Path(name) / one for one in ("died", "done"))
            with server(environment(name), PLUGIN) as one, server(environment(name), PLUGIN) as other:
                run = play(events((one, other), died, done), name)
            said = run.stdout[-3000:] + run.stderr[-6000:]
            self.assertTrue(died.exists(), said)  # a check that fails ends the events
            if os.environ["PALPATE_PARAVIEW"] == "5.11":
                self.assertTrue(done.exists(), said)
            self.assertEqual(run.returncode, 255, said)  # so ParaView ends where a server is lost


if __name__ == "__main__":
    unittest.main()
