# SPDX-License-Identifier: GPL-3.0-or-later
"""The language of the documents. Four rules hold the sentences of each page in HELD:

1. "what" stands in questions only: a noun says more than a clause without one.
2. None of the words in PRIVATE stands there; docs/glossary.md has the terms of the field.
3. No sentence begins with "It": the subject is named anew behind a full stop.
4. Nine sentences of ten have at most 30 words.

A page that is rewritten joins HELD. No page leaves the list. The first two rules hold each text of the product that a user
can see as well (product_text.py): help, tooltips, messages, documentation of XML and of Python functions. Comments (comment_text.py) have the first
and the third rule, and some words of the second.
"""

import math
import os
import re
import sys
import unittest
from pathlib import Path

sys.path += [str(Path(__file__).resolve().parents[1] / folder) for folder in ("plugin", "architecture")]
import described  # noqa: E402
from comment_text import comments  # noqa: E402
from product_text import joined, of_xml, product_texts  # noqa: E402
from rules import files_of  # noqa: E402

ROOT = Path(os.environ.get("PALPATE_SOURCE_DIR") or Path(__file__).resolve().parents[2])
LONGEST_WORDS = 30  # of nine sentences in ten
COMMENTED = {".h", ".cpp", ".cxx", ".py", ".cmake", ".txt", ".sh", ".xml", ""}

