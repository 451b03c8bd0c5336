# SPDX-License-Identifier: GPL-3.0-or-later
"""The commands that a page of the documentation gives, to be run as they stand there."""

import os
from pathlib import Path


def commands(page, title):
    """The indented text below a heading of docs/`page`."""
    text = (Path(os.environ["PALPATE_SOURCE_DIR"]) / "docs" / page).read_text(encoding="utf-8")
    section = text.split(f"\n## {title}\n")[1].split("\n## ")[0]
    return "\n".join(line[4:] for line in section.splitlines() if line.startswith("    "))
