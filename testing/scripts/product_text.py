# SPDX-License-Identifier: GPL-3.0-or-later
"""The text that a user can see: string literals of the product with three words or more, or with a space at an end (parts of a
sentence), and the documentation of its XML."""

import ast
import re
from xml.etree import ElementTree

ROOMS = ("haptics", "devices", "filters", "ui", "plugin")
TOKEN = re.compile(r'//[^\n]*|/\*.*?\*/|R"\((.*?)\)"|"((?:[^"\\\n]|\\.)*)"|\'(?:[^\'\\\n]|\\.)+\'', re.DOTALL)
LEAST_WORDS = 3


def joined(text):
    """Each string literal outside of comments, neighbours joined as the compiler joins them."""
    found, end = [], None
    for token in TOKEN.finditer(text):
        literal = token[1] if token[1] is not None else token[2]
        if literal is None:
            continue
        if end is not None and not text[end:token.start()].strip():
            found[-1] += literal
        else:
            found.append(literal)
        end = token.end()
    return [re.sub(r"\\n", " ", literal).replace('\\"', '"') for literal in found]


def of_python(text):
    return [node.value for node in ast.walk(ast.parse(text)) if isinstance(node, ast.Constant) and isinstance(node.value, str)]


def of_xml(text):
    """Documentation and its short forms. Labels are names that scripts use."""
    for element in ElementTree.fromstring(text).iter():
        yield from (element.get(name) for name in ("short_help", "long_help") if element.get(name))
        if element.tag == "Documentation":
            yield " ".join("".join(element.itertext()).split())


READERS = {".h": joined, ".cpp": joined, ".cxx": joined, ".py": of_python, ".xml": of_xml}


def is_sentence(text):
    """Whether the text is a sentence or a part of one, and not a name or a key."""
    words = len(re.findall(r"[^\W\d_]{2,}", text))
    return words >= LEAST_WORDS and " " in text.strip() or words > 0 and text != text.strip()


def product_texts(root):
    """(file, text) of each text that a user can see."""
    for room in ROOMS:
        for file in sorted((root / room).rglob("*")):
            for text in READERS.get(file.suffix, lambda _: ())(file.read_text(encoding="utf-8") if file.suffix in READERS else ""):
                if is_sentence(text):
                    yield str(file.relative_to(root)), text
