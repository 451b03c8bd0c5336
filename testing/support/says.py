# SPDX-License-Identifier: GPL-3.0-or-later
"""The facts that a message must name: a file, a number with its unit, the noun that matters."""


def unsaid(text, *facts):
    """The facts that the text does not name. A sentence may be worded anew, a fact may not get lost."""
    return [fact for fact in facts if fact not in text]
