# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs inside ParaView: a million triangles turn before the camera, in turn without a touch and with one; what a frame costs the
GUI's thread and what a tick costs, drawn for and not. test_render_load.py writes the events that call this."""

import json
import math
import pathlib
import statistics
import time

from paraview import servermanager, simple
from palpate.vtkHapticInteraction import vtkHapticSession  # noqa: F401  makes the proxy's object scriptable

FRAME_MS = 20
RADIUS = 50.0  # u


class RenderLoad:
    def __init__(self):
        ball = simple.Sphere(Radius=RADIUS, ThetaResolution=1000, PhiResolution=501)
        self.view = simple.GetActiveViewOrCreate("RenderView")
        simple.Show(ball, self.view)
        simple.ResetCamera(self.view)
        simple.Render(self.view)
        self.camera = simple.GetActiveCamera()
        manager = servermanager.ActiveConnection.Session.GetSessionProxyManager()
        self.proxy = manager.GetProxy("haptics", "HapticSession")
        self.frames = []  # [s] of the GUI's thread from one frame to the next
        self.kept = {"free": [], "touched": []}
        self.costs = {}
        self.before = None
        self.turning = False
        interactor = self.view.GetInteractor()
        interactor.AddObserver("TimerEvent", self.turn)
        interactor.CreateRepeatingTimer(FRAME_MS)

    def session(self):
        return self.proxy.GetClientSideObject()

    def put(self, name, *values):
        for index, value in enumerate(values):
            servermanager.vtkSMPropertyHelper(self.proxy, name).Set(index, value)
        self.proxy.UpdateVTKObjects()

    def turn(self, *_):
        """All that the thread does from here to here is one frame's: drawing, the panel, the tools in the view."""
        if not self.turning:
            return
        now = time.thread_time()
        if self.before is not None:
            self.frames.append(now - self.before)
        self.before = now
        self.camera.Azimuth(1.0)
        simple.Render(self.view)

    def touch(self):
        """A simulated hand strokes a great circle, 2 mm under the surface."""
        self.put("DeviceName", "simulated-generic")
        self.put("Scale", 1000.0)
        self.put("StrokeSpeed", 0.05)
        around = [(1.3, 0.0)] + [(0.96, 0.1 * i) for i in range(200)]
        self.put("StrokePoints", *(c for r, a in around for c in (r * RADIUS * math.cos(a), r * RADIUS * math.sin(a), 3.0)))
        self.put("Touching", 1)

    def let_go(self):
        self.put("Touching", 0)

    def begin(self):
        self.frames, self.before, self.turning = [], None, True

    def end(self, name):
        self.turning = False
        self.kept[name] += self.frames
        return len(self.frames)

    def note_cost(self, name):
        """Of the ticks of this touch; each touch begins its numbers anew."""
        session = self.session()
        session.Update()
        assert session.GetTicks() + session.GetMissed() == session.GetPeriods(), "a period is not accounted for"
        self.costs[name] = (session.GetCostP50(), session.GetCostP99(), session.GetContactSeconds(), session.GetTicks(), session.GetMissed())

    def report(self, path):
        medians = {name: statistics.median(values) * 1e3 for name, values in self.kept.items()}
        longest = {name: max(values) * 1e3 for name, values in self.kept.items()}
        frames = {name: len(values) for name, values in self.kept.items()}
        pathlib.Path(path).write_text(
            json.dumps({"frames": frames, "median_ms": medians, "longest_ms": longest, "cost_us": self.costs}), encoding="utf-8")
