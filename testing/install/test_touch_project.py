# SPDX-License-Identifier: GPL-3.0-or-later
"""A CMake project of somebody else with a touch test, against the installed product: it passes, and where the surface has
moved by half a millimetre it fails with a report."""

import math
import tempfile
import unittest
from pathlib import Path
from xml.etree import ElementTree

from installed import BUILD, SOURCE, run_command

RADIUS_MM, STIFFNESS_N_PER_M, JND_N = 50.0, 500.0, 0.07
MOVED_MM = 0.5


class TouchProject(unittest.TestCase):
    """One install; the project is copied, as its baseline is written beside its sources."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.prefix, cls.source, cls.build = (Path(folder.name, name) for name in ("prefix", "source", "build"))
        run_command("cmake", "--install", BUILD, "--prefix", cls.prefix)
        run_command("cp", "-r", SOURCE / "testing/install/touch_project", cls.source)
        cls.configure(0)
        run_command("cmake", "--build", cls.build)

    @classmethod
    def configure(cls, moved_mm):
        run_command("cmake", "-S", cls.source, "-B", cls.build, f"-DCMAKE_PREFIX_PATH={cls.prefix}", f"-DMOVED_MM={moved_mm}")

    def touch(self, code, **more):
        """The output of ctest, and the test suite of the JUnit file."""
        said = run_command("ctest", "--test-dir", self.build, "-L", "touch", "--output-on-failure", code=code, **more)
        return said, ElementTree.parse(self.build / "ball.junit.xml").getroot()

    def test_it_passes_until_the_surface_moves_and_then_says_where_it_differs(self):
        failed = 8  # exit code of ctest
        said, suite = self.touch(failed)
        self.assertEqual((suite.get("errors"), suite.get("failures")), ("1", "0"))
        self.assertIn("PALPATE_UPDATE_BASELINES=1", said)

        self.touch(0, PALPATE_UPDATE_BASELINES="1")
        self.assertEqual(self.touch(0)[1].get("failures"), "0")

        self.configure(MOVED_MM)
        said, suite = self.touch(failed)
        self.assertEqual((suite.get("errors"), suite.get("failures")), ("0", "1"))
        self.assertIn("does not feel as it did", said)
        most_jnd = float(said.split("at most by ")[1].split()[0])
        # 0.25 N more or less of about 1 N where it is stroked along its motion: a stroke is 2 mm deep, and not 2.5 mm
        # where it rounds the ball off (by half a millimetre over the 12 mm it is smoothed over).
        change_N = STIFFNESS_N_PER_M * MOVED_MM / 1000
        self.assertLessEqual(most_jnd, change_N / JND_N + 0.01)
        self.assertGreaterEqual(most_jnd, change_N / (JND_N * STIFFNESS_N_PER_M * 2.5e-3) - 0.01)
        self.assertTrue((self.build / "ball.differs.vtp").is_file())

    def test_its_program_calls_the_modules(self):
        force_N = float(run_command(self.build / "make_ball", self.build / "made.vtp", "0"))
        hooke_N = STIFFNESS_N_PER_M * 2e-3
        facets_N = STIFFNESS_N_PER_M * 2 * RADIUS_MM / 1000 * (1 - math.cos(math.pi / 60))
        self.assertLessEqual(force_N, hooke_N + 1e-6)
        self.assertGreaterEqual(force_N, hooke_N - facets_N - 1e-6)

    def refused(self, name, why, *lines):
        """A project of these lines is not configured, for a reason that is said."""
        bad = self.build / name
        bad.mkdir()
        (bad / "CMakeLists.txt").write_text("\n".join(["cmake_minimum_required(VERSION 3.25)", "project(bad CXX)", *lines]),
                                            encoding="utf-8")
        with self.assertRaisesRegex(AssertionError, why):
            run_command("cmake", "-S", bad, "-B", bad / "build", f"-DCMAKE_PREFIX_PATH={self.prefix}")

    def test_a_call_that_lacks_something_is_said(self):
        self.refused("lacking", "BASELINE is missing", "find_package(Palpate REQUIRED)",
                     "palpate_add_touch_test(NAME ball SURFACE ball.vtp UNIT mm)")

    def test_another_vtk_that_was_found_before_is_not_taken(self):
        other = "/usr/lib/libvtkCommonCore-9.1.so"
        self.refused("other", rf"(?s)another\s+one\s+was\s+found\s+before:\s+{other}", "add_library(VTK::CommonCore SHARED IMPORTED)",
                     f"set_target_properties(VTK::CommonCore PROPERTIES IMPORTED_LOCATION {other})",
                     "find_package(Palpate REQUIRED COMPONENTS VTK)")


if __name__ == "__main__":
    unittest.main(verbosity=2)
