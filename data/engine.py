#!/usr/bin/env pvpython
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes a probe, its path behind the engine of the motorbike, and a ParaView state in which a hand holds the probe.

    pvpython data/engine.py MOTORBIKE FOLDER

MOTORBIKE is the file that `data/get motorbike` prints. FOLDER gets probe.vtp, way.csv for `palpate touch --tool --path`, and
engine.pvsm. The probe is a rod of 0.3 m with a ball of 12 mm at its end. The probe comes from the right, between the engine and the
wheel behind it, and is then led forward, 4 cm further than the engine lets it. Needs PYTHONPATH and PV_PLUGIN_PATH as the README
says.
"""

import csv
import pathlib
import sys

from paraview import simple

simple.LoadDistributedPlugin("Palpate", remote=False, ns=globals())
from palpate.simple import HoldTool, SetHaptics  # noqa: E402
from palpate.vtkHapticPipeline import vtkHapticToolShape  # noqa: E402
from vtkmodules.vtkCommonTransforms import vtkTransform  # noqa: E402
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter  # noqa: E402
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter  # noqa: E402

RADIUS, LENGTH = 0.006, 0.3  # m, of the probe's ball and of the whole
BEHIND = 0.83, 0.324  # m, x and z of a gap that is wide enough
OUTSIDE, INSIDE = -0.6, -0.1  # m, y of the ball's end
FORWARD = 0.06  # m
IN, ON = 0.5, 0.25  # s, to go in and then forward
STEPS = 750
UNTURNED = 1.0, 0.0, 0.0, 0.0


def fail(text):
    sys.exit(f"engine: {text}")


def write_probe(path):
    """A tool that hangs below the hand is laid along y: a hand that cannot turn holds it so."""
    probe, forward, turned, writer = vtkHapticToolShape(), vtkTransform(), vtkTransformPolyDataFilter(), vtkXMLPolyDataWriter()
    probe.SetShape(vtkHapticToolShape.Burr)
    probe.SetRadius(RADIUS)
    probe.SetLength(LENGTH)
    probe.SetResolution(3)
    forward.RotateX(90.0)
    turned.SetTransform(forward)
    turned.SetInputConnection(probe.GetOutputPort())
    writer.SetInputConnection(turned.GetOutputPort())
    writer.SetFileName(str(path))
    if not writer.Write():
        fail(f"cannot write {path}: is there room, and may you write there?")


def hand(t):
    """Where the hand is that holds the upper end of the probe."""
    inward, onward = min(1.0, t / IN), max(0.0, (t - IN) / ON)
    return BEHIND[0] - FORWARD * onward, OUTSIDE + (INSIDE - OUTSIDE) * inward - LENGTH, BEHIND[1]


def write_way(path):
    with open(path, "w", newline="", encoding="utf-8") as file:
        rows = csv.writer(file, lineterminator="\n")
        rows.writerow(["t", "x", "y", "z", "qw", "qx", "qy", "qz"])
        for i in range(STEPS + 1):
            t = (IN + ON) * i / STEPS
            rows.writerow([f"{value:.9g}" for value in (t, *hand(t), *UNTURNED)])


def write_state(motorbike, probe, path):
    """The motorbike is shown, the probe is held at its upper end, with a millimetre of the hand as one of the data."""
    view = simple.GetActiveViewOrCreate("RenderView")
    bike = simple.OpenDataFile(str(motorbike))
    if not bike:
        fail(f"ParaView cannot open {motorbike}: run `data/get motorbike` and give the file that it prints")
    simple.Show(bike, view)
    held = simple.OpenDataFile(str(probe))
    simple.RenameSource("Probe", held)
    simple.Show(held, view)
    SetHaptics(Scale=1.0, FitOnTouch=0, ToolHandle="Origin of its data", Offset=[BEHIND[0], OUTSIDE - LENGTH, BEHIND[1]])
    HoldTool("Probe", view)
    simple.ResetCamera(view)
    simple.SaveState(str(path))


def main(arguments):
    if len(arguments) != 2:
        fail("needs MOTORBIKE and FOLDER: data/engine.py motorbike.obj out")
    motorbike, folder = (pathlib.Path(text).absolute() for text in arguments)
    if not motorbike.is_file():
        fail(f"there is no file {motorbike}: run `data/get motorbike` and give the file that it prints")
    folder.mkdir(parents=True, exist_ok=True)
    write_probe(folder / "probe.vtp")
    write_way(folder / "way.csv")
    write_state(motorbike, folder / "probe.vtp", folder / "engine.pvsm")


if __name__ == "__main__":
    main(sys.argv[1:])
