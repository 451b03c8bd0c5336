# SPDX-License-Identifier: GPL-3.0-or-later
"""The guide as HTML: every page is there, every link leads to a page and a heading, every function has its docstring."""

import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SOURCE = Path(os.environ["PALPATE_SOURCE_DIR"])
STATES = ("skull", "brain", "soft-brain", "spatula", "stone", "wire", "flow", "labyrinth")


class Pages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder, made = Path(folder.name, "guide"), Path(folder.name, "made")
        made.mkdir()
        data = Path(folder.name, "data")
        for name in STATES:
            (made / f"{name}.pvsm").write_text(f'<Element index="0" value="{data}/{name}.vtp"/>', encoding="utf-8")
        subprocess.run([sys.executable, SOURCE / "docs/guide/make.py", cls.folder, made], check=True,
                       env={**os.environ, "PALPATE_DATA": str(data)})
        cls.pages = {path.name: path.read_text(encoding="utf-8") for path in cls.folder.glob("*.html")}

    def test_every_link_leads_to_a_page_and_a_heading_and_no_page_is_left_alone(self):
        met = {"index.html"}
        for name, text in self.pages.items():
            for target, anchor in re.findall(r'href="(?!https?:)([^"#]*)(?:#([^"]*))?"', text):
                if target.endswith(".pvsm"):
                    continue
                met.add(target or name)
                self.assertIn(target or name, self.pages, name)
                if anchor:
                    self.assertIn(f'id="{anchor}"', self.pages[target or name], (name, target))
        self.assertEqual(met, {name for name in self.pages if not name.startswith("panel-")})

    def test_each_page_of_the_panel_has_a_file_that_leads_to_a_page_and_a_heading_of_the_guide(self):
        panel = (SOURCE / "ui/panel/pqHapticPanel.cxx").read_text(encoding="utf-8")
        names = re.findall(r'page\("(\w+)", tr\(', panel)
        self.assertEqual(len(names), 13)
        self.assertEqual({f"panel-{name}.html" for name in names}, {name for name in self.pages if name.startswith("panel-")})
        for name in names:
            (target,) = re.findall(r'content="0; url=([^"]*)"', self.pages[f"panel-{name}.html"])
            page, _, anchor = target.partition("#")
            self.assertGreater(len(self.pages[page]), 1000, name)
            self.assertIn(f'id="{anchor}"' if anchor else "<h1", self.pages[page], name)

    def test_each_tutorial_links_its_state_file_which_names_its_data_as_the_script_does(self):
        for name in STATES:
            self.assertIn(f'href="pictures/{name}.pvsm"', self.pages[f"guide-{name}.html"])
            self.assertEqual((self.folder / f"pictures/{name}.pvsm").read_text(encoding="utf-8"),
                             f'<Element index="0" value="data/cache/{name}.vtp"/>')

    def test_every_picture_is_there(self):
        pictures = [picture for text in self.pages.values() for picture in re.findall(r'src="([^"]*)"', text)]
        self.assertGreater(len(pictures), 4)
        for picture in pictures:
            self.assertTrue((self.folder / picture).is_file(), picture)

    def test_the_api_says_what_each_public_function_says(self):
        text = self.pages["guide-api.html"]
        for name in ("assert_feels_the_same", "jnd", "Touch", "SetHaptics", "HoldTool"):
            self.assertIn(f"<code>{name}(", text)


if __name__ == "__main__":
    unittest.main(verbosity=2)
