# SPDX-License-Identifier: GPL-3.0-or-later
"""The tree keeps the rules of the house, and each rule catches its fault.

usage: test_rules.py tree      the project's own tree
       test_rules.py rules     each rule on small good and bad examples
"""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import rules

SPDX = "// SPDX-License-Identifier: GPL-3.0-or-later\n"


class Tree(unittest.TestCase):
    """The project itself."""

    root = Path(os.environ.get("PALPATE_SOURCE_DIR") or Path(__file__).resolve().parents[2])

    def test_the_walk_sees_the_tree(self):
        layers = {layer for _, _, layer in rules.code_files(self.root)}
        self.assertLessEqual({"haptics", "filters", "ui", "testing"}, layers)

    def test_the_tree_keeps_every_rule(self):
        for rule in rules.ALL:
            with self.subTest(rule=rule.__name__):
                found = rule(self.root)
                self.assertEqual(found, [], f"{rule.__doc__}\n" + "\n".join(found))


class Rules(unittest.TestCase):
    """Every rule on examples: one that passes, and those that must not."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def write_including(self, name, *includes):
        self.write(name, SPDX + "".join(f"#include {include}\n" for include in includes))

    def found(self, rule):
        return [line.split(":")[0] for line in rule(self.root)]

    def test_includes_to_the_left_pass(self):
        self.write_including("haptics/core/Types.h")
        self.write_including("devices/Hand.cpp", '"haptics/core/Types.h"')
        self.write_including("filters/pipeline/vtkHapticThing.h", '"vtkHapticPipelineModule.h"', '"haptics/core/Types.h"')
        self.write_including("filters/views/vtkHapticScan.cxx", '"vtkHapticThing.h"')
        self.write_including("ui/pqHapticPanel.cxx", '"vtkHapticThing.h"', "<QWidget>")
        self.write_including("testing/haptics/TestTypes.cpp", '"haptics/core/Types.h"', "<CGAL/AABB_tree.h>")
        self.assertEqual(rules.map_rule(self.root) + rules.forbidden_libraries(self.root), [])

    def test_an_include_to_the_right_is_found(self):
        self.write_including("devices/Hand.h")
        self.write_including("haptics/core/Types.h", '"devices/Hand.h"')
        self.assertEqual(self.found(rules.map_rule), ["haptics/core/Types.h"])

    def test_an_include_to_the_right_by_plain_name_is_found(self):
        self.write_including("ui/pqHapticPanel.h")
        self.write_including("filters/views/vtkHapticScan.cxx", '"pqHapticPanel.h"')
        self.assertEqual(self.found(rules.map_rule), ["filters/views/vtkHapticScan.cxx"])

    def test_an_include_to_the_right_by_a_relative_path_is_found(self):
        self.write_including("devices/Hand.h")
        self.write_including("haptics/core/Types.h", '"../../devices/Hand.h"')
        self.assertEqual(self.found(rules.map_rule), ["haptics/core/Types.h"])

    def test_an_earlier_filter_module_must_not_include_a_later_one(self):
        self.write_including("filters/interaction/vtkHapticSession.h")
        self.write_including("filters/pipeline/vtkHapticThing.cxx", '"vtkHapticSession.h"', '"vtkHapticViewsModule.h"')
        self.assertEqual(self.found(rules.map_rule), ["filters/pipeline/vtkHapticThing.cxx"] * 2)

    def test_nothing_includes_testing(self):
        self.write_including("testing/support/Meshes.h")
        self.write_including("plugin/Register.cxx", '"testing/support/Meshes.h"')
        self.write_including("ui/pqHapticPanel.cxx", '"Meshes.h"')
        self.assertEqual(self.found(rules.map_rule), ["plugin/Register.cxx", "ui/pqHapticPanel.cxx"])

    def test_a_folder_is_full_with_one_source_more_than_the_limit(self):
        for number in range(rules.MOST_SOURCES):
            self.write(f"haptics/room/a{number}.{'h' if number % 2 else 'cpp'}", SPDX)
            self.write(f"testing/room/a{number}.cpp", SPDX)
        self.write("haptics/room/CMakeLists.txt", SPDX)
        self.write("haptics/room/inner/b.cpp", SPDX)
        self.write("testing/room/one-more.cpp", SPDX)
        self.assertEqual(rules.full_rooms(self.root), [])
        self.write("haptics/room/one-more.cpp", SPDX)
        self.assertEqual(self.found(rules.full_rooms), ["haptics/room"])

    def test_a_file_is_long_with_one_line_more_than_the_limit(self):
        self.write("ui/pqHapticPanel.cxx", "\n" * rules.MOST_LINES)
        self.write("testing/TestTypes.cpp", "\n" * (rules.MOST_LINES + 1))
        self.assertEqual(rules.long_files(self.root), [])
        self.write("ui/pqHapticPanel.cxx", "\n" * (rules.MOST_LINES + 1))
        self.assertEqual(self.found(rules.long_files), ["ui/pqHapticPanel.cxx"])

    def test_the_header_of_the_session_has_a_limit_of_its_own(self):
        name = "filters/interaction/session/vtkHapticSession.h"
        self.write(name, "\n" * rules.MOST_LINES_OF[name])
        self.assertEqual(rules.long_files(self.root), [])
        self.write(name, "\n" * (rules.MOST_LINES_OF[name] + 1))
        self.assertEqual(self.found(rules.long_files), [name])

    def test_a_header_is_heavy_with_one_header_more_behind_it_than_the_limit(self):
        chain = [f"haptics/core/H{number}.h" for number in range(rules.MOST_PULLED + 2)]
        for header, behind in zip(chain, chain[1:]):
            self.write_including(header, f'"{behind}"')
        self.write_including(chain[-1])
        self.assertEqual(self.found(rules.heavy_headers), [chain[0]])
        self.write_including(str(rules.LIST_OF_STAGES), f'"{chain[-1]}"')
        self.assertEqual(rules.heavy_headers(self.root), [])

    def test_a_chain_of_includes_and_two_ways_to_one_header_are_no_circle(self):
        self.write_including("haptics/core/Types.h")
        self.write_including("haptics/force/Spring.h", '"haptics/core/Types.h"')
        self.write_including("haptics/force/Spring.cpp", '"haptics/force/Spring.h"', '"haptics/core/Types.h"')
        self.write_including("haptics/tick/Tick.h", '"haptics/force/Spring.h"', '"haptics/core/Types.h"')
        self.assertEqual(rules.include_circles(self.root), [])

    def test_files_that_include_one_another_are_found_once(self):
        self.write_including("haptics/core/A.h", '"haptics/core/B.h"')
        self.write_including("haptics/core/B.h", '"haptics/core/C.h"')
        self.write_including("haptics/core/C.h", '"haptics/core/A.h"')
        self.write_including("haptics/core/D.h", '"haptics/core/A.h"')
        self.assertEqual(self.found(rules.include_circles), ["haptics/core/A.h"])

    def test_folders_that_include_one_another_are_found_though_no_file_does(self):
        self.write_including("filters/views/readers/vtkHapticGuard.h")
        self.write_including("filters/views/readers/vtkHapticReader.cxx", '"vtkHapticDrawing.h"')
        self.write_including("filters/views/drawings/vtkHapticDrawing.h")
        self.write_including("filters/views/drawings/vtkHapticDrawing.cxx", '"vtkHapticGuard.h"')
        self.assertEqual(self.found(rules.include_circles), ["filters/views/drawings"])

    def test_a_folder_and_the_room_within_it_that_include_one_another_are_found(self):
        self.write_including("haptics/field/FieldBlock.h")
        self.write_including("haptics/field/FieldProxy.cpp", '"haptics/field/iso/IsoProxy.h"')
        self.write_including("haptics/field/iso/IsoProxy.h", '"haptics/field/FieldBlock.h"')
        self.assertEqual(self.found(rules.include_circles), ["haptics/field"])

    def test_cgal_is_found_in_any_header_and_outside_haptics(self):
        self.write_including("haptics/geometry/Tree.cpp", "<CGAL/AABB_tree.h>")
        self.write_including("haptics/geometry/Tree.h", "<CGAL/AABB_tree.h>")
        self.write_including("filters/pipeline/vtkHapticThing.cxx", "<CGAL/AABB_tree.h>")
        self.assertEqual(
            self.found(rules.forbidden_libraries), ["filters/pipeline/vtkHapticThing.cxx", "haptics/geometry/Tree.h"]
        )

    def test_cholmod_is_found_in_any_header_and_outside_haptics(self):
        self.write_including("haptics/compliance/Factor.cpp", "<cholmod.h>")
        self.write_including("haptics/compliance/Factor.h", "<cholmod.h>")
        self.write_including("devices/Hand.cpp", "<suitesparse/cholmod.h>")
        self.assertEqual(self.found(rules.forbidden_libraries), ["devices/Hand.cpp", "haptics/compliance/Factor.h"])

    def test_vtk_qt_and_hidapi_are_found_in_haptics(self):
        for include in ('"vtkPolyData.h"', "<QWidget>", "<QtCore/QObject>", '"pqView.h"', "<hidapi/hidapi.h>"):
            with self.subTest(include=include):
                self.write_including("haptics/core/Types.h", include)
                self.assertEqual(self.found(rules.forbidden_libraries), ["haptics/core/Types.h"])

    def test_qt_is_found_in_filters_and_paraview_in_what_works_without_it(self):
        self.write_including("filters/views/vtkHapticScan.cxx", "<QTimer>", '"vtkSMProxy.h"')
        self.write_including("filters/pipeline/vtkHapticThing.cxx", '"vtkSMProxy.h"')
        self.write_including("filters/pipeline/vtkHapticThreads.cxx", '"vtkSMPTools.h"')  # VTK's threads
        self.assertEqual(
            self.found(rules.forbidden_libraries), ["filters/pipeline/vtkHapticThing.cxx", "filters/views/vtkHapticScan.cxx"]
        )

    def test_an_extension_of_the_other_layer_is_found(self):
        for name in ("haptics/a.h", "haptics/a.cpp", "ui/b.h", "ui/b.cxx", "testing/c.cpp", "testing/d.cxx"):
            self.write(name, SPDX)
        self.assertEqual(rules.extensions(self.root), [])
        for name in ("devices/wrong.cxx", "filters/wrong.cpp", "haptics/wrong.hpp"):
            self.write(name, SPDX)
        self.assertEqual(self.found(rules.extensions), ["devices/wrong.cxx", "filters/wrong.cpp", "haptics/wrong.hpp"])

    def test_a_missing_licence_line_is_found(self):
        self.write("haptics/a.h", SPDX)
        self.write("script", "#!/bin/sh\n# SPDX-License-Identifier: GPL-3.0-or-later\n")
        self.write("events.xml", "<pqevents>\n  <!-- SPDX-License-Identifier: GPL-3.0-or-later -->\n</pqevents>\n")
        self.write("notes.txt", "no code\n")
        self.assertEqual(rules.spdx_line(self.root), [])
        self.write("haptics/b.cpp", "int b;\n")
        self.write("haptics/CMakeLists.txt", "# sources\n")
        self.write("other", "#!/bin/sh\necho\n")
        self.write("empty.py", "")
        self.write("bare.xml", "<pqevents/>\n")
        self.write("late.py", "import os\n# SPDX-License-Identifier: GPL-3.0-or-later\n")
        self.assertEqual(self.found(rules.spdx_line), ["bare.xml", "empty.py", "haptics/CMakeLists.txt", "haptics/b.cpp", "late.py", "other"])

    def test_a_path_of_a_machine_and_a_registry_are_found(self):
        self.write("README.md", "see build/lib, https://example.org/home/page and ../tmp/x\n")
        self.assertEqual(rules.text_of_the_project(self.root), [])
        self.write("a.py", "open('/" + "tmp/x')\n")
        self.write("b.md", "in /" + "home/me\n")
        self.write("c.sh", "curl deb.debian" + ".org\n")
        self.assertEqual(self.found(rules.text_of_the_project), ["a.py", "b.md", "c.sh"])

    def test_build_trees_and_caches_are_not_looked_at(self):
        self.write("build-asan/haptics/wrong.hpp", "")
        self.write("data/cache/x.py", "")
        self.assertEqual([line for rule in rules.ALL for line in rule(self.root)], [])

    def test_in_a_repository_only_what_is_tracked_is_looked_at(self):
        self.write("haptics/wrong.hpp", SPDX)
        self.write("haptics/stray.hpp", SPDX)
        for arguments in (["init", "-q"], ["add", "haptics/wrong.hpp"]):
            subprocess.run(["git", *arguments], cwd=self.root, check=True, capture_output=True)
        self.assertEqual(self.found(rules.extensions), ["haptics/wrong.hpp"])


if __name__ == "__main__":
    SUITE = {"tree": "Tree", "rules": "Rules"}[sys.argv.pop(1)]
    unittest.main(defaultTest=SUITE, verbosity=2)
