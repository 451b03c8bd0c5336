# SPDX-License-Identifier: GPL-3.0-or-later
"""The CSVs of a lab run, read strictly: a chart must never show something else than was measured."""

import csv
import dataclasses
import math
import pathlib

COLUMNS = ["experiment", "case", "method", "quantity", "value", "unit", "truth", "pass_line", "verdict",
           "cost_us_p50", "cost_us_p99", "cost_us_most"]
VERDICTS = ("pass", "fail", "info", "absent")
MARK = ", at least"


class Problem(Exception):
    """Bad input: one line that names the file and the reason."""


@dataclasses.dataclass
class Row:
    experiment: str
    case: str
    method: str
    quantity: str  # without the mark of a lower limit
    value: float | None
    unit: str
    truth: float | None
    pass_line: float | None
    verdict: str
    cost_us_p50: float | None
    cost_us_p99: float | None
    cost_us_most: float | None  # only where each tick was timed in several runs
    at_least: bool  # value must be at least pass_line

    @property
    def pairs(self):
        """A case like "rate=1000 delay=2" as a dictionary; words stay words."""
        found = {}
        for part in self.case.split():
            key, sign, text = part.partition("=")
            if sign:
                try:
                    found[key] = float(text)
                except ValueError:
                    found[key] = text
        return found


def number(text, file, line, column):
    if text == "":
        return None
    try:
        value = float(text)
    except ValueError:
        raise Problem(f"{file}, line {line}: {column} '{text}' is not a number: run the lab again") from None
    if not math.isfinite(value):
        raise Problem(f"{file}, line {line}: {column} is not finite: run the lab again")
    return value


def read_file(file):
    try:
        with open(file, newline="", encoding="utf-8") as stream:
            lines = list(csv.reader(stream))
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise Problem(f"{file} cannot be read: {error}") from None
    if not lines or lines[0] != COLUMNS:
        raise Problem(f"{file} is not of this version of the lab: its columns should be {','.join(COLUMNS)}")
    rows = []
    for line, fields in enumerate(lines[1:], start=2):
        if len(fields) != len(COLUMNS):
            raise Problem(f"{file}, line {line}: {len(fields)} fields instead of {len(COLUMNS)}: run the lab again")
        given = dict(zip(COLUMNS, fields))
        if given["verdict"] not in VERDICTS:
            raise Problem(f"{file}, line {line}: verdict '{given['verdict']}' is not one of {', '.join(VERDICTS)}")
        for column in ("value", "truth", "pass_line", "cost_us_p50", "cost_us_p99", "cost_us_most"):
            given[column] = number(given[column], file, line, column)
        at_least = given["quantity"].endswith(MARK)
        given["quantity"] = given["quantity"].removesuffix(MARK)
        rows.append(Row(**given, at_least=at_least))
    return rows


def read_folder(folder):
    """All rows by experiment."""
    folder = pathlib.Path(folder)
    if not folder.is_dir():
        raise Problem(f"{folder} is not a folder: give the one the lab wrote to")
    files = sorted(folder.glob("*.csv"))
    if not files:
        raise Problem(f"{folder} holds no CSV of the lab: run palpate-lab run all --out {folder} first")
    tables = {}
    for file in files:
        for row in read_file(file):
            tables.setdefault(row.experiment, []).append(row)
    return tables
