# SPDX-License-Identifier: GPL-3.0-or-later
"""GUI scripts on fields: data, the panel's session, and checks against formulas and ParaView's own probe."""

import gzip
import math
import os
import struct
import tempfile

from paraview import servermanager, simple

from palpate.vtkHapticInteraction import vtkHapticSession  # noqa: F401  the proxy's object becomes scriptable


def session():
    proxy = servermanager.ActiveConnection.Session.GetSessionProxyManager().GetProxy("haptics", "HapticSession")
    return proxy.GetClientSideObject()


def show(source, representation, array=None):
    """The only source that is shown, coloured by an array of its points."""
    for other in simple.GetSources().values():
        simple.Hide(other)
    display = simple.Show(source)
    if array:
        simple.ColorBy(display, ("POINTS", array))
    display.SetRepresentationType(representation)
    simple.SetActiveSource(source)
    simple.ResetCamera()
    simple.Render()
    return display


def wavelet():
    show(simple.Wavelet(registrationName="Wavelet1"), "Volume", "RTData")


def head():
    """A NIfTI volume of distances from its middle, mirrored along x as scanners give them, packed."""
    size = 33
    header = bytearray(352)
    struct.pack_into("<i", header, 0, 348)
    struct.pack_into("<8h", header, 40, 3, size, size, size, 1, 1, 1, 1)
    struct.pack_into("<2h", header, 70, 16, 32)
    struct.pack_into("<3f", header, 108, 352, 1, 0)
    struct.pack_into("<h", header, 254, 1)
    struct.pack_into("<12f", header, 280, -1, 0, 0, 16, 0, 1, 0, -16, 0, 0, 1, -16)
    header[344:348] = b"n+1\0"
    voxels = [math.dist((i, j, k), (16, 16, 16)) for k in range(size) for j in range(size) for i in range(size)]
    path = os.path.join(tempfile.mkdtemp(prefix="palpate-"), "head.nii.gz")
    with gzip.open(path, "wb") as file:
        file.write(bytes(header) + struct.pack(f"<{size ** 3}f", *voxels))
    show(simple.OpenDataFile(path, registrationName="head"), "Volume", "NIFTI")


def flow(kind, cells):
    source = simple.KnownFlow(registrationName="flow", Flow=kind, Cells=cells)
    show(source, "Outline")


def hidden(kind):
    """A flow that is not shown, called hidden."""
    shown = simple.GetActiveSource()
    simple.KnownFlow(registrationName="hidden", Flow=kind)
    simple.SetActiveSource(shown)


def labels():
    """Whole numbers on voxels, as an atlas has them."""
    map_of = simple.Calculator(registrationName="labels", Input=simple.Wavelet(), Function="floor(RTData / 60)", ResultArrayName="Label")
    show(map_of, "Outline", "Label")


def later(time):
    """ParaView's time goes there."""
    scene = simple.GetAnimationScene()
    scene.UpdateAnimationUsingDataTimeSteps()
    scene.AnimationTime = time
    simple.Render()


def ready():
    """Waits for the worker: the next motion of a scripted hand is not to depend on how busy the machine is."""
    assert session().FinishField(), session().GetFieldText() + session().GetProblem()


def check_value_at_proxy(array, value, within):
    """The judge is ParaView's probe where the proxy is."""
    located = simple.ProbeLocation(Input=simple.GetActiveSource(), ProbeType="Fixed Radius Point Source")
    located.ProbeType.Center = list(session().GetProxyPosition())
    found = servermanager.Fetch(located).GetPointData().GetArray(array).GetTuple1(0)
    simple.Delete(located)
    assert abs(found - value) <= within, f"{array} is {found} at the proxy, not {value}"


def check_value_at_hand(value, within):
    found = session().GetFieldValue()
    assert abs(found - value) <= within, f"the value at the hand is {found}, not {value}"


def double_gyre_speed(x, y, time):
    """By the formula of Shadden, Lekien and Marsden (2005): 0.1, 0.25, 10 s."""
    a = 0.25 * math.sin(0.2 * math.pi * time)
    b = 1 - 2 * a
    f, slope = a * x * x + b * x, 2 * a * x + b
    u = -0.1 * math.pi * math.sin(math.pi * f) * math.cos(math.pi * y)
    v = 0.1 * math.pi * math.cos(math.pi * f) * math.sin(math.pi * y) * slope
    return math.hypot(u, v)


def check_forces_where_the_data_is():
    """*Touch Along Path* through heights, on whatever server and ranks they are: only the forces travel."""
    heights = simple.Calculator(Input=simple.Wavelet(), Function="coordsZ", ResultArrayName="height")
    path = simple.Line(Point1=[0.3, 0.2, 1.0], Point2=[0.3, 0.2, -1.0], Resolution=80)
    touch = simple.TouchAlongPath(Input=heights, Path=path, Field=heights, Stiffness=400, FieldArray="height", FieldIsosurface=1,
                                  FieldIsovalue=0.125)
    felt = servermanager.Fetch(touch).GetPointData()
    assert felt.GetNumberOfTuples() == 81, f"{felt.GetNumberOfTuples()} ticks were felt"
    for i in range(81):
        hand, force = felt.GetArray("Device").GetTuple3(i), felt.GetArray("Force").GetTuple3(i)
        expected = 400 * max(0.0, 0.125 - hand[2])
        assert math.dist(force, (0, 0, expected)) <= 1e-3, f"{force} N at {hand}, not {expected}"
    for source in (touch, path, heights):
        simple.Delete(source)


def picture(name):
    """The view, for a person to look at, where PALPATE_PICTURES names a folder."""
    folder = os.environ.get("PALPATE_PICTURES")
    if folder:
        simple.SaveScreenshot(os.path.join(folder, name + ".png"))
