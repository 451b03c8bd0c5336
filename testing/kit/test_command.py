# SPDX-License-Identifier: GPL-3.0-or-later
"""`python3 -m palpate.testing`: exit codes, output, JUnit; and the version of the package."""

import os
import subprocess
import sys
import tempfile
import unittest
from contextlib import redirect_stderr, redirect_stdout
from io import StringIO
from pathlib import Path
from xml.etree import ElementTree

from plates import plate
from vtkmodules.vtkIOGeometry import vtkSTLWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

import palpate
from palpate.testing.__main__ import main


class Command(unittest.TestCase):
    """One folder: a plate at 0, one at 0.5 mm, the baseline of the first."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        cls.baseline = cls.folder / "plate.json"
        for name, writer, height_mm in (("low.vtp", vtkXMLPolyDataWriter(), 0.0), ("high.stl", vtkSTLWriter(), 0.5)):
            source = plate(height_mm)
            writer.SetInputConnection(source.GetOutputPort())
            writer.SetFileName(str(cls.folder / name))
            writer.Write()
        code, text = cls.run_command("low.vtp", "--unit", "mm", "--update")
        assert code == 0 and "written" in text, text

    @classmethod
    def run_command(cls, surface, *options):
        """(exit code, all that it prints)"""
        with redirect_stdout(StringIO()) as out, redirect_stderr(out):
            code = main([str(word) for word in (cls.folder / surface, cls.baseline, *options)])
        return code, out.getvalue()

    def junit(self, code, surface, *options):
        """(failures, errors, text of the problem) of a run with that exit code."""
        file = self.folder / "verdict.xml"
        self.assertEqual(self.run_command(surface, *options, "--junit", file)[0], code)
        suite = ElementTree.parse(file).getroot()
        self.assertEqual((suite.tag, suite.get("tests"), suite[0].tag), ("testsuite", "1", "testcase"))
        return int(suite.get("failures")), int(suite.get("errors")), "".join(problem.text for problem in suite[0])

    def test_the_same_surface_passes(self):
        self.assertEqual(self.junit(0, "low.vtp", "--unit", "mm"), (0, 0, ""))

    def test_a_moved_one_fails_with_a_report_and_differences(self):
        differences = self.folder / "where.vtp"
        failures, errors, text = self.junit(1, "high.stl", "--unit", "mm", "--differences", differences)
        self.assertEqual((failures, errors), (1, 0))
        self.assertIn("does not feel as it did", text)
        self.assertTrue(differences.is_file())
        self.assertEqual(self.junit(0, "high.stl", "--unit", "mm", "--tolerance", "9"), (0, 0, ""))

    def test_what_cannot_be_judged_is_an_error_of_one_line(self):
        for surface, options in (("low.vtp", ["--unit", "m"]), ("none.vtp", ["--unit", "mm"]), ("plate.json", ["--unit", "mm"]),
                                 ("low.vtp", ["--unit", "mm", "--set", "Radius=2"]), ("low.vtp", ["--unit", "mm", "--scene", "x"])):
            failures, errors, text = self.junit(2, surface, *options)
            self.assertEqual((failures, errors, len(text.splitlines())), (0, 1, 1), text)
        cut = self.folder / "cut.vtp"
        cut.write_bytes((self.folder / "low.vtp").read_bytes()[:-200])
        self.assertEqual(self.junit(2, "cut.vtp", "--unit", "mm")[:2], (0, 1))

    def test_no_verdict_of_an_earlier_run_stays(self):
        files = [self.folder / name for name in ("old.xml", "old.vtp")]
        for file in files:
            file.write_text("old", encoding="utf-8")
        self.assertEqual(self.run_command("low.vtp", "--unit", "mm", "--junit", files[0], "--differences", files[1])[0], 0)
        self.assertNotEqual(files[0].read_text(encoding="utf-8"), "old")
        self.assertFalse(files[1].exists())

    def test_what_is_read_is_not_written_and_no_argument_of_the_function_is_a_setting(self):
        held = (self.folder / "low.vtp").read_bytes()
        for options in (["--junit", self.folder / "low.vtp"], ["--differences", self.baseline], ["--set", "tolerance=2"],
                        ["--set", "scene=x"], ["--set", "Radius"]):
            with self.assertRaises(SystemExit) as ended:
                self.run_command("low.vtp", "--unit", "mm", *options)
            self.assertEqual(ended.exception.code, 2)
        self.assertEqual((self.folder / "low.vtp").read_bytes(), held)

    def test_the_package_the_command_and_the_program_have_one_version(self):
        for command in ([sys.executable, "-m", "palpate.testing"], [os.environ["PALPATE_PROGRAM"]]):
            said = subprocess.run([*command, "--version"], capture_output=True, text=True, check=True).stdout
            self.assertEqual(said.split("\n")[0], palpate.__version__)


if __name__ == "__main__":
    unittest.main(verbosity=2)
