# SPDX-License-Identifier: GPL-3.0-or-later
"""clang-tidy enforces the names of each layer, and would catch the wrong ones.

usage: test_naming.py tree        all headers of every layer that this build compiles; with PALPATE_TEST_FULL=1 in the
                                  environment every source file too (minutes)
       test_naming.py examples    each layer's .clang-tidy on names it must accept and names it must refuse

Names are the plain C++ ones in haptics/ and devices/, VTK's in filters/, ui/cli/ and plugin/, ParaView's Qt ones in ui/.
"""

import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import rules

ROOT = Path(os.environ.get("PALPATE_SOURCE_DIR") or Path(__file__).resolve().parents[2])
BUILD = Path(os.environ.get("PALPATE_BUILD_DIR") or ROOT / "build")
# Headers of one group are read at once, as most of the time goes into those of libraries; clang-tidy judges each header by the
# .clang-tidy of its own folder.
TOGETHER = [["haptics", "devices"], ["filters/pipeline", "filters/interaction", "filters/views", "ui/cli", "ui", "plugin"]]
PLACES = [place for group in TOGETHER for place in group]

ACCEPTED = {
    "haptics": """
        namespace palpate {
        struct Pose { double length_m = 0; int wallCount = 0; };
        class ForceRenderer {
        public:
          void tick(double stiffness_N_per_m);
        private:
          double gap_ = 0;
          double normal_W_ = 0;
        };
        }""",
    "filters": """
        class vtkHapticThing {
        public:
          void SetStiffness(double stiffness);
          double Radius;
        private:
          int Count;
        };
        void vtkHapticRead(int value);""",
    "ui": """
        class pqHapticThing {
        public:
          void setStiffness(double stiffness);
        private:
          int Count;
        };""",
}
REFUSED = {
    "haptics": """
        class force_renderer {
        public:
          void Tick(double Stiffness);
        private:
          double gap;
        };
        namespace Palpate { enum class Fault { not_a_fault }; }""",
    "filters": """
        class HapticThing {};
        class vtkThing {
        public:
          void setStiffness(double Stiffness);
        private:
          int count_;
        };""",
    "ui": """
        class vtkHapticThing {
        public:
          void SetStiffness(double Stiffness);
        private:
          int count_;
        };""",
}
REFUSED_NAMES = {
    "haptics": {"force_renderer", "Tick", "Stiffness", "gap", "Palpate", "not_a_fault"},
    "filters": {"vtkThing", "setStiffness", "Stiffness", "count_"},
    "ui": {"vtkHapticThing", "SetStiffness", "Stiffness", "count_"},
}
ALIAS = {"devices": "haptics", "ui/cli": "filters", "plugin": "filters"}
FINDING = re.compile(r"^.*invalid case style for .*$|^.*error: .*$", re.MULTILINE)


def tidy(source, flags, header_filter="^$"):
    """Findings and compile errors of clang-tidy for one file."""
    command = ["clang-tidy", "--quiet", f"--header-filter={header_filter}", str(source), "--", *flags]
    result = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    return FINDING.findall(result.stdout + result.stderr)


def sources_in(path):
    """The sources of the project that are compiled with a file: itself, or those that a file of several sources includes."""
    together = path.is_relative_to(BUILD) and path.parent.name == "Unity"
    named = re.findall(r'^#include "(.+)"$', path.read_text(encoding="utf-8"), re.MULTILINE) if together else [str(path)]
    return [Path(name) for name in named if Path(name).is_relative_to(ROOT) and not Path(name).is_relative_to(BUILD)]


def compile_flags():
    """Flags of each compiled source of the project, by its path relative to the root; only those that clang-tidy needs."""
    flags = {}
    for entry in json.loads((BUILD / "compile_commands.json").read_text(encoding="utf-8")):
        for path in sources_in(Path(entry["file"])):
            words = shlex.split(entry["command"])
            kept, following = ["-x", "c++"], False
            for word in words:
                if following or word.startswith(("-I", "-D", "-std=", "-isystem")):
                    kept.append(word)
                following = word == "-isystem"
            flags[path.relative_to(ROOT)] = kept
    return flags


def place_of(relative):
    """The most precise of PLACES that holds the file, or None."""
    return max((p for p in PLACES if relative.is_relative_to(p)), key=len, default=None)


class Tree(unittest.TestCase):
    """The project's own names."""

    header_filter = f"^{re.escape(str(ROOT))}/({'|'.join(rules.LAYERS[:-1])})/"

    def tidy_headers(self, places, by_place):
        """With the flags of all of the places that are compiled."""
        headers = [r for _, r, _ in rules.code_files(ROOT) if r.suffix == ".h" and place_of(r) in places and place_of(r) in by_place]
        flags = [flag for place in places for flag in by_place.get(place, [])]
        with tempfile.TemporaryDirectory(dir=BUILD) as folder:
            unit = Path(folder, "headers.cpp")
            unit.write_text("".join(f'#include "{ROOT / header}"\n' for header in headers), encoding="utf-8")
            return tidy(unit, flags, self.header_filter)

    def test_every_name_follows_its_layer(self):
        flags = compile_flags()
        # A small program of its own that includes nothing of the project says nothing of headers.
        by_place = {place_of(source): flags[source] for source in flags if place_of(source) and f"-I{ROOT}" in flags[source]}
        self.assertIn("haptics", by_place, "no source of haptics in compile_commands.json")
        with_headers = {place_of(relative) for _, relative, _ in rules.code_files(ROOT) if relative.suffix == ".h"} - {None}
        compiled = {place_of(source) for source in flags if place_of(source) in with_headers}
        self.assertEqual(compiled - set(by_place), set(), "places whose headers no flags find, though their sources are compiled")
        print("places:", ", ".join(by_place), file=sys.stderr)
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            jobs = [pool.submit(self.tidy_headers, places, by_place) for places in TOGETHER if by_place.keys() & set(places)]
            if os.environ.get("PALPATE_TEST_FULL"):
                sources = [source for source in flags if place_of(source)]
                jobs += [pool.submit(tidy, ROOT / source, flags[source], self.header_filter) for source in sources]
            found = sorted({line for job in jobs for line in job.result()})
        self.assertEqual(found, [], "\n".join(found))


class Examples(unittest.TestCase):
    """Each layer's .clang-tidy on a few names."""

    def findings(self, place, text):
        with tempfile.TemporaryDirectory() as folder:
            shutil.copy(ROOT / ".clang-tidy", folder)
            layer = Path(folder, place)
            layer.mkdir(parents=True)
            if (ROOT / place / ".clang-tidy").exists():
                shutil.copy(ROOT / place / ".clang-tidy", layer)
            source = layer / "example.cpp"
            source.write_text(text, encoding="utf-8")
            return tidy(source, ["-std=c++20"])

    def test_names_of_the_layer_pass(self):
        for place in ("haptics", "devices", "filters", "ui", "ui/cli", "plugin"):
            with self.subTest(place=place):
                self.assertEqual(self.findings(place, ACCEPTED[ALIAS.get(place, place)]), [])

    def test_names_of_another_layer_are_refused(self):
        for place in ("haptics", "devices", "filters", "ui", "ui/cli", "plugin"):
            with self.subTest(place=place):
                lines = "\n".join(self.findings(place, REFUSED[ALIAS.get(place, place)]))
                self.assertEqual(set(re.findall(r"'(\w+)'", lines)), REFUSED_NAMES[ALIAS.get(place, place)])


if __name__ == "__main__":
    SUITE = {"tree": "Tree", "examples": "Examples"}[sys.argv.pop(1)]
    unittest.main(defaultTest=SUITE, verbosity=2)
