# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests that take minutes are done in turn: each commit does one share, so that as many commits in a row as there are shares
do all of them. With PALPATE_TEST_FULL a run does every share."""

import os
import pathlib
import subprocess

HERE = pathlib.Path(__file__).resolve().parent


def git(*words):
    """What git says, or 0 in sources without a history."""
    told = subprocess.run(["git", *words], cwd=HERE, capture_output=True, text=True, check=False)
    return told.stdout.strip() if told.returncode == 0 else "0"


def commit_number():
    """How many commits led to this one; where the history is cut off, the commit's hash as a number."""
    whole = git("rev-parse", "--is-shallow-repository") == "false"
    return int(git("rev-list", "--count", "HEAD")) if whole else int(git("rev-parse", "HEAD"), 16)


def shares_of_this_run(shares):
    """Those of the shares that this run does: a list of one, or of all of them."""
    if os.environ.get("PALPATE_TEST_FULL"):
        return list(shares)
    return [shares[commit_number() % len(shares)]]
