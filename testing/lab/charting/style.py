# SPDX-License-Identifier: GPL-3.0-or-later
"""How things look in every chart: one colour and one marker a method, told apart without colour as well."""

import matplotlib

matplotlib.use("Agg")  # no display
matplotlib.rcParams.update({
    "svg.hashsalt": "palpate-lab",  # the same file for the same data
    "svg.fonttype": "none",
    "font.size": 10,
    "figure.titlesize": 10,
    "axes.titlesize": 10,
    "axes.grid": True,
    "grid.alpha": 0.25,
    "axes.axisbelow": True,
    "legend.frameon": False,
    "figure.constrained_layout.use": True,
})

import matplotlib.pyplot as pyplot  # noqa: E402  (after the back-end is chosen)

# Okabe and Ito's colours, which most colour-blind people tell apart, and four more that markers tell apart.
COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000", "#999999", "#7F3C8D", "#A6761D", "#117733"]
MARKERS = ["o", "s", "^", "D", "v", "p", "<", ">", "h", "8", "d"]  # all with an inside: hollow means failed
OURS = ("god-object", "ours", "enumeration", "spring+passivity")


def is_ours(method):
    return method.startswith(OURS)


def looks(methods):
    """A colour, marker and line width for each method, the product's own first and bold, the later ones smaller: equal
    results lie on top of each other."""
    ordered = sorted(set(methods), key=lambda method: (not is_ours(method), method))
    return {
        method: {"color": COLOURS[i % len(COLOURS)], "marker": MARKERS[i % len(MARKERS)],
                 "linewidth": 2.2 if is_ours(method) else 1.1, "markersize": max(4, 9 - 3.5 * i) if is_ours(method) else 5}
        for i, method in enumerate(ordered)
    }


def line(axes, points, label, look, **more):
    """Points (x, y) in order of x."""
    points = sorted(points)
    axes.plot([x for x, _ in points], [y for _, y in points], label=label, **{**look, **more})
