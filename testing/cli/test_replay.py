# SPDX-License-Identifier: GPL-3.0-or-later
"""`palpate replay` on a recording of 2000 ticks with one scene swap, whole and damaged, and `palpate devices`."""

import json
import os
import re
import struct
import subprocess
import unittest

from palpate_cli import SQUARE_FACES, SQUARE_POINTS, CommandLineTest
from says import unsaid

MAKE_RECORDING = os.environ["PALPATE_MAKE_RECORDING"]
TICKS = 2000
BEFORE_CHECKS = struct.Struct("<8sIQQ")  # name filled up with zeros, version, size of the payload, number from 1 on
CHECKS = struct.Struct("<II")  # of the payload and of the head; then the payload
HEAD_SIZE = BEFORE_CHECKS.size + CHECKS.size
HEADER_END = b"\nend\n"


def crc32c(data):
    """By its definition, one bit after the other."""
    rest = 0xFFFFFFFF
    for byte in data:
        rest ^= byte
        for _ in range(8):
            rest = rest >> 1 ^ (0x82F63B78 if rest & 1 else 0)
    return rest ^ 0xFFFFFFFF


def chunk_bytes(number, name, version, payload):
    head = BEFORE_CHECKS.pack(name, version, len(payload), number) + struct.pack("<I", crc32c(payload))
    return head + struct.pack("<I", crc32c(head)) + payload


def checked_header(text):
    """With the checksum that belongs to the text, which ends with that line."""
    text = text[:text.rindex(b" ") + 1]
    return text + f"{crc32c(text):08x}".encode() + HEADER_END


def split_chunks(content):
    """The bytes before the first chunk, and (name, version, payload) of each chunk."""
    at = content.index(HEADER_END) + len(HEADER_END)
    head, chunks = content[:at], []
    while at < len(content):
        name, version, length, _ = BEFORE_CHECKS.unpack_from(content, at)
        at += HEAD_SIZE + length
        chunks.append((name.rstrip(b"\0"), version, content[at - length:at]))
    return head, chunks


def joined(head, chunks):
    """A recording of these chunks, which are numbered anew."""
    return head + b"".join(chunk_bytes(number, *chunk) for number, chunk in enumerate(chunks, 1))


class Recorded(CommandLineTest):
    def setUp(self):
        super().setUp()
        subprocess.run([MAKE_RECORDING, str(self.folder / "a.palpate")], check=True, timeout=60)
        self.content = (self.folder / "a.palpate").read_bytes()

    def without_scenes(self):
        head, chunks = split_chunks(self.content)
        return joined(head, [chunk for chunk in chunks if chunk[0] != b"scene"])


