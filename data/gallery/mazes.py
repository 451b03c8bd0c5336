# SPDX-License-Identifier: GPL-3.0-or-later
"""Mazes of square cells: a spanning tree of the cells is the ways, all other sides are walls.

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
    """Cells (x, y), which of their sides are open, and rooms: cells that are one place."""

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

    def ways(self, cell):
        """The cells one can go to."""
        return [c for c in self.around(cell) if (cell, c) in self.open]

    def grow(self, first, random, room=()):
        """A spanning tree from `first` over all cells outside of the room, which stays one place with one door."""
        seen, stack, doors = {first, *room}, [first], []
        while stack:
            fresh = [c for c in self.around(stack[-1]) if c not in seen]
            if not fresh:
                stack.pop()
                continue
            cell = fresh[random.below(len(fresh))]
            self.join(stack[-1], cell)
            seen.add(cell)
            stack.append(cell)
        for cell in room:
            for beside in self.around(cell):
                if beside in room:
                    self.join(cell, beside)
                else:
                    doors.append((cell, beside))
        if doors:
            self.join(*doors[random.below(len(doors))])

    def path(self, begin, end):
        """The cells from one to the other."""
        came = {begin: begin}
        queue = [begin]
        for cell in queue:
            for c in self.ways(cell):
                if c not in came:
                    came[c] = cell
                    queue.append(c)
        back = [end]
        while back[-1] != begin:
            back.append(came[back[-1]])
        return back[::-1]

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


def turns(maze, path):
    """Left or right at every place on the path where there is a choice: L or R of the two ways on, - of three."""
    letters = ""
    for before, here, after in zip(path, path[1:], path[2:]):
        heading = SIDES.index((here[0] - before[0], here[1] - before[1]))
        ways = [c for c in maze.ways(here) if c != before]
        if len(ways) > 1:
            # From the leftmost: left of the heading, straight on, right.
            order = [(here[0] + SIDES[(heading + k) % 4][0], here[1] + SIDES[(heading + k) % 4][1]) for k in (1, 0, 3)]
            ways = [c for c in order if c in ways]
            letters += "-" if len(ways) > 2 else "LR"[ways.index(after)]
    return letters


# How visitors of Hampton Court are told to go: left on entering, twice right, then left to the middle.
HAMPTON_TURNS = "LRRLLLL"


def hampton_court():
    """A maze of the size of Hampton Court's in whose middle one arrives by the directions given for that one.

    The first of the numbered mazes of this kind with these directions: not a survey of the hedges."""
    width, height = 15, 9
    room = [(x, y) for x in (6, 7, 8) for y in (4, 5)]
    for seed in range(1, 1000000):
        maze = Maze(width, height)
        maze.grow((7, 0), Random(seed), room)
        # The step in from outside counts: it gives the first heading.
        path = [(7, -1)] + maze.path((7, 0), (7, 4))
        door = next(i for i, cell in enumerate(path) if cell in room)
        if turns(maze, path[: door + 1]) == HAMPTON_TURNS:
            gate = ((7, 0), (8, 0))
            return PlaneWorld(maze.walls([gate]), start=(7.5, -0.5), exit=(7.5, 5.0))
    raise ValueError("no maze with these directions")


def versailles():
    """A maze of the size of the lost one at Versailles: 48 by 32 cells, some 1,000 walls. Not its plan."""
    maze = Maze(48, 32)
    maze.grow((0, 0), Random(1677))
    gates = [((0, 0), (0, 1)), ((48, 31), (48, 32))]
    return PlaneWorld(maze.walls(gates), start=(-0.5, 0.5), exit=(48.5, 31.5))
