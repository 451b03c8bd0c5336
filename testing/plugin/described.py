# SPDX-License-Identifier: GPL-3.0-or-later
"""The settings of haptics/session/settings/ as text: properties, setters, the user guide's tables and the program's.

`ninja -C build tables` runs it with the program that prints the tables as JSON: it writes the places of PLACES anew.
"""

import json
import re
import subprocess
import sys
from pathlib import Path
from xml.sax.saxutils import escape

ROOT = Path(__file__).resolve().parents[2]
XML = ROOT / "filters" / "interaction" / "HapticInteraction.xml"
GUIDE = ROOT / "plugin" / "README.md"
WRAPPED = ROOT / "filters" / "interaction" / "session" / "vtkHapticSession.h"  # includes the declarations; the wrapper looks at its own time
DECLARATIONS = ROOT / "filters" / "interaction" / "session" / "vtkHapticSessionDescribed.h"
TOUCH_XML = ROOT / "filters" / "pipeline" / "HapticPipeline.xml"
PROGRAM = ROOT / "docs" / "program.md"

SETTING_KIND = {"flag": "Int", "count": "Int", "choice": "Int", "number": "Double", "rotation": "Double",
                "points": "Double", "text": "String"}
READOUT_KIND = {"flag": "Int", "count": "Int", "long count": "IdType", "number": "Double", "text": "String"}
REPEATED = ' command="AddStrokePoint" clean_command="ClearStrokePoints"\n' + 28 * " " + \
           'repeat_command="1" number_of_elements_per_command="3" number_of_elements="0"'


def documentation(described):
    """The unit stands behind the first sentence, which names the quantity."""
    unit = f" [{described['unit']}]" if described["unit"] else ""
    first, stop, rest = described["sentence"].partition(". ")
    return f"        <Documentation>{escape(first + unit + stop + rest)}.</Documentation>"


def number(value):
    return f"{value:.15g}"


def domain(setting):
    """Lines that give the allowed values of the property."""
    ends = "".join(f' {end}="{number(setting[key])}"' for end, key in (("min", "low"), ("max", "high"))
                   if setting[key] is not None and not setting["above"])
    if setting["kind"] == "flag":
        return ['        <BooleanDomain name="bool"/>']
    if setting["kind"] == "choice":
        entries = [f'          <Entry value="{i}" text="{text}"/>' for i, text in enumerate(setting["choices"])]
        return ['        <EnumerationDomain name="enum">', *entries, "        </EnumerationDomain>"]
    if setting["kind"] == "text" and setting["choices"]:
        entries = [f'          <String value="{text}"/>' for text in setting["choices"]]
        return ['        <StringListDomain name="list">', *entries, "        </StringListDomain>"]
    kind = {"count": "Int", "number": "Double"}.get(setting["kind"])
    return [f'        <{kind}RangeDomain name="range"{ends}/>'] if kind and ends else []


def setting_xml(setting):
    name = setting["name"]
    element = SETTING_KIND[setting["kind"]] + "VectorProperty"
    default = setting["default_text"] if setting["kind"] == "text" else " ".join(map(number, setting["defaults"]))
    attributes = f' command="SetSetting" initial_string="{name}" number_of_elements="{max(1, len(setting["defaults"]))}" default_values="{default}"'
    attributes = REPEATED if setting["kind"] == "points" else attributes
    attributes += "" if setting["saved"] else ' is_internal="1"'
    lines = [f'      <{element} name="{name}"{attributes}>', *domain(setting), documentation(setting), f"      </{element}>"]
    return "\n".join(lines) + "\n"


def readout_xml(readout):
    kind = READOUT_KIND[readout["kind"]]
    default = "" if kind == "String" else ' default_values="' + " ".join(["0"] * readout["elements"]) + '"'
    return (f'      <{kind}VectorProperty name="{readout["name"]}" command="Get{readout["name"]}" information_only="1" '
            f'number_of_elements="{readout["elements"]}"{default}>\n'
            f"        <Simple{kind}InformationHelper/>\n{documentation(readout)}\n      </{kind}VectorProperty>\n")


