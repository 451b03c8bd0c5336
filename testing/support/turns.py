# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests that take minutes are done in turn: each commit does one share of them, so that as many commits in a row as there are turns
do all. With PALPATE_TEST_FULL a run does every one.

usage: turns.py label     prints the label of the slow tests that this commit does: those of IN_TURN in testing/cmake/PalpateTests.cmake
       turns.py others    prints a regular expression of ctest for the labels of all others
"""

import os
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
SHARES = 5  # of the long experiments, of the fuzzers and of other tests IN_TURN
TURNS = SHARES + 2  # then each sanitizer: a commit has time for one


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


def label_of(number):
    """The label of the tests that the commit of that number does; a commit that has a sanitizer does none."""
    turn = number % TURNS
    return f"turn-{turn}" if turn < SHARES else "turn-none"


def others_of(number):
    """A regular expression for the labels of the tests that the commit of that number leaves to others."""
    return f"^turn-[^{label_of(number).removeprefix('turn-')}]"


if __name__ == "__main__":
    print({"label": label_of, "others": others_of}[sys.argv[1]](commit_number()))
