# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces of a server are felt. The judge is the same hand on the same surface of the built-in server."""

import contextlib
import io
import os
import re
import shlex
import signal
import subprocess
import sys
import time
import unittest
from pathlib import Path

from paraview import servermanager, simple
from vtkmodules.vtkCommonCore import mutable
from vtkmodules.vtkCommonDataModel import vtkStaticCellLocator

from haptic_proxies import put
from palpate.simple import HapticRefusal, Touch
from pvserver import server
from slow_link import slow_link
from view_fixture import ViewTest

SCALE, STIFFNESS = 50.0, 500.0  # u/m: a hand is followed 6 u far; N/m
DEPTH, FELT = 0.3, 0.2  # u below the surface along z, which is steep: at least so much is felt [N]
WAY = [-4.5 + 0.22 * i for i in range(40)]  # along x [u]
PART, WHOLE = 2000, 100000  # ServerLimit


def waves():
    """Waves around the origin, of 50 000 triangles."""
    wavelet = simple.Wavelet(registrationName="Source", WholeExtent=[-30, 30, -30, 30, -30, 30])
    return simple.Contour(registrationName="Waves", Input=wavelet, ContourBy=["POINTS", "RTData"], Isosurfaces=[180.0])


def slide():
    """A path of the hand below the highest surface over a line, by a ray through the data that are here."""
    contour = waves()
    surface, locator, hand = servermanager.Fetch(contour), vtkStaticCellLocator(), []
    locator.SetDataSet(surface)
    locator.BuildLocator()
    for x in WAY:
        at = [0.0, 0.0, 0.0]
        if locator.IntersectWithLine((x, 0.31, 29.0), (x, 0.31, -29.0), 1e-9, mutable(0.0), at, [0.0] * 3, mutable(0)):
            hand.append((x, 0.31, at[2] - DEPTH))
    for source in (contour, contour.Input):
        simple.Delete(source)
    assert len(hand) == len(WAY)
    return hand


class Hand(ViewTest):
    """On a surface of whatever server is connected."""

    def __init__(self):
        super().__init__("touch")

    def touch(self, hand, limit, virtual=True):
        self.contour = waves()
        self.show(self.contour)
        put(self.proxy, "Scale", SCALE)
        put(self.proxy, "Stiffness", STIFFNESS)
        put(self.proxy, "ServerLimit", limit)
        self.session.SetSetting("VirtualTime", virtual)
        x, y, z = hand[0]
        self.session.SetHandPosition(x, y, z + 3.0)
        self.follow()
        put(self.proxy, "Touching", 1)

    def at(self, place):
        self.session.SetHandPosition(*place)
        self.session.Step(1)
        self.follow()

    def forces(self, hand, limit):
        """In virtual time, along the path."""
        self.touch(hand, limit)
        self.session.Step(1200)
        x, y, z = hand[0]
        for i in range(1, 11):
            self.at((x, y, z + 3.0 - 0.3 * i))
        felt = []
        for place in hand:
            self.at(place)
            felt.append(tuple(self.session.GetForce()))
        return felt

    def until(self, holds, most=60.0):
        """As soon as it holds; a limit no machine is too slow for says that it never does."""
        end = time.monotonic() + most
        while not holds() and time.monotonic() < end:
            self.follow()
            time.sleep(0.05)
            self.session.Update()
        return holds()

    def wait(self, seconds):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            self.session.Update()
            time.sleep(0.01)


@contextlib.contextmanager
def hand():
    one = Hand()
    one.setUp()
    try:
        yield one
    finally:
        one.tearDown()


@contextlib.contextmanager
def connected(ranks=1, plugin=True, delay_s=0.0):
    """A server of so many ranks; the number of its process."""
    with contextlib.ExitStack() as stack:
        environment = {name: value for name, value in os.environ.items() if plugin or name != "PV_PLUGIN_PATH"}
        port, process = stack.enter_context(server(environment, [], ranks))
        if delay_s > 0.0:
            port = stack.enter_context(slow_link(port, delay_s))
        stack.callback(simple.Connect)  # as ParaView has it without a server
        assert simple.Connect("localhost", port), "no connection"
        stack.callback(simple.Disconnect)
        yield process