class Replay(Recorded):
    def test_a_recording_is_computed_again_bit_for_bit(self):
        run = self.succeed("replay", "a.palpate")
        self.assertIn(f"{TICKS} ticks", run.stdout)

    def test_the_csv_has_a_row_per_tick_in_order(self):
        self.succeed("replay", "a.palpate", "--csv", "out.csv")
        rows = self.read_rows()
        self.assertEqual(len(rows), TICKS)
        self.assertEqual(list(rows[0]), ["t", "device_x", "device_y", "device_z", "proxy_x", "proxy_y", "proxy_z",
                                         "force_x", "force_y", "force_z", "contacts", "cost_us"])
        self.assertTrue(any(row["contacts"] > 0 for row in rows))
        self.assertTrue(all(later["t"] > earlier["t"] for earlier, later in zip(rows, rows[1:])))

    def test_a_mechanisms_laws_have_columns_and_what_becomes_of_them_is_told(self):
        strength, spring = 0.5, 1.0  # N, and the hand's displacement in a tick at 1000 N/m is below a millimetre
        subprocess.run([MAKE_RECORDING, str(self.folder / "a.palpate"), "mechanism"], check=True, timeout=60)
        run = self.succeed("replay", "a.palpate", "--csv", "out.csv")
        said = re.search(r"palpate: (\S+) s: tick (\d+): law1 \(break\) broken at (\S+) N\n", run.stderr)
        self.assertTrue(said, run.stderr)
        self.assertEqual(run.stderr.count("\n"), 1)
        rows = self.read_rows()
        self.assertEqual(list(rows[0])[-3:], ["law1_force", "law1_phase", "law1_inside"])
        gone = next(i for i, row in enumerate(rows) if row["law1_phase"] == 4)
        self.assertAlmostEqual(rows[gone]["t"], float(said[1]), delta=1e-4)
        self.assertGreater(max(row["law1_force"] for row in rows[:gone]), 0.0)
        self.assertLessEqual(max(row["law1_force"] for row in rows[:gone]), strength)
        self.assertGreaterEqual(float(said[3]), strength)
        self.assertLess(float(said[3]), strength + spring)
        self.assertEqual(max(row["law1_force"] for row in rows[gone + 1:]), 0.0)
        self.assertEqual(run.stderr, self.succeed("replay", "a.palpate").stderr)

    def test_one_changed_bit_is_the_first_difference_with_exit_code_1(self):
        head, chunks = split_chunks(self.content)
        ticks = [n for n, (kind, _, _) in enumerate(chunks) if kind == b"tick"]
        kind, version, payload = chunks[ticks[700]]
        # the device's position starts after tick and dt; half of it is a hand elsewhere
        changed = bytearray(payload)
        changed[8 + 8 + 8 + 6] ^= 0x10
        chunks[ticks[700]] = (kind, version, bytes(changed))
        self.write("b.palpate", joined(head, chunks))
        run = self.run_palpate("replay", "b.palpate")
        self.assertEqual(run.returncode, 1, run.stderr)
        self.assertIn("tick", run.stdout)
        self.assertIn("differs", run.stdout)

    def test_a_bit_that_flipped_in_a_file_is_refused_with_the_chunk_that_it_is_in(self):
        head, chunks = split_chunks(self.content)
        for number in (1, 2, 700, len(chunks)):
            begin = len(head) + sum(HEAD_SIZE + len(payload) for _, _, payload in chunks[:number - 1])
            kind, _, payload = chunks[number - 1]
            for at, said in ((begin + 12, f"the head of its chunk {number}"),
                             (begin + HEAD_SIZE + 2, f"its chunk {number} ({kind.decode()}), bytes {begin} to "
                                                   f"{begin + HEAD_SIZE + len(payload) - 1}, ")):
                with self.subTest(number=number, at=at):
                    flipped = bytearray(self.content)
                    flipped[at] ^= 0x10
                    self.write("flipped.palpate", bytes(flipped))
                    self.refused("replay", "flipped.palpate", saying=["flipped.palpate", said, "another copy"])

    def test_a_chunk_that_is_missing_or_there_twice_is_refused_with_its_place(self):
        head, chunks = split_chunks(self.content)
        each = [chunk_bytes(number, *chunk) for number, chunk in enumerate(chunks, 1)]
        self.assertEqual(head + b"".join(each), self.content)
        for number in (1, 2, 700, len(chunks) - 1):
            self.write("less.palpate", head + b"".join(each[:number - 1] + each[number:]))
            self.write("more.palpate", head + b"".join(each[:number] + each[number - 1:]))
            for file, place, stands in (("less.palpate", number, number + 1), ("more.palpate", number + 1, number)):
                with self.subTest(number=number, file=file):
                    self.refused("replay", file, saying=[file, f"the place of its chunk {place} stands its chunk {stands},"])

    def test_a_recording_cut_short_at_any_place_is_refused(self):
        for length in range(1, len(self.content), len(self.content) // 29):
            with self.subTest(length=length):
                self.write("cut.palpate", self.content[:length])
                self.refused("replay", "cut.palpate", saying=["cut.palpate"])

    def test_a_recording_of_another_version(self):
        head, chunks = split_chunks(self.content)
        first, rest = head.removesuffix(HEADER_END).split(b"\n", 1)
        version = int(first.removeprefix(b"PALPATE-RECORDING "))
        other = checked_header(b"PALPATE-RECORDING 99\n" + rest)
        self.write("old.palpate", joined(other, chunks))
        self.refused("replay", "old.palpate", saying=["old.palpate", "format 99", f"reads format {version}"])

    def test_what_this_program_does_not_know_is_refused_by_its_name(self):
        head, chunks = split_chunks(self.content)
        chunks.insert(2, (b"glove", 1, b"any"))
        self.write("newer.palpate", joined(head, chunks))
        self.refused("replay", "newer.palpate", saying=["newer.palpate", "glove", "does not know"])

    def test_what_is_no_recording(self):
        self.write("no.palpate", "t,x,y,z\n")
        self.refused("replay", "no.palpate", saying=["no.palpate", "not a recording"])
        self.write("empty.palpate", "")
        self.refused("replay", "empty.palpate", saying=["empty.palpate", "empty"])
        self.refused("replay", "gone.palpate", saying=["gone.palpate", "no such file"])

    def test_scenes_that_were_left_out_are_asked_for(self):
        self.write("bare.palpate", self.without_scenes())
        self.write("out.csv", "kept")
        self.refused("replay", "bare.palpate", "--csv", "out.csv", saying=["bare.palpate", "--scene"])
        self.assertEqual((self.folder / "out.csv").read_text(), "kept")

    def test_scenes_that_were_left_out_can_be_given_as_files(self):
        self.write("bare.palpate", self.without_scenes())
        self.write_off("first.off", SQUARE_POINTS, SQUARE_FACES)
        self.write_off("second.off", [(x, y, -0.25) for x, y, _ in SQUARE_POINTS], SQUARE_FACES)
        self.succeed("replay", "bare.palpate", "--scene", "first.off", "second.off")
        self.refused("replay", "bare.palpate", "--scene", "first.off", saying=["bare.palpate", "--scene"])

    def test_an_output_that_is_the_recording_is_not_overwritten(self):
        self.refused("replay", "a.palpate", "--csv", "a.palpate", saying=["a.palpate", "input"])
        self.assertEqual((self.folder / "a.palpate").read_bytes(), self.content)


class Devices(CommandLineTest):
    def test_every_device_says_what_it_can_do_with_units(self):
        text = self.succeed("devices").stdout
        for word in ("simulated-ideal", "fed", "replay", "axes of force", "kg"):
            self.assertIn(word, text)

    def test_devices_say_what_each_cannot_do(self):
        text = self.succeed("devices").stdout
        self.assertIn("renders no force", text)
        self.assertEqual(unsaid(text, "along x and y only"), [])
        devices = {device["name"]: device for device in json.loads(self.succeed("devices", "--json").stdout)}
        self.assertEqual(devices["simulated-ideal"]["cannot"], "")
        self.assertEqual(unsaid(devices["simulated-joystick"]["cannot"], "along z"), [])
        self.assertEqual(devices["simulated-joystick"]["sensed_axes"], 2)
        self.assertIn("renders no force", devices["replay"]["cannot"])

    def test_json_lists_the_same_devices(self):
        devices = json.loads(self.succeed("devices", "--json").stdout)
        names = [device["name"] for device in devices]
        self.assertIn("simulated-generic", names)
        for device in devices:
            self.assertEqual(device["usable"], device["problem"] == "")
            self.assertIn("known", device["max_force_N"])


if __name__ == "__main__":
    unittest.main()
