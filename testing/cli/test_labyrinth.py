# SPDX-License-Identifier: GPL-3.0-or-later
"""`palpate labyrinth`: the gallery, a blind hand, a path with a known time, and refusals before a hand is moved."""

import struct
import unittest
import zlib

from palpate_cli import CommandLineTest, vtp_text
from says import unsaid

MAZES = ("chartres", "corridor", "hampton-court", "spiral", "versailles")
STRUCTURES = ("circle-set", "wedge-field")
REACH = 0.4  # of the exit, in corridor widths

LINES = [(0.0, 1.0, 0.0), (10.0, 1.0, 0.0), (10.0, 0.0, 0.0), (0.0, 0.0, 0.0)]  # a corridor, open on the left
INSIDE, OUTSIDE = (9.5, 0.5, 0.0), (-0.5, 0.5, 0.0)


def world_text(points=LINES, line=(0, 1, 2, 3), **places):
    """One line as poly data, with field arrays of one point each."""
    arrays = "".join(f'<DataArray type="Float64" Name="{name}" NumberOfTuples="1" NumberOfComponents="3" format="ascii">'
                     f'{" ".join(map(str, place))}</DataArray>' for name, place in places.items())
    lines = vtp_text(points, [line], kind="Lines")
    return lines.replace("<PolyData>", f"<PolyData><FieldData>{arrays}</FieldData>", 1)


