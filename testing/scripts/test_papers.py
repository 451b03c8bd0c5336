# SPDX-License-Identifier: GPL-3.0-or-later
"""Texts for people are short, and their links have targets: pages, records of decisions, recipes."""

import os
import re
import sys
import unittest
from pathlib import Path

import test_readme

sys.path.append(str(Path(__file__).resolve().parents[1] / "plugin"))
import described  # noqa: E402

ROOT = Path(os.environ.get("PALPATE_SOURCE_DIR") or Path(__file__).resolve().parents[2])
SCREEN_COLUMNS, THREE_SCREENS = 100, 130
ONE_PAGE_WORDS = 1300
FOLDERS = ("haptics", "devices", "filters", "ui", "plugin", "testing", "docs", "data")

PAGES = sorted([ROOT / "ARCHITECTURE.md", ROOT / "README.md", ROOT / "CONTRIBUTING.md",
                *(page for folder in ("docs", "plugin", "testing", "data") for page in (ROOT / folder).rglob("*.md"))])


def prose(page):
    """A page without its fenced blocks."""
    return re.sub(r"^```.*?^```", "", page.read_text(encoding="utf-8"), flags=re.DOTALL | re.MULTILINE)


def anchors(page):
    """The name of a heading in a link, as the hosts of repositories make it."""
    headings = re.findall(r"^#+ (.*)$", prose(page), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def named_paths(text):
    """Files and folders of the tree that stand in backquotes; a name in brackets as well is one that does not exist yet."""
    found = re.findall(r"(\[?)`((?:%s)/[\w./-]+)`" % "|".join(FOLDERS), text)
    return [path for bracket, path in found if not bracket], [path for bracket, path in found if bracket]


class Pages(unittest.TestCase):
    """Every page."""

    def test_the_first_page_fits_three_screens(self):
        lines = (ROOT / "README.md").read_text(encoding="utf-8").splitlines()
        shown = sum(max(1, -(-len(line) // SCREEN_COLUMNS)) for line in lines)
        self.assertLessEqual(shown, THREE_SCREENS)

    def test_the_architecture_fits_one_page(self):
        self.assertLessEqual(len((ROOT / "ARCHITECTURE.md").read_text(encoding="utf-8").split()), ONE_PAGE_WORDS)

    def test_every_link_leads_to_a_page_and_a_heading_that_are_there(self):
        for page in PAGES:
            for target, anchor in re.findall(r"\]\((?!https?:)([^)#]*)(?:#([^)]*))?\)", prose(page)):
                with self.subTest(page=page.relative_to(ROOT), target=target, anchor=anchor):
                    aim = (page.parent / target).resolve() if target else page
                    self.assertTrue(aim.exists())
                    if anchor:
                        self.assertIn(anchor, anchors(aim))

    def test_every_file_and_folder_they_name_is_there(self):
        count = 0
        for page in PAGES:
            there, later = named_paths(prose(page))
            count += len(there)
            for path in there:
                self.assertTrue((ROOT / path).exists(), f"{page.relative_to(ROOT)} names {path}")
            for path in later:
                self.assertFalse((ROOT / path).exists(), f"{page.relative_to(ROOT)} says that {path} does not exist yet")
        self.assertGreater(count, 100)  # the walk sees names


class Numbers(unittest.TestCase):
    """Counts on a page are those of the tree."""

    WORDS = ("none", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve")

    def says(self, page, sentence, count):
        """That a page has a sentence with a number, in words, in place of the star."""
        wanted = sentence.replace("*", self.WORDS[count])
        self.assertIn(wanted.lower(), " ".join(prose(ROOT / page).split()).lower(), f"{page} counts otherwise")

    @staticmethod
    def found(folder, pattern, suffixes=(".cpp",)):
        """How many files of a folder have something."""
        return sum(1 for path in (ROOT / folder).rglob("*")
                   if path.suffix in suffixes and re.search(pattern, path.read_text(encoding="utf-8"), re.MULTILINE))

    def test_simulated_devices_and_their_hands(self):
        models = (ROOT / "devices/simulated/DeviceModels.cpp").read_text(encoding="utf-8")
        devices = len(set(re.findall(r'"(simulated-[\w-]+)"', models)))
        hands = len(re.findall(r'^ +\{ "(?:none|light|stylus|firm)",', models, re.MULTILINE))
        self.assertGreater(devices, 5)
        self.says("README.md", "* simulated devices, the mouse, a program, a recording", devices)
        self.says("docs/devices.md", "* simulated devices, from an ideal point mass", devices)
        self.says("docs/devices.md", "behind a serial link, in * hands", hands)

    def test_tutorials(self):
        for page, besides in (("fields", ()), ("tools", ("Where it is held",))):
            headings = re.findall(r"^## (.*)$", prose(ROOT / f"docs/{page}.md"), re.MULTILINE)
            tutorials = len([heading for heading in headings if heading not in besides])
            self.says(f"docs/{page}.md", "* tutorials", tutorials)
            self.says("docs/touching.md", f"({page}.md) *", tutorials)

    def test_files_that_know_a_library(self):
        self.says("ARCHITECTURE.md", "CGAL in * .cpp", self.found("haptics", r"^#include <CGAL/"))
        self.says("ARCHITECTURE.md", "CHOLMOD in *;", self.found("haptics", r"^#include <(suitesparse/)?cholmod"))
        for library in (r"hidapi", r"dbus/"):
            self.assertEqual(self.found("devices", rf"^#include <{library}"), 1)
        self.says("ARCHITECTURE.md", "hidapi and libdbus in * .cpp each", 1)
        self.says("ARCHITECTURE.md", "`filters` are * VTK modules", self.found("filters", r"^NAME", (".module",)))


class Decisions(unittest.TestCase):
    """docs/decisions: one idea a file."""

    FOLDER = ROOT / "docs/decisions"
    records = sorted(path for path in FOLDER.glob("*.md") if path.name != "README.md")

    def test_the_index_names_each_record_once_by_its_title(self):
        index = re.findall(r"^- \[(.*)\]\((.*)\)$", (self.FOLDER / "README.md").read_text(encoding="utf-8"), re.MULTILINE)
        titles = [(re.search(r"^# (.*)$", path.read_text(encoding="utf-8"), re.MULTILINE).group(1), path.name)
                  for path in self.records]
        self.assertGreater(len(titles), 40)
        self.assertEqual(sorted(index), sorted(titles))

    def test_each_says_what_why_how_well_at_what_cost_and_where(self):
        for path in self.records:
            labels = re.findall(r"^\*\*(\w+)\.\*\* \S", path.read_text(encoding="utf-8"), re.MULTILINE)
            self.assertEqual(labels, ["Decided", "Why", "Measured", "Costs", "Where"], path.name)

    def test_every_test_and_experiment_they_name_is_in_the_tree(self):
        exists = test_readme.Bar().exists
        for path in self.records:
            text = path.read_text(encoding="utf-8")
            for name in re.findall(r"`((?:[A-Z]\w+\.[\w*]+|benchmark\.\w+|lab: [a-z-]+))`", " ".join(text.split())):
                if not name.endswith((".h", ".cpp", ".md", ".txt")):
                    self.assertTrue(exists(name.removeprefix("lab: ")), f"{path.name} names {name}")


class Recipes(unittest.TestCase):
    """docs/recipes: the C++ is compiled by testing/recipes; the rest is checked here."""

    FOLDER = ROOT / "docs/recipes"

    def test_every_block_of_cpp_is_a_file_that_is_compiled(self):
        compiled = re.split(r"[\s()]+", (ROOT / "testing/recipes/CMakeLists.txt").read_text(encoding="utf-8"))
        blocks = [block for page in sorted(self.FOLDER.glob("*.md"))
                  for block in re.findall(r"^```cpp\n(.*)$", page.read_text(encoding="utf-8"), re.MULTILINE)]
        self.assertGreater(len(blocks), 8)
        for first_line in blocks:
            self.assertIn(first_line.removeprefix("// "), compiled)

    def read(self, name):
        return (self.FOLDER / name).read_text(encoding="utf-8")

    def listed_and_naming(self, page, *besides):
        """Files of the page's first table, and all that name its setting besides those. No device knows of settings: a
        constant force is a word of USB too."""
        setting = re.search(r"\(`(\w+)`\)", page).group(1)
        option = re.sub("(?<!^)([A-Z])", r"-\1", setting).lower()
        name = re.compile(rf"(?<!set){setting}|--{option}")
        places = [ROOT / "CHANGELOG.md", *(path for folder in FOLDERS for path in (ROOT / folder).rglob("*"))]
        naming = {str(path.relative_to(ROOT)) for path in places
                  if path.suffix in (".h", ".cpp", ".cxx", ".xml", ".py", ".md") and self.FOLDER not in path.parents and "devices" not in path.parts
                  and name.search(path.read_text(encoding="utf-8"))}
        return sorted(re.findall(r"^\| `([^`]+)` \|", page, re.MULTILINE)), sorted(naming - set(besides))

    def test_a_kind_that_is_felt_takes_at_most_20_files_of_which_at_most_6_are_there(self):
        page = self.read("add-a-felt-kind.md")
        listed = set(re.findall(r"^\| \[?`([^`]+)`\]? \|", page, re.MULTILINE))
        shown = set(re.findall(r"^```(?:cpp\n//|diff\n\+\+\+) (.*)$", page, re.MULTILINE))
        self.assertEqual(listed, shown | {"CHANGELOG.md"})
        self.assertLessEqual(len(listed), 20)
        self.assertLessEqual(sum((ROOT / file).exists() for file in listed), 6)

    def test_the_files_of_a_setting_are_all_that_name_it(self):
        listed, naming = self.listed_and_naming(self.read("add-a-setting.md"), "CHANGELOG.md")
        self.assertEqual(listed, naming)

    def test_a_force_with_a_setting_takes_six_files_besides_those_that_are_written_from_the_table(self):
        written = {str(place[0].relative_to(ROOT)) for place in described.PLACES}
        listed, naming = self.listed_and_naming(self.read("add-a-force.md"), *written)
        self.assertEqual(listed, naming)
        self.assertLessEqual(len(listed), 6)

    def test_a_force_stands_in_the_tree_as_the_page_shows_it(self):
        page = self.read("add-a-force.md")
        for name, text in re.findall(r"^```cpp\n// (\S+)\n(.*?)^```$", page, re.DOTALL | re.MULTILINE):
            self.assertEqual((ROOT / name).read_text(encoding="utf-8"), text)
        pieces = re.findall(r"^```diff\n\+{3} (\S+)\n(.*?)^```$", page, re.DOTALL | re.MULTILINE)
        self.assertEqual(len(pieces), 2)
        for name, lines in pieces:
            for line in lines.splitlines():
                self.assertTrue(line.removeprefix("+") + "\n" in (ROOT / name).read_text(encoding="utf-8"), (name, line))


if __name__ == "__main__":
    unittest.main(verbosity=2)
