# SPDX-License-Identifier: GPL-3.0-or-later
"""The cost of feeling the surface of a large data set of a server: run by hand, under pvpython.

    python="build/lib/python:testing/support:testing/plugin"
    PALPATE_PLUGIN=build/lib/paraview-5.11/plugins/Palpate/Palpate.so PYTHONPATH=$python \
        xvfb-run -a pvpython testing/benchmarks/far_surface.py [cells of an edge: 464] [ranks: 2]

The data are waves on an image of so many cells cubed, made on the server by its ranks; their surfaces of nine values are
felt by a hand that goes 0.1 m/s in virtual time, and a part is asked for whenever it is needed.
"""

import os
import sys
import time
from pathlib import Path

from paraview import simple

from haptic_proxies import put
from pvserver import server
from view_fixture import ViewTest

EDGE = int(sys.argv[1]) if len(sys.argv) > 1 else 464
RANKS = int(sys.argv[2]) if len(sys.argv) > 2 else 2
VALUES = [60.0 + 20.0 * i for i in range(9)]
THERE = os.environ | {"PV_PLUGIN_PATH": str(Path(os.environ["PALPATE_PLUGIN"]).resolve().parent)}
TICK = os.sysconf("SC_CLK_TCK")


def resident_mb(process):
    return int(Path(f"/proc/{process}/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 1e6


def cpu_s(process):
    fields = Path(f"/proc/{process}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / TICK


def ranks_of(process):
    """The processes of pvserver: the one, or those that mpiexec began."""
    children = Path(f"/proc/{process}/task/{process}/children").read_text().split()
    return [int(child) for child in children] if RANKS > 1 else [process]


class Walk(ViewTest):
    def __init__(self):
        super().__init__("walk")

    def walk(self, processes):
        half = EDGE // 2
        image = simple.Wavelet(registrationName="Image", WholeExtent=[-half, half, -half, half, -half, half])
        # The waves of the usual size, however fine the image is.
        image.XFreq, image.YFreq, image.ZFreq = (20.0 * f / half for f in (60.0, 30.0, 40.0))
        image.StandardDeviation = 0.5
        contour = simple.Contour(registrationName="Waves", Input=image, ContourBy=["POINTS", "RTData"], Isosurfaces=VALUES,
                                 ComputeNormals=0, ComputeScalars=0)
        begun = time.monotonic()
        contour.UpdatePipeline()
        print(f"{EDGE ** 3:.3g} cells, {contour.GetDataInformation().GetNumberOfCells():.3g} triangles, made in {time.monotonic() - begun:.1f} s")
        put(self.view.SMProxy, "RemoteRenderThreshold", 0.0)  # drawn by the server
        self.show(contour)
        put(self.proxy, "Scale", 100.0)
        self.session.SetHandPosition(0.0, 0.0, 0.0)
        begun = time.monotonic()
        self.follow()
        print(f"first request, which looks at the surface: {time.monotonic() - begun:.1f} s")
        put(self.proxy, "Touching", 1)
        self.session.Step(1000)
        self.requests(processes, half)

    def requests(self, processes, half):
        parts, seconds, kib, cells, before = 0, 0.0, 0.0, 0, sum(map(cpu_s, processes))
        sentence = self.session.GetServerText()
        for i in range(2000):
            self.session.SetHandPosition(-0.5 * half + 0.01 * i * min(1.0, half / 20.0), 1.3, 0.7)
            self.session.Step(1)
            begun = time.monotonic()
            if self.scene.Update():
                seconds += time.monotonic() - begun
                parts += 1
                self.session.FinishScene()
                sentence = self.session.GetServerText()
                cells += int(sentence.split()[1])
        used = sum(map(cpu_s, processes)) - before
        print(f"{parts} parts of {cells / parts:.0f} polygons, {parts / seconds:.1f} a second, {used / parts:.3f} s of server CPU each; "
              f"{sentence}; ticks beyond: {self.session.GetServerTicksBeyond()}")
        print(f"client {resident_mb(os.getpid()):.0f} MB, ranks {', '.join(f'{resident_mb(p):.0f}' for p in processes)} MB")


with server(THERE, [], RANKS) as (port, first):
    simple.Connect("localhost", port)
    walk = Walk()
    walk.setUp()
    walk.walk(ranks_of(first))
    walk.tearDown()
    simple.Disconnect()
