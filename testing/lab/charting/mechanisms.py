# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies that constraints join: a needle as a lever, its path in and out, the cost of constraints."""

from .style import COLOURS, line, looks, pyplot


def draw(mechanism, laws):
    figure, axes = pyplot.subplot_mosaic([["lever", "stroke"], ["cost", "cost"]], figsize=(11, 6.5), height_ratios=[3, 1.6])
    draw_lever(axes["lever"], [row for row in mechanism if row.pairs.get("turning")])
    draw_stroke(axes["stroke"], [row for row in mechanism if "hand_mm" in row.pairs])
    draw_cost(axes["cost"], [row for row in laws if row.cost_us_p50 is not None])
    return figure


def draw_lever(axes, rows):
    spots = ("force of the wall", "force of the organ", "force on the hand")
    for colour, spot in zip(COLOURS, spots):
        for method, look in looks(row.method for row in rows).items():
            here = [row for row in rows if row.quantity == spot and row.method == method]
            ours = here[0].truth is not None
            line(axes, [(row.pairs["turning"], row.value) for row in here], spot if ours else f"{spot}, each spot by itself",
                 look, color=colour, linestyle="-" if ours else ":")
            line(axes, [(row.pairs["turning"], row.truth) for row in here if ours], None, look, color=colour, marker="",
                 linestyle="--", linewidth=5, alpha=0.3)
    axes.axhline(0.0, color="k", linewidth=1)
    axes.set(xscale="log", ylim=(-4.4, 0.6), xlabel="how stiffly the turn is held [N m/rad]", ylabel="[N]", title="moved across by 5 mm")
    axes.legend(fontsize=8, loc="lower left")


def draw_stroke(axes, rows):
    for method, look in looks(row.method for row in rows).items():
        for back in (0, 1):
            way = sorted((row for row in rows if row.method == method and row.pairs["back"] == back),
                         key=lambda row: row.pairs["hand_mm"])
            axes.plot([row.pairs["hand_mm"] for row in way], [row.value for row in way], label=None if back else method,
                      color=look["color"], linewidth=look["linewidth"], linestyle="--" if back else "-")
    axes.set(xlabel="hand along the needle [mm]", ylabel="against the hand [N]", title="in (drawn) and out (dashed)")
    axes.legend(fontsize=8)


def draw_cost(axes, rows):
    for i, row in enumerate(rows):
        axes.plot([i, i], [row.cost_us_p50, row.cost_us_p99], color=COLOURS[0], linewidth=3, alpha=0.4)
        axes.plot(i, row.cost_us_p50, color=COLOURS[0], marker="o")
    axes.set(ylabel="a tick [µs]", ylim=(0, None))
    axes.set_xticks(range(len(rows)), [row.case for row in rows], rotation=20, ha="right")
