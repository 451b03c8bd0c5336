# SPDX-License-Identifier: GPL-3.0-or-later
"""The joystick of the nineties: its link, its springs, the model of soft lines; and walls that feel stiffer than they are."""

from .style import line, looks, pyplot


def draw_joystick(link, springs, lines):
    figure, (rates, energies, corner) = pyplot.subplots(1, 3, figsize=(13, 4.2))
    draw_link(rates, link)
    draw_springs(energies, springs)
    draw_corner(corner, lines)
    return figure


def draw_link(axes, rows):
    of = [row for row in rows if row.quantity == "updates" and row.method in ("a force", "four wall places")]
    for method, look in looks(row.method for row in of).items():
        mine = [row for row in of if row.method == method]
        line(axes, [(row.pairs["host"], row.value) for row in mine], method, look, linestyle="none")
        line(axes, [(row.pairs["host"], row.truth) for row in mine], None, look, marker="", linestyle="--")
    line(axes, [(20, 20), (1000, 1000)], "what is asked for", {"color": "0.5"}, linestyle=":")
    axes.set(xscale="log", yscale="log", xlabel="rate of the host [Hz]", ylabel="carried [1/s]", title="31,250 baud")
    axes.legend()


def draw_springs(axes, rows):
    of = [row for row in rows if "share" in row.pairs and row.pairs["host"] == 125]
    for quantity, look in looks(row.quantity for row in of).items():
        mine = [row for row in of if row.quantity == quantity]
        line(axes, [(row.pairs["share"], 1e6 * row.value) for row in mine], quantity, look, linestyle="none")
        line(axes, [(row.pairs["share"], 1e6 * row.truth) for row in mine], None, look, marker="", linestyle="--")
    axes.set(xlabel="moment of crossing, share of the host's period", ylabel="energy [µJ]",
             title="a switched spring: 200 N/m, 0.1 m/s, 125 Hz")
    axes.legend()


def draw_corner(axes, rows):
    of = [row for row in rows if row.quantity == "force" and row.pairs["x"] == 0.004]
    for label, look in looks(f"{row.method}, {row.pairs['way']}" for row in of).items():
        mine = [row for row in of if f"{row.method}, {row.pairs['way']}" == label]
        line(axes, [(row.pairs["share"], row.value) for row in mine], label, look, markersize=3,
             linestyle="--" if label.startswith("soft") else "-")
    axes.set(xlabel="share of the way to 4 mm, 1 mm beyond the corner", ylabel="force [N]",
             title="pushed into an inside corner, 200 N/m")
    axes.legend(fontsize=8)


def draw_stiff_walls(integral, impact):
    figure, (limits, work, hits) = pyplot.subplots(1, 3, figsize=(13, 4.2))
    draw_limits(limits, integral)
    draw_work(work, integral)
    draw_hits(hits, impact)
    return figure


def draw_limits(axes, rows):
    of = [row for row in rows if row.quantity == "largest K_i"]
    for method, look in looks(row.method for row in of).items():
        line(axes, [(row.pairs["stiffness"], row.value) for row in of if row.method == method], method, look, linestyle="none")
    line(axes, [(row.pairs["stiffness"], row.truth) for row in of], "exact eigenvalues", {"color": "k"})
    axes.set(xlabel="stiffness K [N/m]", ylabel="largest K_i [N/(m s)]", ylim=(0, None), title="0.1 kg, 1 N s/m, 1 kHz")
    axes.legend(fontsize=8)


def draw_work(axes, rows):
    of = [row for row in rows if row.quantity == "damping the hand has to bring"]
    for label, look in looks(f"K_i = {row.pairs['integral']:g} N/(m s)" for row in of).items():
        mine = [row for row in of if f"K_i = {row.pairs['integral']:g} N/(m s)" == label]
        line(axes, [(row.pairs["frequency"], row.value) for row in mine], label, look, linestyle="none")
        line(axes, [(row.pairs["frequency"], row.truth) for row in mine], None, look, marker="", linestyle="--")
    for name, damping in (("light", 2), ("stylus", 5), ("firm", 10)):
        axes.axhline(damping, color="k", linewidth=1, linestyle=":")
        axes.annotate(name, (10, damping), fontsize=8, ha="right", va="bottom")
    axes.set(xscale="log", yscale="log", xlabel="frequency of the hand [Hz]", ylabel="damping the hand has to bring [N s/m]",
             title="what an integral costs; dotted: hands")
    axes.legend(fontsize=8)


def draw_hits(axes, rows):
    pulses = [row for row in rows if row.quantity == "largest force over that of the spring"]
    transients = [row for row in rows if row.quantity == "force at first over the spring's largest"]
    for label, look in looks(f"braking pulse, {row.pairs['speed']:g} m/s" for row in pulses).items():
        mine = [row for row in pulses if f"braking pulse, {row.pairs['speed']:g} m/s" == label]
        line(axes, [(row.pairs["share"], row.value) for row in mine], label, look, linestyle="none")
        line(axes, [(row.pairs["share"], row.truth) for row in mine], None, look, marker="", linestyle="--")
    for row in transients[:1]:
        axes.axhline(row.value, color="k", linestyle=":", label="transient of 20 N s/m")
    axes.axhline(1.0, color="0.5", linewidth=1, label="the spring itself, 1000 N/m")
    axes.set(yscale="log", xlabel="moment of the impact, share of a tick", ylabel="hardest force over the spring's",
             title="what an impact feels like")
    axes.legend(fontsize=8)
