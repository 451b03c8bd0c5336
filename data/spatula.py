# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the surface of a spatula as an OBJ file, in mm: python3 data/spatula.py data/mechanisms/spatula.obj

The hand is at the origin, and the blade is in front of it along +z. The blade is flat: 3 mm along y."""

import math
import sys

import wavefront

THICK, HANDLE, BLADE = 3.0, 4.0, 12.0  # the last two: half of a width
NECK, SHOULDER, LENGTH = 80.0, 92.0, 140.0
EDGE = 6.0


def outline():
    """Half width at places along z, from the hand to the tip."""
    places = [(NECK * i / 8, HANDLE) for i in range(9)]
    places += [(SHOULDER + EDGE * i, BLADE) for i in range(int((LENGTH - BLADE - SHOULDER) / EDGE) + 1)]
    turns = [math.radians(15 * i) for i in range(6)] + [math.radians(85)]
    places += [(LENGTH - BLADE + BLADE * math.sin(t), BLADE * math.cos(t)) for t in turns]
    return sorted(set((round(z, 6), round(half, 6)) for z, half in places))


def mesh(across=4):
    vertices, faces, places = [], [], outline()
    for y in (-THICK / 2, THICK / 2):
        for z, half in places:
            vertices += [(half * (2 * i / across - 1), y, z) for i in range(across + 1)]
    row, side = across + 1, len(places) * (across + 1)

    def quad(a, b, c, d):
        faces.extend([(a, b, c), (a, c, d)])

    for k in range(len(places) - 1):
        for i in range(across):
            a = k * row + i
            quad(a, a + 1, a + row + 1, a + row)
            quad(side + a, side + a + row, side + a + row + 1, side + a + 1)
        for edge in (0, across):
            a = k * row + edge
            corners = (a, a + row, side + a + row, side + a)
            quad(*(corners if edge == 0 else corners[::-1]))
    for k in (0, len(places) - 1):
        for i in range(across):
            a = k * row + i
            corners = (a, side + a, side + a + 1, a + 1)
            quad(*(corners if k == 0 else corners[::-1]))
    return vertices, faces


if __name__ == "__main__":
    wavefront.write(sys.argv[1], "A spatula, made by data/spatula.py [mm]", *mesh())
