# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs inside ParaView: shows a skull, lets a simulated hand stroke it, and reports on the first minute of contact.

Environment: PALPATE_RUN_SURFACE (.vtp), PALPATE_RUN_OUT (folder), PALPATE_RUN_SECONDS (of contact), and
PALPATE_RUN_FRAMEBUFFER (folder of an Xvfb screen; set: take a picture halfway and let go at the end).
"""

import os
import traceback

from paraview import servermanager, simple
from palpate.vtkHapticInteraction import vtkHapticSession  # noqa: F401  makes the proxy's object scriptable
from palpate.vtkHapticPipeline import vtkHapticStroke

import summary

STIFFNESS = 300.0  # N/m
RADIUS = 1.0  # mm
SPEED = 0.04  # m/s
DEPTH = 8.0  # mm under the surface
APPROACH = 30.0  # mm above the first point of the stroke
STEP = 1.0  # mm between two points of the stroke
PERIOD = 100  # ms between two looks at the session


def show_bone(surface):
    """The largest connected part, without the head rest of the scanner."""
    reader = simple.XMLPolyDataReader(registrationName=os.path.basename(surface), FileName=surface)
    largest = simple.Connectivity(
        registrationName="Largest part", Input=reader, ExtractionMode="Extract Largest Region", ColorRegions=0
    )
    surface_of_it = simple.ExtractSurface(registrationName="Its surface", Input=largest)
    bone = simple.Clean(registrationName="Bone", Input=surface_of_it, PointMerging=0)  # drops the points of the rest
    view = simple.GetActiveViewOrCreate("RenderView")
    display = simple.Show(bone, view)
    display.DiffuseColor = display.AmbientColor = [0.91, 0.87, 0.78]
    look_from_the_front_left(view, bone)
    return bone, view


def look_from_the_front_left(view, bone):
    x0, x1, y0, y1, z0, z1 = bone.GetDataInformation().GetBounds()
    centre = [(x0 + x1) / 2, (y0 + y1) / 2, (z0 + z1) / 2]
    room = 0.1 * (z1 - z0)  # above the head, for the arrow of the force
    view.CameraFocalPoint = centre
    view.CameraPosition = [centre[0] - 300, centre[1] - 400, centre[2] + 240]
    view.CameraViewUp = [0, 0, 1]
    view.OrientationAxesVisibility = 0
    simple.ResetCamera(view)
    camera = simple.GetActiveCamera()
    camera.Dolly(1.2)
    for get, put in ((camera.GetFocalPoint, camera.SetFocalPoint), (camera.GetPosition, camera.SetPosition)):
        x, y, z = get()
        put(x, y, z + room)
    simple.Render(view)


def session_proxy():
    manager = servermanager.ActiveConnection.Session.GetSessionProxyManager()
    present = manager.GetProxy("haptics", "HapticSession")
    if present is None:
        present = manager.NewProxy("haptics", "HapticSession")
        manager.RegisterProxy("haptics", "HapticSession", present)
    return present


def set_property(proxy, name, *values):
    for index, value in enumerate(values):
        servermanager.vtkSMPropertyHelper(proxy, name).Set(index, value)


def stroke_over(bone):
    """A path from above the back of the head down to it, over the crown to the brow and back, just under the bone."""
    stroke = vtkHapticStroke()
    stroke.SetInputData(servermanager.Fetch(bone))
    stroke.SetDepth(DEPTH)
    stroke.SetStep(STEP)
    stroke.Update()
    path = stroke.GetOutput()
    points = [path.GetPoint(i) for i in range(path.GetNumberOfPoints())]
    x, y, z = points[0]
    return [(x, y, z + APPROACH)] + points  # straight up is free: the stroke follows the outermost bone


def prepare(proxy, points):
    """The hand stays above the bone while the scene is built."""
    set_property(proxy, "DeviceName", "fed")
    set_property(proxy, "Stiffness", STIFFNESS)
    set_property(proxy, "Radius", RADIUS)
    set_property(proxy, "Scale", 1000.0)
    set_property(proxy, "Offset", *(sum(c) / len(points) for c in zip(*points)))
    set_property(proxy, "HandPosition", *points[0])
    set_property(proxy, "StrokeSpeed", SPEED)
    set_property(proxy, "StrokePoints", *(c for point in points for c in point))
    touch(proxy, True)


def lead_hand(proxy):
    """The same session again, with a simulated hand that follows the stroke, recorded from its first tick."""
    touch(proxy, False)
    set_property(proxy, "DeviceName", "simulated-generic")
    set_property(proxy, "RecordFile", os.path.join(os.environ["PALPATE_RUN_OUT"], "recording.palpate"))
    touch(proxy, True)


def touch(proxy, on):
    set_property(proxy, "Touching", int(on))
    proxy.UpdateVTKObjects()


class Watch:
    """Looks at the session a few times a second, pictures it, and reports when the time is over."""

    def __init__(self, proxy, view):
        self.proxy = proxy
        self.session = proxy.GetClientSideObject()
        self.seconds = float(os.environ["PALPATE_RUN_SECONDS"])
        self.framebuffer = os.environ.get("PALPATE_RUN_FRAMEBUFFER")
        self.pictured = not self.framebuffer
        self.leading = False
        self.clock = summary.WallClock()
        self.interactor = view.GetInteractor()
        self.observer = self.interactor.AddObserver("TimerEvent", self.look)
        self.timer = self.interactor.CreateRepeatingTimer(PERIOD)

    def look(self, *_):
        try:
            self.session.Update()
            if self.leading:
                self.follow()
            elif self.session.GetSceneReport():
                lead_hand(self.proxy)
                self.clock = summary.WallClock()
                self.leading = True
        except Exception:  # nothing else would show it: the caller is VTK's event loop
            traceback.print_exc()
            self.stop()

    def follow(self):
        contact = self.session.GetContactSeconds()
        if not self.pictured and contact > self.seconds / 4 and self.worth_a_picture():
            self.picture()
        if contact >= self.seconds or self.clock.seconds() > 2 * self.seconds + 60:
            self.stop()
            numbers = summary.of(self.session, self.seconds, self.clock)
            summary.write(os.environ["PALPATE_RUN_OUT"], numbers)

    def worth_a_picture(self):
        """The hand presses in front of the crown, where the camera sees it against the bone."""
        y = self.session.GetProxyPosition()[1]
        return self.session.GetForceMagnitude() > 0.7 * self.session.GetPeakForce() and y < self.session.GetSettingNumbers("Offset")[1] - 25

    def picture(self):
        from screen import save_screen

        save_screen(self.framebuffer, os.path.join(os.environ["PALPATE_RUN_OUT"], "screenshot.png"))
        self.pictured = True

    def stop(self):
        """A person at a display goes on touching; with no display the client ends once nothing is touched."""
        self.interactor.DestroyTimer(self.timer)
        self.interactor.RemoveObserver(self.observer)
        if self.framebuffer:
            touch(self.proxy, False)


def main():
    bone, view = show_bone(os.environ["PALPATE_RUN_SURFACE"])
    proxy = session_proxy()
    prepare(proxy, stroke_over(bone))
    return Watch(proxy, view)


watch = main()
