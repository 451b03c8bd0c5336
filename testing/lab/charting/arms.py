# SPDX-License-Identifier: GPL-3.0-or-later
"""Arms of the same links and motors beside each other: maps of their condition, stiffness, force and mass."""

import numpy
from matplotlib.colors import LogNorm, Normalize
from matplotlib.ticker import LogLocator, NullLocator, StrMethodFormatter

from .style import pyplot

MARK = "map: "
ARMS = {"serial": ("two links in a row", [(0.0, 0.0)]), "five-bar": ("five-bar", [(-50.0, 0.0), (50.0, 0.0)])}
QUALITIES = {  # title, norm, colours: light is good
    "condition": ("condition\n(1: the same in all directions)", Normalize, "viridis_r"),
    "softest stiffness": ("stiffness of the tip,\nsoftest direction [N/m]", LogNorm, "viridis"),
    "largest force in the worst direction": ("largest force,\nworst direction [N]", LogNorm, "viridis"),
    "apparent mass in the heaviest direction": ("apparent mass,\nheaviest direction [kg]", LogNorm, "viridis_r"),
}


def places(rows, arm, quality):
    """Places [mm] and values of one map."""
    of = [row for row in rows if row.method == arm and row.quantity == MARK + quality and row.value is not None]
    return [(row.pairs["x_mm"], row.pairs["y_mm"], row.value) for row in of]


def draw_map(axes, points, norm, colours):
    """A square for each place; where there is none the arm cannot be used."""
    xs, ys = (sorted({point[i] for point in points}) for i in (0, 1))
    step = min(b - a for a, b in zip(ys, ys[1:]))
    grid = numpy.full((round((ys[-1] - ys[0]) / step) + 1, round((xs[-1] - xs[0]) / step) + 1), numpy.nan)
    for x, y, value in points:
        grid[round((y - ys[0]) / step), round((x - xs[0]) / step)] = value
    edges = [[(first + (i - 0.5) * step) for i in range(count + 1)] for first, count in ((xs[0], grid.shape[1]), (ys[0], grid.shape[0]))]
    return axes.pcolormesh(*edges, grid, norm=norm, cmap=colours)


def draw(rows):
    figure, grid = pyplot.subplots(len(ARMS), len(QUALITIES), figsize=(14, 5.4), sharex=True, sharey=True)
    for column, (quality, (title, norm, colours)) in enumerate(QUALITIES.items()):
        maps = {arm: places(rows, arm, quality) for arm in ARMS}
        values = [value for points in maps.values() for _, _, value in points]
        low, high = numpy.percentile(values, [1, 99])
        scale = norm(low, high)
        for line, (arm, points) in enumerate(maps.items()):
            axes = grid[line][column]
            drawn = draw_map(axes, points, scale, colours)
            name, motors = ARMS[arm]
            axes.plot(*zip(*motors), "k^", markersize=6, clip_on=False)
            fifth, middle, ninety_fifth = numpy.percentile([value for _, _, value in points], [5, 50, 95])
            axes.text(0.5, 0.03, f"median {middle:.3g}, 5 to 95 %: {fifth:.3g} to {ninety_fifth:.3g}", transform=axes.transAxes,
                      ha="center", fontsize=8)
            axes.set(aspect="equal", xlim=(-310, 310), ylim=(-60, 310))
            if column == 0:
                axes.set_ylabel(name + "\ny [mm]")
        grid[0][column].set_title(title)
        grid[-1][column].set_xlabel("x [mm]")
        bar = figure.colorbar(drawn, ax=list(grid[:, column]), location="bottom", extend="both", shrink=0.9, pad=0.02,
                              format=StrMethodFormatter("{x:g}"))
        if norm is LogNorm:
            bar.ax.xaxis.set_major_locator(LogLocator(subs=(1, 2, 5) if high / low > 5 else (3, 4, 5, 6, 8)))
            bar.ax.xaxis.set_minor_locator(NullLocator())
    return figure
