# SPDX-License-Identifier: GPL-3.0-or-later
"""The comments of a source: of C++, Python with its docstrings, CMake and shell, XML. Code in backquotes and words in quotation marks are left out."""

import io
import re
import tokenize
from pathlib import Path

CPP_TOKEN = re.compile(r'R"\(.*?\)"|"(?:[^"\\\n]|\\.)*"|(?<![0-9A-Fa-f])\'(?:[^\'\\\n]|\\.)+\'|(//[^\n]*|/\*.*?\*/)', re.DOTALL)
SHARP_TOKEN = re.compile(r'"(?:[^"\\]|\\.)*"|\'[^\'\n]*\'|(?<![\w$\\{])(#[^\n]*)')
XML_TOKEN = re.compile(r"(<!--.*?-->)", re.DOTALL)
MARKS = re.compile(r"^\s*(?:///?<?|/\*\*?|\*/|\*|#:?|<!--)\s?|\s*(?:\*/|-->)\s*$", re.MULTILINE)
SUFFIXES = {".h": CPP_TOKEN, ".cpp": CPP_TOKEN, ".cxx": CPP_TOKEN, ".cmake": SHARP_TOKEN, ".sh": SHARP_TOKEN, ".xml": XML_TOKEN}


def of_tokens(text, pattern):
    """(line, comment) of each comment."""
    for token in pattern.finditer(text):
        if token[1] is not None:
            yield text.count("\n", 0, token.start()) + 1, token[1]


def of_python(text):
    """(line, comment) of each comment and docstring."""
    before = None
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        alone = token.type == tokenize.STRING and before in (None, tokenize.INDENT, tokenize.NEWLINE, tokenize.DEDENT)
        if token.type == tokenize.COMMENT or alone:
            yield token.start[0], token.string.strip('"') if alone else token.string
        before = before if token.type in (tokenize.NL, tokenize.COMMENT) else token.type


def read(file, text):
    """(line, comment) in the order of the lines; nothing for a file of another kind."""
    is_script = file.suffix == "" and text.startswith("#!")
    pattern = SHARP_TOKEN if file.name == "CMakeLists.txt" or is_script else SUFFIXES.get(file.suffix)
    return list(of_python(text) if file.suffix == ".py" else of_tokens(text, pattern) if pattern else [])


def comments(file, text):
    """(line, text) of each comment; neighbouring lines of the same kind are one."""
    found, last = [], None
    for line, comment in read(Path(file), text):
        goes_on = last == line - 1 and not comment.startswith("/*")
        found[-1:] = [(found[-1][0], found[-1][1] + "\n" + comment)] if goes_on else [*found[-1:], (line, comment)]
        last = line + comment.count("\n")
    return [(line, " ".join(re.sub(r"`[^`]*`|\"[^\"]*\"", "CODE", MARKS.sub("", comment)).split())) for line, comment in found]