HELD = (
    "ARCHITECTURE.md",
    "CHANGELOG.md",
    "CONTRIBUTING.md",
    "README.md",
    "data/README.md",
    "data/gallery/README.md",
    "docs/decisions/README.md",
    "docs/decisions/a-ball-has-a-largest-radius.md",
    "docs/decisions/a-ball-in-the-hand-is-swept.md",
    "docs/decisions/a-budget-is-work.md",
    "docs/decisions/a-change-of-packets-is-an-offset-that-fades.md",
    "docs/decisions/a-chunks-head-has-its-own-checksum.md",
    "docs/decisions/a-detent-is-a-polynomial.md",
    "docs/decisions/a-difference-is-felt-from-seven-percent.md",
    "docs/decisions/a-fault-ends-the-force-in-10-ms.md",
    "docs/decisions/a-free-way-is-a-multiplier.md",
    "docs/decisions/a-guess-of-what-holds-is-proved.md",
    "docs/decisions/a-joystick-holds-its-walls.md",
    "docs/decisions/a-mark-holds-while-its-cell-does.md",
    "docs/decisions/a-mechanism-in-the-hand-lets-the-others-rest.md",
    "docs/decisions/a-mechanism-is-a-scene-file.md",
    "docs/decisions/a-mesh-file-is-parsed-by-us.md",
    "docs/decisions/a-package-brings-the-list-of-plugins.md",
    "docs/decisions/a-part-of-a-surface-says-where-it-ends.md",
    "docs/decisions/a-patch-is-in-series-with-hertz.md",
    "docs/decisions/a-plane-holds-while-its-feature-does.md",
    "docs/decisions/a-plane-in-space-is-touched-in-the-plane.md",
    "docs/decisions/a-point-is-a-point.md",
    "docs/decisions/a-pose-target-gives-the-limited-force.md",
    "docs/decisions/a-recording-begins-between-two-ticks.md",
    "docs/decisions/a-setting-is-described-once.md",
    "docs/decisions/a-side-is-a-sign.md",
    "docs/decisions/a-soft-body-brings-its-scene.md",
    "docs/decisions/a-step-of-a-tool-is-proven.md",
    "docs/decisions/a-surface-that-vanishes-fades.md",
    "docs/decisions/a-tool-turns-about-its-handle.md",
    "docs/decisions/a-tools-contacts-come-as-a-scene-does.md",
    "docs/decisions/a-tools-friction-is-swept.md",
    "docs/decisions/a-vertex-is-left-along-the-surface.md",
    "docs/decisions/all-triangles-first.md",
    "docs/decisions/an-axis-has-no-sign.md",
    "docs/decisions/an-image-stands-where-its-header-says.md",
    "docs/decisions/an-isosurface-is-felt-by-a-point.md",
    "docs/decisions/an-isosurface-is-its-polynomial.md",
    "docs/decisions/animated-polygons-keep-their-diagonals.md",
    "docs/decisions/another-brick-is-another-value.md",
    "docs/decisions/another-field-is-sampled-at-the-points-of-the-first.md",
    "docs/decisions/another-map-keeps-the-hand.md",
    "docs/decisions/arrays-apart-from-geometry.md",
    "docs/decisions/bending-in-a-moving-frame.md",
    "docs/decisions/bricks-come-by-distance.md",
    "docs/decisions/cgal-is-header-only.md",
    "docs/decisions/chain-of-smaller-models.md",
    "docs/decisions/crevices-by-newton-steps.md",
    "docs/decisions/critical-points-of-what-is-felt.md",
    "docs/decisions/curves-are-surfaces-without-faces.md",
    "docs/decisions/deforming-surface-keeps-its-tree.md",
    "docs/decisions/drawn-line-before-apply.md",
    "docs/decisions/far-from-0-values-are-kept-less-their-middle.md",
    "docs/decisions/fine-lines-are-felt-coarser.md",
    "docs/decisions/force-shading-goes-in-rounds.md",
    "docs/decisions/friction-pulls.md",
    "docs/decisions/large-data-are-read-ahead.md",
    "docs/decisions/material-is-a-potential.md",
    "docs/decisions/measured-beside-the-tick.md",
    "docs/decisions/no-brute-force-in-space.md",
    "docs/decisions/no-brute-force-in-the-plane.md",
    "docs/decisions/no-energy-limit-for-held-walls.md",
    "docs/decisions/no-point-is-held-by-nothing.md",
    "docs/decisions/noise-that-traps-is-smoothed.md",
    "docs/decisions/of-a-server-only-the-brick-travels.md",
    "docs/decisions/one-shared-library.md",
    "docs/decisions/one-writer-one-reader.md",
    "docs/decisions/passivity-before-it-is-needed.md",
    "docs/decisions/plane-worlds-are-walls.md",
    "docs/decisions/polygon-keeps-its-border.md",
    "docs/decisions/recorded-mesh-is-its-tree.md",
    "docs/decisions/same-bits-on-every-machine.md",
    "docs/decisions/scene-units-not-metres.md",
    "docs/decisions/scenes-are-immutable.md",
    "docs/decisions/small-cells-have-a-finer-brick.md",
    "docs/decisions/springs-of-a-field-share-the-stiffness.md",
    "docs/decisions/stiffness-by-eigenvalues.md",
    "docs/decisions/stiffness-from-data-is-felt.md",
    "docs/decisions/stress-is-that-of-the-points-of-strain.md",
    "docs/decisions/surfaces-are-felt-in-the-cells.md",
    "docs/decisions/surfaces-lie-in-the-scene-frame.md",
    "docs/decisions/tetrahedra-fill-a-question.md",
    "docs/decisions/texture-fades-on-its-hills.md",
    "docs/decisions/texture-zero-is-its-highest-place.md",
    "docs/decisions/the-active-view-is-touched.md",
    "docs/decisions/the-game-is-part-of-the-tick.md",
    "docs/decisions/tick-is-a-function.md",
    "docs/decisions/tree-is-a-copy.md",
    "docs/decisions/two-tools-share-one-wrench.md",
    "docs/decisions/vertices-go-straight.md",
    "docs/decisions/ways-are-laid-on-the-surface.md",
    "docs/decisions/what-a-device-holds-is-felt-first.md",
    "docs/decisions/what-a-device-lacks-is-made-up-at-its-command.md",
    "docs/decisions/what-gives-way-is-factored-by-cholmod.md",
    "docs/decisions/what-is-ahead-of-a-tool-is-left-out.md",
    "docs/decisions/what-is-felt-of-a-body-is-drawn.md",
    "docs/decisions/what-is-known-of-a-linear-body-is-kept.md",
    "docs/decisions/what-was-outside-stays-outside.md",
    "docs/decisions/what-yields-is-touched-in-its-material.md",
    "docs/devices.md",
    "docs/example/README.md",
    "docs/faults.md",
    "docs/fields.md",
    "docs/first-arm.md",
    "docs/glossary.md",
    "docs/guide/README.md",
    "docs/guide/brain.md",
    "docs/guide/flow.md",
    "docs/guide/labyrinth.md",
    "docs/guide/skull.md",
    "docs/guide/soft-brain.md",
    "docs/guide/spatula.md",
    "docs/mechanisms.md",
    "docs/program.md",
    "docs/recipes/README.md",
    "docs/recipes/add-a-device.md",
    "docs/recipes/add-a-force.md",
    "docs/recipes/add-a-reader.md",
    "docs/recipes/add-a-setting.md",
    "docs/recipes/add-an-experiment.md",
    "docs/regression.md",
    "docs/servers.md",
    "docs/soft.md",
    "docs/theory.md",
    "docs/tools.md",
    "docs/touching.md",
    "plugin/README.md",
    "testing/BAR.md",
    "testing/benchmarks/README.md",
    "testing/haptics/recording/fixtures/README.md",
    "testing/lab/README.md",
    "testing/vm/README.md",
)