def png(rows):
    """A grey picture."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    pixels = b"".join(b"\0" + bytes(row) for row in rows)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 0, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(pixels)) + chunk(b"IEND", b""))


class Labyrinth(CommandLineTest):
    # 1 - (0.2 + 0.8 / 60) of the light lines' picture are dark.
    def test_says_of_a_picture_what_its_lines_are_and_when_it_is_mostly_dark(self):
        for line, said in ((0, "the middle of its dark strokes"), (255, "mostly dark (79 %)")):
            rows = [[line if i % 10 < 2 or j == 20 else 255 - line for i in range(60)] for j in range(60)]
            (self.folder / "own.png").write_bytes(png(rows))
            run = self.succeed("labyrinth", "own.png")
            self.assertIn(said, run.stderr)
            self.assertEqual(line == 255, "mostly dark" in run.stderr)

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

    def test_a_blind_hand_arrives_in_every_maze_with_a_host_that_closes_the_force_and_behind_one_of_20_hz(self):
        for maze in MAZES:
            for options in ((), ("--device-walls", "--host", 20)):
                self.assertIn("arrived after", self.succeed("labyrinth", maze, "--solve", *options).stdout, (maze, options))

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
        self.refused("labyrinth", "wedge-field", "--solve", saying=("wedge-field", "no start"))
        self.refused("labyrinth", "none.vtp", "--solve", saying=("none.vtp",))
        self.refused("labyrinth", "corridor", "--solve", "--device", "spoon", saying=("spoon",))
        self.refused("labyrinth", "corridor", "--solve", "--device", "simulated-touch", "--device-walls",
                     saying=("simulated-touch", "loop"))
        self.refused("labyrinth", "corridor", "--solve", "--host", 5, saying=("--host",))
        self.refused("labyrinth", "corridor", "--solve", "--corridor", 0, saying=("--corridor",))

    def test_a_line_of_one_point_is_named_with_that_point_and_so_is_a_number_that_is_none(self):
        for name, points, line in (("one", [(1, 2, 0)], (0,)), ("twice", [(1, 2, 0), (1, 2, 0)], (0, 1))):
            self.write(f"{name}.vtp", world_text(points, line, Start=OUTSIDE, Exit=INSIDE))
            self.refused("labyrinth", f"{name}.vtp", saying=(f"{name}.vtp", "all lines are a single point, (1, 2)"))
        self.write("point.vtp", world_text([(0, "nan", 0)] + LINES[1:], Start=OUTSIDE, Exit=INSIDE))
        self.write("place.vtp", world_text(Start=("nan", 0.5, 0), Exit=INSIDE))
        for file in ("point.vtp", "place.vtp"):
            self.refused("labyrinth", file, saying=(file, "not finite"))
        self.write("narrow.vtp", world_text(Start=OUTSIDE, Exit=INSIDE, Corridor=(0, 0, 0)))
        self.refused("labyrinth", "narrow.vtp", saying=("narrow.vtp", "width of its corridors"))
        self.assertIn("corridors of 1 u", self.succeed("labyrinth", "narrow.vtp", "--corridor", 1).stdout)

    def test_a_world_of_ones_own_that_is_no_maze_says_what_it_lacks(self):
        self.write("lost.vtp", world_text(Start=OUTSIDE))
        self.assertIn("lost.vtp: no exit", self.succeed("labyrinth", "lost.vtp").stdout)
        self.write("lines.vtp", world_text())
        self.assertIn("lines.vtp: no start", self.succeed("labyrinth", "lines.vtp").stdout)
        self.write("maze.vtp", world_text(Start=OUTSIDE, Exit=INSIDE))
        self.assertEqual(self.succeed("labyrinth", "maze.vtp").stdout.count("\n"), 2)

    def test_a_hand_that_never_explored_has_no_time_and_no_way(self):
        self.refused("labyrinth", "corridor", "--solve", "--corridor", 0.05,
                     saying=("corridor.vtp", "'simulated-joystick' has a resolution of"))
        run = self.run_palpate("labyrinth", "corridor", "--solve", "--host", 20)  # too weak a lead for its friction
        self.assertEqual(run.returncode, 1)
        self.assertEqual(unsaid(run.stdout, "not", "start"), [])
        self.assertEqual(unsaid(run.stdout, "friction", "0.3 N"), [])
        self.assertNotIn("a path of", run.stdout)

    def test_lines_out_of_the_plane_say_in_which_plane_they_must_lie_and_how_they_get_there(self):
        self.write("high.vtp", world_text([(x, y, 5.0) for x, y, _ in LINES]))
        self.refused("labyrinth", "high.vtp", saying=("high.vtp", "the plane z = 0", "5 scene units", "Transform"))

    def test_an_option_that_would_change_nothing_is_refused(self):
        self.write_path([(0.0, 0.5, 0.5, 0.0), (1.0, 1.5, 0.5, 0.0)])
        path = ("labyrinth", "corridor", "--path", "path.csv")
        self.refused("labyrinth", "corridor", "--csv", "out.csv", saying=("--csv", "--solve or --path"))
        self.refused("labyrinth", "--solve", saying=("--solve", "a name of the gallery"))
        self.refused("labyrinth", "--corridor", 2, saying=("--corridor", "a name of the gallery"))
        self.refused(*path, "--device", "simulated-touch", saying=("--device", "--solve"))
        self.refused("labyrinth", "corridor", "--hold", 2, saying=("--hold", "--play"))
        self.refused("labyrinth", "corridor", "--play", "--host", 20, saying=("--host", "--solve"))
        self.refused("labyrinth", "corridor", "--play", "--csv", "out.csv", saying=("--csv", "--solve or --path"))
        self.refused(*path, "--host", 20, saying=("--host", "--solve"))
        self.refused(*path, "--device-walls", saying=("--device-walls", "--solve"))

    def test_a_hand_out_of_the_plane_is_named(self):
        self.write_path([(0.0, 0.5, 0.5, 0.0), (1.0, 1.5, 0.5, 0.25)])
        self.refused("labyrinth", "corridor", "--path", "path.csv", saying=("row 2", "z = 0.25", "the plane z = 0"))


class PlayTest(CommandLineTest):
    """`labyrinth --play`: from the device alone; a simulated hand presses its buttons."""

    def play(self, *arguments):
        return self.succeed("labyrinth", *arguments, "--play", "--device", "simulated-joystick").stdout.splitlines()

    def test_one_labyrinth_is_button_one_and_the_next_button_ends(self):
        lines = self.play("corridor")
        self.assertEqual(lines[0], "simulated-joystick: press 1 for corridor; 2 ends, Ctrl-C too.")
        self.assertIn("gives up", lines[1])
        self.assertEqual([line.partition(": ")[2].split(" after ")[0] for line in lines[2:-1]],
                         ["hold button 1", "the device guides your hand to the start", "find the exit by touch", "arrived"])
        self.assertEqual(lines[-1], "1 arrival")

    def test_every_maze_of_the_gallery_has_its_button_in_the_order_of_the_list(self):
        listed = self.succeed("labyrinth").stdout.splitlines()
        mazes = [line.split(":")[0] for line in listed if ": a maze of" in line]
        lines = self.play()
        offered = ", ".join(f"{n} for {maze}" for n, maze in enumerate(mazes, 1))
        self.assertEqual(lines[0], f"simulated-joystick: press {offered}; {len(mazes) + 1} ends, Ctrl-C too.")
        for n, maze in enumerate(mazes, 1):
            self.assertIn(f"{maze}: hold button {n}", lines)
            self.assertEqual(sum(line.startswith(f"{maze}: arrived after") for line in lines), 1, maze)
        self.assertEqual(lines[-1], f"{len(mazes)} arrivals")

    def test_what_must_be_held_can_be_another_button_or_the_grip(self):
        self.assertIn("corridor: hold button 7", self.play("corridor", "--hold", 7))
        self.assertIn("corridor: hold the grip", self.play("corridor", "--hold", "grip"))
        for hold in ("0", "33", "-1", "2x", "trigger", "99999999999"):
            self.refused("labyrinth", "corridor", "--play", "--device", "simulated-joystick", "--hold", hold,
                         saying=("--hold", "number of a button, 1 to 32, or grip"))
        for hold in (1, 2):
            self.refused("labyrinth", "corridor", "--play", "--device", "simulated-joystick", "--hold", hold,
                         saying=("--hold", "buttons 1 to 2 choose"))

    def test_the_same_hand_plays_the_same_game(self):
        self.assertEqual(self.play("spiral"), self.play("spiral"))

    def test_who_cannot_arrive_ends_with_the_exit_code_of_that(self):
        walled = [(0, 0, 0), (4, 0, 0), (4, 2, 0), (0, 2, 0), (0, 1, 0), (4, 1, 0)]  # a wall between start and exit
        self.write("walled.vtp", world_text(walled, (0, 1, 2, 3, 0, 4, 5), Start=(0.5, 0.5, 0), Exit=(0.5, 1.5, 0)))
        run = self.run_palpate("labyrinth", "walled.vtp", "--play", "--device", "simulated-joystick")
        self.assertEqual(run.returncode, 1, run.stderr)
        self.assertIn("walled.vtp: given up", run.stdout)
        self.assertTrue(run.stdout.endswith("0 arrivals\n"))

    def test_without_a_device_it_says_what_to_do(self):
        self.refused("labyrinth", "--play", saying=("simulated-joystick", "--device"))
        for device in ("fed", "mouse", "replay"):
            self.refused("labyrinth", "--play", "--device", device, saying=(device, "no force", "another --device"))
        self.refused("labyrinth", "--play", "--device", "abacus", saying=("abacus", "simulated-joystick"))

    def test_what_is_no_maze_is_not_played(self):
        self.refused("labyrinth", "wedge-field", "--play", "--device", "simulated-joystick",
                     saying=("wedge-field", "no start"))
        self.refused("labyrinth", "nowhere.vtp", "--play", "--device", "simulated-joystick", saying=("nowhere.vtp",))


if __name__ == "__main__":
    unittest.main()
