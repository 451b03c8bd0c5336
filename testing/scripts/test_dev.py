# SPDX-License-Identifier: GPL-3.0-or-later
"""./dev with stand-ins for dpkg-query and apt-get: installs, refusals, answers."""

import os
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

from turns import TURNS, label_of, others_of

ROOT = Path(os.environ.get("PALPATE_SOURCE_DIR") or Path(__file__).resolve().parents[2])
BUILD = Path(os.environ.get("PALPATE_BUILD_DIR") or ROOT / "build")
DPKG_QUERY = """#!/bin/sh
# Stand-in: everything is installed but ninja-build.
for last; do :; done
[ "$last" = ninja-build ] && exit 1
echo installed
"""
APT_GET = """#!/bin/sh
# Stand-in: writes down what it is asked for; a simulation prints the plan; an installation always fails.
echo "$*" >> "{log}"
case "$*" in
  update*) exit 0 ;;
  "-s "*) {plan} ;;
  *) exit 100 ;;
esac
"""


class Dev(unittest.TestCase):
    """The script itself, without a build."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.log = self.folder / "log"

    def stand_in(self, name, text):
        path = self.folder / name
        path.write_text(text, encoding="utf-8")
        path.chmod(0o755)

    def dev(self, *arguments):
        environment = dict(os.environ, PATH=f"{self.folder}:{os.environ['PATH']}")
        return subprocess.run(
            [str(ROOT / "dev"), *arguments], env=environment, capture_output=True, text=True, check=False, timeout=60
        )

    def with_one_missing_package(self, plan):
        self.stand_in("dpkg-query", DPKG_QUERY)
        self.stand_in("apt-get", APT_GET.format(log=self.log, plan=plan))
        self.stand_in("sudo", '#!/bin/sh\nexec "$@"\n')
        return self.dev("build")

    def test_a_conflict_names_the_packages_and_changes_nothing(self):
        result = self.with_one_missing_package("echo 'Remv libvtk9-dev [9.1]'; echo 'Remv python3-vtk9 [9.1]'")
        self.assertEqual(result.returncode, 1)
        self.assertIn("conflict with what Palpate needs: libvtk9-dev python3-vtk9", result.stderr)
        calls = self.log.read_text(encoding="utf-8").splitlines()
        self.assertEqual([call for call in calls if call.startswith("install")], [])

    def test_only_what_is_missing_is_installed_and_nothing_removed(self):
        result = self.with_one_missing_package("echo 'Inst ninja-build'")
        self.assertEqual(result.returncode, 1)
        self.assertIn("could not install", result.stderr)
        last = self.log.read_text(encoding="utf-8").splitlines()[-1].split()
        self.assertEqual(last[0], "install")
        self.assertLessEqual({"--no-install-recommends", "--no-remove"}, set(last))
        self.assertEqual([word for word in last[1:] if not word.startswith("-")], ["ninja-build"])

    def test_the_other_vtk_is_in_no_package_list(self):
        text = (ROOT / "dev").read_text(encoding="utf-8")
        listed = text[text.index("packages=(") :].split(")")[0]
        self.assertNotIn("vtk9", listed)

    def test_wrong_use_exits_2_and_says_why(self):
        for arguments, reason in [
            ((), "usage"),
            (("dance",), "unknown command 'dance'"),
            (("test", "--fast"), "unknown option '--fast'"),
            (("test", "--label"), "--label needs a name"),
            (("test", "--label", "TYPO"), "not 'TYPO'"),
            (("test", "--full", "--label", "TYPO"), "not 'TYPO'"),
            (("build", "now"), "build takes no options"),
            (("run", "now"), "run takes no options"),
            (("lab", "--fast"), "lab: unknown option '--fast'"),
            (("lab", "--seed"), "--seed needs a number"),
        ]:
            with self.subTest(arguments=arguments):
                result = self.dev(*arguments)
                self.assertEqual(result.returncode, 2)
                self.assertIn(reason, result.stderr)

    def test_what_run_builds_is_a_target_without_tests(self):
        text = (ROOT / "dev").read_text(encoding="utf-8")
        run = text[text.index("command_run()") :].split("\n}")[0]
        target = re.search(r"^  build (\w+)", run, re.MULTILINE).group(1)
        told = subprocess.run(["ninja", "-C", BUILD, "-t", "commands", target], capture_output=True, text=True, check=True)
        compiled = re.findall(r" -c (\S+)$", told.stdout, re.MULTILINE)
        self.assertTrue(any(re.search(r"haptics[_/]tick[_/]", source) for source in compiled), compiled)  # alone or as a folder
        self.assertEqual([source for source in compiled if source.startswith(str(ROOT / "testing"))], [])

    def test_help_names_every_command(self):
        result = self.dev("--help")
        self.assertEqual(result.returncode, 0)
        for command in ("run", "test", "build", "lab"):
            self.assertIn(f"\n  {command} ", result.stdout)


class Turns(unittest.TestCase):
    """Slow tests are done by one commit in seven, and none by no commit."""

    COMMITS = range(1000, 1000 + TURNS)

    def test_as_many_commits_in_a_row_as_there_are_turns_do_every_slow_test_once(self):
        told = subprocess.run(["ctest", "--test-dir", str(BUILD), "--print-labels"], capture_output=True, text=True, check=True)
        labels = re.findall(r"^ *(turn-\S+)$", told.stdout, re.MULTILINE)
        self.assertGreater(len(labels), 1)
        for label in labels:
            done = [number for number in self.COMMITS if not re.search(others_of(number), label)]
            self.assertEqual([label_of(number) for number in done], [label])

    def test_a_test_that_is_in_no_turn_is_left_out_by_no_commit(self):
        for number in self.COMMITS:
            for label in ("unit", "filters", "plugin", "gui", "lab", "vm", "vm-usb"):
                self.assertIsNone(re.search(others_of(number), label))

    def test_what_a_commit_builds_is_what_its_tests_need(self):
        told = subprocess.run(["ninja", "-C", str(BUILD), "-t", "targets", "all"], capture_output=True, text=True, check=True)
        targets = set(re.findall(r"^(\S+): phony$", told.stdout, re.MULTILINE))
        self.assertLessEqual({label_of(number) for number in self.COMMITS} | {"palpate_every_turn"}, targets)


if __name__ == "__main__":
    unittest.main(verbosity=2)
