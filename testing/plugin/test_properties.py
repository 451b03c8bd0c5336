# SPDX-License-Identifier: GPL-3.0-or-later
"""Every setting of the session: saved, loaded, set in the object, and in the user guide. A process of its own, for
loading a state replaces views."""

import json
import os
import sys
import tempfile
import unittest
from xml.etree import ElementTree

from paraview import servermanager, simple

import described
from haptic_proxies import manager

# Values that are not the default where a domain does not list the allowed ones.
VALUES = {
    "DeviceName": ["mouse"],
    "ServerLimit": [2000],
    "Hand": ["light"],
    "PressDepth": [0.0035],
    "FieldDetentLevels": ["10, 20, 35"],
    "MarksText": ["Source,X,Y,Z,Cell\nBall,1,2.5,-3,7\n"],
    "SourcesText": ["Source,Touched,Stiffness,FrictionStatic,FrictionKinetic\nBall,0,inf,0.5,0.25\n"],
    "Rotation": [0.5, 0.5, -0.5, 0.5],
    "StrokePoints": [1.0, 2.0, 3.0, 4.0, 5.0, 6.0],
}
# Added point by point: the object says how many there are.
NO_GETTER = ("StrokePoints",)
# Proxies that have settings of the session too, and the tables' key of their defaults.
OTHER_PROXIES = (("plugin/HapticSettings.xml", "HapticSettings", "default_words"),
                 ("filters/pipeline/HapticPipeline.xml", "TouchAlongPath", "path_default_words"))


def said_of(element):
    """How many numbers a property has, between which ends, and its sentence."""
    ends = [(domain.get("min"), domain.get("max")) for domain in element if domain.tag.endswith("RangeDomain")]
    return element.get("number_of_elements"), ends, " ".join(element.findtext("Documentation").split())


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
    session = proxy.GetClientSideObject()
    if proxy.GetProperty(name).GetInformationOnly():
        found = getattr(session, proxy.GetProperty(name).GetCommand())()
        return list(found) if isinstance(found, tuple) else [found]
    return list(session.GetSettingNumbers(name)) if session.GetSettingSize(name) else [session.GetSettingText(name)]


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

    def test_properties_and_user_guide_say_what_the_tables_of_the_session_say(self):
        tables = json.loads(self.proxy.GetClientSideObject().GetDescribed())
        for file, begin, end, table, render in described.PLACES:
            text = file.read_text(encoding="utf-8")
            self.assertEqual((text.count(begin), text.count(end)), (1, 1), (file, begin, end))
            self.assertEqual(described.between(text, begin, end), "".join(map(render, tables[table])), file)

    def test_the_tables_of_the_session_name_what_is_there_and_what_it_is_by_default(self):
        tables = json.loads(self.proxy.GetClientSideObject().GetDescribed())
        saved = [setting for setting in tables["settings"] if setting["saved"]]
        self.assertEqual({setting["name"] for setting in saved}, set(settings(self.proxy)))
        for setting in saved:
            default = [setting["default_text"]] if setting["kind"] == "text" else setting["defaults"]
            if setting["name"] not in NO_GETTER:
                self.assertEqual(from_object(self.proxy, setting["name"]), default, setting["name"])
        for readout in tables["readouts"]:
            self.assertEqual(len(from_object(self.proxy, readout["name"])), readout["elements"], readout["name"])
            self.assertTrue(self.proxy.GetProperty(readout["name"]).GetInformationOnly(), readout["name"])

    def test_the_same_setting_of_another_proxy_is_as_the_tables_say(self):
        tables = json.loads(self.proxy.GetClientSideObject().GetDescribed())
        settings_of = {setting["name"]: setting for setting in tables["settings"]}
        for file, proxy, words in OTHER_PROXIES:
            found = ElementTree.parse(described.ROOT / file).find(f".//*[@name='{proxy}']")
            shared = [element for element in found if element.get("name") in settings_of]
            self.assertGreater(len(shared), 2, proxy)
            for element in shared:
                setting = settings_of[element.get("name")]
                wanted = ElementTree.fromstring(described.setting_xml(setting))
                self.assertEqual(element.tag, wanted.tag, setting["name"])
                self.assertEqual(said_of(element), said_of(wanted), (proxy, setting["name"]))
                default = ", ".join(element.get("default_values").split()) or "none"
                default = {"0": "off", "1": "on"}[default] if setting["kind"] == "flag" else default
                default = setting["choices"][int(default)].lower() if setting["kind"] == "choice" else default
                default += "" if setting["unit"] in ("", "1") else " " + setting["unit"]
                self.assertEqual(default, setting[words], (proxy, setting["name"]))

    def test_a_number_beyond_the_range_of_the_table_is_refused_by_name_and_the_old_one_stays(self):
        session = self.proxy.GetClientSideObject()
        session.GlobalWarningDisplayOff()
        for setting in json.loads(session.GetDescribed())["settings"]:
            name, elements = setting["name"], len(setting["defaults"])
            ends = [setting["low"] if setting["above"] else (setting["low"] or 0) - 1, (setting["high"] or 0) + 1]
            beyond = [end for end, limit in zip(ends, (setting["low"], setting["high"])) if limit is not None]
            for value in beyond + ([len(setting["choices"])] if setting["kind"] == "choice" else []):
                before = from_object(self.proxy, name)
                session.SetSetting(name, *[value] * elements)
                self.assertEqual(from_object(self.proxy, name), before, name)
                self.assertIn(setting["allowed"], session.GetProblem(), name)
                session.SetSetting(name, *before)
                self.assertEqual(session.GetProblem(), "", name)
        session.GlobalWarningDisplayOn()


if __name__ == "__main__":
    # A SystemExit would skip pvpython's own ending, which closes views before the display.
    if not unittest.main(exit=False).result.wasSuccessful():
        sys.exit(1)
