# SPDX-License-Identifier: GPL-3.0-or-later
"""The share of a surface that a hand covers along its path, and the separate pieces without contact.

Forces along a path cannot reveal changes beyond the path, such as a second body that appears or vanishes. A baseline
therefore also stores the pieces of its surface.
"""

from dataclasses import dataclass

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import mutable
from vtkmodules.vtkCommonDataModel import vtkStaticCellLocator
from vtkmodules.vtkFiltersCore import vtkConnectivityFilter, vtkStaticCleanPolyData, vtkTriangleFilter

from palpate.testing.feel import faces_of, updated

REACH_M = 5e-3  # of the hand: half the width of a fingertip
REACH_SHARE = 0.05  # of the size of a surface, where that is less
SAMPLES = 10000  # places, spread evenly over the area: a hundredth of it is known to about a tenth
MOST_PLACES = 2000  # of a path, evenly spaced, that are looked at
MOST_PIECES = 200  # that are told apart, the largest first
SAME_AREA = 0.07  # as of a force: smaller differences count as none


@dataclass
class Piece:
    """A part of a surface that hangs together."""

    area: float  # [u^2]
    centre: np.ndarray  # of its area, (3) [u]
    touched: bool  # a hand felt it on its path

    def is_like(self, other, reach_u):
        """Whether both may be the same one."""
        near = np.linalg.norm(self.centre - other.centre) <= reach_u
        return near and abs(self.area - other.area) <= SAME_AREA * max(self.area, other.area)


@dataclass
class Coverage:
    """The part of a surface that a path reaches."""

    area: float  # [u^2]
    share: float  # of the area, within reach of where the hand felt something
    count: int  # of all pieces
    reach_u: float
    pieces: list  # the largest of them

    def as_written(self):
        """As a baseline holds it."""
        numbers = [[piece.area, *piece.centre, piece.touched] for piece in self.pieces]
        return {"area": _short(self.area), "covered": _short(self.share), "reach": _short(self.reach_u), "pieces": self.count,
                "largest": [[_short(number) for number in row] for row in numbers]}

    @classmethod
    def read(cls, held):
        """Reads the content of a baseline; ValueError, KeyError or TypeError for other content."""
        rows = np.array(held["largest"], dtype=float).reshape(-1, 5)
        numbers = [float(held[name]) for name in ("area", "covered", "reach")]
        if not (np.isfinite(rows).all() and np.isfinite(numbers).all() and len(rows) == min(held["pieces"], MOST_PIECES)):
            raise ValueError("its surface")
        area, share, reach_u = numbers
        return cls(area, share, int(held["pieces"]), reach_u, [Piece(row[0], row[1:4], bool(row[4])) for row in rows])

    def text(self):
        """The coverage of the path as text."""
        touched = sum(piece.touched for piece in self.pieces)
        pieces = "its one piece" if self.count == 1 else f"{touched} of its {self.count} pieces"
        return f"the path covers {100 * self.share:.2g} % of the surface and touches {pieces}"


def _short(number):
    return float(f"{number:.6g}")


def covered(surface, proxies, settings):
    """The coverage of a surface by proxy positions with force (n, 3) [u]; None for a surface without faces."""
    mesh = _triangles(surface)
    if not mesh.GetNumberOfPolys():
        return None
    corners = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
    triangles = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    a, b, c = (corners[triangles[:, k]] for k in range(3))
    areas = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)
    if not areas.sum() > 0:
        return None
    size_u = float(np.linalg.norm(np.ptp(corners, axis=0)))
    reach_u = min(REACH_M * settings["Scale"], REACH_SHARE * size_u) + float(settings.get("Radius", 0.0))
    proxies = proxies[np.unique(np.linspace(0, len(proxies) - 1, min(len(proxies), MOST_PLACES)).astype(int))]
    share = _share_within(_spread(a, b, c, areas), _thinned(proxies, reach_u / 8), reach_u)
    labels = vtk_to_numpy(mesh.GetPointData().GetArray("RegionId"))[triangles[:, 0]]
    touched = set(labels[_nearest_cells(mesh, proxies)].tolist())
    pieces = _pieces(labels, areas, (a + b + c) / 3, touched)
    return Coverage(float(areas.sum()), share, len(pieces), reach_u, pieces[:MOST_PIECES])


