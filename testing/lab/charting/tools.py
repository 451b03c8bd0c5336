# SPDX-License-Identifier: GPL-3.0-or-later
"""Rigid tools that turn: every method on every scene, what is felt between two updates, how stiff a turn may be held."""

from .style import line, looks, pyplot

LEAST = 1e-6  # mm: below, nothing is to be compared
NOTHING = 1e-3  # N: what is less is drawn at the edge


def draw_methods(rows):
    """C7: cost of an update against pose error."""
    errors = [row for row in rows if row.quantity == "pose error" and row.value is not None]
    scenes = list(dict.fromkeys(row.case for row in errors))
    style = looks(row.method for row in errors)
    columns = 3
    lines = -(-(len(scenes) + 1) // columns)
    figure, grid = pyplot.subplots(lines, columns, figsize=(10.5, 3.0 * lines), sharex=True, sharey=True, squeeze=False)
    cells = [axes for row in grid for axes in row]
    for axes, scene in zip(cells, scenes):
        for row in (row for row in errors if row.case == scene and row.cost_us_p50 is not None):
            look, y = style[row.method], max(row.value, LEAST)
            axes.plot([row.cost_us_p50, row.cost_us_p99], [y, y], color=look["color"], linewidth=look["linewidth"], alpha=0.7)
            axes.plot([row.cost_us_p50], [y], marker=look["marker"], color=look["color"], linestyle="none",
                      markersize=look["markersize"])
        axes.set(xscale="log", yscale="log", title=scene)
    for axes in cells[len(scenes):]:
        axes.axis("off")
    for row in grid:
        row[0].set_ylabel("pose error [mm]")
    for axes in cells[len(scenes) - columns:len(scenes)]:
        axes.set_xlabel("cost of an update, p50 to p99 [µs]")
        axes.tick_params(labelbottom=True)
    handles = [pyplot.Line2D([], [], label=method, **look) for method, look in style.items()]
    figure.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, 0.0), ncols=3)
    return figure


def draw_between(drag, stability):
    """What a slide drags with, what a tick jumps by, and the stiffest turn against the rate."""
    style = looks(row.method for row in drag)
    figure, (left, middle, right) = pyplot.subplots(1, 3, figsize=(13, 4))
    for method, look in style.items():
        line(left, [(row.pairs["rate"], max(row.value, NOTHING)) for row in drag
                    if row.quantity == "drag" and row.method == method], method, look)
    left.axhline(0.5, color="k", linewidth=1, linestyle="--")
    left.set(xscale="log", yscale="log", xlabel="updates of the tool [Hz]", ylabel="drag [N]",
             title="sliding at 0.1 m/s, without friction")
    left.legend()
    others = [row for row in drag if row.quantity != "drag" and row.value is not None]
    cases = list(dict.fromkeys(row.case for row in others))
    width = 0.8 / max(1, len(style))
    for k, (method, look) in enumerate(style.items()):
        values = {row.case: max(row.value, NOTHING) for row in others if row.method == method}
        middle.bar([i + (k - 1) * width for i in range(len(cases))], [values.get(case, NOTHING) for case in cases], width,
                   color=look["color"], label=method, edgecolor="w")
    middle.set(xticks=range(len(cases)), xticklabels=[case.replace(" ", "\n") for case in cases], yscale="log",
               ylabel="step or error of the force [N]", title="between updates at 100 Hz")
    hands = looks(row.method for row in stability if row.quantity == "K_max")
    for hand, look in hands.items():
        of = [row for row in stability if row.quantity == "K_max" and row.method == hand and row.value is not None]
        line(right, [(row.pairs["rate"], row.value) for row in of], "hand: " + hand, look)
        line(right, [(row.pairs["rate"], row.truth) for row in of if row.truth is not None], None, look, marker="",
             linestyle="--", linewidth=3.5, alpha=0.3)
    passive = [(row.pairs["rate"], row.value) for row in stability if row.quantity == "K_passive"]
    line(right, passive, "2 b / T", {"color": "0.5"}, linestyle=":", linewidth=2)
    right.set(xscale="log", yscale="log", xlabel="rate [Hz]", ylabel="stiffest spring of a turn [N m/rad]",
              title="a handle that turns")
    right.legend()
    return figure
