# SPDX-License-Identifier: GPL-3.0-or-later
"""`palpate arm`: an arm file is checked, and the forces and masses of its work space are printed."""

import json
import os
import subprocess
import unittest
from pathlib import Path

from palpate_cli import PROGRAM, CommandLineTest

ARMS = Path(os.environ["PALPATE_SOURCE_DIR"]) / "data" / "arms"


def described(*words):
    run = subprocess.run([PROGRAM, "arm", *words], capture_output=True, text=True, timeout=120)
    assert run.returncode == 0, run.stderr
    return run.stdout


class Arm(CommandLineTest):
    def test_a_file_says_the_same_as_the_arm_that_is_built_in(self):
        for file in sorted(ARMS.glob("*.json")):
            with self.subTest(file=file.name):
                self.assertEqual(described(str(file), "--json"), described(file.stem, "--json"))

    def test_the_numbers_lie_within_what_the_file_allows(self):
        falcon = json.loads((ARMS / "falcon.json").read_text())
        said = json.loads(described("falcon", "--json"))
        self.assertEqual((said["kind"], said["joints"], said["motors"]), ("delta", 3, 3))
        least, most = said["condition"]
        self.assertTrue(1.0 <= least <= most < falcon["max_condition"])
        self.assertEqual(said["usable_places"], said["places"])
        least, most = said["manipulability"]
        self.assertTrue(0.0 < least < most)
        self.assertIn(f"manipulability, the product of its singular values: {least:.6g} to {most:.6g}",
                      described("falcon"))
        self.assertGreater(said["force_N"][0], 0.0)
        self.assertLess(said["apparent_mass_kg"][0], said["apparent_mass_kg"][1])
        centre, radius = falcon["work_space"]["centre_m"], falcon["work_space"]["radius_m"]
        self.assertLessEqual(sum((a - b) ** 2 for a, b in zip(said["best_m"], centre)) ** 0.5, radius * (1 + 1e-9))

    def test_its_class_is_said(self):
        for name, kind, links in (("falcon", "delta", "parallel"), ("pantograph", "five-bar", "parallel"),
                                  ("polhem-v1", "woodenhaptics", "serial"), ("delta-wrist", "delta", "hybrid")):
            self.assertEqual(json.loads(described(name, "--json"))["class"], links)
            self.assertIn(f": {kind}, {links}, ", described(name))
        self.assertIn("6 joints, 3 motors", described("delta-wrist"))

    def test_a_work_space_that_is_out_of_reach_in_part_or_has_a_singularity_is_told(self):
        arm = json.loads((ARMS / "pantograph.json").read_text())
        arm["work_space"]["radius_m"] = 0.06
        file = self.folder / "wide.json"
        file.write_text(json.dumps(arm))
        said = described(str(file))
        self.assertIn("note: the arm does not reach", said)
        self.assertRegex(said, r"\d % of the work space is nearer to a singularity than a condition of 6: "
                               r"there is no force there\n")

    def wired(self, **changes):
        """The pantograph's file with other keys in its wire."""
        arm = json.loads((ARMS / "pantograph.json").read_text())
        arm["wire"] |= changes
        return self.write("wired.json", json.dumps(arm))

    def test_a_file_with_a_wire_says_which_devices_it_is_for(self):
        file = self.wired(usb=["16d0:1234", "16d0:abcd"], serial="7")
        self.assertIn("\n  wire: 2diy, USB 16d0:1234, 16d0:abcd, serial number 7\n", described(str(file)))
        self.assertEqual(json.loads(described(str(file), "--json"))["wire"],
                         {"protocol": "2diy", "usb": ["16d0:1234", "16d0:abcd"], "serial": "7"})
        self.assertNotIn("wire", described("falcon"))
        self.assertNotIn("wire", json.loads(described("falcon", "--json")))

    def test_a_wrong_wire_is_refused(self):
        self.refused("arm", self.wired(protocol="smoke"), saying=["wired.json: wire.protocol: unknown protocol \"smoke\""])

    def listed(self):
        """The lines of `palpate devices` of a person with these files of arms, and nothing plugged in."""
        environment = dict(os.environ, XDG_CONFIG_HOME=str(self.folder))
        run = subprocess.run([PROGRAM, "devices"], env=environment, capture_output=True, text=True, timeout=60)
        self.assertEqual(run.returncode, 0, run.stderr)
        return [line for line in run.stdout.splitlines() if not line.startswith("  ")]

    def test_a_wrong_file_in_the_folder_of_arms_is_told_where_devices_are_listed_and_a_good_one_is_not(self):
        before = self.listed()
        folder = self.folder / "palpate" / "arms"
        folder.mkdir(parents=True)
        good = self.wired(usb=["16d0:1234"])
        (folder / "good.json").write_text(good.read_text())
        self.assertEqual(self.listed(), before)
        wrong = self.wired(usb=["16d0"])
        (folder / "my arm.json").write_text(wrong.read_text())
        sentence = ("wire.usb: each text must have the numbers of a device as lsusb shows them, such as \"2341:003e\"")
        self.assertEqual(self.listed(), [*before, f"my-arm: cannot be used: {folder}/my arm.json: {sentence}"])

    def test_bad_input_is_named(self):
        text = (ARMS / "falcon.json").read_text()
        short = self.folder / "short.json"
        short.write_text(text[: len(text) // 2])
        self.refused("arm", "nowhere.json", saying=["nowhere.json", "cannot be read"])
        self.refused("arm", str(short), saying=["short.json", "not JSON"])
        short.write_text(text.replace('"arm_m": 0.06', '"arm_m": -0.06'))
        self.refused("arm", str(short), saying=["short.json", 'the length "arm" must be above 0'])


if __name__ == "__main__":
    unittest.main()
