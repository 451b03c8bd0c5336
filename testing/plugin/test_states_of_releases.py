# SPDX-License-Identifier: GPL-3.0-or-later
"""States that releases of ParaView saved (states/save_states.py) open in this one, and are felt as they are drawn: a box of 100 u, 3 u
along x, with a stiffness of its own. Each in a process of its own.

ParaView leaves out properties with another name, without a word: the place of a display has another name since 5.13, so a state
file of the other side of that change shows the box where it was before it was moved, and there it is felt. Python states of later
releases are refused by ParaView.

usage: test_states_of_releases.py            every state
       test_states_of_releases.py STATE      this one alone
"""

import gzip
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

STATES = pathlib.Path(__file__).resolve().parent / "states"
SERIES, IN_PYTHON = ("5.11", "5.13", "6.1"), ".py.gz"
OF_ALL, OF_BOX, SCALE, DEPTH = 400.0, 250.0, 1000.0, 2.0  # N/m, N/m, u/m, u
FACE, MOVED = 50.0, 3.0  # u along x
OWN = SERIES.index(os.environ["PALPATE_PARAVIEW"])
TICKS_TO_ENGAGE = 1100


def opened(state):
    """Where its box is drawn along x, the session, and the force."""
    from paraview import simple
    simple.LoadPlugin(os.environ["PALPATE_PLUGIN"], remote=False, ns=globals())
    from displays import place_of
    from palpate.simple import GetHapticSession, HapticState, LetGo, SetHaptics, Touch
    content = gzip.decompress(state.read_bytes())
    if IN_PYTHON in state.name:
        GetHapticSession()  # ParaView's client has one before it opens a state
        exec(compile(content, state, "exec"), {"__name__": "__main__"})
    else:
        with tempfile.NamedTemporaryFile(suffix=".pvsm") as file:
            file.write(content)
            file.flush()
            simple.LoadState(file.name)
    (view,) = simple.GetRenderViews()
    simple.SetActiveView(view)
    view.StillRender()
    drawn = place_of(simple.GetDisplayProperties(simple.FindSource("Box"), view))[0]
    SetHaptics(DeviceName="fed", FitOnTouch=0)  # no state chooses the device
    session = GetHapticSession()
    session.SetHandPosition(FACE + drawn + 10.0, 10.0, 20.0)
    Touch()
    session.Step(TICKS_TO_ENGAGE)
    session.SetHandPosition(FACE + drawn - DEPTH, 10.0, 20.0)
    session.Step(300)
    force = HapticState()["Force"]
    LetGo()
    return drawn, (session.GetSetting("Stiffness"), session.GetSetting("Scale")), force


class OneState(unittest.TestCase):
    state = None

    def test_it_is_felt_as_it_is_drawn(self):
        drawn, settings, force = opened(self.state)
        renamed = (SERIES[OWN] == SERIES[0]) != (SERIES[0] in self.state.name)
        if IN_PYTHON in self.state.name or not renamed:
            self.assertEqual(drawn, MOVED)
        self.assertEqual(settings, (OF_ALL, SCALE))
        for got, wanted in zip(force, (OF_BOX * DEPTH / SCALE, 0.0, 0.0)):
            self.assertAlmostEqual(got, wanted, delta=1e-12)


class EveryState(unittest.TestCase):
    def test_state_files_and_python_states_of_the_releases_are_felt_as_they_are_drawn(self):
        for state in [f"box-{series}.pvsm.gz" for series in SERIES] + [f"box-{series}{IN_PYTHON}" for series in SERIES[:OWN + 1]]:
            with self.subTest(state=state):
                run = subprocess.run([shutil.which("pvpython"), "--dr", __file__, state], capture_output=True, text=True, check=False)
                self.assertEqual(run.returncode, 0, run.stdout[-2000:] + run.stderr[-4000:])


if __name__ == "__main__":
    OneState.state = STATES / sys.argv[1] if len(sys.argv) > 1 else None
    chosen = "OneState" if OneState.state else "EveryState"
    # A SystemExit would skip pvpython's own ending, which closes views before the display.
    if not unittest.main(argv=sys.argv[:1], defaultTest=chosen, exit=False).result.wasSuccessful():
        sys.exit(1)
