# SPDX-License-Identifier: GPL-3.0-or-later
"""Shared by the tests of the installed product: running a command, and printing its output when it failed."""

import os
import subprocess
from pathlib import Path

SOURCE = Path(os.environ["PALPATE_SOURCE_DIR"])
BUILD = Path(os.environ["PALPATE_BUILD_DIR"])


def run_command(*words, code=0, **more):
    """Its output; AssertionError unless it ends with that exit code."""
    done = subprocess.run(list(map(str, words)), capture_output=True, text=True, check=False, env={**os.environ, **more})
    if done.returncode != code:
        raise AssertionError(f"{' '.join(map(str, words))}: {done.returncode}\n{done.stdout[-4000:]}{done.stderr[-2000:]}")
    return done.stdout
