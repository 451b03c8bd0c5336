# SPDX-License-Identifier: GPL-3.0-or-later
"""`palpate check` and `palpate touch` with a wire in a vessel."""

import json
import math
import os
import shutil
import unittest
from pathlib import Path

from palpate_cli import CommandLineTest

SCENES = Path(os.environ["PALPATE_SOURCE_DIR"]) / "data" / "mechanisms"


class Wire(CommandLineTest):
    def setUp(self):
        super().setUp()
        for name in ("wire.json", "tube.obj"):
            shutil.copy(SCENES / name, self.folder)

    def change(self, **changes):
        scene = json.loads((SCENES / "wire.json").read_text())
        scene["bodies"][0].update(changes)
        scene["bodies"][0] = {key: value for key, value in scene["bodies"][0].items() if value is not None}
        (self.folder / "wire.json").write_text(json.dumps(scene))

    def test_the_check_says_beams_contacts_and_cost(self):
        said = json.loads(self.succeed("check", "wire.json", "--json").stdout)
        self.assertEqual((said["beams"], said["most_contacts"]), (64, 24))
        self.assertAlmostEqual(said["tightest_bend"], 3 * 250 / 64, places=9)
        # The facets of a tube of 24 are nearer to its middle than its corners are.
        self.assertAlmostEqual(said["clearance"], math.cos(math.pi / 24) - 0.25, places=4)
        self.assertGreater(said["work"], 0)
        self.assertIn("64 beams, at most 24 contacts", self.succeed("check", "wire.json").stdout)

    def test_a_wire_is_pushed_around_the_bend_and_pulled_back_against_friction(self):
        way = [0.1 * n for n in range(1301)] + [130 - 0.1 * n for n in range(200)]
        self.write_path([(n / 1000, x, 0, 0) for n, x in enumerate(way)])
        self.succeed("touch", "wire.json", "--path", "path.csv", "--csv", "out.csv", "--scale", 1000, "--stiffness", 1000)
        rows = self.read_rows()
        self.assertEqual(rows[300]["force_x"], 0.0)  # in the straight part
        pushing, pulling = rows[1300], rows[-1]
        self.assertLess(pushing["force_x"], -0.03)
        self.assertGreater(pulling["force_x"], 0.03)
        # The hand's spring of 1 N/mm is as long as its force says.
        self.assertAlmostEqual(pushing["pushed"], 130 + pushing["force_x"], delta=1e-9)
        tip = (pushing["proxy_x"], pushing["proxy_y"])
        self.assertLess(math.hypot(tip[0] - 40, tip[1] - 25), 80.0)
        self.assertGreater(tip[1], 60.0)  # beyond the bend
        # As far around the bend as here, the work of the push is that of friction .1: the forces of the wall add up to that.
        self.assertGreater(pushing["wall_force"], -pushing["force_x"] / (0.1 * pushing["contacts"]))
        self.assertGreaterEqual(pushing["wall_force"], pushing["tip_force"])

    def test_bad_input_is_refused_in_one_line(self):
        for changes, fault in (
            ({"length": None}, "length: this key is missing"),
            ({"diameter": 3}, "thicker than the vessel at the mouth"),
            ({"young_Pa": 0}, "modulus"),
            ({"beams": 65}, "from 1 to 64: beams of 3.90625 would do"),
            ({"tip": "corkscrew"}, "valid tips: straight, angled, hook, helix"),
            ({"tip": "hook", "tip_length": 251}, "not longer than the wire"),
            ({"vessel": "none.obj"}, "none.obj"),
            ({"direction": [0, 0, 0]}, "direction"),
            ({"colour": "red"}, "unknown key"),
        ):
            with self.subTest(fault):
                self.change(**changes)
                self.refused("check", "wire.json", saying=["wire.json", fault])

    def test_a_file_that_is_cut_short_anywhere_is_refused_in_one_line(self):
        text = (SCENES / "wire.json").read_text().rstrip()
        for length in range(0, len(text), max(1, len(text) // 25)):
            with self.subTest(length):
                (self.folder / "wire.json").write_text(text[:length])
                self.refused("check", "wire.json", saying=["wire.json", "not JSON"])


if __name__ == "__main__":
    unittest.main()
