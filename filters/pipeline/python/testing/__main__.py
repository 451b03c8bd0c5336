# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests whether the surface in a file feels like its baseline. Exit code 0: yes, 1: no, 2: cannot be judged."""

import argparse
import json
import sys
import time
from pathlib import Path

from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader

from palpate import __version__
from palpate.testing import Refused, assert_feels_the_same
from palpate.testing.feel import updated
from palpate.testing.junit import write_junit
from palpate.vtkHapticPipeline import vtkHapticFileReader

READERS = {".vtp": vtkXMLPolyDataReader, ".vtu": vtkXMLUnstructuredGridReader, ".stl": vtkSTLReader, ".ply": vtkPLYReader,
           ".obj": vtkOBJReader, ".off": vtkHapticFileReader}


def read_surface(file):
    """Reads the data in a file; an unreadable file is refused."""
    if file.suffix.lower() not in READERS:
        raise Refused(f"{file}: this type of file is not supported; use one of {', '.join(READERS)}.")
    if not file.is_file():
        raise Refused(f"{file}: there is no such file.")
    reader = READERS[file.suffix.lower()]()
    reader.SetFileName(str(file))
    return updated(reader)


def setting(text):
    """NAME=VALUE as a pair; numbers and lists of numbers are JSON, all other values are text."""
    name, equals, value = text.partition("=")
    if not (name[:1].isupper() and equals):  # in small letters it would be an argument of the function itself
        raise argparse.ArgumentTypeError(f"{text!r} is not NAME=VALUE, NAME a setting such as Radius")
    try:
        return name, json.loads(value)
    except ValueError:
        return name, value


def arguments_of(words):
    parser = argparse.ArgumentParser(prog="python3 -m palpate.testing", description=__doc__)
    parser.add_argument("surface", type=Path, metavar="SURFACE", help=f"{', '.join(READERS)}")
    parser.add_argument("baseline", type=Path, metavar="BASELINE.json", help="baseline with the expected forces")
    parser.add_argument("--unit", required=True, help="unit of the surface: nm, um, mm, cm, m, km")
    parser.add_argument("--scene", help="name of the scene (default: name of the baseline file)")
    parser.add_argument("--path", type=Path, help="path of the hand, PATH.csv with columns t,x,y,z [s, scene units] (default: strokes)")
    parser.add_argument("--tolerance", type=float, default=1.0, help="tolerance in just noticeable differences (default: 1)")
    parser.add_argument("--set", type=setting, action="append", default=[], metavar="NAME=VALUE", dest="settings",
                        help="a setting of the filter Touch Along Path")
    parser.add_argument("--differences", type=Path, metavar="FILE.vtp", help="file that receives the differences")
    parser.add_argument("--junit", type=Path, metavar="FILE.xml", help="JUnit file with the result for continuous integration")
    parser.add_argument("--update", action="store_true", help="write the baseline")
    parser.add_argument("--version", action="version", version=__version__)
    given = parser.parse_args(words)
    read = {file.resolve() for file in (given.surface, given.baseline, given.path) if file}
    for file in written(given):
        if file.resolve() in read:
            parser.error(f"{file}: this run reads the file; name another file for the output.")
    return given


def written(given):
    """The files of a verdict that are asked for."""
    return [file for file in (given.junit, given.differences) if file]


def judge(given):
    """(exit code, kind of verdict, text)."""
    try:
        found = assert_feels_the_same(
            read_surface(given.surface), given.baseline, unit=given.unit, scene=given.scene, path=given.path,
            tolerance=given.tolerance, differences=given.differences, update=given.update or None, **dict(given.settings))
    except Refused as refusal:
        return 2, "error", str(refusal)
    except AssertionError as difference:
        return 1, "failure", str(difference)
    where = f"; {found.coverage.text()}" if found.coverage else ""
    if given.update:
        return 0, None, f"{given.baseline}: written, {len(found.jnd)} places{where}"
    return 0, None, f"{given.surface} feels as {given.baseline} says: at most {found.jnd.max():.3g} JND{where}"


def main(words=None):
    given = arguments_of(words)
    for file in written(given):  # of an earlier run: no verdict but this one's is found, however this one ends
        if file.is_file():
            file.unlink()
    start = time.monotonic()
    code, kind, text = judge(given)
    if given.junit:
        try:
            write_junit(given.junit, given.scene or given.baseline.stem, time.monotonic() - start, kind, text)
        except Refused as refusal:
            code, text = 2, f"{text}\n{refusal}"
    print(text, file=sys.stderr if code else sys.stdout)
    return code


if __name__ == "__main__":
    sys.exit(main())
