# SPDX-License-Identifier: GPL-3.0-or-later
"""The file that says how a surface felt: text, a row a line, so that a change of it can be read in a review."""

import json
import os
from dataclasses import dataclass
from pathlib import Path

import numpy as np

import palpate
from palpate.testing.compare import is_something
from palpate.testing.coverage import Coverage
from palpate.testing.feel import Refused

FORMAT = 1
KIND = "palpate baseline"
HEAD_BYTES = 200  # of a file: a baseline says within them that it is one
COLUMNS = ["t", "x", "y", "z", "force_x", "force_y", "force_z"]  # [s, scene units, N]
SAME_WAY = 1e-9  # largest relative difference of two paths that are meant to be the same
ANOTHER_SIZE = 10.0  # times as large or as small: another unit or another thing, not a change of this one


def release(version):
    """The part of a version within which forces stay: before 1.0 any minor version may change them."""
    return ".".join(version.split(".")[:2])


def _size_u(surface):
    """Length of the diagonal of its box."""
    bounds = [0.0] * 6
    surface.GetBounds(bounds)
    return float(np.linalg.norm(np.array(bounds[1::2]) - bounds[0::2]))


def same_size(baseline, surface):
    """Refuses a surface that is many times as large or as small as that of the baseline."""
    times = _size_u(surface) / baseline.size_u
    if not 1 / ANOTHER_SIZE < times < ANOTHER_SIZE:
        raise Refused(f"{baseline.file}: the surface is {times:.3g} times as large as that of the baseline, so that it is another "
                      f"scene or no longer in {baseline.unit}; give it in {baseline.unit}, or write the baseline again.")


def refuse_another_kind(file):
    """Refuses a file that is there and is not a baseline, so that an update overwrites nothing else."""
    with file.open("rb") as held:
        if KIND.encode() not in held.read(HEAD_BYTES):
            raise Refused(f"{file}: not a baseline of palpate.testing; name another file or remove this one.")


def _rounded(number):
    """Rounds to twelve digits, so that stored and computed numbers are the same."""
    return float(f"{number:.12g}")


def as_written(path):
    """The path after storage in a file: at a corner of a surface, a path that differs by rounding may continue elsewhere."""
    return np.vectorize(_rounded, otypes=[float])(path)


@dataclass
class Baseline:
    """Forces along a path, with scene, unit and version."""

    file: Path
    scene: str
    unit: str
    version: str
    settings: dict  # of Touch Along Path
    size_u: float  # diagonal of the surface's box
    path: np.ndarray  # (n, 4): t, x, y, z [s, scene units]
    force_N: np.ndarray  # (n, 3)
    coverage: Coverage = None  # of the surface; None: it has no faces, or a field is felt
    knows_pieces: bool = True  # False: it was written before baselines had the pieces of a surface

    @classmethod
    def of(cls, file, scene, touch, felt, surface):
        """Makes a baseline from a comparison of a touch with itself."""
        return cls(file, scene, touch.unit, palpate.__version__, touch.settings, _size_u(surface), felt.path, felt.now_N,
                   felt.coverage)

    @classmethod
    def path_of(cls, file, scene, touch):
        """The path in a file of the same scene and unit; None for an unusable file."""
        try:
            known = cls.read(file)
        except Refused:
            return None
        return known.path if (known.scene, known.unit) == (scene, touch.unit) else None

    @classmethod
    def read(cls, file):
        """Reads a baseline; a file of another kind is refused."""
        try:
            held = json.loads(file.read_text(encoding="utf-8"))
        except (OSError, ValueError, RecursionError) as problem:
            raise Refused(f"{file}: it cannot be read as a baseline ({problem}); write the baseline again.") from None
        if not isinstance(held, dict) or KIND not in held:
            raise Refused(f"{file}: it is no baseline of palpate.testing; name another file.")
        if held[KIND] != FORMAT:
            raise Refused(f"{file}: it is a baseline of format {held[KIND]}, and Palpate {palpate.__version__} reads "
                          f"{FORMAT}; write the baseline again.")
        try:
            rows = np.array(held["rows"], dtype=float)
            if rows.ndim != 2 or rows.shape[1] != len(COLUMNS) or not np.isfinite(rows).all() or held["columns"] != COLUMNS:
                raise ValueError("its rows")
            if not (held["size"] > 0 and isinstance(held["settings"], dict)):
                raise ValueError("its size or settings")
            coverage = Coverage.read(held["surface"]) if held.get("surface") is not None else None
            return cls(file, str(held["scene"]), str(held["unit"]), str(held["version"]), held["settings"],
                       float(held["size"]), rows[:, :4], rows[:, 4:], coverage, "surface" in held)
        except (KeyError, TypeError, ValueError, OverflowError) as problem:
            raise Refused(f"{file}: the baseline is damaged ({problem}); write the baseline again.") from None

    def write(self):
        """All of it or nothing."""
        head = {KIND: FORMAT, "version": self.version, "scene": self.scene, "unit": self.unit, "size": _rounded(self.size_u),
                "settings": self.settings, "columns": COLUMNS}
        surface = json.dumps(self.coverage and self.coverage.as_written())
        rows = ",\n".join(json.dumps([_rounded(number) for number in row]) for row in np.hstack([self.path, self.force_N]))
        text = f'{json.dumps(head, indent=1)[:-2]},\n "surface": {surface},\n "rows": [\n{rows}\n]}}\n'
        beside = self.file.with_name(f"{self.file.name}.part")
        try:
            self.file.parent.mkdir(parents=True, exist_ok=True)
            beside.write_text(text, encoding="utf-8")
            os.replace(beside, self.file)
        except OSError as problem:
            raise Refused(f"{self.file}: the baseline cannot be written ({problem.strerror}).") from None

    def check(self, scene, touch, path, tolerance):
        """Refuses a baseline of another scene, unit, version or settings, and a baseline without force."""
        if self.scene != scene:
            raise Refused(f"{self.file}: it is the baseline of the scene {self.scene!r}, not of {scene!r}; name another file.")
        if self.unit != touch.unit:
            raise Refused(f"{self.file}: the baseline is in {self.unit}, the test in {touch.unit}; give the surface in "
                          f"{self.unit}, or write the baseline again.")
        if release(self.version) != release(palpate.__version__):
            raise Refused(f"{self.file}: the baseline is of Palpate {self.version}, and {palpate.__version__} may feel otherwise "
                          "by intention; write the baseline again where the old version still passes.")
        if self.settings != touch.settings:
            changed = sorted(name for name in {**self.settings, **touch.settings}
                             if self.settings.get(name) != touch.settings.get(name))
            said = ", ".join(f"{name} {self.settings.get(name)} then, {touch.settings.get(name)} now" for name in changed)
            raise Refused(f"{self.file}: the baseline has other settings ({said}); write the baseline again.")
        if not is_something(self.force_N, tolerance):
            raise Refused(f"{self.file}: the hand of the baseline felt nothing that {tolerance:g} just noticeable differences tell "
                          "from zero, so that any surface would pass; write the baseline again along a path that meets the surface.")
        if path is not None and not self._leads_along(path):
            raise Refused(f"{self.file}: the path of the baseline differs from the given path; write the baseline again.")

    def _leads_along(self, path):
        """Whether the path is that of the file, up to rounding relative to the size of the surface and to 1 s."""
        scale = np.maximum(np.abs(self.path), [1.0, *3 * [self.size_u]])
        return path.shape == self.path.shape and bool((np.abs(path - self.path) <= SAME_WAY * scale).all())
