# SPDX-License-Identifier: GPL-3.0-or-later
"""docs/example, built and run against the installed library: the force is Hooke's law on a sphere of facets."""

import csv
import math
import tempfile
import unittest
from pathlib import Path

from installed import BUILD, SOURCE, run_command

RADIUS_M = 0.050
STIFFNESS_N_PER_M = 500.0
ROWS = 100  # of vertices from pole to pole, and twice as many around


class InstalledExample(unittest.TestCase):
    """One install, one configuration; each test builds its own subject."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.prefix, cls.build = Path(folder.name, "prefix"), Path(folder.name, "build")
        run_command("cmake", "--install", BUILD, "--component", "core", "--prefix", cls.prefix)
        run_command("cmake", "-S", SOURCE / "docs/example", "-B", cls.build, f"-DCMAKE_PREFIX_PATH={cls.prefix}",
                    "-DCMAKE_BUILD_TYPE=Release")

    def test_the_program_feels_the_sphere_and_nothing_outside_of_it(self):
        run_command("cmake", "--build", self.build)
        rows = list(csv.DictReader(run_command(self.build / "touch_sphere").splitlines()))
        distances_m = [float(row["distance_m"]) for row in rows]
        self.assertGreater(max(distances_m), RADIUS_M)
        self.assertLess(min(distances_m), 0.5 * RADIUS_M)
        # Facets lie inside the sphere: by R (1 - cos) of half a step in each of the two directions at most.
        facets_m = 2 * RADIUS_M * (1 - math.cos(math.pi / (2 * ROWS)))
        for distance_m, row in zip(distances_m, rows):
            deepest_N = STIFFNESS_N_PER_M * max(0.0, RADIUS_M - distance_m)
            shallowest_N = STIFFNESS_N_PER_M * max(0.0, RADIUS_M - facets_m - distance_m)
            self.assertLessEqual(float(row["force_N"]), deepest_N + 1e-12, row)
            self.assertGreaterEqual(float(row["force_N"]), shallowest_N - 1e-12, row)

    def test_every_header_of_the_sources_is_installed_and_compiles(self):
        include = self.prefix / "include" / "palpate"
        headers = sorted(str(path.relative_to(include)) for path in include.rglob("*.h"))
        layers = [SOURCE / layer for layer in ("haptics", "devices")]
        self.assertEqual(headers, sorted(str(path.relative_to(SOURCE)) for layer in layers for path in layer.rglob("*.h")))
        project = self.build / "headers"
        project.mkdir()
        (project / "headers.cpp").write_text("".join(f'#include "{header}"\n' for header in headers), encoding="utf-8")
        (project / "CMakeLists.txt").write_text(
            "cmake_minimum_required(VERSION 3.25)\nproject(headers CXX)\nfind_package(Palpate REQUIRED)\n"
            "add_library(headers OBJECT headers.cpp)\ntarget_link_libraries(headers Palpate::core)\n", encoding="utf-8")
        run_command("cmake", "-S", project, "-B", project / "build", f"-DCMAKE_PREFIX_PATH={self.prefix}")
        run_command("cmake", "--build", project / "build")


if __name__ == "__main__":
    unittest.main()
