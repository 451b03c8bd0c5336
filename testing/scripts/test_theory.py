# SPDX-License-Identifier: GPL-3.0-or-later
"""The tables of docs/theory.md that have a formula, computed anew, and citations of the page have targets."""

import itertools
import math
import os
import re
import sys
import unittest
from pathlib import Path

import numpy as np

ROOT = Path(os.environ.get("PALPATE_SOURCE_DIR") or Path(__file__).resolve().parents[2])
sys.path.insert(0, str(ROOT / "testing/oracles/axisymmetric"))
import cylinder  # noqa: E402

PAGE = (ROOT / "docs/theory.md").read_text(encoding="utf-8")
TICK_S = 1e-3


def section(heading):
    return re.search(rf"^## {re.escape(heading)}\n(.*?)(?=^## |\Z)", PAGE, re.DOTALL | re.MULTILINE).group(1)


def tables(heading):
    """Of a section, each as rows of texts, the head first."""
    found = re.findall(r"(?:^\|.*\|\n)+", section(heading), re.MULTILINE)
    return [[[cell.strip() for cell in row.strip("|").split("|")] for row in table.splitlines() if not row.startswith("|---")]
            for table in found]


def numbers(rows):
    return [[float(cell) for cell in row] for row in rows[1:]]


def vector(text):
    return np.array([float(number) for number in text.split(",")])


def critical(radius_of):
    """The stiffness at which the largest eigenvalue leaves the unit circle."""
    low, high = 1e-3, 1e7
    for _ in range(200):
        middle = math.sqrt(low * high)
        low, high = (middle, high) if radius_of(middle) <= 1 + 1e-12 else (low, middle)
    return low


def held(m, b, step_s):
    """Decay of place and speed, and the effect of a held force on both, of a mass with damping: its exact motion."""
    fall = math.exp(-b * step_s / m)
    glide_s = m / b * (1 - fall)
    return np.array([[1, glide_s], [0, fall]]), np.array([(step_s - glide_s) / b, (1 - fall) / b])


def wall_radius(K, m, b, B, delay, step_s=TICK_S):
    """Of the device's state and the places that the controller remembers."""
    motion, push = held(m, b, step_s)
    size = 3 + delay
    step = np.zeros((size + 1, size + 1))
    step[:2, :2] = motion
    place = lambda ticks: 0 if ticks == 0 else 1 + ticks  # noqa: E731 of the state, so many ticks ago
    step[:2, place(delay)] -= push * (K + B / step_s)
    step[:2, place(delay + 1)] += push * B / step_s
    step[2, 0] = 1
    for i in range(3, size + 1):
        step[i, i - 1] = 1
    return np.abs(np.linalg.eigvals(step)).max()


def gauss(count, length):
    """Points and weights on (0, length)."""
    points, weights = np.polynomial.legendre.leggauss(count)
    return length / 2 * (points + 1), length / 2 * weights


def lack_of_wave(w, nu):
    """1 less how much a bonded layer gives to a wave of pressure, in terms of a half space."""
    k = 3 - 4 * nu
    return 1 - (2 * k * np.sinh(2 * w) - 4 * w) / (2 * k * np.cosh(2 * w) + 4 * w**2 + 1 + k**2)


def ball_on_layer(young, nu, thickness, ball, contact):
    """Depth and force of a sphere whose contact has this radius."""
    x, weights = gauss(40 + int(5 * contact / thickness), contact)
    waves, wave_weights = gauss(400 + int(60 * contact / thickness), 25)
    kernel = lambda y: np.cos(np.multiply.outer(y, waves)) @ (wave_weights * lack_of_wave(waves, nu))  # noqa: E731
    both = lambda at: kernel((at + x) / thickness) + kernel((at - x) / thickness)  # noqa: E731
    own = lambda at: np.stack([2 / np.pi + 0 * at, -at / np.pi * np.log((ball + at) / (ball - at))], -1)  # noqa: E731
    coupled = weights / (np.pi * thickness) * both(x[:, None])
    found = np.linalg.solve(np.eye(len(x)) - coupled, own(x))  # of a depth of 1, and of the sphere
    end = own(np.array(contact)) + weights / (np.pi * thickness) * both(contact) @ found
    depth = -end[1] / end[0]
    return depth, np.pi * young / (1 - nu**2) * (weights @ found @ [depth, 1])


