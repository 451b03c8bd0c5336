# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs inside ParaView: seeded random edits of pipeline, views and states while a hand touches, and invariants after each.

The judge is analytic and knows nothing of contact: the proxy, which starts outside, is outside of every closed ball and box that
the view shows, whatever appeared around it; the force is finite and no larger than the session allows; far from everything it is
zero. test_random_edits.py writes the events that call this.
"""

import math
import os
import pathlib
import random
import tempfile

from paraview import servermanager, simple
from displays import move, place_of
from palpate.vtkHapticInteraction import vtkHapticSession  # noqa: F401  makes the proxy's object scriptable

MOST_FORCE = 3.0 * (1.0 + 1e-12)  # N; of a device that knows none, and the rounding when a force is shortened to it
NO_FORCE = 1e-12  # N; the rest of a blend halves every few milliseconds and is never quite zero
MOST_SOURCES = 6
ROUND = 48  # facets of a ball's equator
SAG = 1.0 - math.cos(math.pi / ROUND)  # how far a facet lies inside of its ball, in radii; twice: it bends two ways
FREE = (400.0, 0.0, 0.0)  # u; nothing ever reaches there


def inside_ball(ball, p):
    """How deep a point is inside of the facets of a ball [u]; negative outside."""
    return (1.0 - 2.0 * SAG) * ball.Radius - math.dist(p, ball.Center)


def inside_box(box, p):
    sizes = (box.XLength, box.YLength, box.ZLength)
    return min(size / 2 - abs(x - c) for size, x, c in zip(sizes, p, box.Center))


def depth_in(source, display, p):
    """How deep a point is inside of the data that a source shows [u]."""
    at = [x - shift for x, shift in zip(p, place_of(display))]
    kind = source.GetXMLName()
    return {"SphereSource": inside_ball, "CubeSource": inside_box}[kind](source, at)


def shown_bodies(view):
    """Sources of closed surfaces in a view with their displays."""
    for (name, _), source in simple.GetSources().items():
        display = servermanager.GetRepresentation(source, view)
        if display and display.Visibility and display.Opacity > 0 and display.Representation == "Surface":
            yield name, source, display


def comes_near(source, display, radius, p, q):
    """Whether the data that a source shows, in any style, come within a ball's radius of the line from p to q, or a little
    further."""
    reach = radius + 2.0 * SAG * 60.0 + 1.0  # u; the largest ball has a radius of 60
    steps = max(2, math.ceil(math.dist(p, q)))
    ways = ([a + (b - a) * i / steps for a, b in zip(p, q)] for i in range(steps + 1))
    return any(depth_in(source, display, x) > -reach for x in ways)


def resident_memory():
    """MB of this process in memory."""
    pages = int(pathlib.Path("/proc/self/statm").read_text(encoding="utf-8").split()[1])
    return pages * os.sysconf("SC_PAGESIZE") / 1e6


class Edits:
    def __init__(self, seed, touching):
        self.random = random.Random(seed)
        self.touching = touching
        self.names = 0
        self.folder = tempfile.mkdtemp()
        self.state = None
        self.memory = None
        self.done = []
        self.compared = 0  # a proxy with a body
        self.pressed = 0  # times that there was a force
        self.engage()

    def view(self):
        """The active view. One that an undo took out of its layout is deleted: nobody sees it, so nothing in it is felt."""
        view = simple.GetActiveViewOrCreate("RenderView")
        if simple.GetLayout(view) is None:
            simple.Delete(view)
            simple.SetActiveView(simple.GetRenderViews()[0])
            view = simple.GetActiveView()
        return view

    def proxy(self):
        manager = servermanager.ActiveConnection.Session.GetSessionProxyManager()
        return manager.GetProxy("haptics", "HapticSession")

    def session(self):
        return self.proxy().GetClientSideObject()

    def put(self, name, *values):
        for index, value in enumerate(values):
            servermanager.vtkSMPropertyHelper(self.proxy(), name).Set(index, value)
        self.proxy().UpdateVTKObjects()

    def engage(self):
        """Touches, anew where it did, from a free place, so that the hand is outside of everything from the start."""
        if not self.touching:
            return
        if self.session().GetTouching():
            self.put("Touching", 0)
        self.put("DeviceName", "fed")
        self.put("Scale", 1000.0)
        self.session().SetHandPosition(*FREE)
        self.put("Touching", 1)
        self.session().Update()

    # Edits.

    def some_source(self):
        sources = list(simple.GetSources().values())
        return self.random.choice(sources) if sources else None

    def add(self):
        if len(simple.GetSources()) >= MOST_SOURCES:
            return self.delete()
        self.names += 1
        kind, name = self.random.choice(("Sphere", "Box")), f"body{self.names}"
        source = getattr(simple, kind)(registrationName=name)
        if kind == "Sphere":
            source.ThetaResolution = source.PhiResolution = ROUND
            source.Radius = self.random.uniform(5.0, 60.0)
        else:
            source.XLength, source.YLength, source.ZLength = (self.random.uniform(10.0, 90.0) for _ in range(3))
        source.Center = [self.random.uniform(-40.0, 40.0) for _ in range(3)]
        simple.Show(source, self.view())

    def delete(self):
        source = self.some_source()
        if source is not None:
            simple.Delete(source)

    def change(self):
        source = self.some_source()
        if source is None:
            return
        source.Center = [self.random.uniform(-40.0, 40.0) for _ in range(3)]
        if source.GetXMLName() == "SphereSource":
            source.Radius = self.random.uniform(5.0, 60.0)

    def switch_eye(self):
        source = self.some_source()
        if source is not None:
            shown = servermanager.GetRepresentation(source, self.view())
            (simple.Hide if shown and shown.Visibility else simple.Show)(source, self.view())

    def restyle(self):
        source = self.some_source()
        display = servermanager.GetRepresentation(source, self.view()) if source is not None else None
        if display:
            display.Representation = self.random.choice(("Surface",) * 4 + ("Wireframe", "Outline", "Points"))
            display.Opacity = self.random.choice((1.0, 1.0, 1.0, 0.5, 0.0))
            move(display, [self.random.uniform(-20.0, 20.0) for _ in range(3)])

    def add_view(self):
        views = simple.GetRenderViews()
        if len(views) < 3:
            view = simple.CreateRenderView()
            simple.AssignViewToLayout(view=view)
            simple.SetActiveView(view)

    def leave_view(self):
        views = simple.GetRenderViews()
        if len(views) > 1:
            other = self.random.choice([view for view in views if view != self.view()] or views)
            if self.random.random() < 0.5:
                simple.SetActiveView(other)
            else:
                simple.Delete(other)

    def keep_state(self):
        self.state = os.path.join(self.folder, "state.pvsm")
        simple.SaveState(self.state)

    def load_state(self):
        if self.state:
            simple.ResetSession()
            simple.LoadState(self.state)
            self.engage()

    def reconnect(self):
        simple.Disconnect()
        simple.Connect()
        self.engage()

    def touch_again(self):
        self.engage()

    def other_ball(self):
        if self.touching:
            self.put("Radius", self.random.choice((0.0, 0.5, 2.0)))

    def move_hand(self):
        """Somewhere, or into the middle of the data that a source shows."""
        source = self.some_source() if self.random.random() < 0.7 else None
        middle, reach = (source.Center, 10.0) if source is not None else ((0.0, 0.0, 0.0), 90.0)
        if self.touching:
            self.session().SetHandPosition(*(c + self.random.uniform(-reach, reach) for c in middle))

    EDITS = {"add": 8, "delete": 2, "change": 6, "switch_eye": 4, "restyle": 3, "add_view": 1, "leave_view": 1, "keep_state": 1,
             "load_state": 0.7, "reconnect": 0.5, "touch_again": 0.7, "other_ball": 1, "move_hand": 12}

    def step(self):
        name = self.random.choices(list(self.EDITS), self.EDITS.values())[0]
        self.done.append(name)
        getattr(self, name)()
        simple.Render(self.view())

    # The invariants.

    def check(self):
        if self.touching:
            session = self.session()
            session.FinishScene()
            session.Update()
            self.check_force(session)

    def check_side(self):
        """After the servo had time for the newest scene."""
        if not self.touching:
            return
        session = self.session()
        session.Update()
        if not session.GetTouching():
            self.engage()  # one of the edits ended it: a state never touches by itself
            return
        self.check_force(session)
        self.pressed += session.GetForceMagnitude() > 0.0
        proxy = tuple(session.GetProxyPosition())
        self.check_hold(session, proxy)
        for name, source, display in shown_bodies(self.view()):
            if f"{name}: " not in session.GetSceneReport():
                continue  # not there yet, on a busy computer; check_free() waits for it
            self.compared += 1
            deep = depth_in(source, display, proxy)
            size = max(1.0, math.dist(proxy, (0.0, 0.0, 0.0)))
            if deep > 1e-6 * size:
                raise AssertionError(
                    f"after {self.done[-8:]}: the proxy at {proxy} is {deep} u inside of {name}; hand {tuple(session.GetHandPosition())}; "
                    f"radius {session.GetRadiusUsed()} u; {session.GetStateText()}; {session.GetFaultText()}; {session.GetSceneReport()}")

    def check_hold(self, session, proxy):
        """Between a proxy and its hand is a body that holds the proxy."""
        hand = tuple(session.GetHandPosition())
        apart = math.dist(proxy, hand)
        shown = [(source, servermanager.GetRepresentation(source, self.view())) for source in simple.GetSources().values()]
        near = [source for source, display in shown
                if display and display.Visibility and comes_near(source, display, session.GetRadiusUsed(), proxy, hand)]
        if apart > 1e-6 * max(1.0, math.dist(proxy, (0.0, 0.0, 0.0))) and not near:
            raise AssertionError(
                f"after {self.done[-8:]}: nothing holds the proxy at {proxy} away from the hand at {hand}; "
                f"{session.GetForceMagnitude()} N; {session.GetStateText()}; {session.GetSceneReport()}")

    def check_force(self, session):
        force = session.GetForceMagnitude()
        if not math.isfinite(force) or force > MOST_FORCE:
            raise AssertionError(f"after {self.done[-8:]}: {force} N")

    def free(self):
        """Lets go and begins anew far out: a hand that goes there through a body stays stopped by it, as it should."""
        self.engage()

    def check_free(self):
        if self.touching:
            self.session().Update()
            force = self.session().GetForceMagnitude()
            if not force < NO_FORCE:
                raise AssertionError(f"after {self.done[-8:]}: {force} N are left far from everything")
            for name, _, _ in shown_bodies(self.view()):
                if f"{name}: " not in self.session().GetSceneReport():
                    raise AssertionError(f"after {self.done[-8:]}: {name} is seen and not felt: {self.session().GetSceneReport()}")

    def clear(self):
        for source in list(simple.GetSources().values()):
            simple.Delete(source)
        for view in simple.GetRenderViews()[1:]:
            simple.Delete(view)
        simple.Render(self.view())

    def remember_memory(self):
        self.memory = resident_memory()

    def report(self, path):
        grown = resident_memory() - self.memory if self.memory else 0.0
        pathlib.Path(path).write_text(f"{len(self.done)} edits, {grown:.1f} MB grown, {self.pressed} times pressed, "
            f"{self.compared} times compared with a body\n", encoding="utf-8")