class SurfaceOnAServer(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.way = slide()
        with hand() as here:
            cls.expected = here.forces(cls.way, WHOLE)
        assert min(sum(c * c for c in f) for f in cls.expected) > FELT ** 2

    def check(self, found):
        self.assertGreater(len(found), 9)
        for i, (one, other) in enumerate(zip(found, self.expected)):
            for a, b in zip(one, other):
                self.assertAlmostEqual(a, b, delta=1e-9, msg=str(i))

    def check_felt(self, limit, sentence, thickest=float("inf"), drawn_there=False):
        with hand() as there:
            self.check(there.forces(self.way, limit))
            self.assertEqual(bool(there.view.GetClientSideObject().GetUseDistributedRenderingForRender()), drawn_there)
            self.assertIn(sentence, there.session.GetServerText())
            self.assertIn("Touching Waves.", there.scene.GetReport())
            self.assertEqual(there.session.GetServerTicksBeyond(), 0)
            cells = int(there.session.GetServerText().split()[1]) if "around the hand" in sentence else 0
            self.assertLess(cells, thickest)

    def test_whole_or_in_parts_drawn_here_or_there_on_one_rank_or_two_it_feels_as_the_built_in_servers(self):
        with connected():
            self.check_felt(WHOLE, "Waves: all of its")
            self.check_felt(PART, "u around the hand", 2 * PART)
        with connected(ranks=2):
            simple.GetSettingsProxy("RenderViewSettings").RemoteRenderThreshold = 0.0
            try:
                self.check_felt(PART, "u around the hand", 2 * PART, drawn_there=True)
            finally:
                simple.GetSettingsProxy("RenderViewSettings").RemoteRenderThreshold = 20.0

    def test_of_what_is_not_drawn_as_a_surface_any_more_nothing_is_kept(self):
        with connected(), hand() as there:
            there.touch(self.way, WHOLE)
            self.assertIn("Waves: all of its", there.session.GetServerText())
            display = simple.GetDisplayProperties(there.contour, there.view)
            display.Representation = "Outline"
            simple.Render(there.view)
            there.follow()
            self.assertEqual(there.session.GetServerText(), "")
            there.contour.Isosurfaces = [150.0]
            display.Representation = "Surface"
            simple.Render(there.view)
            there.follow()
            self.assertIn("Waves: all of its", there.session.GetServerText())

    def test_touch_along_path_on_two_ranks_is_that_of_the_built_in_server(self):
        def felt():
            contour, x = waves(), self.way[0][0]
            path = simple.PolyLineSource(Points=[c for place in [(x, 0.31, 25.0), *self.way] for c in place])
            touched = servermanager.Fetch(simple.TouchAlongPath(Input=contour, Path=path, Stiffness=STIFFNESS, Scale=SCALE))
            force = touched.GetPointData().GetArray("Force")
            return [force.GetTuple(i) for i in range(touched.GetNumberOfPoints())]
        expected = felt()
        with connected(2):
            found = felt()
        self.assertEqual(len(found), len(self.way) + 1)
        for one, other in zip(found, expected):
            for a, b in zip(one, other):
                self.assertAlmostEqual(a, b, delta=1e-9)

    def test_a_server_without_the_plugin_is_said_with_the_cure(self):
        with connected(plugin=False):
            with self.assertRaisesRegex(HapticRefusal, "PV_PLUGIN_PATH"):
                Touch()

    def test_over_a_link_of_200_ms_the_forces_are_the_same(self):
        with connected(delay_s=0.2), hand() as there:
            self.check(there.forces(self.way[:10], PART))
            self.assertIn("u around the hand", there.session.GetServerText())

    def test_the_commands_of_the_guide_do_what_it_says(self):
        guide = Path(os.environ["PALPATE_SOURCE_DIR"], "docs/servers.md").read_text(encoding="utf-8")
        setting, *command = shlex.split(re.search(r"^    (PV_PLUGIN_PATH=.*)$", guide, re.MULTILINE)[1])
        self.assertEqual((setting, command[0]), ("PV_PLUGIN_PATH=$PLUGINS", "pvserver"))
        script = re.search(r"```python\n(.*?)```", guide, re.DOTALL)[1]
        with server(os.environ, command[2:]) as (port, _):  # its port is free
            said = io.StringIO()
            with contextlib.redirect_stdout(said):
                exec(script.replace("11111", str(port)), {})
            simple.Disconnect()
            simple.Connect()
        self.assertRegex(said.getvalue(), r"^Sphere1: \d+ of its 318400 polygons, [0-9.]+ u around the hand\n$")

    def test_a_server_that_stalls_or_dies_ends_the_force_and_another_is_felt(self):
        with connected() as process, hand() as there:
            there.touch(self.way, PART, virtual=False)
            there.wait(1.0)
            force = there.session.GetForceMagnitude
            there.session.SetHandPosition(*self.way[0])
            self.assertTrue(there.until(lambda: force() > FELT))
            os.kill(process, signal.SIGSTOP)
            goes_on = subprocess.Popen(["sh", "-c", f"sleep 5; kill -CONT {process}"])  # this process waits, threads and all
            there.session.SetHandPosition(self.way[0][0] + 4.0, *self.way[0][1:])  # beyond half of the part that is there
            there.wait(0.1)
            there.follow()  # the window stands until the server goes on
            goes_on.wait()
            self.assertGreater(there.session.GetServerTicksBeyond(), 0)
            there.session.SetHandPosition(*self.way[0])
            self.assertTrue(there.until(lambda: force() > FELT), "it goes on")
            os.kill(process, signal.SIGKILL)
            there.session.SetHandPosition(self.way[0][0] + 4.0, *self.way[0][1:])  # the missing part is asked for
            self.assertTrue(there.until(lambda: "the server does not answer" in there.scene.GetReport()))
            self.assertTrue(there.until(lambda: force() == 0.0))
        with connected(), hand() as there:
            self.check(there.forces(self.way[:10], PART))


if __name__ == "__main__":
    # A SystemExit would skip pvpython's own ending, which closes views before the display.
    if not unittest.main(exit=False, argv=sys.argv[:1] + (sys.argv[1:] or ["SurfaceOnAServer"])).result.wasSuccessful():
        sys.exit(1)
