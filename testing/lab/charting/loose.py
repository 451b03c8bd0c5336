# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies with mass: on a slope, in the hand, on a pin."""

from .style import line, looks, pyplot


def draw(loose, inertia):
    figure, (slope, shaken, pin) = pyplot.subplots(1, 3, figsize=(13, 4))
    draw_by(slope, loose, "slid in a second", "slope")
    slope.set(xlabel="tangent of the slope over the friction", ylabel="slid in a second [m]", title="a box on a slope")
    slope.set_yscale("symlog", linthresh=1e-4)
    draw_by(shaken, inertia, "force of the hand", "frequency_Hz")
    shaken.set(xscale="log", yscale="log", xlabel="frequency of the hand [Hz]", ylabel="amplitude of the force [N]",
               title="a box of 160 g that a hand shakes by 1 mm")
    draw_by(pin, inertia, "pendulum off by", "tick_ms")
    pin.set(xscale="log", yscale="log", xlabel="tick [ms]", ylabel="off after 0.16 s [rad]", title="a box that swings from a pin")
    pin.set_xticks([0.125, 0.25, 0.5, 1.0], ["0.125", "0.25", "0.5", "1"])
    pin.set_xticks([], minor=True)
    for axes in (slope, shaken, pin):
        axes.legend(fontsize=8)
    return figure


def draw_by(axes, rows, quantity, pair):
    """Each method against a number of the case, and the formula below as a wide dashed line."""
    here = [row for row in rows if row.quantity == quantity]
    for method, look in looks(row.method for row in here).items():
        mine = [row for row in here if row.method == method]
        line(axes, [(row.pairs[pair], row.value) for row in mine], method, look)
        exact = [(row.pairs[pair], row.truth) for row in mine if row.truth is not None]
        if any(y for _, y in exact):  # a limit has the ideal 0
            line(axes, exact, "formula", look, marker="", linestyle="--", linewidth=5, alpha=0.3)
