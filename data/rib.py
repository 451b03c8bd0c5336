# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the surface of a rib as an OBJ file, in mm: python3 data/rib.py data/mechanisms/rib.obj

A straight rod along x, 16 mm thick, whose axis is 28.5 mm below the hand of rib.json and 100 mm in front of it."""

import math
import sys

import wavefront

RADIUS, HALF_LENGTH = 8.0, 60.0
Y, Z = -28.5, 100.0
AROUND, ALONG = 24, 20


def mesh():
    vertices, faces = [], []
    for i in range(ALONG + 1):
        x = HALF_LENGTH * (2 * i / ALONG - 1)
        for k in range(AROUND):
            turn = 2 * math.pi * k / AROUND
            vertices.append((x, Y + RADIUS * math.cos(turn), Z + RADIUS * math.sin(turn)))
    for i in range(ALONG):
        for k in range(AROUND):
            a, b = i * AROUND + k, i * AROUND + (k + 1) % AROUND
            faces += [(a, b, b + AROUND), (a, b + AROUND, a + AROUND)]
    for end, first in ((-HALF_LENGTH, 0), (HALF_LENGTH, ALONG * AROUND)):
        middle = len(vertices)
        vertices.append((end, Y, Z))
        for k in range(AROUND):
            a, b = first + k, first + (k + 1) % AROUND
            faces.append((middle, b, a) if end < 0 else (middle, a, b))
    return vertices, faces


if __name__ == "__main__":
    wavefront.write(sys.argv[1], "A rib, made by data/rib.py [mm]", *mesh())
