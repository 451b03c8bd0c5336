# SPDX-License-Identifier: GPL-3.0-or-later
"""What README.md and testing/BAR.md promise is there: the program runs, the tests exist."""

import math
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(os.environ.get("PALPATE_SOURCE_DIR") or Path(__file__).resolve().parents[2])


class Readme(unittest.TestCase):
    """What a newcomer copies from the first page."""

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
    """testing/BAR.md names tests that exist, and a row without one says "later"."""

    text = (ROOT / "testing" / "BAR.md").read_text(encoding="utf-8")

    def test_every_test_it_names_is_in_the_tree(self):
        sources = "".join(path.read_text(encoding="utf-8") for path in (ROOT / "testing").rglob("*.c[px][px]"))
        defined = {".".join(names) for names in re.findall(r"^TEST(?:_P|_F)?\((\w+), (\w+)\)", sources, re.MULTILINE)}
        named = set(re.findall(r"`([A-Z]\w+\.[A-Z]\w+)`", self.text))
        self.assertGreater(len(named), 20)
        self.assertEqual(named - defined, set())

    def test_every_experiment_it_names_is_in_the_lab(self):
        listed = set(re.findall(r'^    \{ "([a-z-]+)",', (ROOT / "testing/lab/Experiments.cpp").read_text(encoding="utf-8"), re.MULTILINE))
        named = {name for cell in re.findall(r"lab: ([^|;]*)", self.text) for name in re.findall(r"`([a-z-]+)`", cell)}
        self.assertGreater(len(named), 10)
        self.assertEqual(named - listed, set())

    def test_every_row_of_this_version_names_a_test(self):
        for row in [*range(1, 18), 19, 20, *range(21, 27), 52, *range(54, 59)]:
            line = re.search(rf"^\| {row} \|.*$", self.text, re.MULTILINE).group(0)
            self.assertIn("`", line, line)


if __name__ == "__main__":
    unittest.main(verbosity=2)
