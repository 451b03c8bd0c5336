# SPDX-License-Identifier: GPL-3.0-or-later
"""data/abdomen.py puts a wall before a labelled ball in place of a liver: a needle goes through both and comes back. Under the
skin of a round head the wall is a shell of a sphere."""

import csv
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

from paraview.modules.vtkRemotingCore import vtkPVSession  # noqa: F401  ParaView's own VTK, not another one
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOGeometry import vtkSTLWriter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

SOURCE = pathlib.Path(os.environ["PALPATE_SOURCE_DIR"])
sys.path.insert(0, str(SOURCE / "testing" / "cli"))
from palpate_cli import nifti_bytes  # noqa: E402

VOXELS, SPACING, LABEL = 24, 5.0, 255  # mm
HEAD, THICK = 90.0, 18.0  # mm: radius of a head, and of the wall, as the script assumes
SKIN, CAPSULE, DRAG = 1.5, 0.8, 0.4 + 0.2  # N, as the script assumes


def liver(i, j, k):
    middle = 0.5 * (VOXELS - 1)
    return LABEL if sum((n - middle) ** 2 for n in (i, j, k)) < (0.4 * VOXELS) ** 2 else 0


class Abdomen(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def make(self, *options):
        """The message of the script where it ends in a fault."""
        image = self.folder / "liver.nii"
        image.write_bytes(nifti_bytes(VOXELS, liver, [(SPACING, 0, 0, 0), (0, SPACING, 0, 0), (0, 0, SPACING, 0)]))
        script = ["pvpython", str(SOURCE / "data" / "abdomen.py"), str(image), str(self.folder), "25", *options]
        run = subprocess.run(script, capture_output=True, text=True)
        return run.stderr if run.returncode != 0 else ""

    def head(self):
        sphere, writer = vtkSphereSource(), vtkSTLWriter()
        sphere.SetRadius(HEAD)
        sphere.SetThetaResolution(180)
        sphere.SetPhiResolution(180)
        writer.SetInputConnection(sphere.GetOutputPort())
        writer.SetFileName(str(self.folder / "head.stl"))
        writer.SetFileTypeToBinary()
        writer.Write()
        return str(self.folder / "head.stl")

    def test_under_a_round_skin_the_wall_is_a_shell_of_a_sphere_from_whichever_side(self):
        for side in "zmax", "xmin":
            self.assertEqual(self.make("--skin", self.head(), "--side", side), "")
            reader = vtkXMLUnstructuredGridReader()
            reader.SetFileName(str(self.folder / "wall.vtu"))
            reader.Update()
            wall = reader.GetOutput()
            places = [wall.GetPoint(i) for i in range(wall.GetNumberOfPoints())]
            lowest = min(places, key=lambda p: p[2])
            middle = lowest[0], lowest[1], lowest[2] + HEAD
            away = [math.dist(p, middle) for p in places]
            facet = HEAD * (1.0 - math.cos(math.pi / 180))  # mm, by which its faces are inside of the sphere
            self.assertLess(max(away), HEAD + 2.0 * facet)
            self.assertGreater(min(away), HEAD - THICK - 2.0 * facet)
            outer = sum(abs(r - HEAD) < 2.0 * facet for r in away)
            # A shell of even thickness: at its rim the normals lean by one cell's angle at most, 9 mm of the radius.
            inner = sum(abs(r - HEAD + THICK) < 2.0 * facet + THICK * (9.0 / HEAD) ** 2 for r in away)
            self.assertEqual((outer, inner), (11 * 11, 11 * 11))

    def test_a_skin_that_is_too_small_is_refused_by_name(self):
        self.head()
        small = self.folder / "small.obj"
        small.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", encoding="utf-8")
        self.assertIn("small.obj has nothing", self.make("--skin", str(small)))

    def test_a_needle_pierces_the_wall_and_then_the_liver_and_drags_by_both_on_its_way(self):
        self.assertEqual(self.make(), "")
        run = subprocess.run([os.environ["PALPATE_PROGRAM"], "touch", str(self.folder / "abdomen.json"), "--path",
                              str(self.folder / "way.csv"), "--csv", str(self.folder / "out.csv"), "--scale", "1000",
                              "--torque-stiffness", "5"], check=True, capture_output=True, text=True)
        said = run.stderr.splitlines()
        pierced = [line.split(" at ")[0].split(": ")[-1] for line in said if "punctured" in line]
        self.assertEqual(pierced[:2], ["skin punctured", "capsule punctured"], said)
        with open(self.folder / "out.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        most = {name: max(abs(float(row[f"{name}_fz"])) for row in rows) for name in ("skin", "capsule")}
        self.assertAlmostEqual(most["skin"], SKIN, delta=0.02 * SKIN)
        self.assertAlmostEqual(most["capsule"], CAPSULE, delta=0.05 * CAPSULE)
        back = rows[len(rows) * 11 // 20]  # on its way out of both
        self.assertAlmostEqual(float(back["force_z"]), DRAG, delta=0.05 * DRAG)
        self.assertAlmostEqual(float(rows[-1]["force_z"]), 0.0, delta=1e-3)  # the spread step dies away


if __name__ == "__main__":
    unittest.main()
