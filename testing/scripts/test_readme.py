# SPDX-License-Identifier: GPL-3.0-or-later
"""The promises of README.md and testing/BAR.md are kept: the program runs, the tests exist."""

import math
import os
import re
import subprocess
import sys
import tempfile
import unittest
from fnmatch import fnmatchcase as fnmatch
from pathlib import Path

ROOT = Path(os.environ.get("PALPATE_SOURCE_DIR") or Path(__file__).resolve().parents[2])


class Readme(unittest.TestCase):
    """The code that a newcomer copies from the first page."""

    text = (ROOT / "README.md").read_text(encoding="utf-8")

    def test_the_python_program_prints_the_force_on_a_ball(self):
        program = re.search(r"```python\n(.*?)```", self.text, re.DOTALL).group(1)
        with tempfile.TemporaryDirectory() as folder:
            script = Path(folder, "touch.py")
            script.write_text(program, encoding="utf-8")
            result = subprocess.run([sys.executable, script], capture_output=True, text=True, timeout=100, check=False)
        self.assertEqual(result.returncode, 0, result.stderr)
        force = float(re.fullmatch(r"(\S+) N\n", result.stdout).group(1))
        # R = 50 mm, hand at (10, 0, 47) mm, 500 N/m. 100 facets around lie up to R (1 - cos(pi / 100)) inside the sphere
        # in each of the two directions.
        sphere = (0.050 - math.hypot(0.010, 0.047)) * 500
        facets = 2 * 0.050 * (1 - math.cos(math.pi / 100)) * 500
        self.assertLessEqual(force, sphere + 0.0005)
        self.assertGreaterEqual(force, sphere - facets - 0.0005)
        self.assertIn(f"`{force:.3f} N`", self.text)

    def test_every_file_it_links_to_is_there(self):
        for link in re.findall(r"\]\((?!https?:)([^)#]+)\)", self.text):
            self.assertTrue((ROOT / link).exists(), link)


class Bar(unittest.TestCase):
    """testing/BAR.md names tests that exist; a row that names none says "later"."""

    TESTING = ROOT / "testing"
    text = (TESTING / "BAR.md").read_text(encoding="utf-8")
    sources = "".join(path.read_text(encoding="utf-8") for path in TESTING.rglob("*.c[px][px]"))
    defined = set(re.findall(r"^(?:TYPED_)?TEST(?:_P|_F)?\((\w+), (\w+)\)", sources, re.MULTILINE))
    # Each experiment's rows.
    experiments = {name: {int(row) for row in rows.split(",") if row.strip()} for name, rows in re.findall(
        r'^    \{ "([a-z-]+)",.*?\{ ?([\d, ]*)\}', (TESTING / "lab/Experiments.cpp").read_text(encoding="utf-8"),
        re.MULTILINE | re.DOTALL)}

    def rows(self):
        """(number or None, text, its names in backquotes) of each row of both tables."""
        for line in self.text.splitlines():
            if line.startswith("| ") and not re.match(r"\| (row|property) ", line):
                number = re.match(r"\| (\d+) \|", line)
                yield number and int(number[1]), line, re.findall(r"`([^`]+)`", line.split("|")[-2])

    def exists(self, name):
        """A suite, a test of one or those that begin alike, a script, a program test or a folder with tests; whatever
        else says no."""
        if test := re.fullmatch(r"([A-Z]\w+)\.([A-Z]\w+|(?:[A-Z]\w+)?\*)", name):
            return any(test[1] == suite and fnmatch(case, test[2]) for suite, case in self.defined)
        if name.endswith(".py"):
            return any(self.TESTING.rglob(Path(name).name)) and ("/" not in name or (ROOT / name).is_file())
        if test := re.fullmatch(r"pv(?:cs)?\.(\w+)", name):
            return (self.TESTING / "ui" / f"{test[1]}.xml").is_file() or self.is_named(name)
        if re.match(r"(benchmark|plugin|filters|install|sanitizers)\.", name):
            return self.is_named(name)
        return name in self.experiments or (name.endswith("/") and (ROOT / name).is_dir())

    def is_named(self, name):
        """A test that is a program of its own."""
        return any(f"NAME {name} " in path.read_text(encoding="utf-8") for path in self.TESTING.rglob("CMakeLists.txt"))

    def test_every_row_without_later_names_what_exists(self):
        rows = list(self.rows())
        self.assertGreater(len(rows), 50)
        for _, line, names in rows:
            later = line.endswith("| later |")
            self.assertNotEqual(later, any(map(self.exists, names)), line)

    def test_every_test_script_and_experiment_it_names_is_in_the_tree(self):
        self.assertGreater(len(self.experiments), 40)
        beside = {"palpate-tick-bench", "palpate-device-bench", "palpate-field-bench", "palpate-soft-bench", "palpate-tool-bench",
                  "palpate-mechanism-bench", "data/get"}  # programs and a command, not tests
        for _, line, names in self.rows():
            for name in names:
                self.assertTrue(name in beside or self.exists(name), (name, line))

    def test_every_experiment_is_named_in_a_row_of_its_own(self):
        for name, own in self.experiments.items():
            rows = {number for number, _, names in self.rows() if name in names}
            self.assertTrue(rows, f"{name} is in no row")
            self.assertLessEqual(rows - {None}, own, name)


if __name__ == "__main__":
    unittest.main(verbosity=2)
