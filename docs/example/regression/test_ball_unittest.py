# SPDX-License-Identifier: GPL-3.0-or-later
import unittest
from pathlib import Path

from palpate.testing import assert_feels_the_same
from vtkmodules.vtkFiltersSources import vtkSphereSource


class Ball(unittest.TestCase):
    def test_it_feels_as_it_did(self):
        ball = vtkSphereSource()
        ball.SetRadius(50)
        assert_feels_the_same(ball, Path(__file__).with_name("ball.json"), unit="mm", Stiffness=500, Radius=1)


if __name__ == "__main__":
    unittest.main()
