# SPDX-License-Identifier: GPL-3.0-or-later
"""The reader of recordings says which part of a damaged file is not as it was written, and reads those of every format."""

import os
import tempfile
import unittest
from pathlib import Path

from palpate.testing.feel import Refused, updated
from palpate.vtkHapticPipeline import vtkHapticRecordingReader

FIXTURES = Path(os.environ["PALPATE_SOURCE_DIR"]) / "testing/haptics/recording/fixtures"


def read(file):
    reader = vtkHapticRecordingReader()
    reader.SetFileName(str(file))
    return updated(reader)


class RecordingReader(unittest.TestCase):
    def test_recordings_of_every_format_open(self):
        files = sorted(FIXTURES.glob("*.palpate"))
        self.assertEqual(len(files), 2)  # one on surfaces, one on lines
        for file in files:
            with self.subTest(file=file.name):
                self.assertEqual(read(file).GetNumberOfPoints(), 2)

    def test_one_whose_bit_flipped_does_not_open_and_its_chunk_is_said(self):
        whole = (FIXTURES / "format-8-solid.palpate").read_bytes()
        chunks = whole.index(b"\nend\n") + len(b"\nend\n")
        with tempfile.TemporaryDirectory() as folder:
            for at, said in ((60, "its header"), (chunks + 10, "the head of its chunk 1"),
                             (chunks + 48, f"its chunk 1 (start), bytes {chunks} to ")):
                flipped = bytearray(whole)
                flipped[at] ^= 1
                file = Path(folder, f"{at}.palpate")
                file.write_bytes(flipped)
                with self.assertRaises(Refused) as refused:
                    read(file)
                for words in (file.name, said, "another copy"):
                    self.assertIn(words, str(refused.exception))


if __name__ == "__main__":
    unittest.main(verbosity=2)
