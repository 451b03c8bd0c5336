# SPDX-License-Identifier: GPL-3.0-or-later
"""The gallery of plane worlds: made by its script, and every maze has a path, found by a search that knows only its walls."""

import math
import os
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as xml
from pathlib import Path

GALLERY = Path(os.environ["PALPATE_SOURCE_DIR"]) / "data" / "gallery"
MAZES = ("corridor", "spiral", "chartres", "hampton-court", "versailles")
STRUCTURES = ("wedge-field", "circle-set")

CLEARANCE = 0.2  # corridor widths between the path and every wall
STEP = 0.125  # shorter than twice the clearance: a step between two free places crosses no wall


class World:
    """The content of a file."""

    def __init__(self, path):
        root = xml.parse(path).getroot()
        arrays = {a.get("Name"): [float(t) for t in a.text.split()] for a in root.iter("DataArray")}
        values = arrays["Points"]
        points = list(zip(values[0::3], values[1::3]))
        self.heights = set(values[2::3])
        self.lines, begin = [], 0
        for end in (int(v) for v in arrays["offsets"]):
            self.lines.append([points[int(i)] for i in arrays["connectivity"][begin:end]])
            begin = end
        self.start = tuple(arrays["Start"][:2]) if "Start" in arrays else None
        self.exit = tuple(arrays["Exit"][:2]) if "Exit" in arrays else None

    def segments(self):
        return [pair for line in self.lines for pair in zip(line, line[1:])]


def distance(p, a, b):
    ax, ay = b[0] - a[0], b[1] - a[1]
    t = ((p[0] - a[0]) * ax + (p[1] - a[1]) * ay) / (ax * ax + ay * ay)
    t = min(1.0, max(0.0, t))
    return math.hypot(p[0] - a[0] - t * ax, p[1] - a[1] - t * ay)


class FreePlaces:
    """Places on a grid that are farther than the clearance from every wall."""

    def __init__(self, segments, start):
        self._start, self._blocked = start, set()
        for a, b in segments:
            low = [math.floor((min(a[k], b[k]) - CLEARANCE - start[k]) / STEP) for k in (0, 1)]
            high = [math.ceil((max(a[k], b[k]) + CLEARANCE - start[k]) / STEP) for k in (0, 1)]
            for i in range(low[0], high[0] + 1):
                for j in range(low[1], high[1] + 1):
                    if distance(self.place((i, j)), a, b) < CLEARANCE:
                        self._blocked.add((i, j))
        nodes = [self.node(p) for segment in segments for p in segment]
        self._low = [min(n[k] for n in nodes) - 8 for k in (0, 1)]
        self._high = [max(n[k] for n in nodes) + 8 for k in (0, 1)]

    def place(self, node):
        return (self._start[0] + STEP * node[0], self._start[1] + STEP * node[1])

    def node(self, place):
        return tuple(round((place[k] - self._start[k]) / STEP) for k in (0, 1))

    def _free(self, node):
        inside = all(self._low[k] <= node[k] <= self._high[k] for k in (0, 1))
        return inside and node not in self._blocked

    def steps_to(self, place):
        """Steps of the shortest path from the start to within a step of the place; None where there is no path."""
        goal, queue, count = self.node(place), [(0, 0)], {(0, 0): 0}
        for node in queue:
            if max(abs(node[0] - goal[0]), abs(node[1] - goal[1])) <= 1:
                return count[node]
            for dx, dy in ((1, 0), (0, 1), (-1, 0), (0, -1)):
                beside = (node[0] + dx, node[1] + dy)
                if beside not in count and self._free(beside):
                    count[beside] = count[node] + 1
                    queue.append(beside)
        return None


def open_sides(segments, width, height):
    """Pairs of neighbouring square cells without a wall between them, from the walls alone."""
    walls = set()
    for (ax, ay), (bx, by) in segments:
        length = round(abs(bx - ax) + abs(by - ay))
        for k in range(length):
            walls.add((ax + (bx - ax) * (k + 0.5) / length, ay + (by - ay) * (k + 0.5) / length))
    pairs = [((x, y), (x + 1, y), (x + 1.0, y + 0.5)) for x in range(width - 1) for y in range(height)]
    pairs += [((x, y), (x, y + 1), (x + 0.5, y + 1.0)) for x in range(width) for y in range(height - 1)]
    return [(a, b) for a, b, middle in pairs if middle not in walls]


SIDES = ((1, 0), (0, 1), (-1, 0), (0, -1))  # each is to the left of the one before


