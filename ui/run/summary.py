# SPDX-License-Identifier: GPL-3.0-or-later
"""Results of a run: summary.json for programs, summary.txt for people. Names contain the units."""

import json
import math
import os
import time

#: Rounding of a few additions of numbers as large as coordinates, times the stiffness; far below any hand's threshold.
LARGEST_RESIDUAL_N = 1e-9


class WallClock:
    """Seconds since it was made, by a clock of its own: an independent check of the servo's counting."""

    def __init__(self):
        self.start = time.monotonic()

    def seconds(self):
        return time.monotonic() - self.start


def of(session, wanted_s, clock):
    """The session's numbers now."""
    return {
        "ticks": session.GetTicks(),
        "missed_periods": session.GetMissed(),
        "periods": session.GetPeriods(),
        "capped_ticks": session.GetCappedTicks(),
        "rate_Hz": session.GetRate(),
        "lateness_p50_us": session.GetLatenessP50(),
        "lateness_p99_us": session.GetLatenessP99(),
        "cost_p50_us": session.GetCostP50(),
        "cost_p99_us": session.GetCostP99(),
        "cost_p999_us": session.GetCostP999(),
        "force_residual_N": session.GetForceResidual(),
        "peak_force_N": session.GetPeakForce(),
        "peak_stabiliser_N": session.GetPeakStabiliserForce(),
        "stiffness_N_per_m": session.GetStiffnessUsed(),
        "stiffness_limited": session.GetStiffnessLimited(),
        "stability": session.GetStabilityText(),
        "delivered_J": session.GetDeliveredEnergy(),
        "peak_excess_J": session.GetPeakExcessEnergy(),
        "contact_s": session.GetContactSeconds(),
        "wanted_contact_s": wanted_s,
        "wall_clock_s": clock.seconds(),
        "fault": session.GetFaultText(),
        "scheduling": session.GetSchedulingReport(),
        "scene": session.GetSceneReport(),
    }


def failures(numbers):
    """One sentence for each thing that did not hold."""
    wrong = []
    if numbers["contact_s"] < numbers["wanted_contact_s"]:
        wrong.append(f"contact lasted {numbers['contact_s']:.1f} s of {numbers['wanted_contact_s']:.0f} s")
    if numbers["ticks"] + numbers["missed_periods"] != numbers["periods"]:
        wrong.append("ticks and missed periods do not add up to the periods elapsed")
    if numbers["fault"]:
        wrong.append(f"fault: {numbers['fault']}")
    if not numbers["force_residual_N"] <= LARGEST_RESIDUAL_N:
        wrong.append(f"the force is not the spring's and the stabiliser's: off by up to {numbers['force_residual_N']:.3g} N")
    if not (math.isfinite(numbers["peak_force_N"]) and numbers["peak_force_N"] > 0.0):
        wrong.append("no force was felt")
    return wrong


def stiffness(numbers):
    limited = "limited, " if numbers["stiffness_limited"] else ""
    return f"{numbers['stiffness_N_per_m']:.0f} N/m, {limited}this device can hold {numbers['stability']}"


def text(numbers):
    rows = [
        ("contact", f"{numbers['contact_s']:.1f} s of {numbers['wall_clock_s']:.1f} s"),
        ("rate", f"{numbers['rate_Hz']:.0f} Hz"),
        ("ticks + missed = periods", f"{numbers['ticks']} + {numbers['missed_periods']} = {numbers['periods']}"),
        ("lateness p50 / p99", f"{numbers['lateness_p50_us']:.1f} / {numbers['lateness_p99_us']:.1f} us"),
        ("cost of a tick p50 / p99 / p99.9", " / ".join(f"{numbers[f'cost_p{p}_us']:.1f}" for p in (50, 99, 999)) + " us"),
        ("ticks at a work limit", f"{numbers['capped_ticks']}"),
        ("largest |F - S - K (p - x)|", f"{numbers['force_residual_N']:.2g} N"),
        ("peak force", f"{numbers['peak_force_N']:.2f} N"),
        ("stabiliser S, peak", f"{numbers['peak_stabiliser_N']:.3f} N"),
        ("stiffness K", stiffness(numbers)),
        ("energy given / in excess", f"{1e3 * numbers['delivered_J']:.2f} / {1e3 * numbers['peak_excess_J']:.3f} mJ"),
        ("servo thread", numbers["scheduling"].strip()),
        ("scene", numbers["scene"].strip()),
    ]
    lines = [f"{name + ':':<29}{value}" for name, value in rows]
    return "\n".join(lines + [f"{'FAILED:':<29}{reason}" for reason in failures(numbers)]) + "\n"


def write(folder, numbers):
    complete = dict(numbers, failures=failures(numbers), passed=not failures(numbers))
    with open(os.path.join(folder, "summary.txt"), "w", encoding="utf-8") as file:
        file.write(text(numbers))
    with open(os.path.join(folder, "summary.json"), "w", encoding="utf-8") as file:
        json.dump(complete, file, indent=2)
        file.write("\n")
