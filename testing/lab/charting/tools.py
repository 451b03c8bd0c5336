# SPDX-License-Identifier: GPL-3.0-or-later
"""Rigid tools that turn: the force between two updates, and the stiffest turn."""

from .style import line, looks, pyplot

NOTHING = 1e-3  # N: less is drawn at the edge


def draw_between(drag, stability):
    """The drag on a slide, the step of a tick, and the stiffest turn against the rate."""
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
