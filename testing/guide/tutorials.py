# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the tutorials of docs/guide: tutorials.py FOLDER (pvpython). Pictures and state files are left there."""

import io
import os
import re
import sys
from contextlib import chdir, redirect_stdout
from pathlib import Path

from paraview import simple

GUIDE = Path(__file__).resolve().parents[2] / "docs/guide"
NAMES = ("skull", "brain", "soft-brain", "spatula", "stone", "wire", "flow", "labyrinth")
DATA = {"skull": "skull.vtp", "brain": "brain.nii.gz", "soft-brain": "brain.nii.gz"}


def present():
    """Those whose data are there."""
    folder = Path(os.environ["PALPATE_DATA"])
    return [name for name in NAMES if name not in DATA or (folder / DATA[name]).is_file()]


def play(name, folder):
    """The output of a tutorial."""
    script = re.search(r"^```python\n(.*?)^```$", (GUIDE / f"{name}.md").read_text(encoding="utf-8"), re.DOTALL | re.MULTILINE)[1]
    simple.ResetSession()
    with chdir(folder), redirect_stdout(io.StringIO()) as said:
        exec(compile(script, f"{name}.md", "exec"), {"__name__": name})  # the page itself is the program
    return said.getvalue()


if __name__ == "__main__":
    for tutorial in present():
        print(f"{tutorial}: {play(tutorial, sys.argv[1])}", end="")
