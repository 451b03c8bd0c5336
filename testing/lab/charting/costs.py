# SPDX-License-Identifier: GPL-3.0-or-later
"""C1, C2, C9 and lines in a plane: the cost of size, and its gain."""

from matplotlib.ticker import LogFormatter, MaxNLocator

from .style import line, looks, pyplot

LEAST = 1e-16
QUERIES_A_LINE = 3


def spread(axes, rows, key, style):
    """Median as a line, p50 to p99 as a band; hollow marks where the answers were wrong."""
    for method, look in style.items():
        points = sorted((row.pairs[key], row.cost_us_p50, row.cost_us_p99) for row in rows
                        if row.method == method and row.cost_us_p50 is not None and key in row.pairs)
        if points:
            x = [p[0] for p in points]
            axes.fill_between(x, [p[1] for p in points], [p[2] for p in points], color=look["color"], alpha=0.12)
            line(axes, [(p[0], p[1]) for p in points], method, look)
            wrong = [(row.pairs[key], row.cost_us_p50) for row in rows
                     if row.method == method and row.quantity == "disagreements" and row.value and row.cost_us_p50 is not None]
            line(axes, wrong, None, look, linestyle="none", markerfacecolor="w")


def limit(axes, height, text):
    axes.axhline(height, color="k", linestyle="--", linewidth=1)
    axes.annotate(text, (0.02, height), xycoords=("axes fraction", "data"), textcoords="offset points", xytext=(0, 3), fontsize=9)


def draw_facets(rows):
    """C1: triangles against force error and cost."""
    errors = [row for row in rows if row.quantity == "force error" and row.value is not None]
    style = looks(row.method for row in errors)
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(11, 4))
    for method, look in style.items():
        line(left, [(row.pairs["triangles"], row.value) for row in errors if row.method == method], method, look)
    limit(left, 0.07, "7 %: what a hand notices")
    left.set(xscale="log", yscale="log", xlabel="triangles of the sphere", ylabel="largest relative force error",
             title="1 mm deep in a sphere of 50 mm")
    left.legend()
    spread(right, errors, "triangles", style)
    right.set(xscale="log", yscale="log", xlabel="triangles of the sphere", ylabel="cost of a tick, p50 to p99 [µs]")
    for which in (right.yaxis.set_major_formatter, right.yaxis.set_minor_formatter):  # hardly a decade high
        which(LogFormatter(minor_thresholds=(2, 1)))
    return figure


def draw_solver(rows):
    """C2: solver against cost."""
    errors = [row for row in rows if row.quantity == "error" and row.value is not None and "planes" in row.pairs]
    style = looks(row.method for row in errors)
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(11, 4))
    for method, look in style.items():
        line(left, [(row.pairs["planes"], max(row.value, LEAST)) for row in errors if row.method == method], method, look)
    limit(left, 1e-12, "1e-12: exact")
    left.xaxis.set_major_locator(MaxNLocator(integer=True))
    left.set(yscale="log", xlabel="planes", ylabel="relative error against an exact oracle")
    left.legend()
    spread(right, errors, "planes", style)
    right.xaxis.set_major_locator(MaxNLocator(integer=True))
    right.set(yscale="log", xlabel="planes", ylabel="cost of a solution, p50 to p99 [µs]")
    return figure


def draw_queries(rows):
    """C9: triangles against query cost."""
    timed = [row for row in rows if row.quantity == "disagreements" and row.cost_us_p50 is not None and "triangles" in row.pairs]
    kinds = sorted({row.pairs.get("query", "") for row in timed})
    style = looks(row.method for row in timed)
    lines = max(1, -(-len(kinds) // QUERIES_A_LINE))
    figure, grid = pyplot.subplots(lines, QUERIES_A_LINE, figsize=(10.5, 3.5 * lines), sharex=True, sharey=True, squeeze=False)
    cells = [axes for row in grid for axes in row]
    for axes, kind in zip(cells, kinds):
        spread(axes, [row for row in timed if row.pairs.get("query") == kind], "triangles", style)
        axes.set(xscale="log", yscale="log", title=f"query: {kind}")
        axes.xaxis.set_tick_params(labelbottom=True)
    for axes in cells[len(kinds):]:
        axes.axis("off")
    for row in grid:
        row[0].set_ylabel("cost of a query [µs]")
    figure.supxlabel("triangles", fontsize="medium")
    figure.legend(*cells[0].get_legend_handles_labels(), loc="upper center", bbox_to_anchor=(0.5, 0.0), ncols=6)
    return figure


def draw_lines(rows):
    """Lines of a plane world against the cost of a question, by the tree and by asking every line, and of a whole tick."""
    timed = [row for row in rows if "lines" in row.pairs and row.cost_us_p50 is not None and not row.quantity.startswith("p50")]
    figure, axes = pyplot.subplots(figsize=(8, 4.4))
    spread(axes, timed, "lines", looks(row.method for row in timed))
    axes.set(xscale="log", yscale="log", xlabel="lines", ylabel="cost, p50 to p99 [µs]")
    axes.legend()
    return figure


def draw_bricks(rows):
    """Tetrahedra against the error of a block and its cost, for three distances of its points."""
    errors = [row for row in rows if row.quantity == "error" and "tetrahedra" in row.pairs]
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(11, 4))
    shares = sorted({row.pairs["share"] for row in errors})
    style = looks(f"points {share:g} edges apart" for share in shares)
    for share, (name, look) in zip(shares, sorted(style.items())):
        here = [row for row in errors if row.pairs["share"] == share]
        line(left, [(row.pairs["tetrahedra"], row.value) for row in here], name, look)
        line(right, [(row.pairs["tetrahedra"], 1e-3 * row.cost_us_p50) for row in here], name, look)
    left.set(xscale="log", yscale="log", xlabel="tetrahedra", ylabel="largest error of a function of size 1")
    right.set(xscale="log", yscale="log", xlabel="tetrahedra", ylabel="cost of a brick, p50 [ms]")
    limit(right, 40.0, "40 ms")
    left.legend()
    return figure
