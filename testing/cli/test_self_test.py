# SPDX-License-Identifier: GPL-3.0-or-later
"""`palpate devices --self-test`: a simulated hand follows the requests; the result is kept where settings are."""

import os
import re
import subprocess
import unittest

from palpate_cli import PROGRAM, CommandLineTest
from says import unsaid


class SelfTest(CommandLineTest):
    def devices(self, *arguments):
        environment = dict(os.environ, XDG_CONFIG_HOME=str(self.folder))
        command = [PROGRAM, "devices", *arguments]
        return subprocess.run(command, env=environment, capture_output=True, text=True, timeout=60)

    def check(self, *arguments):
        return self.devices("--self-test", *arguments)

    def test_a_simulated_joystick_works_and_its_range_is_that_of_its_stops(self):
        run = self.check("simulated-joystick")
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        self.assertIn("The device works.", run.stdout)
        for axis in "xy":  # stops at 50 mm either side, 1024 steps
            self.assertIn(f"{axis}: 100 mm, 1024 steps; motor {axis}: moves the driver's {axis} by", run.stdout)
        for ask in ["still", "left", "right", "towards you", "away from you", "relaxed"]:
            self.assertIn(ask, run.stdout)
        self.assertFalse((self.folder / "palpate").exists())

    def test_what_was_found_is_kept_where_it_says(self):
        run = self.check("simulated-joystick", "--keep")
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        file = re.search(r"^kept in (.*)$", run.stdout, re.MULTILINE).group(1)
        self.assertTrue(file.startswith(str(self.folder / "palpate" / "calibration")), file)
        with open(file, encoding="ascii") as text:
            lines = text.read().splitlines()
        self.assertEqual(lines[0], "palpate calibration 2")
        self.assertIn("device simulated-joystick", lines)
        self.assertEqual(lines[-1], "end")
        self.assertEqual(sum(line.startswith("axis ") for line in lines), 2)
        self.assertIn("workspace radius 0.05 m\n", self.devices().stdout)  # measured, no longer assumed

    def test_without_a_folder_to_keep_it_in_no_check_begins(self):
        environment = {name: value for name, value in os.environ.items() if name not in ("HOME", "XDG_CONFIG_HOME")}
        command = [PROGRAM, "devices", "--self-test", "simulated-joystick", "--keep"]
        for home in ({}, {"HOME": "here"}):
            run = subprocess.run(command, env=environment | home, capture_output=True, text=True, timeout=60)
            self.assertEqual((run.returncode, run.stdout), (2, ""))
            self.assertIn("--keep: no folder", run.stderr)

    def test_a_damaged_file_is_named_where_devices_are_listed(self):
        folder = self.folder / "palpate" / "calibration"
        folder.mkdir(parents=True)
        (folder / "simulated-joystick.calibration").write_text("nonsense")
        listed = self.devices()
        self.assertEqual(listed.returncode, 0, listed.stderr)
        self.assertEqual(unsaid(listed.stdout, f"cannot be used: {folder}/simulated-joystick.calibration", "not a calibration"), [])

    def test_a_file_of_the_old_directions_is_refused_with_what_to_do(self):
        folder = self.folder / "palpate" / "calibration"
        folder.mkdir(parents=True)
        (folder / "simulated-joystick.calibration").write_text("palpate calibration 1\ndevice simulated-joystick\n")
        listed = self.devices()
        self.assertEqual(unsaid(listed.stdout, "directions", "remove the file", "check the device again"), [])

    def test_who_says_that_it_is_a_wheel_is_asked_for_one_axis(self):
        run = self.check("simulated-joystick", "--wheel")
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        self.assertIn("right", run.stdout)
        self.assertNotIn("away from you", run.stdout)

    def test_the_same_check_finds_the_same_to_the_last_digit(self):
        self.assertEqual(self.check("simulated-premium").stdout, self.check("simulated-premium").stdout)

    def test_bad_input_is_named(self):
        self.refused("devices", "--self-test", "abacus", saying=["abacus", "simulated-joystick"])
        self.refused("devices", "--self-test", "fed", saying=["fed", "no force"])
        self.refused("devices", "--keep", saying=["--self-test"])
        self.refused("devices", "--wheel", saying=["--self-test"])


if __name__ == "__main__":
    unittest.main()
