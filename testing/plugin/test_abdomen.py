# SPDX-License-Identifier: GPL-3.0-or-later
"""data/abdomen.py puts a wall before a labelled ball in place of a liver: a needle goes through both and comes back."""

import csv
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ["PALPATE_SOURCE_DIR"])
sys.path.insert(0, str(SOURCE / "testing" / "cli"))
from palpate_cli import nifti_bytes  # noqa: E402

VOXELS, SPACING, LABEL = 24, 5.0, 255  # mm
SKIN, CAPSULE, DRAG = 1.5, 0.8, 0.4 + 0.2  # N, as the script assumes


def liver(i, j, k):
    middle = 0.5 * (VOXELS - 1)
    return LABEL if sum((n - middle) ** 2 for n in (i, j, k)) < (0.4 * VOXELS) ** 2 else 0


class Abdomen(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_a_needle_pierces_the_wall_and_then_the_liver_and_drags_by_both_on_its_way(self):
        image = self.folder / "liver.nii"
        image.write_bytes(nifti_bytes(VOXELS, liver, [(SPACING, 0, 0, 0), (0, SPACING, 0, 0), (0, 0, SPACING, 0)]))
        subprocess.run(["pvpython", str(SOURCE / "data" / "abdomen.py"), str(image), str(self.folder), "25"], check=True)
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
        self.assertAlmostEqual(float(rows[-1]["force_z"]), 0.0, delta=1e-3)  # what is spread dies away


if __name__ == "__main__":
    unittest.main()
