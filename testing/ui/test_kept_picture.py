# SPDX-License-Identifier: GPL-3.0-or-later
"""A picture in which only the hand moved draws the hand alone, before a kept picture of the data: it looks as if all were drawn,
and changes are drawn at once."""

import unittest

from played import event, python, report_of, wait

VIEW = ("pqClientMainWindow/centralwidget/MultiViewWidget/CoreWidget/qt_tabwidget_stackedwidget/MultiViewWidget1/Container/Frame.0/"
        "CentralWidgetFrame/Viewport/1QVTKOpenGLNativeWidget0")

def settle():
    """Some pictures of the present data."""
    return python("kept.begin()") + wait(300)


def events(report):
    lines = python("import kept_picture; kept = kept_picture.KeptPicture()") + wait(500) + python("kept.touch()") + wait(1000)
    lines += python("kept.begin()") + "".join(python(f"kept.move({0.1 * i})") + wait(100) for i in range(10)) + python("kept.end('stroked')")
    lines += settle() + python("kept.compare('rest')", "kept.move(1.2)") + settle() + python("kept.compare('moved')")
    lines += python("kept.redness('white')", "kept.colour()") + settle() + python("kept.redness('red')")
    lines += python("kept.begin()", "kept.turn()") + wait(300) + python("kept.end('turned')") + settle()
    lines += python("kept.compare('turned and rest')", "kept.stereo(1)", "kept.begin()") + wait(300) + python("kept.end('stereo')", "kept.stereo(0)")
    lines += python("kept.touch_with_the_mouse()") + wait(500)
    lines += event("hapticGlide", "0.45,0.45,0.55,0.55,20", VIEW) + python("kept.begin()") + event("hapticGlide", "0.55,0.55,0.45,0.45,20", VIEW)
    return lines + python("kept.end('hovered')", f"kept.report({str(report)!r})")


class KeptPicture(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.found = report_of(events)
        print(cls.found)

    def test_the_data_are_not_drawn_for_a_hand_that_moves(self):
        for name in ("stroked", "hovered"):
            self.assertGreater(self.found[name]["window"], 5)
            self.assertEqual(self.found[name]["ball"], 0)

    def test_a_picture_of_the_hand_alone_is_the_picture_in_which_all_is_drawn(self):
        for name in ("rest", "moved", "turned and rest"):
            self.assertEqual(self.found[name + " drawn"], 0)
            self.assertEqual(self.found[name], 0)

    def test_of_two_eyes_both_pictures_are_drawn_whole(self):
        self.assertEqual(self.found["stereo"]["ball"], 2 * self.found["stereo"]["window"])
        self.assertGreater(self.found["stereo"]["window"], 1)

    def test_colours_and_cameras_that_change_are_seen_in_the_next_picture(self):
        self.assertGreater(self.found["red"], self.found["white"] + 10.0)
        self.assertGreaterEqual(self.found["turned"]["ball"], 1)


if __name__ == "__main__":
    unittest.main()
