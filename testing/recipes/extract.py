# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the files that a page of docs/recipes shows below a folder.

usage: extract.py PAGE.md FOLDER

A block of C++ whose first line is a path, `// devices/x/X.h`, is that file; the rest of the block is its text.
"""

import re
import sys
from pathlib import Path

BLOCK = re.compile(r"^```cpp\n// ([\w./-]+\.(?:h|cpp|cxx))\n(.*?)^```$", re.DOTALL | re.MULTILINE)


def main(page, folder):
    for name, text in BLOCK.findall(Path(page).read_text(encoding="utf-8")):
        path = Path(folder, name)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
