# SPDX-License-Identifier: GPL-3.0-or-later
"""A verdict as JUnit writes it, which servers of continuous integration read."""

from xml.etree import ElementTree

from palpate.testing.feel import Refused


def write_junit(file, name, seconds, kind=None, text=""):
    """`kind`: failure (it feels otherwise), error (it cannot be judged) or none."""
    suite = ElementTree.Element("testsuite", name="palpate.testing", tests="1", failures=str(int(kind == "failure")),
                                errors=str(int(kind == "error")), skipped="0", time=f"{seconds:.3f}")
    case = ElementTree.SubElement(suite, "testcase", classname="palpate.testing", name=name, time=f"{seconds:.3f}")
    if kind:
        ElementTree.SubElement(case, kind, message=text.splitlines()[0]).text = text
    try:
        ElementTree.ElementTree(suite).write(file, encoding="utf-8", xml_declaration=True)
    except OSError as problem:
        raise Refused(f"{file}: the JUnit file cannot be written ({problem.strerror}).") from None
