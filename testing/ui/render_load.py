# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs inside ParaView: a million triangles turn before the camera, in turn without a touch and with one; the cost of a picture for
the GUI's thread, of a tick, drawn for and not, and of making so many triangles ready for that thread at once. test_render_load.py
writes the events that call this."""

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
        self.ball = simple.Sphere(Radius=RADIUS, ThetaResolution=1000, PhiResolution=501)
        self.view = simple.GetActiveViewOrCreate("RenderView")
        simple.Show(self.ball, self.view)
        simple.ResetCamera(self.view)
        self.camera = simple.GetActiveCamera()
        manager = servermanager.ActiveConnection.Session.GetSessionProxyManager()
        self.proxy = manager.GetProxy("haptics", "HapticSession")
        self.parts = {"free": [], "touched": []}  # of each part [ms a picture]: drawing it, all else that the thread did
        self.costs = {}
        self.ready = {"shares": [], "slices": []}  # progress, and work of the thread between two looks beside drawing [ms], pictures
        self.turning = False
        self.drawing = self.begun = self.looked = 0.0
        self.drawn = 0
        window, interactor = self.view.GetRenderWindow(), self.view.GetInteractor()
        window.AddObserver("StartEvent", self.begin_picture)
        window.AddObserver("EndEvent", self.end_picture)
        interactor.AddObserver("TimerEvent", self.turn)
        interactor.CreateRepeatingTimer(FRAME_MS)
        simple.Render(self.view)  # one-time work happens before anything is measured

    def session(self):
        return self.proxy.GetClientSideObject()

    def put(self, name, *values):
        for index, value in enumerate(values):
            servermanager.vtkSMPropertyHelper(self.proxy, name).Set(index, value)
        self.proxy.UpdateVTKObjects()

    def begin_picture(self, *_):
        self.picture_begun = time.thread_time()

    def end_picture(self, *_):
        self.drawing += time.thread_time() - self.picture_begun
        self.drawn += 1

    def turn(self, *_):
        if self.turning:
            self.camera.Azimuth(1.0)
            simple.Render(self.view)

    # Making the data ready.

    def prepare(self):
        """A simulated hand that strokes a great circle, 2 mm under the surface."""
        self.put("DeviceName", "simulated-generic")
        self.put("Scale", 1000.0)
        self.put("StrokeSpeed", 0.05)
        around = [(1.3, 0.0)] + [(0.96, 0.1 * i) for i in range(200)]
        self.put("StrokePoints", *(c for r, a in around for c in (r * RADIUS * math.cos(a), r * RADIUS * math.sin(a), 3.0)))

    def show_another(self):
        """Of about as many triangles, none of which is known."""
        self.ball.PhiResolution += 2
        simple.Render(self.view)

    def first_touch(self):
        begun = time.thread_time()
        self.put("Touching", 1)
        self.ready["touch"] = 1e3 * (time.thread_time() - begun)
        self.begin_slice()

    def begin_slice(self):
        self.looked, self.drawing, self.drawn = time.thread_time(), 0.0, 0

    def look(self):
        self.ready["slices"].append((1e3 * (time.thread_time() - self.looked - self.drawing), self.drawn))
        self.ready["shares"].append(self.session().GetSceneProgress())
        self.begin_slice()

    def turn_once(self):
        """As while a person turns the camera: ParaView draws so many triangles coarser."""
        self.view.SMProxy.InteractiveRender()
        self.ready["turned"] = [self.view.GetClientSideObject().GetUsedLODForLastRender(), self.session().GetSceneProgress()]

    def cancel(self):
        self.proxy.InvokeCommand("CancelScene")

    def note_cancelled(self):
        session = self.session()
        session.Update()
        self.ready["cancelled"] = [session.GetWarning(), session.GetSceneReport()]

    # Touching it.

    def touch(self):
        self.put("Touching", 1)

    def draw(self, on):
        """Whether anybody draws the view: beside a tick that nothing runs beside, nobody does."""
        self.view.SMProxy.SetEnable(on)

    def let_go(self):
        self.put("Touching", 0)

    def begin(self):
        self.turning, self.drawn, self.drawing, self.begun = True, 0, 0.0, time.thread_time()

    def end(self, name):
        self.turning = False
        whole = time.thread_time() - self.begun
        self.parts[name].append((1e3 * self.drawing / self.drawn, 1e3 * (whole - self.drawing) / self.drawn, self.drawn))

    def note_cost(self, name):
        """Of the ticks of this touch; each touch begins its numbers anew."""
        session = self.session()
        session.Update()
        self.costs.setdefault(name, []).append({
            "p99": session.GetCostP99(), "p99.9": session.GetCostP999(), "contact_s": session.GetContactSeconds(),
            "ticks": session.GetTicks(), "missed": session.GetMissed(), "periods": session.GetPeriods()})

    def report(self, path):
        middle = {name: [statistics.median(column) for column in zip(*parts)] for name, parts in self.parts.items()}
        found = {"middle": middle, "parts": self.parts, "costs": self.costs, "ready": self.ready}
        pathlib.Path(path).write_text(json.dumps(found), encoding="utf-8")
