# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes files that a page of docs/recipes shows below a folder.

usage: extract.py PAGE.md FOLDER FILE...

A block of C++ whose first line is a path, `// devices/x/X.h`, is that file; the rest of the block is its text. Exit code 1
and one line where the page does not show one of the files.
"""

import re
import sys
from pathlib import Path

BLOCK = re.compile(r"^```cpp\n// ([\w./-]+\.(?:h|cpp|cxx))\n(.*?)^```$", re.DOTALL | re.MULTILINE)


def main(page, folder, *names):
    shown = dict(BLOCK.findall(Path(page).read_text(encoding="utf-8")))
    for name in names:
        if name not in shown:
            sys.exit(f"{page}: no block of C++ begins with // {name}; give the block that line, or take the file off the test")
        path = Path(folder, name)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(shown[name], encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