class Theory(unittest.TestCase):
    def test_a_sampled_wall(self):
        for m, b, B, delay, exact, formula in numbers(tables("A sampled wall")[0]):
            with self.subTest(m=m, b=b, B=B, delay=delay):
                self.assertAlmostEqual(critical(lambda K: wall_radius(K, m, b, B, int(delay))), exact, delta=0.06)
                self.assertAlmostEqual((b + B) / (TICK_S / 2 + delay * TICK_S), formula, delta=0.05)
        held_force = section("Contacts that share what gives way")
        for rate_Hz, said in ((100, "203"), (20, "43.6")):
            self.assertIn(f"{said} N/m at {rate_Hz} Hz", held_force)
            self.assertAlmostEqual(critical(lambda K: wall_radius(K, 0.1, 1, 0, 0, 1 / rate_Hz)), float(said), delta=0.4)

    def test_points_and_balls(self):
        root3, floor = math.sqrt(3), (0, 0, 1)
        scenes = [[floor], [floor, (1, 0, 0)], [floor, (1, 0, 0), (0, 1, 0)], [floor, (1, 0, -root3)], [floor, (1, 0, root3)]]
        rows = tables("Contact of a point and of a ball")[0][1:]
        self.assertEqual(len(rows), len(scenes))
        for planes, (name, device, proxy, force) in zip(scenes, rows):
            normals = [np.array(n) / np.linalg.norm(n) for n in planes]
            found = [place for place in self.feet(normals, vector(device)) if all(n @ place >= -1e-12 for n in normals)]
            nearest = min(found, key=lambda place: np.linalg.norm(place - vector(device)))
            np.testing.assert_allclose(nearest, vector(proxy), atol=1e-12, err_msg=name)
            self.assertAlmostEqual(np.linalg.norm(nearest - vector(device)), float(force), delta=1e-9)

    @staticmethod
    def feet(normals, place):
        """Of a place on the intersections of the planes."""
        yield place
        for count in (1, 2, 3):
            for some in itertools.combinations(normals, count):
                yield place - np.linalg.pinv(np.array(some)) @ (np.array(some) @ place)

    def test_a_tool_that_tips(self):
        h, K_t, K_r = 0.02, 1000.0, 2.0
        for depth_mm, hand_deg, turn_deg, height_mm in numbers(tables("A rigid tool that turns")[0]):
            turns = np.radians(np.linspace(0, hand_deg, 2_000_001))
            heights = h * (np.cos(turns) + np.sin(turns))  # of the middle of a cube that stands on an edge
            least = np.argmin(K_t * (heights - h + 1e-3 * depth_mm)**2 + K_r * (turns - math.radians(hand_deg))**2)
            self.assertAlmostEqual(math.degrees(turns[least]), turn_deg, delta=3e-5)
            self.assertAlmostEqual(1e3 * heights[least], height_mm, delta=2e-5)

    def test_a_bar_that_is_pulled(self):
        nu = 0.4
        lam, mu = nu / (1 + nu) / (1 - 2 * nu), 0.5 / (1 + nu)
        for stretch, hooke, green, neo in numbers(tables("Elements that bend")[1]):
            low, high = 0.5, 2.0  # the side's stretch, at which the side bears nothing
            for _ in range(100):
                side = (low + high) / 2
                low, high = (low, side) if mu * (side - 1 / side) + lam * math.log(stretch * side**2) / side > 0 else (side, high)
            self.assertAlmostEqual(mu * (stretch - 1 / stretch) + lam * math.log(stretch * side**2) / stretch, neo, delta=6e-7)
            self.assertAlmostEqual((stretch**3 - stretch) / 2, green, delta=6e-7)
            self.assertAlmostEqual(stretch - 1, hooke, delta=1e-12)

    def test_a_cantilever_and_a_layer(self):
        length, side, young, nu = 0.1, 0.02, 1e6, 0.3
        tip = length**3 / (3 * young * side**4 / 12) + length / (5 / 6 * young / 2 / (1 + nu) * side**2)
        self.assertIn(f"{1e3 * tip:.3f} mm", section("Elements that bend"))
        for R, h, d, nu, factor in numbers(tables("A patch, and Hertz below it")[1]):
            a = -(1.2876 - 1.4678 * nu + 1.3442 * nu**2) / (1 - nu)
            b = (0.6387 - 1.0277 * nu + 1.5164 * nu**2) / (1 - nu)
            x = math.sqrt(R * d) / h / math.pi
            series = 1 - 2 * a * x + 4 * a**2 * x**2 - 8 * (a**3 + 4 * math.pi**2 * b / 15) * x**3 \
                + 16 * a * (a**3 + 3 * math.pi**2 * b / 5) * x**4
            self.assertAlmostEqual(series, factor, delta=5e-5)

    def test_balls_on_layers(self):
        _, _, layers, sides = tables("A patch, and Hertz below it")
        for R, h, d, nu, a, force_N in numbers(layers):
            depth, found = ball_on_layer(20e-3, nu, h, R, a)  # N/mm^2
            self.assertAlmostEqual(depth / d, 1, delta=2e-3)  # a has four digits, depth goes as its square
            # From the depth of the rounded radius to that of the table, by the slope that force over depth has: between
            # that of a half space, 3 / 2, and that of a thin layer, 2.
            self.assertAlmostEqual(found * (d / depth)**1.75 / force_N, 1, delta=3e-3)
        for radius_mm, force_N in zip(sides[0][1:], sides[1][1:]):
            found = cylinder.force(20e3, 0.4, 0.05, 1e-3 * float(radius_mm), 0.02, 0.003, 0.0012)
            self.assertAlmostEqual(found, float(force_N), delta=6e-5)
        self.assertAlmostEqual(float(sides[1][1]) / float(layers[1][5]), 1, delta=2e-3)  # far out they are one
        self.assertAlmostEqual(cylinder.force(20e3, 0.4, 0.005, 0.05, 0.01, 0.001, 0.0006) / float(layers[4][5]), 1, delta=3e-3)

    def test_what_is_below_a_patch(self):
        s, weights = gauss(4000, 400)
        angles = np.pi * (np.arange(800) + 0.5) / 800
        bessel2 = np.cos(2 * angles - np.multiply.outer(s, np.sin(angles))).mean(axis=1)
        half_space = weights @ (8 * bessel2 / s**2)**2 / np.pi
        self.assertAlmostEqual(half_space, 2048 / 315 / math.pi**2, delta=1e-8)
        # With R = E* = a = 1: W = c / a, G = a^2 / 6.
        force, depth = 2 * (1 / 3) / half_space, 2 / 3 / half_space * half_space + 1 / 6
        self.assertIn(f"F is {force / (4 / 3 * depth**1.5):.4f} of Hertz's", section("A patch, and Hertz below it"))
        for nu in (0.0, 0.3, 0.49):
            shear = 1 / 2 / (1 + nu)  # of E = 1
            along, into = (2 - nu) / (8 * shear), (1 - nu**2) / 2
            self.assertAlmostEqual(along / into, (2 - nu) / (2 * (1 - nu)), delta=1e-12)

    def test_contacts_that_share(self):
        np.testing.assert_allclose(np.linalg.solve([[1, .6], [.6, 1]], [1, 1]), [.625, .625])
        w, force = np.array([[1, .9, .8], [.9, 1, .9], [.8, .9, 1]]), np.array([5 / 9, 0, 5 / 9])
        np.testing.assert_allclose(w @ force - [1, .5, 1], [0, .5, 0], atol=1e-12)  # the middle one is open by .5

    def test_a_lever_and_a_stroke(self):
        y, rows, spots = 5e-3, np.array([[1, 0.05], [1, 0.15]]), np.diag([500.0, 200.0])
        lever = tables("Constraints between bodies")[1]
        for turning, row in ((2.0, lever[1]), (0.0, lever[2])):
            pose = np.linalg.solve(np.diag([1000.0, turning]) + rows.T @ spots @ rows, [1000 * y, 0])  # of least energy
            force = -spots @ rows @ pose
            np.testing.assert_allclose([*force, force.sum()], [float(cell) for cell in row[1:]], atol=6e-7)
        strength, friction, c, s = 1.5, 0.4, 1 / 1000 + 1 / 500, 0.02
        work = strength**2 * c / 2 + friction * (s - strength * c) + friction * (s - 2 * friction * c)
        for said in (f"{1e3 * strength * c:.1f} mm", f"{2e3 * friction * c:.1f} mm", f"{1e3 * work:.3f} mJ"):
            self.assertIn(said, section("Constraints between bodies"))

    def test_an_object_that_is_driven_at_a_low_rate(self):
        mass, stiffness, damping = 5e-3, 3000.0, 0.5
        rates, limits = tables("Objects that move, touched")[0]
        for rate_Hz, said in zip(map(float, rates[1:]), map(float, limits[1:])):
            h = 1 / rate_Hz
            motion, push = held(0.1, 1.0, h)

            def radius(K):
                step = np.zeros((4, 4))  # place and speed of the device, of the object
                step[:2, :2] = motion
                step[:2, 0] -= K * push
                step[:2, 2] += K * push
                speed = np.array([h * K, 0, -h * stiffness - h * K, mass]) / (mass + h * damping + h * h * stiffness)
                step[3], step[2] = speed, np.array([0, 0, 1, 0]) + h * speed
                return np.abs(np.linalg.eigvals(step)).max()

            self.assertAlmostEqual(critical(radius), said, delta=0.006 * said)

    def test_a_mass_that_is_struck(self):
        phases, table = 20, tables("Objects that move, touched")[1]
        for rate_Hz, most_N, leaves in zip(*([float(cell) for cell in row[1:]] for row in table)):
            period = round(1 / rate_Hz / TICK_S)
            found = [self.struck(period, -period * TICK_S * phase / phases) for phase in range(phases)]
            np.testing.assert_allclose(np.mean(found, axis=0), [most_N, leaves], atol=6e-4)

    @staticmethod
    def struck(period, first_s, mass=0.1, speed=0.1, K=1000.0):
        """Most force on a free mass, which knows its motion by one snapshot a period, and the speed it leaves with."""
        h = period * TICK_S
        compliance = h * h / mass
        x = v = most_N = 0.0
        for begin in range(0, 300, period):
            forces = [max(0.0, speed * (first_s + TICK_S * (begin + tick)) - x - h * v) / (1 / K + compliance)
                      for tick in range(min(period, 300 - begin))]
            most_N = max([most_N, *forces])
            if len(forces) == period:
                v += h * np.mean(forces) / mass
                x += h * v
        return most_N, v

    def test_single_numbers(self):
        self.assertIn(f"{math.ceil(math.log(1e-6) / math.log(math.cos(math.radians(5)))):,} projections", PAGE)
        self.assertIn(f"{31250 // 10} bytes", PAGE)
        self.assertIn(f"{3125 // 12} forces of 12 bytes, or {3125 // 24} times four walls", PAGE)


