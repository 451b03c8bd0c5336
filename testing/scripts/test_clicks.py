# SPDX-License-Identifier: GPL-3.0-or-later
"""Scripts of the panel say after how few clicks each task is felt. Here their clicks are counted."""

import os
import re
import unittest
from pathlib import Path

ROOT = Path(os.environ.get("PALPATE_SOURCE_DIR") or Path(__file__).resolve().parents[2])
SCRIPTS = ROOT / "testing" / "ui"
MOST = {"touch": 1, "friction": 2, "array as stiffness": 2, "volume": 3, "streamlines": 1, "five marks": 7, "tool": 2, "tissue": 2,
        "needle": 3, "record, replay, back": 3}

TASK = re.compile(r"<!-- Clicks: (\d+), ([a-z, ]+?)[:.].*?-->(.*?)(?=<!-- Clicks)", re.DOTALL)
EVENT = re.compile(r'<pqevent object="([^"]*)" command="([^"]*)" arguments="([^"]*)"/>')
NO_CLICK = {"mouseMove", "mouseRelease", "filesSelected"}  # the last follows the click that opened the dialog
LOOKS = ("assert ", "field_play.picture(")


def clicks(target, command):
    """A list is opened and chosen from; a menu of the pipeline browser is opened and an entry of it pressed."""
    if command.startswith("haptic") or command in NO_CLICK:
        return 0
    return 2 if command == "set_string" or target.endswith("/hapticSourceMenu") else 1


def count(script, start, body):
    """Clicks of a task, with those on pages that it did not open."""
    opened = re.findall(r'list/(\w+)Button" command="activate"', script[:start])
    page, total = opened[-1] if opened else "main", 0
    for target, command, arguments in EVENT.findall(body):
        button, of = re.search(r"list/(\w+)Button$", target), re.search(r"body/(\w+)Page/", target)
        cost = clicks(target, command)
        total += cost + (1 if cost and of and of.group(1) != page else 0)
        page = button.group(1) if button else of.group(1) if cost and of else page
        if command == "hapticPython" and total and not arguments.startswith(LOOKS):
            raise AssertionError(f"a script works in the place of a person: {arguments}")
    return total


class Clicks(unittest.TestCase):
    def setUp(self):
        self.tasks = {}
        for file in sorted(SCRIPTS.glob("*.xml")):
            script = file.read_text(encoding="utf-8")
            for task in TASK.finditer(script):
                said, name, body = task.groups()
                self.assertNotIn(name, self.tasks)
                self.tasks[name] = file.name, script, int(said), count(script, task.start(), body)

    def test_each_task_takes_as_many_clicks_as_its_script_says_and_no_more_than_it_may(self):
        self.assertEqual(set(self.tasks), set(MOST))
        for name, (file, _, said, counted) in self.tasks.items():
            with self.subTest(name):
                self.assertEqual(counted, said, file)
                self.assertLessEqual(counted, MOST[name], file)

    def test_each_is_played_in_a_small_window(self):
        for name, (file, script, _, _) in self.tasks.items():
            self.assertIn('command="hapticWindow" arguments="1366,768"', script, (name, file))

    def test_a_row_of_another_page_costs_a_click_more_and_a_list_two(self):
        row = '<pqevent object="panel/body/{}Page/g/array" command="set_string" arguments="x"/>'
        self.assertEqual(count("", 0, row.format("main")), 2)
        self.assertEqual(count("", 0, row.format("material")), 3)
        opened = '<pqevent object="list/materialButton" command="activate" arguments=""/>'
        self.assertEqual(count("", 0, opened + row.format("material")), 3)


if __name__ == "__main__":
    unittest.main()
