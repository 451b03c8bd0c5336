# SPDX-License-Identifier: GPL-3.0-or-later
from pathlib import Path

from palpate.testing import assert_feels_the_same
from vtkmodules.vtkFiltersSources import vtkSphereSource


def test_the_ball_feels_as_it_did():
    ball = vtkSphereSource()
    ball.SetRadius(50)
    assert_feels_the_same(ball, Path(__file__).with_name("ball.json"), unit="mm")