# A word of this project alone, and the term that stands for it.
PRIVATE = {
    r"g[ai]v(?:es?|ing|en) way": "deforms, soft body",
    r"ways?": "displacement, path, degree of freedom, direction",
    r"bricks?": "sampled block",
    r"packets?": "condensed compliance",
    r"nobody": "a subject that exists",
    r"rub(?:s|bed|bing)?": "friction",
}

PRIVATE_IN_COMMENTS = r"\b(?:g[ai]v(?:es?|ing|en) way|bricks?|rub(?:s|bed|bing)?)\b"

# In texts of the product also these. The key `laws` of a scene file is a name: it stands in quotes or before a colon.
PRIVATE_IN_PRODUCT = {r"(?<!['`\"])laws?(?!['`\":])": "constraint, constitutive model, force field", r"rooms?": "workspace, clearance"}
# Arrays have names that scripts use; a name that is a private word stands here.
NAMES = ("point array Way",)


def texts(page):
    """Each paragraph, list item and table cell: without code, headings, targets of links, names of controls (in italics)
    and the rows that are written from the table of settings."""
    text = (ROOT / page).read_text(encoding="utf-8")
    for file, begin, end, *_ in described.PLACES:
        if file.relative_to(described.ROOT) == Path(page):
            text = text.replace(described.between(text, begin, end), "")
    text = re.sub(r"^```.*?^```$|<!--.*?-->", "", text, flags=re.DOTALL | re.MULTILINE)
    text = re.sub(r"^(?:    |#).*$", "", text, flags=re.MULTILINE)
    text = re.sub(r"`(?:[^`\n]|\n(?!\n))*`", "CODE", text)
    text = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", text)
    text = re.sub(r"(?<!\*)\*(?!\*)(?:[^*\n]|\n(?!\n))+\*(?!\*)", "NAME", text).replace("**", "")
    for block in re.split(r"\n\s*\n|\n(?=\s*(?:\d+\. |- |\|))", text):
        yield from (re.split(r"(?<!\\)\|", block) if block.lstrip().startswith("|") else [block])


def sentences(page):
    """A sentence ends with a full stop, a question or an exclamation mark before white space."""
    for text in texts(page):
        for sentence in re.split(r"(?<=[.!?])[)\"]?\s+", " ".join(re.sub(r"^\s*(?:\d+\.|-)\s", "", text).split())):
            if re.search(r"[A-Za-z]", sentence):
                yield sentence


def headless(found):
    return [sentence for sentence in found if re.search(r"\bwhat\b", sentence, re.IGNORECASE) and "?" not in sentence]


def private(found):
    return [(word[0], sentence) for sentence in found for word in re.finditer(rf"\b(?:{'|'.join(PRIVATE)})\b", sentence, re.IGNORECASE)]


def of_product():
    """Each text of the product that a user can see, with its file, without names that scripts use."""
    for file, text in product_texts(ROOT):
        for name in NAMES:
            text = text.replace(name, "NAME")
        yield file, text


def private_in_product(text):
    words = "|".join({**PRIVATE, **PRIVATE_IN_PRODUCT})
    return re.search(rf"\b(?:{words})\b", text, re.IGNORECASE)


def of_comments():
    """Each comment of the tree, with its place."""
    for file in files_of(ROOT):
        name = str(file.relative_to(ROOT))
        if file.suffix in COMMENTED:
            yield from ((f"{name}:{line}", text) for line, text in comments(name, file.read_text(encoding="utf-8", errors="replace")))


def headless_comment(text):
    return headless(re.split(r"(?<=[.!?:;])\s", text))


def private_comment(text):
    return re.findall(PRIVATE_IN_COMMENTS, text, re.IGNORECASE)


def nameless_comment(text):
    return re.findall(r"(?<=[.!?]) It \w+", text)


def words_of_nine_in_ten(found):
    lengths = sorted(len(re.findall(r"\w[\w'.-]*", sentence)) for sentence in found)
    return lengths[math.ceil(0.9 * len(lengths)) - 1]


