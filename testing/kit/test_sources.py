# SPDX-License-Identifier: GPL-3.0-or-later
"""palpate.testing with sources of paraview.simple: the data come to where the test runs."""

import sys
import tempfile
import unittest
from pathlib import Path

from paraview import simple

from palpate.testing import assert_feels_the_same


class Sources(unittest.TestCase):
    def test_a_source_that_moves_no_longer_feels_as_it_did(self):
        ball = simple.Sphere(Radius=50.0, ThetaResolution=40, PhiResolution=40)
        moved = simple.Transform(Input=ball)
        with tempfile.TemporaryDirectory() as folder:
            assert_feels_the_same(moved, Path(folder, "ball.json"), unit="mm", update=True)
            self.assertLess(assert_feels_the_same(moved, Path(folder, "ball.json"), unit="mm").jnd.max(), 1e-9)
            moved.Transform.Translate = [0.5, 0.0, 0.0]
            with self.assertRaisesRegex(AssertionError, "does not feel as it did"):
                assert_feels_the_same(moved, Path(folder, "ball.json"), unit="mm")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
