# SPDX-License-Identifier: GPL-3.0-or-later
"""A plane world as a VTK poly data file, in text: lines, and where a maze begins and ends.

Lengths are in corridor widths (scene units); z = 0. A maze has the field arrays Start and Exit, three numbers each; a
structure to explore has none. Both have the field array Corridor.
"""

from dataclasses import dataclass, field


@dataclass
class PlaneWorld:
    """Lines as lists of points (x, y); a line that ends where it began is closed."""

    lines: list = field(default_factory=list)
    start: tuple | None = None
    exit: tuple | None = None

    def segments(self):
        """Every segment as a pair of points."""
        return [pair for line in self.lines for pair in zip(line, line[1:])]


def _numbers(values):
    return " ".join(f"{value:.9g}" for value in values)


def _array(name, values, kind="Float64", **more):
    attributes = "".join(f' {key}="{value}"' for key, value in more.items())
    return f'<DataArray type="{kind}" Name="{name}"{attributes} format="ascii">{_numbers(values)}</DataArray>'


def _field(world):
    places = (("Start", world.start), ("Exit", world.exit))
    arrays = [_array(name, (*p, 0.0), NumberOfTuples=1, NumberOfComponents=3) for name, p in places if p]
    arrays.append(_array("Corridor", (1.0,), NumberOfTuples=1))
    return "    <FieldData>\n      " + "\n      ".join(arrays) + "\n    </FieldData>\n"


def to_text(world):
    """The file's text. A point that several lines share is written once."""
    index = {}
    for line in world.lines:
        for point in line:
            index.setdefault(tuple(float(f"{value:.9g}") for value in point), len(index))
    rows = [[index[tuple(float(f"{value:.9g}") for value in point)] for point in line] for line in world.lines]
    connectivity = [i for row in rows for i in row]
    offsets = [sum(len(row) for row in rows[: k + 1]) for k in range(len(rows))]
    points = [value for x, y in index for value in (x, y, 0.0)]
    return (
        '<?xml version="1.0"?>\n'
        '<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian">\n'
        "  <PolyData>\n"
        f"{_field(world)}"
        f'    <Piece NumberOfPoints="{len(index)}" NumberOfVerts="0" NumberOfLines="{len(rows)}" '
        'NumberOfStrips="0" NumberOfPolys="0">\n'
        f"      <Points>{_array('Points', points, NumberOfComponents=3)}</Points>\n"
        f"      <Lines>{_array('connectivity', connectivity, 'Int32')}{_array('offsets', offsets, 'Int32')}</Lines>\n"
        "    </Piece>\n"
        "  </PolyData>\n"
        "</VTKFile>\n"
    )
