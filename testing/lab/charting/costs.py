# SPDX-License-Identifier: GPL-3.0-or-later
"""C1, C2 and C9: what size costs, and what it brings."""

from .style import line, looks, pyplot

LEAST = 1e-16


def spread(axes, rows, key, style):
    """Median as a line, p50 to p99 as a band."""
    for method, look in style.items():
        points = sorted((row.pairs[key], row.cost_us_p50, row.cost_us_p99) for row in rows
                        if row.method == method and row.cost_us_p50 is not None and key in row.pairs)
        if points:
            x = [p[0] for p in points]
            axes.fill_between(x, [p[1] for p in points], [p[2] for p in points], color=look["color"], alpha=0.12)
            line(axes, [(p[0], p[1]) for p in points], method, look)


def draw_facets(rows):
    """C1: triangles against force error and cost."""
    errors = [row for row in rows if row.quantity == "force error" and row.value is not None]
    style = looks(row.method for row in errors)
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(11, 4))
    for method, look in style.items():
        line(left, [(row.pairs["triangles"], row.value) for row in errors if row.method == method], method, look)
    left.axhline(0.07, color="k", linestyle="--", linewidth=1)
    left.annotate("7 %: what a hand notices", (left.get_xlim()[0] * 1.2, 0.075), fontsize=7)
    left.set(xscale="log", yscale="log", xlabel="triangles of the sphere", ylabel="largest relative force error",
             title="1 mm deep in a sphere of 50 mm")
    left.legend()
    spread(right, errors, "triangles", style)
    right.set(xscale="log", yscale="log", xlabel="triangles of the sphere", ylabel="cost of a tick, p50 to p99 [µs]")
    return figure


def draw_solver(rows):
    """C2: solver against cost."""
    errors = [row for row in rows if row.quantity == "error" and row.value is not None and "planes" in row.pairs]
    style = looks(row.method for row in errors)
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(11, 4))
    for method, look in style.items():
        line(left, [(row.pairs["planes"], max(row.value, LEAST)) for row in errors if row.method == method], method, look)
    left.axhline(1e-12, color="k", linestyle="--", linewidth=1)
    left.set(yscale="log", xlabel="planes", ylabel="relative error against an exact oracle")
    left.legend()
    spread(right, errors, "planes", style)
    right.set(yscale="log", xlabel="planes", ylabel="cost of a solution, p50 to p99 [µs]")
    return figure


def draw_queries(rows):
    """C9: triangles against query cost."""
    timed = [row for row in rows if row.quantity == "disagreements" and row.cost_us_p50 is not None and "triangles" in row.pairs]
    kinds = sorted({row.pairs.get("query", "") for row in timed})
    style = looks(row.method for row in timed)
    figure, grid = pyplot.subplots(1, max(1, len(kinds)), figsize=(5.5 * max(1, len(kinds)), 4), sharey=True, squeeze=False)
    for axes, kind in zip(grid[0], kinds):
        spread(axes, [row for row in timed if row.pairs.get("query") == kind], "triangles", style)
        axes.set(xscale="log", yscale="log", xlabel="triangles", title=f"query: {kind}")
    grid[0][0].set_ylabel("cost of a query, p50 to p99 [µs]")
    grid[0][0].legend(fontsize=7)
    return figure
