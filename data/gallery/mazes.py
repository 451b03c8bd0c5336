# SPDX-License-Identifier: GPL-3.0-or-later
"""Mazes of square cells: one from its published plan, one grown as a spanning tree of its cells.

Everything random comes from splitmix64 (Steele, Lea & Flood 2014), so that the files are the same everywhere.
"""

from vtp import PlaneWorld

SIDES = ((1, 0), (0, 1), (-1, 0), (0, -1))  # east, north, west, south: one to the left of the other


class Random:
    """splitmix64."""

    def __init__(self, seed):
        self._state = seed

    def below(self, count):
        """A whole number from 0 to count - 1."""
        mask = (1 << 64) - 1
        self._state = (self._state + 0x9E3779B97F4A7C15) & mask
        z = self._state
        z = ((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9) & mask
        z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & mask
        return (z ^ (z >> 31)) % count


class Maze:
    """Cells (x, y) and which of their sides are open."""

    def __init__(self, width, height):
        self.width, self.height = width, height
        self.open = set()  # (cell, cell), both ways

    def join(self, a, b):
        """Opens the side between two cells."""
        self.open |= {(a, b), (b, a)}

    def inside(self, cell):
        """Is there such a cell?"""
        return 0 <= cell[0] < self.width and 0 <= cell[1] < self.height

    def around(self, cell):
        """The cells beside this one."""
        return [c for c in ((cell[0] + dx, cell[1] + dy) for dx, dy in SIDES) if self.inside(c)]

    def grow(self, first, random):
        """A spanning tree from `first` over all cells."""
        seen, stack = {first}, [first]
        while stack:
            fresh = [c for c in self.around(stack[-1]) if c not in seen]
            if not fresh:
                stack.pop()
                continue
            cell = fresh[random.below(len(fresh))]
            self.join(stack[-1], cell)
            seen.add(cell)
            stack.append(cell)

    def walls(self, gates=()):
        """Walls as the longest straight lines, each once, along grid lines. A gate is an opening in the rim: ((x, y), (x, y))."""
        units = set()
        for x in range(self.width + 1):
            for y in range(self.height):
                if ((x - 1, y), (x, y)) not in self.open:
                    units.add(((x, y), (x, y + 1)))
        for x in range(self.width):
            for y in range(self.height + 1):
                if ((x, y - 1), (x, y)) not in self.open:
                    units.add(((x, y), (x + 1, y)))
        return _joined(units - set(gates))


def _joined(units):
    lines = []
    for dx, dy in ((0, 1), (1, 0)):
        for a, b in sorted(unit for unit in units if (unit[1][0] - unit[0][0], unit[1][1] - unit[0][1]) == (dx, dy)):
            if ((a[0] - dx, a[1] - dy), a) in units:
                continue
            while (b, (b[0] + dx, b[1] + dy)) in units:
                b = (b[0] + dx, b[1] + dy)
            lines.append([a, b])
    return lines


# Where a hedge begins and how it runs on from there, in corridors to the east, north, west or south. The two that
# begin at (9, 10) and (14, 3) touch no other: they make the two islands.
HAMPTON_HEDGES = (
    (0, 5, "E1"),
    (2, 3, "S1 E6 N1 W3 N5 E3"),
    (2, 7, "N2 E3 N2 E14 S11 W9"),
    (3, 3, "N5 E2"),
    (4, 2, "N5"),
    (4, 10, "W3 S4 E1 S2 W1 S3 E18"),
    (5, 11, "W5 S11 E9"),
    (6, 8, "N2 E2 N1"),
    (7, 9, "E4"),
    (9, 1, "N3 W3 N3 E6 S3 W2 S2 E8 N3"),
    (9, 7, "N2"),
    (9, 10, "E3 S2 E1 S5 W2"),
    (10, 8, "E2"),
    (13, 11, "S2 E4 S1"),
    (14, 3, "N5 E2 S4"),
    (14, 10, "E4 S3 W1 S4 W2 N4"),
    (15, 2, "N1"),
    (18, 6, "E1"),
)


def _hedge(x, y, runs):
    line = [(x, y)]
    for run in runs.split():
        dx, dy = SIDES["ENWS".index(run[0])]
        x, y = x + dx * int(run[1:]), y + dy * int(run[1:])
        line.append((x, y))
    return line


def hampton_court():
    """The maze of Hampton Court (about 1690) as its plan is published, every corridor as wide as any other and all corners square:
    the same paths in the same order, not the trapezium of the garden."""
    return PlaneWorld([_hedge(*hedge) for hedge in HAMPTON_HEDGES], start=(9.5, -0.5), exit=(9.0, 5.5))


def versailles():
    """A maze of the size of the lost one at Versailles: 48 by 32 cells, some 1,000 walls. Not its plan."""
    maze = Maze(48, 32)
    maze.grow((0, 0), Random(1677))
    gates = [((0, 0), (0, 1)), ((48, 31), (48, 32))]
    return PlaneWorld(maze.walls(gates), start=(-0.5, 0.5), exit=(48.5, 31.5))
