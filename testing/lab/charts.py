#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the charts of a lab run: PNG and SVG of each, and one static index.html.

usage: charts.py FOLDER [--out FOLDER]      FOLDER: where palpate-lab wrote its CSVs
Exit code 2 for bad input, with one line that names the file and the reason.
"""

import argparse
import pathlib
import sys

from charting import arms, costs, loose, mechanisms, old_joystick, plane_worlds, soft, speed_accuracy, stability, tools
from charting.page import page
from charting.style import pyplot
from charting.tables import Problem, read_folder

# name, title, caption, experiments it needs, how it is drawn
CHARTS = [
    ("speed-accuracy", "Speed against accuracy",
     "Each mark is a method on a scene: how long a tick takes (a line from the median to the 99th of a hundred, dotted to the longest; "
     "each tick is the least of three runs) against its largest error, in units of what a hand can feel (7 % of the force, 18 degrees; 1e-4 and less on one height). Below the "
     "dashed line nobody feels a difference; hollow marks failed, those in the grey band went through, stuck or left every "
     "bound; the wide blue line is the product's frontier: nothing of it is both cheaper and truer.",
     ["speed-accuracy"], lambda t: speed_accuracy.draw(t["speed-accuracy"])),
    ("stability-atlas", "Stability atlas, and what stability costs",
     "The stiffest wall that stays still, for each method: marks are measured, wide dashed lines are theory, the dotted line is "
     "what is passive whoever holds the device (10 N/m and less on one height): stable and passive are different questions. Below: what each way to gain "
     "stiffness costs a hand in free air and on a spring; left of and under the dashed lines it cannot be felt.",
     ["stability-atlas", "transparency"], lambda t: stability.draw_atlas(t["stability-atlas"], t["transparency"])),
    ("facets", "How fine a sphere must be (C1)",
     "The force error that facets make falls like one over their number; under 7 % more triangles cannot be felt. "
     "The cost of a tick hardly grows with them.",
     ["facets"], lambda t: costs.draw_facets(t["facets"])),
    ("solver", "The nearest point under many planes (C2)",
     "Enumeration is exact for any number of planes a tick meets; taking one plane a tick or projecting in turn is cheaper and wrong.",
     ["solver"], lambda t: costs.draw_solver(t["solver"])),
    ("rate-stiffness", "Rate against stiffness (C3)",
     "A wall can be as stiff as its rate allows: at the 60 Hz of drawing it is mush. Filled marks are measured on the simulated "
     "device, black is the exact limit, grey what is passive in any hand: right, a damped wall that stays still need not be passive (10 N/m and less on one height).",
     ["wall-stability"], lambda t: stability.draw_rates(t["wall-stability"])),
    ("queries", "Collision queries (C9)",
     "What one query costs in each library on the same meshes and segments; a band reaches from the median to the 99th of a hundred. "
     "Hollow marks answer wrongly somewhere: what is cheap at a vertex or a seam is often not right there.",
     ["queries"], lambda t: costs.draw_queries(t["queries"])),
    ("host-rate", "A slanted wall behind a slow host (C8)",
     "A joystick holds a slanted line as two walls, which the host moves on: between two updates they drag. Marks are measured on "
     "held walls, dashed lines are the formula; above the dotted line a hand feels it. At the device's own rate there is none (drawn at the edge).",
     ["slanted-wall"], lambda t: plane_worlds.draw_host_rate(t["slanted-wall"])),
    ("plane-cost", "A tree or every line",
     "Where a way of 20 ticks first meets a line, asked of the tree and of all lines in turn: they cross where a tree begins to be "
     "worth it. A tick asks the tree several times, of shorter ways, and does the rest of contact as well. Bands reach from the median to the 99th of a hundred.",
     ["plane-cost"], lambda t: costs.draw_lines(t["plane-cost"])),
    ("smallest-feature", "How small a feature may be",
     "A hand that presses with F stands F / K behind a wall: corridors and walls narrower than 2 F / K (dashed) cannot be told apart. "
     "Right: how many corridors off the hand comes to rest, and that the zoom that is offered makes it none.",
     ["smallest-feature"], lambda t: plane_worlds.draw_smallest_feature(t["smallest-feature"])),
    ("blind-solver", "Blind hands in mazes",
     "A hand that knows no walls finds its way by force and position alone (Tremaux's rules): the virtual time from start to exit, for "
     "each simulated device in each hand with the host closing the force at 1 kHz, and with a joystick that holds four walls behind a host of 20 Hz.",
     ["blind-solver"], lambda t: plane_worlds.draw_blind_solver(t["blind-solver"])),
    ("old-joystick", "The joystick of the nineties",
     "Left: what its serial link carries; a force in each millisecond is four times too much, walls at 20 Hz are a sixth of it. Middle: its "
     "springs pull as well as push, so the host switches them: what a hand is given on the way in is taken on the way out. Right: lines that "
     "push back as deep as the handle is in them let it through an inside corner; the virtual location stays. Dashed on the left: formulas.",
     ["link-budget", "switched-springs", "soft-lines"],
     lambda t: old_joystick.draw_joystick(t["link-budget"], t["switched-springs"], t["soft-lines"])),
    ("stiff-walls", "Walls that feel stiffer than the loop allows",
     "An integral walks a pressing hand back to the surface: left, how fast it may (marks measured); middle, the damping a swinging hand has to "
     "bring for it, the more the slower it is (dotted: simulated hands). Right: a braking pulse and a transient against the spring they are added to.",
     ["integral-wall", "impact-walls"], lambda t: old_joystick.draw_stiff_walls(t["integral-wall"], t["impact-walls"])),
    ("fields", "Numbers in space: speed against accuracy",
     "As above, for a ball and a thin sheet in voxels and for ten turns round a vortex: a proxy on the isosurface and an implicit "
     "follower, beside forces mapped from the value where the hand is, explicit followers, and a mesh of triangles of the same voxels.",
     ["fields"], lambda t: speed_accuracy.draw(t["fields"])),
    ("brick", "How true and how dear the numbers around a hand are",
     "A brick of 48 x 48 x 48 points around a hand in tetrahedra, its points a quarter, half or all of their edge apart: the largest "
     "error of a smooth function falls with the cells, and a brick costs little more in many cells than in few.",
     ["brick"], lambda t: costs.draw_bricks(t["brick"])),
    ("soft-stability", "Stability atlas: what gives way (C4)",
     "A body that is computed at a low rate. Left: its compliance shared with the servo holds what the servo's own rate holds, on time, late "
     "or with packets lost; a force that is held dies with the rate; a spring to where the ball was is stiff, but wrong. Wide dashed lines "
     "are exact eigenvalues. Middle: the same where the body has a mass. Right: what each makes of a fast press.",
     ["multirate", "direct-coupling"], lambda t: soft.draw_stability(t["multirate"], t["direct-coupling"])),
    ("soft-accuracy", "What gives way: speed against accuracy",
     "As above, for a ball that is pressed 15 mm deep at 0.2 m/s into a soft pad: the whole body solved in every tick is the truth, and "
     "costs more than a period of the servo has; packets of its compliance; a force or a place that is held from one packet to the next.",
     ["multirate"], lambda t: speed_accuracy.draw(t["multirate"])),
    ("soft-mechanics", "What gives way: elements and contacts (C5, C6)",
     "Edge-smoothed tetrahedra bend as a bar does where linear ones lock, for less. Under a patch compliance has a limit as edges shrink, "
     "under a node it has none. Contacts that share compliance are solved within the tick (a band from the median to the 99th of a "
     "hundred). A body with a mass that is struck needs steps of the servo's rate: below, that is said to whoever strikes it.",
     ["locking", "patch", "contacts", "struck"],
     lambda t: soft.draw_mechanics(t["locking"], t["patch"], t["contacts"], t["struck"])),
    ("mechanism", "A needle through a wall and an organ",
     "Left: what wall and organ do to a needle that the hand moves across by 5 mm, against how stiffly the device holds its turn: wide dashed "
     "lines are the least energy. Each spot by itself pushes where the organ is pulled, and has the hand feel up to 29 % too much. Right: the needle goes in, "
     "punctures, turns round and comes back; what falls at once is spread for the hand. Below: what laws cost a tick, from the median to the 99th of a hundred.",
     ["mechanism", "laws"], lambda t: mechanisms.draw(t["mechanism"], t["laws"])),
    ("loose", "Bodies with mass: slopes, inertia, and the tick",
     "Left: a box slides on a slope as Coulomb's law says (wide dashed line), and rests below the angle of friction; friction as a damper, "
     "whole from 1 mm/s on, creeps there. Middle: the hand feels the inertia of a box that it shakes; a body at rest in each tick has none. "
     "Right: with half the tick a pendulum is twice as near to the true one.",
     ["loose", "inertia"], lambda t: loose.draw(t["loose"], t["inertia"])),
    ("tool-methods", "A tool that turns: speed against accuracy (C7)",
     "As above, for the force of a virtual coupling from the hand to where a tool ends, beside its nearest free pose: points among "
     "voxels and in a field of distances, corners as penalties against a coupling, steps as long as a distance allows, and planes that prove "
     "each step. A bar of 1 mm passes points and corners; points as coarse as the clearance do not let a peg in.",
     ["tool-methods"], lambda t: speed_accuracy.draw(t["tool-methods"], "an update")),
    ("mechanism-methods", "A needle in a wall and an organ: speed against accuracy",
     "As above, for a needle that a hand sways from side to side, held against turns by a soft, a usual and a stiff spring: all constraints as "
     "one problem, each spot as if there were no other, one spot after the other with the force of the last tick, one linear model of the "
     "start, and a force that is held for the period of a screen.",
     ["mechanism-methods"], lambda t: speed_accuracy.draw(t["mechanism-methods"])),
    ("bodies-meet", "A mesh that presses what gives way: speed against accuracy",
     "As above, for a mesh ball that is pressed into a pad, drawn across it and lifted, at 5 and at 40 mm/s: the exact ball and contacts "
     "that are found 25 times a second, beside contacts of the whole body in every tick, a force that is held from one computation to the "
     "next, contacts and compliance of the first touch for all times, and a mattress of springs.",
     ["bodies-meet"], lambda t: speed_accuracy.draw(t["bodies-meet"])),
    ("tool-between", "A tool between two updates",
     "Left: what holds a cube back that slides without friction: a coupling to where it was drags, the contacts do not (1e-3 N and less at the "
     "edge; dashed: 0.5 N). Middle: the largest step when a face is met, and the largest error beside an update in every tick. Right: how "
     "stiff a spring may hold a turn; wide dashed lines are exact eigenvalues.",
     ["tool-drag", "turning-stability"], lambda t: tools.draw_between(t["tool-drag"], t["turning-stability"])),
    ("arms", "A serial and a parallel arm of the same links and motors",
     "Two links of 150 mm in a row and a five-bar of 150 mm links, with motors of 10 N m (triangles) and, for the stiffness, springs of "
     "10 N m/rad in the joints: light is good. Coloured is where the condition of the Jacobian is below 5. The serial arm has more room and "
     "carries its second motor; the five-bar is lighter and, at a place, more even between directions. From place to place its stiffness "
     "and force differ more.",
     ["arms"], lambda t: arms.draw(t["arms"])),
]


def save(figure, folder, name):
    figure.savefig(folder / f"{name}.png", dpi=110, bbox_inches="tight")
    figure.savefig(folder / f"{name}.svg", metadata={"Date": None}, bbox_inches="tight")
    pyplot.close(figure)


def draw(tables, folder):
    charts, missing = [], []
    for name, title, caption, needs, make in CHARTS:
        absent = [experiment for experiment in needs if all(row.value is None for row in tables.get(experiment, []))]
        if absent:
            missing.append((title, "the run measured nothing of " + ", ".join(absent)))
            continue
        try:
            figure = make(tables)
        except KeyError as error:
            raise Problem(f"{' or '.join(needs)}.csv has a case without {error}: run the lab again") from None
        save(figure, folder, name)
        charts.append((name, title, caption))
        print(f"charts: {folder / name}.png", flush=True)
    (folder / "index.html").write_text(page(tables, charts, missing), encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path, help="with the CSVs of palpate-lab run")
    parser.add_argument("--out", type=pathlib.Path, help="where the charts go (default: the same folder)")
    arguments = parser.parse_args()
    out = arguments.out or arguments.folder
    try:
        tables = read_folder(arguments.folder)
        try:
            out.mkdir(parents=True, exist_ok=True)
            draw(tables, out)
        except OSError as error:
            raise Problem(f"{out} cannot be written: {error.strerror or error}") from None
    except Problem as problem:
        print(f"charts.py: {problem}", file=sys.stderr)
        return 2
    print(f"charts: {out / 'index.html'}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
