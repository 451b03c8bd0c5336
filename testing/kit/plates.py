# SPDX-License-Identifier: GPL-3.0-or-later
"""A plate at a height and a path of a hand into it: the force follows from Hooke's law."""

from vtkmodules.vtkFiltersSources import vtkPlaneSource

STIFFNESS_N_PER_M = 500.0  # the default of palpate.testing
MM_PER_M = 1000.0
# A hand comes down on a plate at height 0, is 2 mm deep in rows 3 to 5 and leaves.
HEIGHTS_MM = [5.0, 2.0, 1.0, -2.0, -2.0, -2.0, 1.0, 5.0]
WAY = [[3.0, 4.0, height] for height in HEIGHTS_MM]
PRESSED = [3, 4, 5]


def plate(height_mm=0.0):
    source = vtkPlaneSource()
    source.SetOrigin(-50, -50, height_mm)
    source.SetPoint1(50, -50, height_mm)
    source.SetPoint2(-50, 50, height_mm)
    return source


def force_N(height_mm):
    """Of a plate so high, in the rows that press."""
    return STIFFNESS_N_PER_M * (height_mm - HEIGHTS_MM[3]) / MM_PER_M
