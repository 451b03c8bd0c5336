# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests that take minutes are done in turn: each commit does one of them, so that as many commits in a row as there are do all.
With PALPATE_TEST_FULL a run does every one."""

import os
import pathlib
import subprocess

HERE = pathlib.Path(__file__).resolve().parent
TURNS = 7  # five shares of the long experiments, then each sanitizer: a commit has time for one


def git(*words):
    """The output of git, or 0 in sources without a history."""
    told = subprocess.run(["git", *words], cwd=HERE, capture_output=True, text=True, check=False)
    return told.stdout.strip() if told.returncode == 0 else "0"


def commit_number():
    """How many commits led to this one; where the history is cut off, the commit's hash as a number."""
    whole = git("rev-parse", "--is-shallow-repository") == "false"
    return int(git("rev-list", "--count", "HEAD")) if whole else int(git("rev-parse", "HEAD"), 16)


def in_turn(shares, first):
    """Those of the shares that this run does: all, or the one whose turn it is, the turns of these beginning at `first`."""
    if os.environ.get("PALPATE_TEST_FULL"):
        return list(shares)
    turn = commit_number() % TURNS - first
    return [shares[turn]] if 0 <= turn < len(shares) else []
