# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the surface of a stone as an OBJ file, in mm: python3 data/stone.py data/mechanisms/stone.obj

A pebble about the origin, 40 mm long, 21 mm high along y, which lies on a flat side 9 mm below the origin."""

import math
import sys

import wavefront

RADII = (20.0, 12.0, 18.0)
FLAT = -9.0
AROUND, RINGS = 24, 11


def place(up, around):
    """On the pebble: angle from the bottom, angle about y."""
    radius = math.sin(up) * (1.0 + 0.04 * math.cos(3.0 * around))
    y = -RADII[1] * math.cos(up)
    return RADII[0] * radius * math.cos(around), max(y, FLAT), RADII[2] * radius * math.sin(around)


def mesh():
    vertices = [place(0.0, 0.0)]
    for i in range(1, RINGS + 1):
        vertices += [place(math.pi * i / (RINGS + 1), 2.0 * math.pi * k / AROUND) for k in range(AROUND)]
    vertices.append(place(math.pi, 0.0))
    faces, last = [], len(vertices) - 1
    for k in range(AROUND):
        after = (k + 1) % AROUND
        faces.append((0, 1 + k, 1 + after))
        for i in range(RINGS - 1):
            a, b = 1 + i * AROUND + k, 1 + i * AROUND + after
            faces += [(a, a + AROUND, b + AROUND), (a, b + AROUND, b)]
        top = 1 + (RINGS - 1) * AROUND
        faces.append((top + k, last, top + after))
    return vertices, faces


if __name__ == "__main__":
    wavefront.write(sys.argv[1], "A stone, made by data/stone.py [mm]", *mesh())
