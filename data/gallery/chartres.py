# SPDX-License-Identifier: GPL-3.0-or-later
"""The labyrinth of Chartres by its rule: the walls are the space that the path leaves between its parts.

The path is a list of turns (in or out by so many circuits) and of arcs between them in quarters of a circle, as the literature on
labyrinths lists them: in 5; in 1; in 5; four out; four in; ten out; four in; four out; in 5; in 1; in 5. The path goes once through
each of the 44 quarters of its 11 circuits, which is checked.
"""

import math

from structures import arc
from vtp import PlaneWorld

CIRCUITS = 11
CENTRE = 3.0  # radius of the place in the middle
IN, OUT = 1, -1
STEPS = [5, 1, 5] + 4 * [OUT] + 4 * [IN] + 10 * [OUT] + 4 * [IN] + 4 * [OUT] + [5, 1, 5]
QUARTERS = [1, 1, 2, 2, 1] + 3 * [1, 2, 1, 2, 1, 2, 1] + [1, 2, 2, 1, 1]
# Axes in the order of the path: 0 below, where one enters, 1 left, 2 above, 3 right; 4 is 0 again.
LEFT_LANE, RIGHT_LANE = 0, 4


def way():
    """Arcs of the path: (circuit counted from outside, axis where it begins, axis where it ends)."""
    arcs, circuit, axis, direction = [], 0, LEFT_LANE, 1
    for step, quarters in zip(STEPS, QUARTERS):
        circuit += step
        arcs.append((circuit, axis, axis + direction * quarters))
        axis, direction = arcs[-1][2], -direction
    return arcs


def _angle(axis):
    return -math.pi / 2.0 - axis * math.pi / 2.0  # clockwise from below


def _radius(circuit):
    """Of the wall on the outer side of a circuit."""
    return CENTRE + CIRCUITS + 1 - circuit


def _through(arcs):
    """Which (circuit, axis) the path passes straight on."""
    return {(c, axis) for c, begin, end in arcs for axis in range(min(begin, end) + 1, max(begin, end))}


def _gaps(arcs):
    """(wall, axis, side): where the path turns from one circuit to the next, on the side of the axis it comes from."""
    gaps = set()
    for (c, begin, end), (after, _, _) in zip(arcs, arcs[1:]):
        if abs(after - c) == 1:
            gaps.add((max(c, after), end, 1 if begin > end else -1))
    return gaps


def _circles(arcs):
    """Walls between circuits, a quarter each, shortened by a corridor where the path turns round their end."""
    lines, gaps = [], _gaps(arcs)
    for wall in range(1, CIRCUITS + 2):
        radius = _radius(wall)
        for axis in range(4):
            # The two lanes at the entrance are a corridor wide.
            ends = []
            for at, side in ((axis, 1), (axis + 1, -1)):
                off = (1.0 if at in (LEFT_LANE, RIGHT_LANE) else 0.0) + (1.0 if (wall, at, side) in gaps else 0.0)
                ends.append(_angle(at) - side * math.asin(off / radius))
            lines.append(arc(radius, *ends))
    return lines


def _barriers(arcs):
    """Walls along the axes at the left, above and right where the path does not pass."""
    through = _through(arcs)
    return [
        [(r * math.cos(_angle(axis)), r * math.sin(_angle(axis))) for r in (_radius(c), _radius(c + 1))]
        for axis in (1, 2, 3)
        for c in range(1, CIRCUITS + 1)
        if (c, axis) not in through
    ]


def _lane(x, doors):
    """The side of a lane, open where a circuit leaves it."""
    depth = lambda circuit: -math.sqrt(_radius(circuit) ** 2 - x * x)
    return [[(x, depth(c)), (x, depth(c + 1))] for c in range(1, CIRCUITS + 1) if c not in doors]


def _stop(wall, begin, end):
    """A piece of a circular wall across a lane, between two places left or right of the middle."""
    radius = _radius(wall)
    return arc(radius, -math.pi / 2.0 + math.asin(begin / radius), -math.pi / 2.0 + math.asin(end / radius))


def chartres():
    """From below the entrance to the middle."""
    arcs = way()
    quarters = {(c, min(a, b) + k) for c, a, b in arcs for k in range(abs(b - a))}
    if len(quarters) != 4 * CIRCUITS or sum(QUARTERS) != 4 * CIRCUITS:
        raise ValueError("the way does not go once through every quarter of every circuit")
    middle = [(0.0, -_radius(1)), (0.0, -_radius(CIRCUITS + 1))]
    lanes = _lane(-1.0, {5, 6, 11}) + _lane(1.0, {1, 6, 7})
    stops = [_stop(6, -1.0, 0.0), _stop(CIRCUITS + 1, -1.0, 0.0), _stop(1, 0.0, 1.0), _stop(7, 0.0, 1.0)]
    return PlaneWorld(
        _circles(arcs) + _barriers(arcs) + lanes + stops + [middle],
        start=(-0.5, -_radius(1) - 0.5),
        exit=(0.0, 0.0),
    )
