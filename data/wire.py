# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes a bent tube for a wire as an OBJ file, in mm: python3 data/wire.py data/mechanisms/tube.obj

Its centre line begins 5 mm behind the origin, runs along x for 40 mm, bends by 135 degrees with a radius of 25 mm
towards y, and runs straight for 60 mm. The tube has a radius of 1 mm and is open at both ends."""

import math
import sys

import wavefront

RADIUS, BEFORE, FIRST, BEND, ANGLE, LAST = 1.0, 5.0, 40.0, 25.0, math.radians(135), 60.0
AROUND, RING = 24, 1.0


def centre(s):
    """The centre line, and the direction of its tangent, at a length from the origin."""
    angle = min(max((s - FIRST) / BEND, 0.0), ANGLE)
    beyond = max(s - FIRST - BEND * ANGLE, 0.0)
    x = min(s, FIRST) + BEND * math.sin(angle) + beyond * math.cos(angle)
    y = BEND * (1.0 - math.cos(angle)) + beyond * math.sin(angle)
    return x, y, angle


def mesh():
    vertices, faces = [], []
    length = BEFORE + FIRST + BEND * ANGLE + LAST
    rings = math.ceil(length / RING) + 1
    for i in range(rings):
        x, y, angle = centre(-BEFORE + length * i / (rings - 1))
        for k in range(AROUND):
            turn = 2 * math.pi * k / AROUND
            across = RADIUS * math.cos(turn)
            vertices.append((x - across * math.sin(angle), y + across * math.cos(angle), RADIUS * math.sin(turn)))
    for i in range(rings - 1):
        for k in range(AROUND):
            a, b = i * AROUND + k, i * AROUND + (k + 1) % AROUND
            faces += [(a, b, b + AROUND), (a, b + AROUND, a + AROUND)]
    return vertices, faces


if __name__ == "__main__":
    wavefront.write(sys.argv[1], "A bent tube, made by data/wire.py [mm]", *mesh())
