# SPDX-License-Identifier: GPL-3.0-or-later
"""data/get against packages made here; a stand-in for apt-get hands them out."""

import gzip
import hashlib
import importlib.machinery
import importlib.util
import io
import os
import subprocess
import tarfile
import tempfile
import unittest
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path

ROOT = Path(os.environ.get("PALPATE_SOURCE_DIR") or Path(__file__).resolve().parents[2])
APT_GET = """#!/bin/sh
# Stand-in: `apt-get download NAME` copies NAME.deb from the folder beside it and counts the call.
[ "$1" = update ] && exit 100
echo "$2" >> "{folder}/downloads"
cp "{folder}/$2.deb" . 2> /dev/null || {{ echo "E: no network" >&2; exit 100; }}
"""


def load_get():
    """data/get as a module."""
    loader = importlib.machinery.SourceFileLoader("get", str(ROOT / "data" / "get"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("get", loader))
    loader.exec_module(module)
    return module


def make_tar(members):
    buffer = io.BytesIO()
    with tarfile.open(fileobj=buffer, mode="w:gz") as archive:
        for name, content in members.items():
            entry = tarfile.TarInfo(name)
            entry.size = len(content)
            archive.addfile(entry, io.BytesIO(content))
    return buffer.getvalue()


class Get(unittest.TestCase):
    """Everything a person can meet when fetching data."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.cache = self.folder / "cache"
        apt_get = self.folder / "apt-get"
        apt_get.write_text(APT_GET.format(folder=self.folder), encoding="utf-8")
        apt_get.chmod(0o755)
        before = dict(os.environ)
        self.addCleanup(lambda: (os.environ.clear(), os.environ.update(before)))
        os.environ["PATH"] = f"{self.folder}:{os.environ['PATH']}"
        os.environ["PALPATE_DATA"] = str(self.cache)
        self.get = load_get()
        self.get.SOURCES = {}

    def make_package(self, package, files):
        tree = self.folder / package
        (tree / "DEBIAN").mkdir(parents=True)
        control = f"Package: {package}\nVersion: 1\nArchitecture: all\nMaintainer: a <a@b.c>\nDescription: d\n"
        (tree / "DEBIAN" / "control").write_text(control, encoding="utf-8")
        for name, content in files.items():
            path = tree / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(content)
        target = self.folder / f"{package}.deb"
        subprocess.run(["dpkg-deb", "-b", str(tree), str(target)], check=True, capture_output=True)

    def add(self, name, package, path, member, file, content):
        digest = hashlib.sha256(content).hexdigest()
        self.get.SOURCES[name] = self.get.Source(package, path, member, file, digest)

    def call(self, *names):
        """(exit code, printed paths, messages)."""
        out, messages = io.StringIO(), io.StringIO()
        with redirect_stdout(out), redirect_stderr(messages):
            code = self.get.main(list(names))
        return code, out.getvalue().split(), messages.getvalue()

    def downloads(self):
        log = self.folder / "downloads"
        return log.read_text(encoding="utf-8").split() if log.exists() else []

    def add_three(self):
        """A gzipped file, a file that stays gzipped, and a member of an archive, in one package."""
        packed = gzip.compress(b"image")
        files = {"usr/a.stl.gz": gzip.compress(b"solid"), "usr/b.nii.gz": packed, "usr/c.tar.gz": make_tar({"m/c.off": b"OFF"})}
        self.make_package("pack", files)
        self.add("a", "pack", "usr/a.stl.gz", "", "a.stl", b"solid")
        self.add("b", "pack", "usr/b.nii.gz", "", "b.nii.gz", packed)
        self.add("c", "pack", "usr/c.tar.gz", "m/c.off", "c.off", b"OFF")
        return {"a.stl": b"solid", "b.nii.gz": packed, "c.off": b"OFF"}

    def test_all_files_of_a_package_come_out_plain_with_one_download(self):
        expected = self.add_three()
        code, paths, _ = self.call("all")
        self.assertEqual((code, paths), (0, [str(self.cache / name) for name in expected]))
        self.assertEqual({name: (self.cache / name).read_bytes() for name in expected}, expected)
        self.assertEqual(self.downloads(), ["pack"])
        self.assertEqual(sorted(path.name for path in self.cache.iterdir()), sorted(expected))

    def test_a_cached_file_is_not_downloaded_again(self):
        self.add_three()
        self.call("a")
        self.assertEqual(self.call("a")[0], 0)
        self.assertEqual(self.downloads(), ["pack"])

    def test_a_damaged_cached_file_is_replaced(self):
        self.add_three()
        self.call("a")
        (self.cache / "a.stl").write_bytes(b"sol")
        code, _, messages = self.call("a")
        self.assertEqual(code, 0)
        self.assertIn("a.stl is damaged", messages)
        self.assertEqual((self.cache / "a.stl").read_bytes(), b"solid")

    def test_a_package_with_another_content_is_refused_and_nothing_is_left(self):
        self.add_three()
        self.add("a", "pack", "usr/a.stl.gz", "", "a.stl", b"expected")
        code, paths, messages = self.call("a")
        self.assertEqual((code, paths), (1, []))
        self.assertIn(hashlib.sha256(b"solid").hexdigest(), messages)
        self.assertEqual(list(self.cache.iterdir()), [])

    def test_without_a_network_one_line_says_so(self):
        self.add("x", "absent", "usr/x", "", "x", b"")
        code, _, messages = self.call("x")
        self.assertEqual(code, 1)
        self.assertIn("package absent cannot be downloaded (E: no network)", messages.splitlines()[-1])

    def test_a_package_without_the_file_or_the_member_is_named(self):
        self.add_three()
        self.add("x", "pack", "usr/x", "", "x", b"")
        self.add("y", "pack", "usr/c.tar.gz", "m/y.off", "y.off", b"")
        self.assertIn("pack has no usr/x", self.call("x")[2])
        self.assertIn("holds no m/y.off", self.call("y")[2])

    def test_a_cache_that_cannot_be_made_is_named(self):
        self.add_three()
        (self.folder / "file").write_bytes(b"")
        os.environ["PALPATE_DATA"] = str(self.folder / "file" / "cache")
        code, _, messages = self.call("a")
        self.assertEqual(code, 1)
        self.assertIn("PALPATE_DATA", messages)

    def test_an_unknown_name_lists_the_known_ones(self):
        self.add_three()
        code, _, messages = self.call("a", "zebra")
        self.assertEqual(code, 2)
        self.assertIn("unknown name 'zebra': one of a, b, c, all", messages)
        self.assertEqual(self.downloads(), [])

    def test_the_table_in_the_readme_has_every_checksum(self):
        readme = (ROOT / "data" / "README.md").read_text(encoding="utf-8")
        for name, source in load_get().SOURCES.items():
            self.assertIn(f"| {source.file} | `{source.sha256}` |", readme, name)


if __name__ == "__main__":
    unittest.main(verbosity=2)
