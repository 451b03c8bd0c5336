# SPDX-License-Identifier: GPL-3.0-or-later
"""A view, and a session in virtual time that follows it."""

import unittest

from paraview import simple

from haptic_proxies import manager, put

STIFFNESS = 200.0  # N/m
SCALE = 1.0  # u/m
DEPTH = 0.01  # u
FORCE = STIFFNESS * DEPTH / SCALE  # N


class ViewTest(unittest.TestCase):
    def setUp(self):
        self.view = simple.CreateView("RenderView")
        self.view.ViewSize = [120, 100]
        self.proxy = manager().NewProxy("haptics", "HapticSession")
        self.session = self.proxy.GetClientSideObject()
        put(self.proxy, "DeviceName", "fed")
        put(self.proxy, "Stiffness", STIFFNESS)
        put(self.proxy, "Scale", SCALE)
        self.session.SetSetting("VirtualTime", True)
        self.scene_proxy = manager().NewProxy("haptics", "HapticViewScene")
        self.scene = self.scene_proxy.GetClientSideObject()
        put(self.scene_proxy, "View", self.view.SMProxy)
        put(self.scene_proxy, "Session", self.proxy)

    def tearDown(self):
        put(self.proxy, "Touching", 0)
        put(self.scene_proxy, "View", None)  # the property would keep the view until the display is closed
        put(self.scene_proxy, "Session", None)
        del self.scene, self.scene_proxy, self.session, self.proxy
        simple.Delete(self.view)
        del self.view
        for source in list(simple.GetSources().values()):
            simple.Delete(source)

    def show(self, source):
        display = simple.Show(source, self.view)
        simple.Render(self.view)
        return display

    def follow(self):
        changed = self.scene.Update()
        self.session.FinishScene()
        return changed

    def feel(self, **settings):
        """The shown data as a field; whether a block of them is there."""
        for name, value in settings.items():
            put(self.proxy, name, value)
        self.follow()
        return self.session.FinishField()

    def press(self, *point):
        """Starts 0.2 u outside along x, engages, and goes to the point in steps of 1 mm of the hand."""
        start = (point[0] + 0.2, *point[1:])
        self.session.SetHandPosition(*start)
        put(self.proxy, "Touching", 1)
        self.session.Step(2000)
        for i in range(1, 201):
            self.session.SetHandPosition(start[0] - 0.001 * i, *point[1:])
            self.session.Step(1)
        self.session.Step(500)
        self.session.Update()
