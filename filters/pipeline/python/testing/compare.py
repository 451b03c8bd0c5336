# SPDX-License-Identifier: GPL-3.0-or-later
"""By how many just noticeable differences (JND) forces differ.

One JND is 7 % of a force or 18 degrees of its direction, as in the rest of the project (docs/decisions). Below 1 N a hand
tells forces apart by the same 0.07 N as at 1 N, and directions of a fainter force count in proportion to it.
"""

from dataclasses import dataclass

import numpy as np

from palpate.testing.coverage import Coverage

FORCE_SHARE = 0.07
DIRECTION_RAD = np.radians(18.0)
FAINT_N = 1.0


def jnd(before_N, now_N):
    """For each row of two arrays (n, 3) [N]: the larger of the differences in magnitude and in direction [JND]."""
    before, now = (np.linalg.norm(force, axis=1) for force in (before_N, now_N))
    scale_N = np.maximum(before, FAINT_N)
    strength = np.abs(now - before) / (FORCE_SHARE * scale_N)
    turn_rad = np.arctan2(np.linalg.norm(np.cross(before_N, now_N), axis=1), np.sum(before_N * now_N, axis=1))
    return np.maximum(strength, np.minimum(before, now) * turn_rad / (DIRECTION_RAD * scale_N))


@dataclass
class Comparison:
    """Two touches along one path, row by row."""

    path: np.ndarray  # (n, 4): t, x, y, z [s, scene units]
    before_N: np.ndarray  # (n, 3)
    now_N: np.ndarray  # (n, 3)
    jnd: np.ndarray  # (n)
    tolerance: float  # [JND]
    coverage: Coverage = None  # of the surface now; None: it has no faces, or a field is felt
    changed: tuple = ()  # sentences on pieces of the surface that the path does not reach

    @property
    def beyond(self):
        """For each row, whether the row differs; NaN counts as different."""
        return ~(self.jnd <= self.tolerance)

    @property
    def differs(self):
        return bool(self.beyond.any() or self.changed)

    def stretches(self):
        """First and last row of each stretch of rows that differ, the worst stretch first."""
        beyond = np.flatnonzero(self.beyond)
        runs = np.split(beyond, np.flatnonzero(np.diff(beyond) > 1) + 1) if len(beyond) else []
        return sorted(((run[0], run[-1]) for run in runs), key=lambda run: -self.jnd[run[0]:run[1] + 1].max())


def is_something(force_N, tolerance):
    """Whether a hand can distinguish the forces from zero."""
    return not (jnd(force_N, np.zeros_like(force_N)) <= tolerance).all()


def compare(path, before_N, now_N, tolerance):
    return Comparison(path, before_N, now_N, jnd(before_N, now_N), tolerance)
