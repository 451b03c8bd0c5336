#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Small changes to the product's sources, and which of them no test sees. Run by hand; no source is touched.

usage: mutate.py --build build-core --target safety [--count 30] [--seed 1] haptics/safety/ForceLimits.cpp ...

Each mutant changes one operator or one number. A .cpp file is compiled anew and linked, in place of its object, with those
of the build; for a header the target's own test sources are compiled anew, so a header's mutant reaches the test's calls
only. Prints one line a mutant: killed (a test failed), refused (it does not compile) or SURVIVED, then the counts.
"""

import argparse
import json
import random
import re
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SWAPS = {"<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "==", "+": "-", "-": "+", "*": "/", "/": "*",
         "&&": "||", "||": "&&"}
# Operators between blanks, so that templates, pointers and signs are left alone; numbers that stand alone.
PLACES = re.compile(r"(?<= )(<=|>=|==|!=|&&|\|\||[<>+*/-])(?= )|(?<![\w.])(\d+\.\d+|\d+)(?![\w.])")


def mutants_of(path):
    """(path, line number, changed line, whole changed text) for each place outside comments and preprocessor lines."""
    lines = path.read_text(encoding="utf-8").splitlines(keepends=True)
    for number, line in enumerate(lines):
        code = line.split("//")[0]
        if code.lstrip().startswith(("#", "template", "///", "*")):
            continue
        for match in PLACES.finditer(code):
            old = match.group(0)
            new = SWAPS.get(old) or (f"({old} * 1.5)" if "." in old and float(old) != 0.0 else f"({old} + 1)")
            changed = line[: match.start()] + new + line[match.end():]
            yield path, number + 1, changed.strip(), "".join(lines[:number] + [changed] + lines[number + 1:])


class Build:
    """What the build knows: how each file is compiled, what the target is linked from."""

    def __init__(self, folder, target):
        self.folder = folder
        entries = json.loads((folder / "compile_commands.json").read_text(encoding="utf-8"))
        self.commands = {Path(entry["file"]): entry["command"] for entry in entries}
        self.link = self.last_command(target)
        self.core_link = self.last_command("palpate_core")

    def last_command(self, target):
        told = subprocess.run(["ninja", "-C", self.folder, "-t", "commands", target], capture_output=True, text=True, check=True)
        links = [line for line in told.stdout.splitlines() if " -o " in line and " -c " not in line]
        return next(line for line in reversed(links) if re.search(r"-o (lib/libpalpate\.so|bin/)", line))

    def compile(self, source, text_of, output):
        """The object of `source` with some files' text replaced, or None where the compiler refuses."""
        with tempfile.TemporaryDirectory() as overlay:
            for path, text in text_of.items():
                copy = Path(overlay, path.relative_to(ROOT))
                copy.parent.mkdir(parents=True, exist_ok=True)
                copy.write_text(text, encoding="utf-8")
            given = Path(overlay, source.relative_to(ROOT)) if source in text_of else source
            command = re.sub(r" -o \S+ -c \S+$", "", self.commands[source]).replace(" -I", f" -I{overlay} -I", 1)
            command = re.sub(r" -M\w+( \S+\.(?:o|d))?(?= )", "", command)
            words = shlex.split(command) + ["-o", str(output), "-c", str(given)]
            return output if subprocess.run(words, cwd=self.folder, capture_output=True, check=False).returncode == 0 else None

    def objects(self, link):
        return [word for word in shlex.split(link) if word.endswith(".o")]

    def program(self, replaced, output):
        """The target linked statically with the core's objects, some of them replaced; `replaced` maps sources to objects."""
        def object_of(source):
            return re.search(r" -o (\S+)", self.commands[source]).group(1)
        new = {object_of(source): str(path) for source, path in replaced.items()}
        objects = [new.get(o, o) for o in self.objects(self.link) + self.objects(self.core_link)]
        tail = [w for link in (self.link, self.core_link) for w in shlex.split(link)
                if (w.endswith(".a") or re.search(r"\.so(\.|$)", w) or w.startswith("-l")) and "libpalpate." not in w]
        words = ["c++", "-o", str(output), *objects, *tail, "-lpthread"]
        subprocess.run(words, cwd=self.folder, check=True)
        return output


def outcome(build, path, text, tests, folder):
    """killed, refused or SURVIVED."""
    sources = [path] if path in build.commands else tests
    replaced = {source: build.compile(source, {path: text}, folder / f"{source.stem}.o") for source in sources}
    if None in replaced.values():
        return "refused"
    program = build.program(replaced, folder / "mutant")
    try:
        run = subprocess.run([program, "--gtest_brief=1"], capture_output=True, timeout=300, check=False)
    except subprocess.TimeoutExpired:
        return "killed"
    return "SURVIVED" if run.returncode == 0 else "killed"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", type=Path, required=True)
    parser.add_argument("--target", required=True, help="a test program, already built")
    parser.add_argument("--count", type=int, default=30)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("files", nargs="+", type=Path)
    options = parser.parse_args()
    build = Build(options.build.resolve(), options.target)
    own = set(build.objects(build.link))
    tests = [source for source, command in build.commands.items() if re.search(r" -o (\S+)", command).group(1) in own]
    found = [mutant for file in options.files for mutant in mutants_of(file.resolve())]
    chosen = random.Random(options.seed).sample(found, min(options.count, len(found)))
    counts = {"killed": 0, "refused": 0, "SURVIVED": 0}
    with tempfile.TemporaryDirectory() as folder:
        if outcome(build, options.files[0].resolve(), options.files[0].read_text(encoding="utf-8"), tests, Path(folder)) != "SURVIVED":
            sys.exit("mutate: the tests fail on the sources as they are; nothing can be told")
        for path, number, line, text in sorted(chosen, key=lambda mutant: mutant[:2]):
            what = outcome(build, path, text, tests, Path(folder))
            counts[what] += 1
            print(f"{what} {path.relative_to(ROOT)}:{number}: {line}", flush=True)
    print(", ".join(f"{count} {what}" for what, count in counts.items()), f"of {len(found)} places")


if __name__ == "__main__":
    main()