class Citations(unittest.TestCase):
    """Truths stand in the tree: on this page, or in a row of the bar."""

    def test_what_is_cited_is_a_heading_of_the_page_or_a_row_of_the_bar(self):
        headings = set(re.findall(r"^## (.*)$", PAGE, re.MULTILINE))
        bar = (ROOT / "testing/BAR.md").read_text(encoding="utf-8")
        rows = {int(number) for cell in re.findall(r"^\| ([\d, ]+) \|", bar, re.MULTILINE) for number in cell.split(",")}
        cited = 0
        for folder in ("haptics", "devices", "filters", "ui", "plugin", "testing", "docs"):
            for file in (ROOT / folder).rglob("*"):
                if file.suffix not in (".h", ".cpp", ".cxx", ".py", ".md") or file == Path(__file__).resolve():
                    continue
                text = re.sub(r"\s*\n\s*(?://+|#|\*)?\s*", " ", file.read_text(encoding="utf-8"))
                for heading in re.findall(r'docs/theory\.md, "([^"]*)"', text):
                    self.assertIn(heading, headings, file)
                    cited += 1
                self.assertIsNone(re.search(r"\bTHEORY\b|\b(?:COMPLIANCE|FIELDS|TOOL)\.md", text), file)
                for number in re.findall(r"\b[Rr]ows? (\d+)(?: of the bar| \w+ the bar)", text):
                    self.assertIn(int(number), rows, file)
        self.assertGreater(cited, 8)


if __name__ == "__main__":
    unittest.main(verbosity=2)
