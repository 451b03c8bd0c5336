# SPDX-License-Identifier: GPL-3.0-or-later
"""Soft bodies: how stiff and how true they are felt at a low rate, the cost of their elements and contacts."""

from .costs import limit, spread
from .style import line, looks, pyplot


def by_rate(axes, rows, style, key="rate"):
    """Measured marks, and in the same colour the exact line."""
    for method, look in style.items():
        of = [row for row in rows if row.method == method and row.value is not None]
        line(axes, [(row.pairs[key], row.value) for row in of], method, look)
        line(axes, [(row.pairs[key], row.truth) for row in of if row.truth is not None], None, look, marker="",
             linestyle="--", linewidth=3.5, alpha=0.3)


def on_time(row):
    return row.pairs["lost"] == 0.0 and row.pairs["late_ms"] * row.pairs["rate"] < 1001.0


def draw_stability(multirate, direct):
    """C4: the stiffest contact and the error of the force against the rate of the body."""
    limits = [row for row in multirate if row.quantity == "stiffest contact"]
    errors = [row for row in multirate if row.quantity == "RMS error of the force" and row.value is not None]
    style = looks(row.method for row in limits)
    figure, (left, middle, right) = pyplot.subplots(1, 3, figsize=(13, 4))
    by_rate(left, [row for row in limits if on_time(row)], style)
    late = [(row.pairs["rate"], row.value) for row in limits if not on_time(row) and row.value is not None]
    line(left, late, "three periods late, or half of the packets lost", {"color": "k", "marker": "x"}, linestyle="none")
    left.set(xscale="log", yscale="log", ylim=(10, 2e4), xlabel="packets of the body [Hz]", ylabel="stiffest coupling [N/m]",
             title="a device of 0.1 kg on a pad of 27 N/mm")
    left.legend(fontsize=8)
    held = [row for row in direct if "rate" in row.pairs and row.quantity == "stiffest contact"]
    by_rate(middle, held, {method: style["ours: " + method if method.startswith("shared") else method]
                           for method in {row.method for row in held}})
    middle.set(xscale="log", yscale="log", xlabel="rate of the body [Hz]", ylabel="stiffest contact [N/m]",
               title="on a body of 5 g and 3 N/mm")
    middle.legend(fontsize=8)
    by_rate(right, errors, style)
    limit(right, 0.03, "3 %")
    right.set(xscale="log", yscale="log", xlabel="packets of the body [Hz]", ylabel="RMS error of the force",
              title="pressed 15 mm deep at 0.2 m/s")
    return figure


def draw_mechanics(locking, patch, contacts, struck):
    """C5 and C6: elements, patches, contacts, and bodies that are struck."""
    figure, grid = pyplot.subplots(2, 2, figsize=(10.5, 8))
    bent = [row for row in locking if row.quantity == "too stiff by" and row.value is not None and row.cost_us_p50]
    for method, look in looks(row.method for row in bent).items():
        line(grid[0][0], [(1e-3 * row.cost_us_p50, row.value) for row in bent if row.method == method], method, look)
    limit(grid[0][0], 0.02, "2 %")
    grid[0][0].set(xscale="log", yscale="log", xlabel="factor [ms]", ylabel="too stiff by", title="a bar that bends")
    grid[0][0].legend()
    soft = [row for row in patch if row.quantity == "compliance" and row.value is not None]
    line(grid[0][1], [(row.pairs["edge_mm"], 1e3 * row.value) for row in soft], "under a patch of 12.5 mm", {"color": "#0072B2", "marker": "o"})
    growth = [row for row in patch if row.method == "one node" and row.value is not None]
    line(grid[0][1], [(row.pairs["edge_mm"], row.value) for row in growth], "under a node, over that of the mesh before",
         {"color": "#D55E00", "marker": "s"})
    grid[0][1].set(xlabel="edges [mm]", ylabel="compliance [mm/N], or growth", title="finer meshes")
    grid[0][1].legend()
    many = [row for row in contacts if "contacts" in row.pairs]
    spread(grid[1][0], many, "contacts", looks(row.method for row in many))
    limit(grid[1][0], 350.0, "0.35 ms")
    grid[1][0].set(xscale="log", yscale="log", xlabel="contacts with friction", ylabel="cost of a solution, p50 to p99 [µs]")
    hit = [row for row in struck if row.quantity == "most force of an impact"]
    by_rate(grid[1][1], hit, looks(row.method for row in hit))
    limit(grid[1][1], 1.0, "truth: v sqrt(K m)")
    grid[1][1].set(xscale="log", ylim=(0, 1.1), xlabel="steps of the body [Hz]", ylabel="most force of an impact [N]",
                   title="a free body of 0.1 kg is struck")
    return figure
