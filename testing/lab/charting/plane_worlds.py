# SPDX-License-Identifier: GPL-3.0-or-later
"""Plane worlds on a joystick: the drag of a slow host on slanted walls, how small a feature may be, blind hands in mazes."""

from .style import line, looks, pyplot

NOTICED_N = 0.35  # 7 % of the 5 N of the simulated joystick
LEAST_N = 1e-3  # at the device's own rate there is no drag: drawn at the edge


def draw_host_rate(rows):
    figure, cells = pyplot.subplots(1, 2, figsize=(10.5, 4.2), sharey=True)
    for axes, quantity in zip(cells, ("mean drag", "peak drag")):
        of = [row for row in rows if row.quantity == quantity and row.method == "two held walls, down"]
        slides = sorted({(row.pairs["speed"], row.pairs["depth"]) for row in of})
        style = looks([f"{speed:g} m/s, {1e3 * depth:g} mm deep" for speed, depth in slides])
        for (speed, depth), (label, look) in zip(slides, style.items()):
            mine = [row for row in of if (row.pairs["speed"], row.pairs["depth"]) == (speed, depth)]
            line(axes, [(row.pairs["host"], max(row.value, LEAST_N)) for row in mine], label, look, linestyle="none")
            line(axes, [(row.pairs["host"], max(row.truth, LEAST_N)) for row in mine], None, look, marker="", linestyle="--")
        axes.axhline(NOTICED_N, color="k", linewidth=1, linestyle=":", label="felt from here on: 7 % of 5 N")
        axes.set(xscale="log", yscale="log", xlabel="rate of the host [Hz]", ylabel=quantity + " [N]",
                 title=quantity + " along a line at 45 degrees")
        axes.set_xticks([20, 50, 125, 250, 500, 1000], ["20", "50", "125", "250", "500", "1000"], minor=False)
        axes.minorticks_off()
    cells[0].legend(loc="lower left")
    return figure


def draw_smallest_feature(rows):
    figure, (axes, zooms) = pyplot.subplots(1, 2, figsize=(10.5, 4.2))
    of = [row for row in rows if row.quantity == "least width told apart" and row.method == "nearest side"]
    forces = sorted({row.pairs["force"] for row in of})
    for force, (label, look) in zip(forces, looks([f"pressed with {force:g} N" for force in forces]).items()):
        mine = [row for row in of if row.pairs["force"] == force]
        line(axes, [(row.pairs["stiffness"], 1e3 * row.value) for row in mine], label, look, linestyle="none")
        line(axes, [(row.pairs["stiffness"], 1e3 * row.truth) for row in mine], None, look, marker="", linestyle="--")
    axes.set(xscale="log", yscale="log", xlabel="stiffness of the walls [N/m]", ylabel="narrowest corridor told apart [mm]",
             title="2 F / K")
    axes.legend()
    offered = [row for row in rows if row.quantity == "zoom"]
    lost = {(row.case, row.method): row.value for row in rows if row.quantity == "corridors lost"}
    for i, row in enumerate(sorted(offered, key=lambda row: row.pairs["width"])):
        before, after = lost[(row.case, "nearest side")], lost[(row.case, "nearest side, enlarged")]
        zooms.bar(i - 0.2, before, 0.4, color="#D55E00", label="as it is" if i == 0 else None)
        zooms.bar(i + 0.2, after, 0.4, color="#0072B2", label="with the zoom offered" if i == 0 else None)
        zooms.text(i + 0.2, after, f" {after:g} at x {row.value:g}", color="#0072B2", rotation=90, ha="center", va="bottom")
    widths = [f"{1e3 * row.pairs['width']:g}\n{row.pairs['force']:g}" for row in sorted(offered, key=lambda row: row.pairs["width"])]
    zooms.set(xticks=range(len(widths)), xticklabels=widths, xlabel="width of the corridors [mm]; force [N]",
              ylabel="corridors the hand is lost by", title="200 N/m: zoomed so far, none is lost")
    zooms.set_ylim(0, 1.35 * zooms.get_ylim()[1])
    zooms.legend(loc="upper center", ncols=2)
    return figure


def draw_blind_solver(rows):
    of = [row for row in rows if row.quantity == "virtual time"]
    arrived = {(row.case, row.method): row.value == 1 for row in rows if row.quantity == "arrives"}
    mazes = list(dict.fromkeys(row.pairs["maze"] for row in of))
    runs = list(dict.fromkeys((row.pairs["device"], row.method) for row in of))
    style = looks([f"{device}, {method}" for device, method in runs])
    figure, axes = pyplot.subplots(figsize=(10.5, 4.6))
    hands = list(dict.fromkeys(row.pairs["hand"] for row in of))
    for k, (device, method) in enumerate(runs):
        look = style[f"{device}, {method}"]
        for j, hand in enumerate(hands):
            mine = [row for row in of if (row.pairs["device"], row.method, row.pairs["hand"]) == (device, method, hand)]
            places = [mazes.index(row.pairs["maze"]) + 0.08 * (k - len(runs) / 2) for row in mine]
            axes.plot(places, [row.value for row in mine], linestyle="none", color=look["color"], marker=look["marker"],
                      markersize=9 - 2 * (len(hands) - 1 - j),
                      label=f"{device.removeprefix('simulated-')}, {method}" if hand == hands[-1] else None)
            for place, row in zip(places, mine):
                if not arrived[(row.case, row.method)]:
                    axes.annotate("lost", (place, row.value))
    axes.set(xticks=range(len(mazes)), xticklabels=mazes, yscale="log", ylabel="virtual time to the exit [s]",
             title="the larger the mark, the stiffer the hand: " + ", ".join(hands))
    axes.legend(loc="upper left", ncols=2)
    return figure
