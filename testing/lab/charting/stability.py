# SPDX-License-Identifier: GPL-3.0-or-later
"""How stiff a wall may be: against rate, delay, damping, encoder step, friction, and the cost for a hand."""

from .style import line, looks, pyplot

AXES = {
    "rate": ("rate [Hz]", "log"),
    "delay": ("delay [ticks]", "linear"),
    "damping": ("damping of the device [N s/m]", "log"),
    "quantisation": ("encoder step [µm]", "log"),
    "friction": ("friction of the device [N]", "linear"),
}
NAMES = "m {mass:g}\nb {damping:g}\nB {virtual:g}\nd {delay:g}"
LEAST = 10.0  # N/m: softer walls are drawn at the edge


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
             title="simulated devices, 1 kHz, no hand")


def draw_atlas(rows, transparency):
    style = looks(row.method for row in rows + transparency if row.quantity == "K_max")
    chains = {row.method: style[row.method] for row in rows if row.quantity == "K_max"}
    figure, grid = pyplot.subplots(3, 3, figsize=(10.5, 9.5))
    cells = [axes for line_of in grid for axes in line_of]
    for axes, what in zip(cells, AXES):
        draw_varied(axes, rows, what, chains)
    draw_devices(cells[5], rows, chains)
    draw_transparency(cells[6:], transparency, style)
    handles = [pyplot.Line2D([], [], label=method, **look) for method, look in style.items()]
    handles.append(pyplot.Line2D([], [], color="0.5", linestyle=":", linewidth=2, label="passive (any hand)"))
    handles.append(pyplot.Line2D([], [], color="0.4", linestyle="--", linewidth=3.5, alpha=0.4, label="theory, same colour"))
    figure.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, 0.0), ncols=4)
    return figure


def draw_transparency(cells, rows, style):
    """The cost of each stabiliser: drag in free air, error of a spring's impedance, and the stiffness it buys."""
    first = [row for row in rows if row.pairs.get("device") == "D1"]
    titles = {"drag": ("drag in free air at 0.1 m/s [N]", 0.05), "impedance error": ("error of a spring's impedance", 0.08)}
    for axes, (quantity, (label, limit)) in zip(cells, titles.items()):
        for method, look in style.items():
            points = [(row.pairs["frequency"], row.value) for row in first
                      if row.quantity == quantity and row.method == method and "frequency" in row.pairs]
            line(axes, points, method, look)
        axes.axhline(limit, color="k", linewidth=1, linestyle="--")
        axes.set(xscale="log", xlabel="frequency of the hand [Hz]", ylabel=label)
    for method, look in style.items():
        drag = [row.value for row in first if row.method == method and row.quantity == "drag"]
        stiffest = [row.value for row in first if row.method == method and row.quantity == "K_max"]
        if drag and stiffest:
            cells[2].plot([max(drag)], [max(stiffest[0], LEAST)], linestyle="none", label=method, **{**look, "linewidth": 0})
    cells[2].axvline(0.05, color="k", linewidth=1, linestyle="--")
    cells[2].set(xlabel="drag in free air at 0.1 m/s [N]", ylabel="stiffest wall [N/m]", yscale="log",
                 title="what stability costs (D1)")


def draw_rates(rows):
    """C3: rate against stiffness, and beside it the effect of delay and damping on both limits."""
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(10.5, 4.5))
    limits = [[row for row in rows if row.quantity == quantity and row.value is not None] for quantity in ("K_crit", "K_passive")]
    draw_limits(left, *([(row.pairs["rate"], row) for row in of if set(row.pairs) == {"rate"}] for of in limits), "", "")
    left.axvline(60, color="k", linewidth=1, alpha=0.5)
    left.annotate("drawing, 60 Hz", (60, 0.55), xycoords=("data", "axes fraction"), textcoords="offset points", xytext=(-3, 0),
                  rotation=90, fontsize=9, ha="right")
    left.set(xscale="log", xlabel="rate [Hz]", ylabel="stiffest wall [N/m]", title="0.1 kg with 1 N s/m against a spring")
    draw_cases(right, *limits)
    return figure


def draw_cases(axes, measured, passive):
    """Devices and delays at one rate, side by side."""
    names = {row.case: NAMES.format(**row.pairs) for row in measured if "mass" in row.pairs}
    cases = list(names)
    draw_limits(axes, *([(cases.index(row.case), row) for row in of if row.case in names] for of in (measured, passive)), "_", "v",
                linestyle="none")
    axes.set_xticks(range(len(cases)), names.values(), fontsize=8)
    axes.set(xlabel="m [kg], b of device, B of wall [N s/m], d [ticks]", title="mass, damping and delay at 1 kHz")


def draw_limits(axes, measured, passive, exact, dotted, **more):
    """Where a wall begins to shake, found and by eigenvalues, and up to where it is passive."""
    line(axes, [(x, max(row.value, LEAST)) for x, row in measured], "measured: begins to shake", {"color": "#D55E00", "marker": "s"},
         linestyle="none")
    line(axes, [(x, max(row.truth, LEAST)) for x, row in measured], "exact eigenvalues",
         {"color": "#000000", "linestyle": "-", "marker": exact, "markersize": 14, **more})
    line(axes, [(x, max(row.value, LEAST)) for x, row in passive], "passive with any hand",
         {"color": "0.5", "linestyle": ":", "marker": dotted, "markerfacecolor": "none", **more})
    axes.set(yscale="log")
    axes.legend(fontsize=9)
