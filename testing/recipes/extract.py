# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes files that a page of docs/recipes shows below a folder.

usage: extract.py PAGE.md FOLDER FILE...

A block of C++ whose first line is a path, `// devices/x/X.h`, is that file; the rest of the block is its text. A block of
JSON has its path behind the word json. A file that the page changes by a block of diff is that of the source tree, with the
change: a line that begins with a blank says where, one with - is taken out, one with + put in after it. Exit code 1 and one
line where the page does not show one of the files, or a line that it changes is not there.
"""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BLOCK = re.compile(r"^```cpp\n// ([\w./-]+\.(?:h|cpp|cxx))\n(.*?)^```$", re.DOTALL | re.MULTILINE)
JSON = re.compile(r"^```json ([\w./-]+\.json)\n(.*?)^```$", re.DOTALL | re.MULTILINE)
CHANGE = re.compile(r"^```diff\n\+\+\+ ([\w./-]+)\n(.*?)^```$", re.DOTALL | re.MULTILINE)


def changed(name, change):
    """The file of that name with a change."""
    lines = (ROOT / name).read_text(encoding="utf-8").splitlines()
    at = 0
    for line in change.splitlines():
        sign, text = line[:1], line[1:]
        if sign == "+":
            lines.insert(at, text)
        elif text in lines[at:]:
            at = lines.index(text, at)
            if sign == "-":
                del lines[at]
                continue
        else:
            sys.exit(f"{name} has no line '{text}' any more: the page changes it")
        at += 1
    return "\n".join(lines) + "\n"


def main(page, folder, *names):
    text = Path(page).read_text(encoding="utf-8")
    shown, changes = dict(BLOCK.findall(text) + JSON.findall(text)), dict(CHANGE.findall(text))
    for name in names:
        if name not in shown and name not in changes:
            sys.exit(f"{page}: no block of C++ begins with // {name} and none of JSON is named so; "
                     "name the block, or take the file off the test")
        path = Path(folder, name)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(shown[name] if name in shown else changed(name, changes[name]), encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