def _triangles(surface):
    """Faces as triangles whose points have the number of their piece; points in one place are one."""
    together, triangles, connected = vtkStaticCleanPolyData(), vtkTriangleFilter(), vtkConnectivityFilter()
    together.ToleranceIsAbsoluteOn()
    together.SetAbsoluteTolerance(0.0)
    together.SetInputData(faces_of(surface))
    triangles.PassVertsOff()
    triangles.PassLinesOff()
    triangles.SetInputData(updated(together))
    connected.SetExtractionModeToAllRegions()
    connected.ColorRegionsOn()
    connected.SetInputData(updated(triangles))
    return updated(connected)


def _pieces(labels, areas, centres, touched):
    """All, the largest first."""
    numbers, which = np.unique(labels, return_inverse=True)
    area = np.bincount(which, areas)
    weight = np.where(area > 0, area, 1.0)
    centre = np.column_stack([np.bincount(which, areas * centres[:, k]) / weight for k in range(3)])
    return [Piece(float(area[i]), centre[i], int(numbers[i]) in touched) for i in np.argsort(-area, kind="stable")]


def _spread(a, b, c, areas):
    """Places that are spread evenly over the area of triangles: the same ones every time."""
    ends = np.cumsum(areas)
    number = np.arange(SAMPLES)
    triangle = np.minimum(np.searchsorted(ends, (number + 0.5) / SAMPLES * ends[-1]), len(areas) - 1)
    plastic = 1.32471795724474602596  # Roberts' sequence: no two of its points are close
    u, v = (0.5 + number / plastic) % 1, (0.5 + number / plastic**2) % 1
    u, v = np.where(u + v > 1, 1 - u, u)[:, None], np.where(u + v > 1, 1 - v, v)[:, None]
    return a[triangle] + u * (b - a)[triangle] + v * (c - a)[triangle]


def _thinned(places, step_u):
    """One of those in each cell of a grid."""
    return places[np.unique(np.round(places / step_u), axis=0, return_index=True)[1]] if len(places) else places


def _share_within(places, proxies, reach_u):
    beyond = places
    for some in np.array_split(proxies, len(proxies) // 50 + 1):
        if len(some) and len(beyond):
            squares = ((beyond[:, None] - some[None]) ** 2).sum(axis=2)
            beyond = beyond[squares.min(axis=1) > reach_u**2]
    return 1 - len(beyond) / len(places)


def _nearest_cells(mesh, places):
    """The triangle that is nearest to each place."""
    locator = vtkStaticCellLocator()
    locator.SetDataSet(mesh)
    locator.BuildLocator()
    cells, nearest, cell, part, far = [], [0.0] * 3, mutable(0), mutable(0), mutable(0.0)
    for place in places:
        locator.FindClosestPoint(place.tolist(), nearest, cell, part, far)
        cells.append(int(cell))
    return cells


def changed_pieces(then, now):
    """Sentences on pieces that appeared, vanished or changed beyond the path; empty without changes."""
    if then is None or now is None:
        return [] if then is now else ["the surface has faces now, and had none" if now else "the surface has no faces any more"]
    reach_u = max(then.reach_u, now.reach_u)
    gone = _without_partner(then.pieces, now.pieces, reach_u)
    come = _without_partner(now.pieces, then.pieces, reach_u)
    lines = [f"gone, and never touched: {_said(piece)}" for piece in gone] + \
            [f"new, and not touched: {_said(piece)}" for piece in come]
    if then.count != now.count:
        lines.insert(0, f"the surface has {now.count} separate pieces, and had {then.count}")
    if not lines and abs(then.area - now.area) > SAME_AREA * max(then.area, now.area):
        lines.append(f"the surface's area is {now.area:.4g}, and was {then.area:.4g}, at positions that the path does not reach")
    return lines


def _without_partner(pieces, others, reach_u):
    """The untouched ones of which none of the others is like."""
    left = list(others)
    alone = []
    for piece in pieces:
        partner = next((i for i, other in enumerate(left) if piece.is_like(other, reach_u)), None)
        if partner is not None:
            del left[partner]
        elif not piece.touched:
            alone.append(piece)
    return alone


def _said(piece):
    return f"a piece of area {piece.area:.4g} around ({', '.join(f'{coordinate:.4g}' for coordinate in piece.centre)})"
