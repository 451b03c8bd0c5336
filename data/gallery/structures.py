# SPDX-License-Identifier: GPL-3.0-or-later
"""Simple plane worlds by formula: a corridor, a spiral, wedges, circles."""

import math

from vtp import PlaneWorld

CHORD_ERROR = 0.005  # how far a drawn curve may be from the true one, in corridor widths


def arc(radius, begin, end, centre=(0.0, 0.0)):
    """Points along a circle from one angle to the other [rad], no chord farther from it than CHORD_ERROR."""
    widest = 2.0 * math.acos(1.0 - CHORD_ERROR / radius)
    count = max(1, math.ceil(abs(end - begin) / widest))
    angles = (begin + (end - begin) * i / count for i in range(count + 1))
    return [(centre[0] + radius * math.cos(a), centre[1] + radius * math.sin(a)) for a in angles]


def circle(radius, centre=(0.0, 0.0)):
    """A closed circle: the last point is the first."""
    points = arc(radius, 0.0, 2.0 * math.pi, centre)
    return points[:-1] + points[:1]


def corridor():
    """A straight corridor ten times as long as it is wide, closed at one end."""
    return PlaneWorld([[(0, 1), (10, 1), (10, 0), (0, 0)]], start=(0.5, 0.5), exit=(9.5, 0.5))


def spiral(turns=4):
    """A wall that winds outwards by one corridor a turn (Archimedes): from outside to the middle."""
    steps = 256 * turns
    wall = []
    for i in range(steps + 1):
        turn = turns * i / steps
        radius, angle = 0.5 + turn, 2.0 * math.pi * turn
        wall.append((radius * math.cos(angle), radius * math.sin(angle)))
    # Just outside of the outer end, where the way in begins, half a corridor off the wall.
    return PlaneWorld([wall], start=(turns + 1.0, -0.5), exit=(0.0, 0.0))


def wedge_field():
    """Wedges of 90 down to 5 degrees that open upwards, in a row: how sharp a corner still holds."""
    lines, x = [], 0.0
    for degrees in (90, 60, 45, 30, 20, 10, 5):
        half = math.radians(degrees) / 2.0
        reach = 3.0 * math.tan(half)
        lines.append([(x, 3.0), (x + reach, 0.0), (x + 2.0 * reach, 3.0)])
        x += 2.0 * reach + 1.0
    return PlaneWorld(lines)


def circle_set():
    """Circles of radius 4 down to 1/8 beside each other, and rings within rings."""
    lines, x = [], 0.0
    for radius in (4.0, 2.0, 1.0, 0.5, 0.25, 0.125):
        lines.append(circle(radius, (x + radius, 0.0)))
        x += 2.0 * radius + 1.0
    lines += [circle(radius, (4.0, 0.0)) for radius in (3.0, 2.0, 1.0)]
    return PlaneWorld(lines)
