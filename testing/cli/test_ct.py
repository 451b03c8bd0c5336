# SPDX-License-Identifier: GPL-3.0-or-later
"""The bone of a real CT scan as an isosurface without a mesh: the hand never gets to its other side, and where it is held the
value at the proxy is that of the surface, by an interpolation of our own. Nothing without `data/get ct`."""

import csv
import os
import pathlib
import subprocess
import tempfile
import unittest

import numpy as np

SHAPE = (108, 256, 256)  # voxels along z, y, x
STEP = np.array((0.9570312, -0.9570312, 1.5))  # mm, as data/get places them
BONE = 226.0  # HU
ROWS = 4000
ROUNDED = 1e-3  # HU: values and places in single precision


def folder():
    return pathlib.Path(os.environ.get("PALPATE_DATA") or pathlib.Path(os.environ["PALPATE_SOURCE_DIR"]) / "data" / "cache")


def values_at(image, places):
    """Trilinear."""
    at = places / STEP
    cell = np.clip(np.floor(at).astype(int), 0, np.array(SHAPE[::-1]) - 2)
    part = at - cell
    total = np.zeros(len(places))
    for corner in np.ndindex(2, 2, 2):
        weight = np.prod(np.where(corner, part, 1.0 - part), axis=1)
        i, j, k = (cell + corner).T
        total += weight * image[k, j, i]
    return total


def stroke(times):
    """From the air beside the head into the bone of its side, up and down and to and fro."""
    depth = np.minimum(1.0, times / 0.5)
    x = (45.0 + 22.0 * depth) * STEP[0] + 2.0 * np.sin(9.0 * times) * depth
    return np.stack((x, (128.0 + 20.0 * np.sin(1.7 * times)) * STEP[1], (54.0 + 10.0 * np.sin(2.3 * times)) * STEP[2]), axis=1)


class RealScan(unittest.TestCase):
    def touch(self, file, smoothing):
        times = np.arange(ROWS) * 1e-3
        with tempfile.TemporaryDirectory() as work:
            way, felt = (pathlib.Path(work) / name for name in ("way.csv", "felt.csv"))
            rows = np.column_stack((times, stroke(times)))
            np.savetxt(way, rows, fmt="%.17g", delimiter=",", header="t,x,y,z", comments="")
            subprocess.run([os.environ["PALPATE_PROGRAM"], "touch", file, "--field", "NIFTI", "--mode", "isosurface", "--iso", str(BONE),
                            "--smoothing", str(smoothing), "--scale", "1000", "--path", way, "--csv", felt], check=True, capture_output=True)
            with open(felt, newline="", encoding="utf-8") as told:
                read = list(csv.DictReader(told))
        columns = [np.array([[float(row[f"{name}_{axis}"]) for axis in "xyz"] for row in read]) for name in ("proxy", "force")]
        return columns[0], np.linalg.norm(columns[1], axis=1)

    def test_the_hand_stays_outside_of_the_bone_and_is_held_at_its_value(self):
        file = folder() / "ct.nii"
        if not file.exists():
            return  # data/get fetches it
        image = np.fromfile(file, dtype="<i2", offset=352).reshape(SHAPE).astype(float)
        proxy, force = self.touch(file, 0)
        value = values_at(image, proxy)
        held = force > 1e-6
        self.assertGreater(held.sum(), ROWS / 2, "the way leads into bone")
        self.assertLessEqual(value.max(), BONE + ROUNDED)
        self.assertGreaterEqual(value[held].min(), BONE - ROUNDED)


if __name__ == "__main__":
    unittest.main()
