# SPDX-License-Identifier: GPL-3.0-or-later
"""How stiff a wall may be: against rate, delay, damping, encoder step, friction, and what that costs a hand."""

from .style import line, looks, pyplot

AXES = {
    "rate": ("rate [Hz]", "log"),
    "delay": ("delay [ticks]", "linear"),
    "damping": ("damping of the device [N s/m]", "log"),
    "quantisation": ("encoder step [µm]", "log"),
    "friction": ("friction of the device [N]", "linear"),
}
LEAST = 10.0  # N/m: what is softer is drawn at the edge


def varied(rows, what, quantity):
    return [row for row in rows if row.quantity == quantity and row.pairs.get("vary") == what and row.value is not None]


def draw_varied(axes, rows, what, style):
    measured, passive = varied(rows, what, "K_max"), varied(rows, what, "K_passive")
    for method, look in style.items():
        of = [row for row in measured if row.method == method]
        line(axes, [(row.pairs["x"], max(row.value, LEAST)) for row in of], method, look)
        theory = [(row.pairs["x"], max(row.truth, LEAST)) for row in of if row.truth is not None]
        line(axes, theory, None, look, marker="", linestyle="--", linewidth=3.5, alpha=0.3)
    springs = [row for row in passive if row.method == "spring"]
    line(axes, [(row.pairs["x"], max(row.value, LEAST)) for row in springs], "passive (any hand)",
         {"color": "0.5"}, linestyle=":", linewidth=2)
    label, scale = AXES[what]
    axes.set(xlabel=label, ylabel="stiffest wall [N/m]", xscale=scale, yscale="log", title="against " + what)


def draw_devices(axes, rows, style):
    measured = varied(rows, "device", "K_max")
    devices = sorted({row.pairs["device"] for row in measured})
    width = 0.8 / max(1, len(style))
    for k, (method, look) in enumerate(style.items()):
        values = {row.pairs["device"]: max(row.value, LEAST) for row in measured if row.method == method}
        axes.bar([i + (k - 1) * width for i in range(len(devices))], [values.get(d, LEAST) for d in devices], width,
                 color=look["color"], label=method, hatch=["", "//", ".."][k % 3], edgecolor="w")
    passive = {row.pairs["device"]: max(row.value, LEAST) for row in varied(rows, "device", "K_passive") if row.method == "spring"}
    axes.plot(range(len(devices)), [passive.get(d, LEAST) for d in devices], "k_", markersize=24, label="passive (any hand)")
    axes.set(xticks=range(len(devices)), xticklabels=devices, yscale="log", ylabel="stiffest wall [N/m]",
             title="the simulated devices, 1 kHz, in no hand")


def draw_atlas(rows, transparency):
    style = looks(row.method for row in rows + transparency if row.quantity == "K_max")
    chains = {row.method: style[row.method] for row in rows if row.quantity == "K_max"}
    figure, grid = pyplot.subplots(3, 3, figsize=(12, 10))
    cells = [axes for line_of in grid for axes in line_of]
    for axes, what in zip(cells, AXES):
        draw_varied(axes, rows, what, chains)
    draw_devices(cells[5], rows, chains)
    draw_transparency(cells[6:], transparency, style)
    handles, labels = cells[0].get_legend_handles_labels()
    handles.append(pyplot.Line2D([], [], color="0.4", linestyle="--", linewidth=3.5, alpha=0.4))
    figure.legend(handles, labels + ["theory, same colour"], loc="upper center", bbox_to_anchor=(0.5, 0.0), ncols=5)
    return figure


def draw_transparency(cells, rows, style):
    """What each stabiliser costs: drag in free air, error of a spring's impedance, and the stiffness it buys."""
    first = [row for row in rows if row.pairs.get("device") == "D1"]
    titles = {"drag": ("drag in free air at 0.1 m/s [N]", 0.05), "impedance error": ("error of a spring's impedance", 0.08)}
    for axes, (quantity, (label, limit)) in zip(cells, titles.items()):
        for method, look in style.items():
            points = [(row.pairs["frequency"], row.value) for row in first
                      if row.quantity == quantity and row.method == method and "frequency" in row.pairs]
            line(axes, points, method, look)
        axes.axhline(limit, color="k", linewidth=1, linestyle="--")
        axes.set(xscale="log", xlabel="frequency of the hand [Hz]", ylabel=label)
        axes.legend(fontsize=6)
    for method, look in style.items():
        drag = [row.value for row in first if row.method == method and row.quantity == "drag"]
        stiffest = [row.value for row in first if row.method == method and row.quantity == "K_max"]
        if drag and stiffest:
            cells[2].plot([max(drag)], [max(stiffest[0], LEAST)], linestyle="none", label=method, **{**look, "linewidth": 0})
    cells[2].axvline(0.05, color="k", linewidth=1, linestyle="--")
    cells[2].set(xlabel="drag in free air at 0.1 m/s [N]", ylabel="stiffest wall [N/m]", yscale="log",
                 title="what stability costs (D1)")
    cells[2].legend(fontsize=6)


def draw_rates(rows):
    """C3: rate against stiffness."""
    figure, axes = pyplot.subplots(figsize=(7, 4.5))
    by_rate = [row for row in rows if set(row.pairs) == {"rate"} and row.value is not None]
    measured = [row for row in by_rate if row.quantity == "K_crit"]
    line(axes, [(row.pairs["rate"], row.value) for row in measured], "measured: begins to shake",
         {"color": "#D55E00", "marker": "s"}, linestyle="none")
    line(axes, [(row.pairs["rate"], row.truth) for row in measured], "exact eigenvalues", {"color": "#D55E00"})
    line(axes, [(row.pairs["rate"], row.value) for row in by_rate if row.quantity == "K_passive"],
         "passive with any hand, 2 b / T", {"color": "0.5"}, linestyle=":")
    axes.axvline(60, color="k", linewidth=1, alpha=0.5)
    axes.annotate("drawing, 60 Hz", (60, axes.get_ylim()[0] * 2), rotation=90, fontsize=7, ha="right")
    axes.set(xscale="log", yscale="log", xlabel="rate [Hz]", ylabel="stiffest wall [N/m]",
             title="0.1 kg with 1 N s/m against a spring")
    axes.legend()
    return figure
