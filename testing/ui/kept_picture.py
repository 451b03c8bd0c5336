# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs inside ParaView: a hand strokes a ball; which pictures drew the ball, and whether pictures without it look the same.
test_kept_picture.py writes the events that call this."""

import json
import math
import pathlib

from paraview import servermanager, simple
from palpate.vtkHapticInteraction import vtkHapticSession  # noqa: F401  makes the proxy's object scriptable
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray

RADIUS = 50.0  # u


class KeptPicture:
    def __init__(self):
        self.ball = simple.Sphere(Radius=RADIUS, ThetaResolution=200, PhiResolution=100)
        self.view = simple.GetActiveViewOrCreate("RenderView")
        self.display = simple.Show(self.ball, self.view)
        simple.ResetCamera(self.view)
        simple.Render(self.view)
        self.proxy = servermanager.ActiveConnection.Session.GetSessionProxyManager().GetProxy("haptics", "HapticSession")
        self.pictures = {"window": 0, "ball": 0}
        self.found = {}
        self.window = self.view.GetRenderWindow()
        self.window.AddObserver("EndEvent", lambda *_: self.count("window"))
        self.view.GetRenderer().AddObserver("EndEvent", lambda *_: self.count("ball"))

    def count(self, what):
        self.pictures[what] += 1

    def put(self, name, *values):
        for index, value in enumerate(values):
            servermanager.vtkSMPropertyHelper(self.proxy, name).Set(index, value)
        self.proxy.UpdateVTKObjects()

    def touch(self):
        """In virtual time, so that the hand rests while pictures are compared."""
        self.put("Scale", 1000.0)
        self.put("DeviceName", "fed")
        self.put("VirtualTime", 1)
        self.put("FitOnTouch", 0)
        self.session = self.proxy.GetClientSideObject()
        self.session.SetHandPosition(1.3 * RADIUS, 0.0, -0.3 * RADIUS)
        self.put("Touching", 1)
        self.session.Step(500)
        self.move(0.0)

    def touch_with_the_mouse(self):
        self.put("Touching", 0)
        self.put("VirtualTime", 0)
        self.put("DeviceName", "mouse")
        self.put("Touching", 1)

    def move(self, angle):
        """To a place under the surface, where the ball hides a part of the force."""
        self.session.SetHandPosition(0.9 * RADIUS * math.cos(angle), 0.9 * RADIUS * math.sin(angle), -0.3 * RADIUS)
        self.session.Step(200)

    def begin(self):
        self.pictures.update(window=0, ball=0)

    def end(self, name):
        self.found[name] = dict(self.pictures)

    def colour(self):
        """Changed without a picture asked for: the next one of the hand must show it."""
        self.display.DiffuseColor = [1.0, 0.0, 0.0]
        self.display.AmbientColor = [1.0, 0.0, 0.0]

    def stereo(self, on):
        """Red and blue: a picture for each eye."""
        self.view.StereoType = "Red-Blue"
        self.view.StereoRender = on
        simple.Render(self.view)

    def turn(self):
        self.view.GetActiveCamera().Azimuth(30.0)

    def pixels(self):
        size, found = self.window.GetSize(), vtkUnsignedCharArray()
        self.window.GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, found, 0)
        return vtk_to_numpy(found).astype(int)

    def redness(self, name):
        """Mean of red less mean of blue, of the picture that is seen."""
        seen = self.pixels()
        self.found[name] = float(seen[:, 0].mean() - seen[:, 2].mean())

    def compare(self, name):
        """The picture that is seen with one in which all is drawn: greatest difference of a channel."""
        self.found[name + " drawn"] = self.pictures["ball"]
        seen = self.pixels()
        simple.Render(self.view)
        whole = self.pixels()
        self.found[name] = int(abs(seen - whole).max())

    def report(self, path):
        self.put("Touching", 0)
        pathlib.Path(path).write_text(json.dumps(self.found), encoding="utf-8")