def spoken(title):
    """A title of the panel without the mark of its letter."""
    return re.sub(r" \(&.\)$", "", title).replace("&", "")


def setting_row(setting):
    said = [setting["sentence"], setting["allowed"], setting["default_words"]]
    return (f"| {spoken(setting['title'])} | `{setting['name']}` | {'; '.join(part for part in said if part)} "
            f"| {setting['effect']} |\n")


def readout_row(readout):
    unit = f" [{readout['unit']}]" if readout["unit"] else ""
    return f"| {readout['title']} | `{readout['name']}`{unit} | {readout['sentence']} |\n"


def defined(macro, *arguments):
    """A line of a macro that defines its declaration."""
    return f"  vtkHaptic{macro}Macro({', '.join(arguments)})" + " \\\n"


ARRAY_LIST = """        <ArrayListDomain name="array_list" none_string="" input_domain_name="field_arrays">
          <RequiredProperties><Property name="Field" function="Input"/></RequiredProperties>
        </ArrayListDomain>
"""


def of_field(render):
    """The settings that *Touch Along Path* has: how numbers in space are felt."""
    return lambda setting: render(setting) if setting["name"].startswith("Field") else ""


def touch_xml(setting):
    head, newline, rest = setting_xml(setting).partition("\n")
    arrays = ARRAY_LIST if setting["kind"] == "text" and setting["name"] != "FieldDetentLevels" else ""
    return head[:-1] + '\n                         panel_visibility="advanced">' + newline + arrays + rest


def getter(readout):
    name, kind = readout["name"], readout["kind"]
    if readout["elements"] > 1:
        return defined("Numbers", name, str(readout["elements"]))
    if kind == "text":
        return defined("Text", name)
    return defined("Readout", name, {"flag": "bool", "count": "int", "long count": "vtkIdType"}.get(kind, "double"))


def option_row(setting):
    value = "" if setting["kind"] == "flag" else {2: " LOW,HIGH", 3: " X,Y,Z"}.get(len(setting["defaults"]), " V")
    said = [setting["sentence"], setting["path_allowed"], setting["path_default_words"]]
    row = f"| `--{setting['option']}{value}` | {'; '.join(part for part in said if part)} |\n"
    return row if setting["option"] else ""


def between(text, begin, end):
    """The text between the two marks, each of which stands once."""
    return text[text.index(begin) + len(begin):text.index(end)]


# The text of a file between two of its lines, and its writer.
PLACES = (
    (XML, "      <!-- Settings -->\n", "      <!-- Commands -->\n", "settings", setting_xml),
    (XML, "      <!-- Read-outs -->\n", "    </HapticSessionProxy>\n", "readouts", readout_xml),
    (GUIDE, "| takes effect |\n|---|---|---|---|\n", "\nWithout a title", "settings", setting_row),
    (GUIDE, "| meaning |\n|---|---|---|\n", "\n## With the mouse", "readouts", readout_row),
    (DECLARATIONS, "#define vtkHapticTableReadoutsMacro() \\\n", "  /* the end of the read-outs", "readouts", getter),
    (TOUCH_XML, "      <!-- Settings of a field -->\n", "      <!-- Of the path -->\n", "settings", of_field(touch_xml)),
    (PROGRAM, "| option of `touch` | effect |\n|---|---|\n", "\nThe program reads", "settings", option_row),
)


def write(described):
    for file, begin, end, table, render in PLACES:
        text = file.read_text(encoding="utf-8")
        made = "".join(map(render, described[table]))
        file.write_text(text.replace(begin + between(text, begin, end), begin + made), encoding="utf-8")
    WRAPPED.touch()


if __name__ == "__main__":
    write(json.loads(subprocess.run(sys.argv[1:], check=True, capture_output=True, text=True).stdout))
