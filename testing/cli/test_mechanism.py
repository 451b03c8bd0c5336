# SPDX-License-Identifier: GPL-3.0-or-later
"""`palpate check` and `palpate touch` with a scene file of bodies and constraints; each expected value from statics by hand."""

import json
import math
import os
import re
import shutil
import unittest
from pathlib import Path

from palpate_cli import CommandLineTest

SCENES = Path(os.environ["PALPATE_SOURCE_DIR"]) / "data" / "mechanisms"
UPRIGHT = (1.0, 0.0, 0.0, 0.0)
POSES = "t,x,y,z,qw,qx,qy,qz"
MOST_STEP = 0.2  # N a tick that a constraint's change reaches the hand with


class Mechanism(CommandLineTest):
    def scene(self, name):
        shutil.copy(SCENES / name, self.folder)
        return name

    def touch(self, scene, poses, *options):
        self.write_path([(n / 1000, *pose, *UPRIGHT) for n, pose in enumerate(poses)], header=POSES)
        run = self.succeed("touch", scene, "--path", "path.csv", "--csv", "out.csv", *options)
        return self.read_rows(), run.stderr

    def test_a_lever_on_two_springs_is_pulled_as_the_balance_of_forces_and_moments_says(self):
        """A rigid rod, K_c 1000 N/m and 2 N m/rad at the hand, 500 N/m at 0.05 m and 200 N/m at 0.15 m."""
        held, turn, springs, aside = 1000.0, 2.0, ((0.05, 500.0), (0.15, 200.0)), 0.005
        # Balance of the rod: x sideways, a turn about y that carries a point at z by a z.
        k11 = held + sum(k for _, k in springs)
        k12 = sum(k * z for z, k in springs)
        k22 = turn + sum(k * z * z for z, k in springs)
        determinant = k11 * k22 - k12 * k12
        x = a = 0.0
        for _ in range(20):  # the balance of the finite turn, led there by that of a small one
            yields = [(k * (x + z * math.sin(a)), z * math.cos(a)) for z, k in springs]
            force = held * (aside - x) - sum(f for f, _ in yields)
            moment = -turn * a - sum(f * arm for f, arm in yields)
            x, a = x + (k22 * force - k12 * moment) / determinant, a + (k11 * moment - k12 * force) / determinant
        rows, _ = self.touch(self.scene("lever.json"), [(aside, 0, 0)] * 200, "--stiffness", held, "--torque-stiffness", turn)
        last = rows[-1]
        for name, (z, k) in zip(("wall", "organ"), springs):
            self.assertAlmostEqual(last[f"{name}_fx"], -k * (x + z * math.sin(a)), delta=1e-6)
        self.assertAlmostEqual(last["force_x"], held * (x - aside), delta=1e-6)
        self.assertAlmostEqual(last["torque_y"], turn * a, delta=1e-6)
        self.assertAlmostEqual(last["proxy_x"], x, delta=1e-9)
        self.assertAlmostEqual(2 * math.asin(last["proxy_qy"]), a, delta=1e-6)

    def test_a_hand_that_does_not_turn_the_rod_feels_the_balance_of_moments(self):
        """No moment about the hand: 500 f .05 and 200 f .15 cancel; the three springs are in series, 148.148 N/m."""
        aside = 0.005
        rows, _ = self.touch(self.scene("lever.json"), [(aside, 0, 0)] * 200, "--stiffness", 1000)
        last = rows[-1]
        # Rod x + a z: 500 (x + .05 a) .05 + 200 (x + .15 a) .15 = 0, and 1000 (x - aside) = -500 (..) - 200 (..).
        a_of_x = -(500 * 0.05 + 200 * 0.15) / (500 * 0.05**2 + 200 * 0.15**2)
        felt = 500 * (1 + 0.05 * a_of_x) + 200 * (1 + 0.15 * a_of_x)
        series = 1 / (1 / 1000 + 1 / felt)
        self.assertAlmostEqual(series, 148.148, places=3)
        self.assertAlmostEqual(last["force_x"], -series * aside, delta=1e-6)
        for axis in "xyz":
            self.assertAlmostEqual(last[f"torque_{axis}"], 0.0, delta=1e-12)

    def test_a_needle_pierces_at_its_strength_and_then_drags_by_its_friction(self):
        strength, friction, tip = 1.5, 0.4, 150
        ways = [(0, 0, -8 - tip - 1 + 0.02 * i) for i in range(1500)]
        rows, said = self.touch(self.scene("needle.json"), ways, "--stiffness", 1000, "--scale", 1000,
                                "--torque-stiffness", 5, "--low-rate", 100)
        force = [row["skin_fz"] for row in rows]
        pierced = next(i for i, row in enumerate(rows) if row["skin_phase"] == 3)
        self.assertTrue(all(f == 0.0 for f in force[:50]), "a millimetre before the wall")
        step = 1000 * 0.02 / 1000  # largest rise of the force in a tick
        self.assertAlmostEqual(max(-f for f in force[:pierced]), strength, delta=step)
        self.assertLessEqual(max(-f for f in force), strength + step)
        self.assertAlmostEqual(-force[pierced + 200], friction, delta=1e-6)
        self.assertIn("skin punctured at ", said)
        steps = [abs(b["force_z"] - a["force_z"]) for a, b in zip(rows, rows[1:])]
        self.assertLessEqual(max(steps), MOST_STEP + step, "what pierces is spread")

    def test_a_needle_in_a_wall_that_no_law_of_it_holds_is_said_once_as_it_comes_there(self):
        scene = json.loads((SCENES / "needle.json").read_text())
        wall, tip = -8, 150
        ways = [(0, 0, wall - tip - 1 + 0.05 * i) for i in range(60)]  # 1 mm before the wall, to 2 mm in it
        options = ("--stiffness", 1000, "--scale", 1000, "--torque-stiffness", 5, "--low-rate", 100)
        _, said = self.touch(self.scene("needle.json"), ways, *options)
        self.assertNotIn("overlap", said)
        scene["laws"] = [law for law in scene["laws"] if law["name"] != "skin"]
        self.write("open.json", json.dumps(scene))
        _, said = self.touch("open.json", ways, *options)
        lines = [line for line in said.splitlines() if "overlap" in line]
        self.assertEqual(len(lines), 1, said)
        self.assertIn('s: bodies "needle" and "wall" overlap: no active constraint joins them', lines[0])
        self.assertAlmostEqual(float(lines[0].split()[1]), 1 / 0.05 * 1e-3, delta=2e-3)

    def test_a_needle_dents_a_body_by_its_own_width_and_not_by_the_edges_of_the_mesh(self):
        """A block of 80 x 80 x 40 mm, 20 kPa, Poisson's ratio .4, fixed below; the needle is 1.2 mm wide."""
        young, poisson, radius, held, deep = 20e3, 0.4, 0.6e-3, 1000.0, 3e-3
        # The mean under a paraboloid of pressure on a half space is .65875 of (1 - nu^2) / (E r).
        on_half_space = 0.65875 * (1 - poisson**2) / (young * radius)
        face, tip = 18, 150
        ways = [(0, 0, face - tip + z) for z in (-1, -0.5, 1e3 * deep)]
        yields = {}
        for edge in (20, 13.4, 10, 8):
            scene = json.loads((SCENES / "needle.json").read_text())
            scene["bodies"] = [body for body in scene["bodies"] if body["name"] != "wall"]
            scene["laws"] = [law for law in scene["laws"] if law["b"] == "liver"]
            del scene["bodies"][1]["tip_diameter"]  # as wide as the needle
            scene["bodies"][1].update(edge=edge)
            self.write("edge.json", json.dumps(scene))
            rows, _ = self.touch("edge.json", ways, "--stiffness", held, "--scale", 1000, "--torque-stiffness", 5, "--low-rate", 0)
            yields[edge] = deep / -rows[-1]["force_z"] - 1 / held
            self.assertAlmostEqual(yields[edge] / on_half_space, 1, delta=0.1)  # its depth takes some
        for edge, given in yields.items():
            self.assertAlmostEqual(given / yields[8], 1, delta=0.02, msg=f"edges of {edge} mm: {yields}")
        scene["bodies"][1].update(tip_diameter=2.4)
        self.write("wide.json", json.dumps(scene))
        rows, _ = self.touch("wide.json", ways, "--stiffness", held, "--scale", 1000, "--torque-stiffness", 5, "--low-rate", 0)
        self.assertAlmostEqual((deep / -rows[-1]["force_z"] - 1 / held) / (0.5 * on_half_space), 1, delta=0.1)

    def test_what_a_mechanism_becomes_is_told_to_people_and_programs(self):
        for name, least in (("lever.json", 2), ("drawer.json", 8), ("hinge.json", 8), ("suture.json", 3), ("needle.json", 2)):
            told = json.loads(self.succeed("check", self.scene(name), "--json").stdout)
            self.assertTrue(told["touchable"], name)
            self.assertGreaterEqual(told["rows"], least, name)
            self.assertLessEqual(told["rank"], told["rows"], name)
            self.assertIn("it can be felt", self.succeed("check", name).stdout)

    def test_a_check_judges_the_hand_that_touches_and_not_a_stiffer_one(self):
        """A rod that the hand does not turn has three degrees of freedom to turn; a needle's tip then slips; three points with
        friction share nothing."""
        scene = json.loads((SCENES / "needle.json").read_text())
        for law in scene["laws"]:
            law["friction"] = 0
        self.write("smooth.json", json.dumps(scene))
        free = json.loads(self.succeed("check", "smooth.json", "--json").stdout)
        held = json.loads(self.succeed("check", "smooth.json", "--json", "--torque-stiffness", 0.5).stdout)
        self.assertEqual((free["free_turns"], held["free_turns"]), (3, 0))
        self.assertTrue(any("slips sideways" in remark for remark in free["remarks"]), free)
        self.assertFalse(any("slips sideways" in remark for remark in held["remarks"]), held)
        scene["bodies"] = [body for body in scene["bodies"] if body["kind"] == "held"] + [{"name": "ground", "kind": "world"}]
        scene["laws"] = [{"name": f"rubs {z}", "kind": "friction", "a": "needle", "b": "ground", "point_a": [0, 0, z],
                          "point_b": [0, 0, z], "friction": 0.3} for z in (0, 75, 150)]
        self.write("rubs.json", json.dumps(scene))
        self.write_path([(0, 0, 0, 0)])
        touch = ("--path", "path.csv", "--csv", "out.csv")
        for command in (("check", "rubs.json"), ("touch", "rubs.json", *touch)):
            self.refused(*command, saying=("friction", "share of the friction is undetermined"))
            self.succeed(*command, "--torque-stiffness", 0.5)
        self.refused("check", "smooth.json", "--torque-stiffness", -1, saying=("--torque-stiffness",))
        self.write("square.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        self.refused("check", "square.obj", "--torque-stiffness", 1, saying=("--torque-stiffness", "mechanism"))

    def test_a_file_in_capitals_is_read_and_one_that_is_a_list_is_refused_by_its_name(self):
        shutil.copy(SCENES / "lever.json", self.folder / "LEVER.JSON")
        self.assertIn("LEVER.JSON: it can be felt", self.succeed("check", "LEVER.JSON").stdout)
        self.write("list.json", "[]")
        self.refused("check", "list.json", saying=("list.json: must be an object",))

    def test_a_drawer_goes_along_its_rails_by_the_friction_of_its_felt_and_stops_where_its_stops_are(self):
        friction, stop, most, arm = 0.6, 800, 0.060, 0.020  # N, N/m, m, from the hand to the drawer
        ways = [(0.1 * i, 0, 0) for i in range(1000)]
        rows, _ = self.touch(self.scene("drawer.json"), ways, "--stiffness", 1000, "--scale", 1000, "--torque-stiffness", 5)
        self.assertAlmostEqual(rows[400]["force_x"], -friction, delta=1e-3)
        self.assertAlmostEqual(rows[400]["proxy_y"], 0.0, delta=1e-6)
        last = rows[-1]
        drawer = last["proxy_x"] / 1000 + arm * 2 * last["proxy_qy"] * last["proxy_qw"]  # the handle leans
        self.assertGreater(drawer, most)
        self.assertAlmostEqual(last["felt_fx"], -friction, delta=1e-6)
        self.assertAlmostEqual(last["stops_fx"], -stop * (drawer - most), delta=1e-3 * -last["stops_fx"])
        self.assertAlmostEqual(last["force_x"], last["felt_fx"] + last["stops_fx"], delta=1e-6)

    def spatula(self, change=lambda scene: None, file="spatula.json"):
        for mesh in ("spatula.obj", "rib.obj"):
            shutil.copy(SCENES / mesh, self.folder)
        scene = json.loads((SCENES / file).read_text())
        change(scene)
        self.write("scene.json", json.dumps(scene))
        return "scene.json"

    def test_a_spatula_presses_a_liver_where_they_meet_and_rubs_it_by_its_friction(self):
        gap, deep, friction = 1.0, 4.0, 0.3  # mm from the blade to the liver
        down = [(0, -0.01 * i, 0) for i in range(int(100 * (gap + deep)))]
        aside = [(0.02 * i, -gap - deep, 0) for i in range(600)]
        options = ("--stiffness", 5000, "--scale", 1000, "--torque-stiffness", 20)
        rows, said = self.touch(self.spatula(), down + aside, *options)
        before = [row for row in rows[: int(100 * gap)]]
        self.assertTrue(all(row["force_y"] == 0 and row["contacts"] == 0 for row in before), "nothing is met yet")
        pressed = rows[len(down) - 1]
        self.assertGreater(pressed["force_y"], 0.5)
        self.assertGreaterEqual(pressed["contacts"], 4)
        self.assertLess(abs(pressed["force_x"]), 0.02 * pressed["force_y"])
        last = rows[-1]  # 12 mm aside, it slips
        self.assertAlmostEqual(-last["force_x"] / last["force_y"], friction, delta=0.02)
        beyond = re.search(r"in (\d+) ticks the constraints were not satisfied within a tick's work", said)
        self.assertLess(int(beyond[1]) if beyond else 0, len(rows) / 100, "one tick of a hundred may be left to the next")
        self.assertNotIn("in one another", said)
        _, said = self.touch(self.spatula(), [(0, -gap - deep, 0)] * 3, *options)
        self.assertIn('the path begins with bodies "spatula" and "liver" in one another', said)

    def test_a_check_says_how_many_contacts_may_be_found(self):
        self.assertIn("contacts are found, at most 16 at once", self.succeed("check", self.spatula()).stdout)
        self.assertNotIn("are not found", self.succeed("check", self.spatula()).stdout)

    def test_two_soft_bodies_are_felt_apart_and_refused_in_one_another(self):
        def ground(at):
            body = {"name": "ground", "kind": "soft", "box": [80, 10, 80], "at": at, "edge": 8, "fixed": "ymin", "young_Pa": 1e5}
            return self.spatula(lambda scene: scene["bodies"].append(body))

        self.assertNotIn("are not found", self.succeed("check", ground([0, -48, 125])).stdout)
        self.refused("check", ground([0, -46, 125]), saying=("liver and ground lie in one another", "move one"))

    def test_a_liver_is_held_up_by_the_rib_that_it_is_pressed_onto(self):
        gap, close, deep = 1.0, 2.0, 6.0  # mm: spatula to liver, liver to rib, the spatula's way into the liver
        down = [(0, -0.02 * i, 0) for i in range(int(50 * (gap + deep)))]
        options = ("--stiffness", 5000, "--scale", 1000, "--torque-stiffness", 20)
        on, _ = self.touch(self.spatula(file="rib.json"), down, *options)
        off, _ = self.touch(self.spatula(lambda scene: scene["bodies"].pop(), "rib.json"), down, *options)

        def stiffness(rows, i):
            return rows[i]["force_y"] - rows[i - 20]["force_y"]

        share = [stiffness(on, i) / stiffness(off, i) for i in range(90, len(down))]
        met = next(0.02 * (90 + i) for i, now in enumerate(share) if now > 1.5 * share[0])
        self.assertGreater(met, gap + close, "the liver is pressed together before it is bent")
        self.assertLess(met, gap + 2 * close)
        self.assertGreater(on[-1]["force_y"], 1.3 * off[-1]["force_y"])

    def test_a_liver_that_is_pressed_onto_a_kidney_is_held_up_the_more_the_stiffer_that_is(self):
        gap, deep, step = 1.0, 7.0, 0.02  # mm: spatula to liver, the spatula's way into the liver, and that in a tick
        down = [(0, -step * i, 0) for i in range(int((gap + deep) / step))]
        options = ("--stiffness", 5000, "--scale", 1000, "--torque-stiffness", 20)

        def pressed(young_Pa):
            rows, said = self.touch(self.spatula(lambda scene: scene["bodies"][2].update(young_Pa=young_Pa), "tissues.json"), down, *options)
            self.assertNotIn("overlap", said)
            return [row["force_y"] for row in rows]

        softest, soft, stiff = (pressed(young_Pa) for young_Pa in (1e3, 1e4, 1e6))
        before = int(1.2 * gap / step)  # nothing bends the liver yet
        self.assertAlmostEqual(softest[before], stiff[before], delta=1e-6)
        self.assertGreater(soft[-1], softest[-1] + 0.2)
        self.assertGreater(stiff[-1], soft[-1] + 0.2)

    def test_a_liver_and_a_rib_in_one_another_are_named_by_a_check(self):
        said = self.succeed("check", self.spatula(lambda scene: scene["bodies"][1].update(at=[0, -16, 125]), "rib.json")).stdout
        self.assertIn('"liver" and "rib" overlap in the scene file: the contacts push them apart at once', said)

    def test_a_mesh_that_stands_is_met_where_its_pose_puts_it(self):
        """A cube of 20 mm, turned by 45 degrees and put 30 mm before the hand, comes with an edge towards a cube of 2 mm."""

        def cube(half):
            corners = [(x, y, z) for x in (-half, half) for y in (-half, half) for z in (-half, half)]
            quads = ((1, 2, 4, 3), (5, 7, 8, 6), (1, 5, 6, 2), (3, 4, 8, 7), (1, 3, 7, 5), (2, 6, 8, 4))
            return "".join("v {} {} {}\n".format(*at) for at in corners) + "".join("f {} {} {} {}\n".format(*f) for f in quads)

        for name, half in (("large", 10), ("small", 1)):
            self.write(f"{name}.obj", cube(half))
        eighth = math.radians(45) / 2
        self.write("scene.json", json.dumps({"format": "palpate mechanism", "version": 1, "unit_m": 0.001, "contacts": "found", "bodies": [
            {"name": "tool", "kind": "held", "file": "small.obj"},
            {"name": "block", "kind": "world", "file": "large.obj", "at": [0, 0, 30], "turn": [math.cos(eighth), 0, math.sin(eighth), 0]},
            {"name": "far", "kind": "rigid", "half_size": [1, 1, 1], "at": [0, 500, 0], "density": 1000}]}))
        rest = 2e-5 * math.sqrt(12)  # of its size a guarded mesh keeps away from one that stands
        met, stiffness = 30 - 10 * math.sqrt(2) - 1 - rest, 500
        rows, _ = self.touch("scene.json", [(0, 0, 0.02 * i) for i in range(800)], "--stiffness", stiffness, "--scale", 1000,
                             "--torque-stiffness", 2)
        for row in rows:
            pressed = stiffness * max(0.0, row["device_z"] - met) * 1e-3
            self.assertAlmostEqual(-row["force_z"], pressed, delta=1e-6, msg=row["device_z"])
        self.assertGreater(-rows[-1]["force_z"], 0.5)

    def test_a_mesh_that_cannot_be_held_is_refused_in_words(self):
        self.write_path([(0, 0, 0, 0)])
        self.write("open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")

        def held(**values):
            return lambda scene: scene["bodies"][0].update(values)

        cases = ((held(file="none.obj"), ("none.obj",)), (held(file="open.obj"), ("open.obj", "open: 3")),
                 (held(length=10, diameter=1), ("spatula", "one of the two")),
                 (lambda scene: scene.update(contacts="all"), ("contacts", '"found"')),
                 (lambda scene: scene.pop("contacts"), ("friction", '"contacts": "found"')),
                 (lambda scene: (scene.pop("contacts"), scene.pop("friction"), scene.update(laws=[])), ("spatula", "meet nothing")),
                 (lambda scene: scene.update(friction=-1), ("friction",)))
        for change, words in cases:
            scene = self.spatula(change)
            self.refused("check", scene, saying=words)
            self.refused("touch", scene, "--path", "path.csv", "--csv", "out.csv", saying=words)

    def stone(self, change=lambda scene: None):
        shutil.copy(SCENES / "stone.obj", self.folder)
        return self.spatula(change, "stone.json")

    def test_a_stone_is_pushed_over_a_table_against_its_friction(self):
        """A slow hand feels mu m g; the mass is that of the stone's volume, by tetrahedra to the origin of its file."""
        friction, density = 0.3, 2600
        lines = [line.split() for line in (SCENES / "stone.obj").read_text().splitlines()]
        at = [tuple(map(float, line[1:])) for line in lines if line[0] == "v"]
        faces = [[at[int(i) - 1] for i in line[1:]] for line in lines if line[0] == "f"]
        volume = sum(ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)
                     for (ax, ay, az), (bx, by, bz), (cx, cy, cz) in faces) / 6e9
        mass = density * abs(volume)
        check = json.loads(self.succeed("check", self.stone(), "--json").stdout)
        (loose,) = check["loose"]
        self.assertEqual(loose["name"], "stone")
        self.assertAlmostEqual(loose["mass_kg"], mass, delta=1e-6 * mass)
        self.assertAlmostEqual(loose["density_kg_per_m3"], density, delta=1e-6 * density)
        self.assertRegex(self.succeed("check", self.stone()).stdout, r"stone is loose: 0\.0\d+ kg at 2600 kg/m\^3")
        ways = [(0, -10, 0.02 * i) for i in range(2500)]
        rows, said = self.touch(self.stone(), ways, "--stiffness", 2000, "--scale", 1000, "--torque-stiffness", 20)
        self.assertTrue(all(row["force_z"] == 0 for row in rows[:500]), "nothing is met yet")
        mean = sum(row["force_z"] for row in rows[-500:]) / 500
        self.assertAlmostEqual(-mean, friction * mass * 9.81, delta=0.05 * friction * mass * 9.81)
        self.assertNotIn("in one another", said)

    def test_a_loose_body_without_a_mass_is_refused_by_its_density(self):
        self.write_path([(0, 0, 0, 0)])
        self.write("open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")

        def stone(**values):
            return lambda scene: scene["bodies"][1].update(values)

        cases = ((stone(density=0), ("density", "above 0")),
                 (lambda scene: scene["bodies"][1].pop("density"), ("density", "missing")),
                 (stone(file="open.obj"), ("open.obj", "open: 3", "density")))
        for change, words in cases:
            scene = self.stone(change)
            self.refused("check", scene, saying=words)
            self.refused("touch", scene, "--path", "path.csv", "--csv", "out.csv", saying=words)

    def test_what_cannot_be_felt_is_refused_in_words(self):
        lever = json.loads((SCENES / "lever.json").read_text())
        self.write_path([(0, 0, 0, 0)])
        touch = ("--path", "path.csv", "--csv", "out.csv")

        def changed(change):
            scene = json.loads(json.dumps(lever))
            change(scene)
            self.write("scene.json", json.dumps(scene))
            return "scene.json"

        def law(**values):
            return lambda scene: scene["laws"][0].update(values)

        cases = ((law(b="needle"), ("wall", "itself")), (law(b="nothing"), ("wall", "nothing")),
                 (law(kind="break", strength_N=0), ("wall", "strength")), (law(kind="weld"), ("weld", "valid kinds: contact")),
                 (lambda scene: scene["bodies"].__setitem__(0, {"name": "needle", "kind": "rigid", "half_size": [1, 1, 1]}),
                  ("holds no body", "held rod")),
                 (lambda scene: scene["bodies"][0].update(name="a,b"), ("name", "comma")),
                 (lambda scene: scene.update(version=9), ("version", "update Palpate")))
        for change, words in cases:
            self.refused("check", changed(change), saying=words)
            self.refused("touch", changed(change), *touch, saying=words)
        self.scene("lever.json")
        for option in (("--young", 1e4), ("--radius", 1), ("--two-d",), ("--field", "f.vti")):
            self.refused("touch", "lever.json", *touch, *option, saying=("mechanism",))
        self.refused("touch", "lever.json", "lever.json", *touch, saying=("another file",))


if __name__ == "__main__":
    unittest.main()
