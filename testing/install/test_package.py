# SPDX-License-Identifier: GPL-3.0-or-later
"""The files that `cpack` packs are where Debian's ParaView, python3, man and udev look, and run from there. Unpacked, not
installed: `testing/install/clean_root` installs it into a Debian of its own, uses and removes it."""

import gzip
import os
import re
import sys
import tempfile
import unittest
from pathlib import Path
from xml.etree import ElementTree

import palpate
from installed import BUILD, SOURCE, run_command


class Package(unittest.TestCase):
    """One package, without the slow steps: stripping and looking for the needs of its libraries."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        (SOURCE / "filters/pipeline/python/testing/__pycache__").mkdir(exist_ok=True)  # as a run from the tree leaves it
        run_command("cpack", "--config", BUILD / "CPackConfig.cmake", "-B", folder.name, "-D", "CPACK_STRIP_FILES=OFF",
                    "-D", "CPACK_DEBIAN_PACKAGE_SHLIBDEPS=OFF", "-D", "CPACK_DEBIAN_COMPRESSION_TYPE=none")
        (cls.package,) = Path(folder.name).glob("*.deb")
        cls.root, cls.control = Path(folder.name, "root"), Path(folder.name, "control")
        run_command("dpkg-deb", "-x", cls.package, cls.root)
        run_command("dpkg-deb", "-e", cls.package, cls.control)
        cls.usr = cls.root / "usr"

    def test_its_name_version_and_needs(self):
        field = lambda name: run_command("dpkg-deb", "-f", self.package, name).strip()  # noqa: E731
        self.assertEqual((field("Package"), field("Version")), ("palpate", palpate.__version__))
        series = os.environ["PALPATE_PARAVIEW"]
        for needed in (f"paraview (>= {series})", "python3-paraview", "python3-numpy"):
            self.assertIn(needed, field("Depends"))
        for script in ("preinst", "postinst", "prerm", "postrm"):
            self.assertTrue(os.access(self.control / script, os.X_OK))
            run_command("sh", "-n", self.control / script)

    def test_a_list_of_plugins_of_somebody_s_own_is_neither_overwritten_nor_taken_for_the_package_s(self):
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            listed, database = root / "usr/bin/paraview.conf", root / "var/lib/dpkg/info"
            preinst = lambda code, *words: run_command("sh", self.control / "preinst", *words, code=code, DPKG_ROOT=folder)  # noqa: E731
            listed.parent.mkdir(parents=True)
            preinst(0, "install")
            listed.write_text("mine.xml\n", encoding="utf-8")
            preinst(1, "install")
            preinst(0, "upgrade", "0.0.1")
            database.mkdir(parents=True)
            (database / "palpate.list").write_text("/usr/bin/paraview.conf\n", encoding="utf-8")
            (database.parent / "status").write_text(
                "Package: palpate\nStatus: install ok installed\nArchitecture: all\nMaintainer: nobody\nVersion: 0.0.1\n"
                "Description: one\n", encoding="utf-8")
            preinst(0, "install")

    def test_paraview_is_led_to_the_plugin(self):
        listed = self.usr / "bin" / (self.usr / "bin/paraview.conf").read_text(encoding="utf-8").strip()
        (plugin,) = ElementTree.parse(listed).getroot()
        self.assertEqual((plugin.get("name"), plugin.get("auto_load")), ("Palpate", "1"))
        self.assertTrue((listed.parent / "Palpate/Palpate.so").is_file())
        (later,) = ElementTree.parse(self.usr / "share/paraview/plugins").getroot()  # as ParaView reads it since 5.13
        self.assertEqual((later.get("name"), later.get("auto_load")), ("Palpate", "1"))
        self.assertTrue((self.root / later.get("filename").lstrip("/")).is_file())

    def test_the_program_and_the_regression_test_of_the_guide_run_from_there(self):
        self.assertEqual(run_command(self.usr / "bin/palpate", "--version").split("\n")[0], palpate.__version__)
        script = self.root / "test_ball_unittest.py"
        script.write_bytes((SOURCE / "docs/example/regression/test_ball_unittest.py").read_bytes())
        there = {"PYTHONPATH": str(self.usr / "lib/python3/dist-packages")}
        run_command(sys.executable, script, PALPATE_UPDATE_BASELINES="1", **there)
        run_command(sys.executable, script, **there)

    def test_each_command_has_a_page_that_man_finds(self):
        commands = re.findall(r'add_subcommand\(\s*"(\w+)"', (SOURCE / "ui/cli/palpate.cxx").read_text(encoding="utf-8"))
        self.assertIn("touch", commands)
        pages = {path.name: gzip.decompress(path.read_bytes()).decode() for path in (self.usr / "share/man/man1").iterdir()}
        self.assertEqual(set(pages), {"palpate.1.gz", *(f"palpate-{command}.1.gz" for command in commands)})
        for name, text in pages.items():
            self.assertIn(f".SH NAME\n{name[:-5]} \\- ", text)

    def test_the_guide_that_the_menu_opens_lies_beside_the_gallery(self):
        shared = self.usr / "share/palpate"
        self.assertTrue((shared / "gallery/chartres.vtp").is_file())
        self.assertIn("url=fields.html", (shared / "guide/panel-field.html").read_text(encoding="utf-8"))
        self.assertIn("<h1", (shared / "guide/fields.html").read_text(encoding="utf-8"))

    def test_every_subsystem_of_the_rules_is_triggered_when_the_package_comes_and_goes(self):
        rules = (SOURCE / "devices/udev/70-palpate.rules").read_text()
        subsystems = set(re.findall(r'SUBSYSTEM=="(\w+)"', rules))
        self.assertLessEqual({"hidraw", "usb", "tty"}, subsystems)
        for script in ("postinst", "postrm"):
            triggered = re.findall(r"--subsystem-match=(\w+)", (SOURCE / "plugin/package" / script).read_text())
            self.assertEqual(subsystems - set(triggered), set(), script)

    def test_udev_cmake_and_nothing_elsewhere(self):
        self.assertEqual((self.usr / "lib/udev/rules.d/70-palpate.rules").read_bytes(),
                         (SOURCE / "devices/udev/70-palpate.rules").read_bytes())
        self.assertIn("/lib/python3/dist-packages", (self.usr / "lib/cmake/Palpate/PalpateConfig.cmake").read_text(encoding="utf-8"))
        self.assertEqual([path.name for path in self.root.iterdir() if path.name != "test_ball_unittest.py"
                          and path.suffix != ".json"], ["usr"])
        names = {path.relative_to(self.usr).parts[0] for path in self.usr.rglob("*")}
        self.assertEqual(names, {"bin", "include", "lib", "libexec", "share"})
        text = "".join(str(path) for path in self.usr.rglob("*"))
        self.assertNotIn("__pycache__", text)


if __name__ == "__main__":
    unittest.main(verbosity=2)
