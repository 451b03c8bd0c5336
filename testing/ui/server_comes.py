# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs inside ParaView: a hand presses on data of the built-in server while another server is connected, and left
again or killed. test_server_comes.py writes the events that call this."""

import os
import signal

from paraview import servermanager, simple
from palpate.vtkHapticInteraction import vtkHapticSession  # noqa: F401  makes the proxy's object scriptable

RADIUS = 50.0  # u
DEEP = 2.0  # u, as many mm
STIFFNESS = 500.0  # N/m


class ServerComes:
    def session(self):
        proxy = servermanager.ActiveConnection.Session.GetSessionProxyManager().GetProxy("haptics", "HapticSession")
        return proxy, proxy.GetClientSideObject()

    def press(self):
        simple.Show(simple.Sphere(Radius=RADIUS, ThetaResolution=96, PhiResolution=96))
        simple.Render()
        proxy, self.pressing = self.session()
        for name, value in (("DeviceName", "fed"), ("Scale", 1000.0), ("Stiffness", STIFFNESS), ("FitOnTouch", 0)):
            servermanager.vtkSMPropertyHelper(proxy, name).Set(value)
        proxy.UpdateVTKObjects()
        self.pressing.SetHandPosition(0.0, 0.0, RADIUS + 20.0)
        servermanager.vtkSMPropertyHelper(proxy, "Touching").Set(1)
        proxy.UpdateVTKObjects()
        self.pressing.FinishScene()

    def go_in(self):
        self.pressing.SetHandPosition(0.0, 0.0, RADIUS - DEEP)

    def check_pressing(self):
        self.pressing.Update()
        force, spring = self.pressing.GetForceMagnitude(), STIFFNESS * DEEP / 1000.0
        assert abs(force - spring) < 0.1 * spring, f"{force} N, not {spring} N: {self.pressing.GetStateText()} {self.pressing.GetWarning()}"

    def check_free(self):
        """Of the session that pressed: the one that is there now may be another."""
        self.pressing.Update()
        assert not self.pressing.GetTouching(), "it still touches"
        assert self.pressing.GetForceMagnitude() == 0.0, f"{self.pressing.GetForceMagnitude()} N are left"

    def connect(self, port):
        simple.Connect("localhost", port)

    def die(self, server):
        """The process of that number."""
        os.kill(server, signal.SIGKILL)

    def leave(self):
        simple.Disconnect()
        simple.Connect()
