# SPDX-License-Identifier: GPL-3.0-or-later
"""Wavefront OBJ files of the scripts beside this one."""


def write(path, title, vertices, faces):
    """Vertices (x, y, z) and faces (three of their indices, from 0 on) below a line of comment."""
    with open(path, "w", encoding="utf-8") as out:
        out.write(f"# {title}\n")
        out.writelines(f"v {x:g} {y:g} {z:g}\n" for x, y, z in vertices)
        out.writelines(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in faces)
