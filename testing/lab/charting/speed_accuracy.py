# SPDX-License-Identifier: GPL-3.0-or-later
"""The chart: every method on every scene it can do, its cost against its error, failures shown as such."""

from .style import is_ours, looks, pyplot

LEAST = 1e-4  # below a ten-thousandth of the least felt error there is nothing to compare
FAILURES = {1: "through", 2: "stuck", 3: "unstable"}  # 4, a wrong force, has an error that says how wrong
FLOOR, BAND, TOP = 3e6, 2e7, 2e8  # of the band of failures, above every error the lab tells


def outcomes(rows):
    return {(row.case, row.method): int(row.value) for row in rows if row.quantity == "outcome" and row.value is not None}


def draw_scene(axes, rows, failed, style, named=True):
    for row in rows:
        if row.value is None or row.cost_us_p50 is None:
            continue
        look = style[row.method]
        outcome = failed.get((row.case, row.method), 0)
        x = [max(row.cost_us_p50, 0.01), max(row.cost_us_p99, 0.01)]
        if outcome in FAILURES:  # no error is large enough for these: they stand above the axis
            y = BAND
            if named:
                axes.annotate(FAILURES[outcome], (x[0], y), textcoords="offset points", xytext=(0, 5), fontsize=9,
                              ha="center", color=look["color"])
        else:
            y = max(row.value, LEAST)
        face = "none" if outcome else look["color"]
        axes.plot(x, [y, y], color=look["color"], linewidth=look["linewidth"], alpha=0.7)
        if row.cost_us_most is not None:
            axes.plot([x[1], max(row.cost_us_most, 0.01)], [y, y], color=look["color"], linewidth=1, linestyle=":", alpha=0.7)
        axes.plot(x[:1], [y], marker=look["marker"], color=look["color"], markerfacecolor=face, linestyle="none",
                  markersize=look["markersize"])
    frontier(axes, rows, failed)
    axes.axhline(1.0, color="k", linewidth=1, linestyle="--")
    axes.axhspan(FLOOR, TOP, color="k", alpha=0.06)
    axes.set(xscale="log", yscale="log", ylim=(LEAST / 2, TOP))


def frontier(axes, rows, failed):
    """The reach of the product: nothing of it is both cheaper and closer to the truth."""
    points = sorted((row.cost_us_p50, max(row.value, LEAST)) for row in rows
                    if is_ours(row.method) and row.value is not None and row.cost_us_p50 and
                    not failed.get((row.case, row.method), 0))
    steps, best = [], float("inf")
    for x, y in points:
        if y < best:
            steps.append((x, y))
            best = y
    if steps:
        xs = [x for x, _ in steps] + [1e3]
        ys = [y for _, y in steps] + [steps[-1][1]]
        axes.step(xs, ys, where="post", color="#0072B2", alpha=0.35, linewidth=4)


def draw(rows, step="a tick"):
    errors = [row for row in rows if row.quantity == "error"]
    failed = outcomes(rows)
    scenes = list(dict.fromkeys(row.case for row in errors))
    style = looks(row.method for row in errors)
    columns = min(3, len(scenes) + 1)
    lines = -(-(len(scenes) + 1) // columns)
    figure, grid = pyplot.subplots(lines, columns, figsize=(10.5, 2.7 * lines), sharex=True, sharey=True, squeeze=False)
    cells = [axes for row in grid for axes in row]
    draw_scene(cells[0], errors, failed, style, named=False)
    cells[0].set_title("all scenes")
    for axes, scene in zip(cells[1:], scenes):
        draw_scene(axes, [row for row in errors if row.case == scene], failed, style)
        axes.set_title(scene)
    for axes in cells[len(scenes) + 1:]:
        axes.axis("off")
    for row in grid:
        row[0].set_ylabel("error [JND]")
    for axes in cells[len(scenes) + 1 - columns:len(scenes) + 1]:  # the lowest of each column
        axes.set_xlabel(f"cost of {step}, p50 to p99 [µs]")
        axes.tick_params(labelbottom=True)
    handles = [pyplot.Line2D([], [], label=method, **look) for method, look in style.items()]
    handles.append(pyplot.Line2D([], [], label="hollow: failed", color="0.4", marker="o", markerfacecolor="none", linestyle="none"))
    handles.append(pyplot.Line2D([], [], label="dotted: to the longest", color="0.4", linewidth=1, linestyle=":"))
    figure.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, 0.0), ncols=4)
    return figure
