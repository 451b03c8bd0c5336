# SPDX-License-Identifier: GPL-3.0-or-later
"""`palpate labyrinth`: the gallery, a blind hand, a path with a known time, and what is refused before a hand is moved."""

import unittest

from palpate_cli import CommandLineTest

MAZES = ("chartres", "corridor", "hampton-court", "spiral", "versailles")
STRUCTURES = ("circle-set", "wedge-field")
REACH = 0.4  # of the exit, in corridor widths


class Labyrinth(CommandLineTest):
    def test_lists_the_gallery_with_what_each_world_is(self):
        listed = self.succeed("labyrinth").stdout
        for name in MAZES:
            self.assertIn(f"{name}: a maze", listed)
        for name in STRUCTURES:
            self.assertIn(f"{name}: a structure to explore", listed)

    def test_a_blind_hand_arrives_and_its_trace_ends_at_the_exit(self):
        for options in ((), ("--device-walls", "--host", 20)):
            run = self.succeed("labyrinth", "corridor", "--solve", "--csv", "out.csv", *options)
            self.assertIn("arrived after", run.stdout)
            rows = self.read_rows()
            self.assertLess(abs(rows[0]["x"] - 0.5) + abs(rows[0]["y"] - 0.5), 1.0)
            self.assertAlmostEqual(rows[-1]["x"], 9.5 - REACH, delta=0.2)  # the trace has a row every 10 ms or each update
            for row in rows:
                self.assertTrue(0.2 - 1e-9 <= row["y"] <= 0.8 + 1e-9, row)  # the disc's radius from the walls

    # One corridor width in a second: the exit's middle is 9 s away, its reach is entered 0.4 s before.
    def test_a_path_straight_through_the_corridor_takes_its_time(self):
        ticks = 1000
        self.write_path([(k / ticks, 0.5 + k / ticks, 0.5, 0.0) for k in range(10 * ticks)])
        run = self.succeed("labyrinth", "corridor", "--path", "path.csv")
        self.assertAlmostEqual(float(run.stdout.split("after")[1].split()[0]), 9.0 - REACH, delta=0.0011)

    def test_a_path_that_ends_before_the_exit_says_so(self):
        self.write_path([(0.0, 0.5, 0.5, 0.0), (1.0, 1.5, 0.5, 0.0)])
        run = self.run_palpate("labyrinth", "corridor", "--path", "path.csv")
        self.assertEqual(run.returncode, 1)
        self.assertIn("does not arrive", run.stdout)

    def test_what_is_no_maze_or_cannot_be_run_is_refused_before_a_hand_is_moved(self):
        self.refused("labyrinth", "wedge-field", "--solve", saying=("wedge-field", "no place to start"))
        self.refused("labyrinth", "none.vtp", "--solve", saying=("none.vtp",))
        self.refused("labyrinth", "corridor", "--solve", "--device", "spoon", saying=("spoon",))
        self.refused("labyrinth", "corridor", "--solve", "--device", "simulated-touch", "--device-walls",
                     saying=("simulated-touch", "loop"))
        self.refused("labyrinth", "corridor", "--solve", "--host", 5, saying=("--host",))
        self.refused("labyrinth", "corridor", "--solve", "--corridor", 0, saying=("--corridor",))

    def test_an_option_that_would_change_nothing_is_refused(self):
        self.write_path([(0.0, 0.5, 0.5, 0.0), (1.0, 1.5, 0.5, 0.0)])
        path = ("labyrinth", "corridor", "--path", "path.csv")
        self.refused("labyrinth", "corridor", "--csv", "out.csv", saying=("--csv", "--solve or --path"))
        self.refused("labyrinth", "--solve", saying=("--solve", "a name of the gallery"))
        self.refused("labyrinth", "--corridor", 2, saying=("--corridor", "a name of the gallery"))
        self.refused(*path, "--device", "simulated-touch", saying=("--device", "--solve"))
        self.refused(*path, "--host", 20, saying=("--host", "--solve"))
        self.refused(*path, "--device-walls", saying=("--device-walls", "--solve"))

    def test_a_hand_out_of_the_plane_is_named(self):
        self.write_path([(0.0, 0.5, 0.5, 0.0), (1.0, 1.5, 0.5, 0.25)])
        self.refused("labyrinth", "corridor", "--path", "path.csv", saying=("row 2", "z = 0.25", "the plane z = 0"))


if __name__ == "__main__":
    unittest.main()
