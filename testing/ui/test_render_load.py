# SPDX-License-Identifier: GPL-3.0-or-later
"""Drawing a million triangles beside the servo: the cost for the GUI's thread until they are touchable, the cost of touching in a
picture, and that of a tick beside drawing. Side by side in one run, as ratios; with PALPATE_TEST_FULL a minute of them."""

import json
import os
import unittest

from played import python, report_of, wait

FULL = bool(os.environ.get("PALPATE_TEST_FULL"))
PAIRS = 8 if FULL else 1
PART_MS = 4000 if FULL else 800
SETTLE_MS = 800  # a hand comes down on the ball
MOST_TICK_RATIO = 3.0
MOST_SHARE = 0.05  # of a picture of so many triangles


def making_ready():
    """Touched, given up at once, for a wait is as long as the pictures that are drawn in it and the scene may be there by then; touched
    again and looked at until it is there."""
    lines = python("load.prepare()", "load.touch()", "load.cancel()") + wait(500)
    lines += python("load.note_cancelled()", "load.let_go()", "load.show_another()", "load.first_touch()")
    return lines + (wait(250) + python("load.look()")) * 12 + python("load.turn_once()")


def touching():
    """Free, touched and not drawn, touched and drawn, in turn."""
    lines = ""
    for _ in range(PAIRS):
        lines += python("load.begin()") + wait(PART_MS) + python("load.end('free')", "load.draw(False)", "load.touch()") + wait(SETTLE_MS)
        lines += wait(PART_MS) + python("load.note_cost('still')", "load.let_go()", "load.draw(True)", "load.touch()") + wait(SETTLE_MS)
        lines += python("load.begin()") + wait(PART_MS) + python("load.end('touched')", "load.note_cost('drawn')", "load.let_go()")
    return lines


def events(report):
    lines = python("import render_load; load = render_load.RenderLoad()") + wait(500) + making_ready() + python("load.let_go()")
    return lines + touching() + python(f"load.report({str(report)!r})")


class RenderLoad(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.found = report_of(events)
        print(json.dumps({name: cls.found[name] for name in ("middle", "costs")}))
        print(cls.found["ready"])

    def picture_ms(self):
        """Time of a picture in the GUI's thread while nobody touches."""
        return sum(self.found["middle"]["free"][:2])

    def test_a_million_triangles_become_touchable_without_holding_the_thread_for_as_long_as_a_picture(self):
        self.assertLess(self.found["ready"]["touch"], 0.5 * self.picture_ms())
        beside = self.found["middle"]["touched"][1]  # of a picture, with nothing to be made ready
        for took_ms, drawn in self.found["ready"]["slices"]:
            self.assertLess(took_ms - drawn * beside, self.picture_ms())

    def test_it_says_how_far_it_is_and_can_be_given_up(self):
        shares = self.found["ready"]["shares"]
        self.assertLess(shares[0], 1.0)
        self.assertEqual(shares, sorted(shares))
        self.assertEqual(shares[-1], 1.0)
        self.assertGreater(len([share for share in shares if 0.0 < share < 1.0]), 0)
        warning, report = self.found["ready"]["cancelled"]
        self.assertIn("cancelled", warning)
        self.assertEqual(report, "")  # nothing came of it

    def test_the_coarser_picture_of_a_turning_camera_is_not_read_as_other_data(self):
        self.assertEqual(self.found["ready"]["turned"], [1, 1.0])  # drawn coarser, and nothing is being made ready

    def test_what_touching_does_beside_drawing_is_a_twentieth_of_a_picture_at_most(self):
        free, touched = (self.found["middle"][name] for name in ("free", "touched"))
        self.assertLessEqual(touched[1] - free[1], MOST_SHARE * self.picture_ms())
        if FULL:
            self.assertLessEqual(sum(touched[:2]), (1.0 + MOST_SHARE) * self.picture_ms())

    def test_a_tick_beside_drawing_costs_no_more_than_three_times_as_much_and_no_period_is_lost(self):
        rank = "p99.9" if FULL else "p99"
        still, drawn = (min(cost[rank] for cost in self.found["costs"][name]) for name in ("still", "drawn"))
        self.assertLessEqual(drawn, MOST_TICK_RATIO * still)
        for cost in self.found["costs"]["still"] + self.found["costs"]["drawn"]:
            self.assertEqual(cost["ticks"] + cost["missed"], cost["periods"])
            self.assertGreater(cost["contact_s"], 0.5)


if __name__ == "__main__":
    unittest.main()
