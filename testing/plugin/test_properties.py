# SPDX-License-Identifier: GPL-3.0-or-later
"""Every setting of the session: saved, loaded, set in the object, and in the user guide. A process of its own, for
loading a state replaces views."""

import os
import re
import sys
import tempfile
import unittest

from paraview import servermanager, simple

from haptic_proxies import manager

# Values that are not the default where a domain does not say what else is allowed.
VALUES = {
    "DeviceName": ["mouse"],
    "Hand": ["light"],
    "PressDepth": [0.0035],
    "Rotation": [0.5, 0.5, -0.5, 0.5],
    "StrokePoints": [1.0, 2.0, 3.0, 4.0, 5.0, 6.0],
}
# Added point by point: the object says how many there are.
NO_GETTER = ("StrokePoints",)


def settings(proxy):
    """Names of the properties that a state file keeps."""
    names = []
    iterator = proxy.NewPropertyIterator()
    while not iterator.IsAtEnd():
        found = iterator.GetProperty()
        if hasattr(found, "GetNumberOfElements") and not found.GetIsInternal() and not found.GetInformationOnly():
            names.append(iterator.GetKey())
        iterator.Next()
    return names


def values(proxy, name):
    helper = servermanager.vtkSMPropertyHelper(proxy, name)
    kind = proxy.GetProperty(name).GetClassName()
    read = {"vtkSMIntVectorProperty": helper.GetAsInt, "vtkSMStringVectorProperty": helper.GetAsString}
    return [read.get(kind, helper.GetAsDouble)(i) for i in range(helper.GetNumberOfElements())]


def other(proxy, name):
    """Values that the property may have and does not have by default."""
    if name in VALUES:
        return VALUES[name]
    present = values(proxy, name)
    kind = proxy.GetProperty(name).GetClassName()
    if kind == "vtkSMStringVectorProperty":
        return [name + ".other"]
    if kind == "vtkSMIntVectorProperty":
        return [1 if value == 0 else 0 for value in present]
    return [0.75 * value + 0.125 * (i + 1) for i, value in enumerate(present)]


def put(proxy, name, new):
    helper = servermanager.vtkSMPropertyHelper(proxy, name)
    helper.SetNumberOfElements(len(new))
    for index, value in enumerate(new):
        helper.Set(index, value)


def from_object(proxy, name):
    found = getattr(proxy.GetClientSideObject(), "G" + proxy.GetProperty(name).GetCommand()[1:])()
    return list(found) if isinstance(found, tuple) else [found]


class Properties(unittest.TestCase):
    def setUp(self):
        self.proxy = manager().NewProxy("haptics", "HapticSession")
        self.proxy.UpdateVTKObjects()

    def test_the_defaults_of_the_properties_are_those_of_the_object(self):
        for name in settings(self.proxy):
            if name not in NO_GETTER:
                self.assertEqual(from_object(self.proxy, name), values(self.proxy, name), name)

    def test_every_setting_is_in_a_state_file_and_comes_back(self):
        names = settings(self.proxy)
        wanted = {name: other(self.proxy, name) for name in names}
        for name in names:
            self.assertNotEqual(wanted[name], values(self.proxy, name), name)
            put(self.proxy, name, wanted[name])
        self.proxy.UpdateVTKObjects()
        manager().RegisterProxy("haptics", "HapticSession", self.proxy)
        with tempfile.TemporaryDirectory() as folder:
            state = os.path.join(folder, "state.pvsm")
            simple.SaveState(state)
            manager().UnRegisterProxy("haptics", "HapticSession", self.proxy)
            simple.LoadState(state)
        loaded = manager().GetProxy("haptics", "HapticSession")
        self.assertIsNot(loaded, self.proxy)
        for name in names:
            self.assertEqual(values(loaded, name), wanted[name], name)
            if name not in NO_GETTER:
                self.assertEqual(from_object(loaded, name), wanted[name], name)
        self.assertEqual(loaded.GetClientSideObject().GetNumberOfStrokePoints(), len(wanted["StrokePoints"]) // 3)
        self.assertEqual(loaded.GetClientSideObject().GetProblem(), "")
        self.assertFalse(loaded.GetClientSideObject().GetTouching())
        manager().UnRegisterProxy("haptics", "HapticSession", loaded)

    def test_the_user_guide_names_every_setting_and_nothing_else(self):
        with open(os.path.join(os.environ["PALPATE_SOURCE_DIR"], "plugin", "README.md"), encoding="utf-8") as file:
            guide = file.read()
        part = guide[guide.index("## What it sets"):guide.index("## What it shows")]
        rows = [row.split("|")[2] for row in part.splitlines() if row.startswith("| ")]
        prose = part[part.index("Without a place in the panel"):].split("\n\n")[0]
        said = set(re.findall(r"`([A-Z][A-Za-z]+)`", " ".join(rows) + prose))
        arrays = {stem + part for stem in ("Stiffness", "Friction", "Texture")
                  for part in ("Array", "Component", "DataRange", "FeltRange")}
        missing = [name for name in settings(self.proxy) if name not in said | arrays]
        unknown = [name for name in said if self.proxy.GetProperty(name) is None]
        self.assertEqual((missing, unknown), ([], []))


if __name__ == "__main__":
    # A SystemExit would skip pvpython's own ending, which closes views before the display.
    if not unittest.main(exit=False).result.wasSuccessful():
        sys.exit(1)
