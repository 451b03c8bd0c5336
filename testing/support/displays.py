# SPDX-License-Identifier: GPL-3.0-or-later
"""Properties of displays with other names in other releases of ParaView."""


def place_property(display):
    """The property by which a display is moved: Translation since ParaView 5.13, Position before."""
    return "Translation" if "Translation" in display.ListProperties() else "Position"


def place_of(display):
    return list(getattr(display, place_property(display)))


def move(display, place):
    setattr(display, place_property(display), place)