class Words(unittest.TestCase):
    def test_what_stands_in_questions_only(self):
        for page in HELD:
            self.assertEqual(headless(sentences(page)), [], page)

    def test_the_terms_are_those_of_the_field(self):
        for page in HELD:
            self.assertEqual(private(sentences(page)), [], page)

    def test_a_subject_is_named_anew_behind_a_full_stop(self):
        for page in HELD:
            self.assertEqual([sentence for sentence in sentences(page) if sentence.startswith("It ")], [], page)

    def test_nine_sentences_of_ten_are_short(self):
        for page in HELD:
            self.assertLessEqual(words_of_nine_in_ten(sentences(page)), LONGEST_WORDS, page)


class Product(unittest.TestCase):
    """The texts for a user in the panel, in the shell and in ParaView's documentation."""

    def test_what_stands_in_questions_only(self):
        self.assertEqual([(file, text) for file, text in of_product() if headless([text])], [])

    def test_the_terms_are_those_of_the_field(self):
        self.assertEqual([(file, text) for file, text in of_product() if private_in_product(text)], [])

    def test_nine_texts_of_ten_have_short_sentences(self):
        found = [sentence for _, text in of_product() for sentence in re.split(r"(?<=[.!?;:])\s+", text)]
        self.assertLessEqual(words_of_nine_in_ten(found), LONGEST_WORDS)

    def test_every_room_has_texts(self):
        files = [file for file, _ in of_product()]
        for start in ("haptics/session/settings/", "devices/", "filters/pipeline/HapticPipeline.xml", "filters/views/python/",
                      "ui/cli/", "ui/panel/", "plugin/HapticSettings.xml"):
            self.assertGreater(len([file for file in files if file.startswith(start)]), 2, start)


class Comments(unittest.TestCase):
    """The comments of the tree."""

    @classmethod
    def setUpClass(cls):
        cls.found = list(of_comments())

    def holds_none(self, fault):
        self.assertEqual([(place, fault(text)[0]) for place, text in self.found if fault(text)], [])

    def test_what_stands_in_questions_only(self):
        self.holds_none(headless_comment)

    def test_the_terms_are_those_of_the_field(self):
        self.holds_none(private_comment)

    def test_a_subject_is_named_anew_behind_a_full_stop(self):
        self.holds_none(nameless_comment)

    def test_every_kind_of_file_has_comments(self):
        for suffix in COMMENTED - {".sh"}:
            self.assertGreater(len([place for place, _ in self.found if Path(place.rsplit(":")[0]).suffix == suffix]), 10, suffix)


class Rules(unittest.TestCase):
    """Each rule finds its fault."""

    def test_literals_outside_of_comments_are_found_and_joined(self):
        code = 'f("one "\n  "two"); // "a comment"\n/* "another" */ g(\'"\', "three", R"(four)");'
        self.assertEqual(joined(code), ["one two", "three", "four"])
        self.assertEqual(list(of_xml('<a><Documentation short_help="s">t\n u</Documentation></a>')), ["s", "t u"])

    def test_comments_are_found_and_joined_and_literals_are_none(self):
        code = 'f("// one"); // two\n// `three` and\n// "four"\n\n/** five\n * six */\n'
        self.assertEqual(comments("a.h", code), [(1, "two CODE and CODE"), (5, "five six")])
        self.assertEqual(comments("a.py", '"""One."""\nx = "# two"  # three\n'), [(1, "One. three")])
        self.assertEqual(comments("a.cmake", 'set(x "# one") # two\n'), [(1, "two")])
        self.assertEqual(comments("a.xml", "<!-- one\n two --><a/>"), [(1, "one two")])

    def test_a_law_is_private_where_it_is_no_key(self):
        self.assertTrue(private_in_product("the law breaks"))
        self.assertFalse(private_in_product("the key 'laws' is a list"))

    def test_each_rule_finds_its_fault(self):
        self.assertEqual(len(headless(["What joins them is solved.", "The panel says what it costs.", "What is felt?"])), 2)
        self.assertEqual(len(private(["A body gives way.", "The subway is short.", "All ways are free."])), 2)
        self.assertEqual(words_of_nine_in_ten(["one two three"] * 9 + ["one"]), 3)

    def test_every_page_that_is_held_has_sentences(self):
        for page in HELD:
            self.assertGreater(len(list(sentences(page))), 2, page)


if __name__ == "__main__":
    unittest.main(verbosity=2)