class Ways:
    """Where one can go from the cells of a maze."""

    def __init__(self, passages):
        self._open = set(passages) | {(b, a) for a, b in passages}

    def on(self, before, here):
        """The next cells for somebody who comes from `before`, the leftmost first."""
        heading = SIDES.index((here[0] - before[0], here[1] - before[1]))
        turned = [SIDES[(heading + k) % 4] for k in (1, 0, 3)]
        return [c for c in ((here[0] + dx, here[1] + dy) for dx, dy in turned) if (here, c) in self._open]

    def room(self, cell):
        """The cells around this one with an open square of four between each and its neighbours."""
        found, queue = {cell}, [cell]
        for x, y in queue:
            for dx, dy in SIDES:
                beside = (x + dx, y + dy)
                squares = [
                    ((x, y), beside, (beside[0] + sx, beside[1] + sy), (x + sx, y + sy))
                    for sx, sy in ((dy, dx), (-dy, -dx))
                ]
                whole = any(all((q[k], q[(k + 1) % 4]) in self._open for k in range(4)) for q in squares)
                if whole and beside not in found:
                    found.add(beside)
                    queue.append(beside)
        return found


def touch(a, b, c, d):
    """Do two lines along the axes meet?"""
    return all(max(min(a[k], b[k]), min(c[k], d[k])) <= min(max(a[k], b[k]), max(c[k], d[k])) for k in (0, 1))


class Gallery(unittest.TestCase):
    def test_the_script_makes_the_files_that_are_there(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([sys.executable, GALLERY / "make", folder], check=True, stdout=subprocess.DEVNULL)
            made = sorted(path.name for path in Path(folder).iterdir())
            self.assertEqual(made, sorted(f"{name}.vtp" for name in MAZES + STRUCTURES))
            self.assertEqual(made, sorted(path.name for path in GALLERY.glob("*.vtp")))
            for name in made:
                self.assertEqual((Path(folder) / name).read_bytes(), (GALLERY / name).read_bytes(), name)

    def test_every_maze_has_a_way_from_start_to_exit(self):
        for name in MAZES:
            with self.subTest(name):
                world = World(GALLERY / f"{name}.vtp")
                self.assertIsNotNone(FreePlaces(world.segments(), world.start).steps_to(world.exit))

    def test_structures_have_no_start(self):
        for name in STRUCTURES:
            self.assertIsNone(World(GALLERY / f"{name}.vtp").start, name)

    def test_all_lines_lie_in_the_plane_and_have_length(self):
        for name in MAZES + STRUCTURES:
            world = World(GALLERY / f"{name}.vtp")
            self.assertEqual(world.heights, {0.0}, name)
            self.assertTrue(all(a != b for a, b in world.segments()), name)

    def test_the_way_of_chartres_goes_through_all_its_circuits(self):
        # Eleven circles round the middle one corridor apart, cut short at each of the 30 turns by about two corridors; steps along
        # the axes of the grid only make the path longer.
        world = World(GALLERY / "chartres.vtp")
        steps = FreePlaces(world.segments(), world.start).steps_to(world.exit)
        circles = sum(2.0 * math.pi * (3.5 + k) for k in range(11))
        self.assertGreater(steps * STEP, circles - 2 * 30)

    def test_the_directions_for_visitors_of_hampton_court_lead_to_its_middle(self):
        # Left on entering, twice right, then four times left (published for the real one). A place with two next cells is a
        # junction, where a turn is to be taken.
        world = World(GALLERY / "hampton-court.vtp")
        ways = Ways(open_sides(world.segments(), 19, 11))
        middle = tuple(math.floor(v) for v in world.exit)
        before, here = (9, -1), (9, 0)
        for turn in "LRRLLLL":
            while len(ways.on(before, here)) == 1:
                before, here = here, ways.on(before, here)[0]
            order = ways.on(before, here)
            self.assertEqual(len(order), 2, here)
            before, here = here, order["LR".index(turn)]
        room = ways.room(middle)
        self.assertEqual(len(room), 6 * 3)
        while here not in room:
            self.assertEqual(len(ways.on(before, here)), 1, here)
            before, here = here, ways.on(before, here)[0]

    def test_hampton_court_has_two_islands(self):
        # Hedges that touch belong together: those around the maze, and two more groups.
        groups = []
        for a, b in World(GALLERY / "hampton-court.vtp").segments():
            touching = [g for g in groups if any(touch(a, b, c, d) for c, d in g)]
            groups = [g for g in groups if g not in touching] + [[(a, b)] + [s for g in touching for s in g]]
        self.assertEqual(len(groups), 3)

    def test_the_maze_of_versailles_size_has_one_way_between_any_two_places(self):
        # A connected graph of n places with n - 1 passages is a tree.
        world = World(GALLERY / "versailles.vtp")
        width, height = 48, 32
        passages = open_sides(world.segments(), width, height)
        self.assertEqual(len(passages), width * height - 1)
        joined = {(0, 0)}
        queue = [(0, 0)]
        beside = {}
        for a, b in passages:
            beside.setdefault(a, []).append(b)
            beside.setdefault(b, []).append(a)
        for cell in queue:
            fresh = [c for c in beside[cell] if c not in joined]
            joined.update(fresh)
            queue += fresh
        self.assertEqual(len(joined), width * height)
        self.assertTrue(500 <= len(world.segments()) <= 2000)


if __name__ == "__main__":
    unittest.main()
