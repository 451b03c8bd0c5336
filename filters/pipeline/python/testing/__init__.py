# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests whether the output of a pipeline feels the same as before, under pytest, unittest, ctest or by hand.

    from palpate.testing import assert_feels_the_same

    def test_bone():
        assert_feels_the_same(reader, "baselines/bone.json", unit="mm")

The baseline is a file beside the test: the path of a hand and the force at each point of the path. A run of the test with
PALPATE_UPDATE_BASELINES=1 in the environment writes the baseline, at first and after each intended change.

Without Python: `python3 -m palpate.testing --help`.
"""

import math
import os
from pathlib import Path

from numpy import isfinite
from numpy.linalg import norm

from palpate.testing.baseline import Baseline, as_written, refuse_another_kind, same_size
from palpate.testing.compare import compare, is_something
from palpate.testing.coverage import changed_pieces, covered
from palpate.testing.feel import Refused, Touch, data_of
from palpate.testing.paths import read_path, strokes
from palpate.testing.report import text_of, write_differences

__all__ = ["Refused", "UPDATE", "assert_feels_the_same"]

NOTHING_N = 1e-6  # below which a force is but rounding
UPDATE = "PALPATE_UPDATE_BASELINES"  # in the environment, not empty and not 0: the forces felt become the baseline


def assert_feels_the_same(surface, baseline, *, unit, scene=None, path=None, tolerance=1.0, differences=None, update=None,
                          **settings):
    """Raises AssertionError, with the places of the differences, if a surface feels different from its baseline.

    surface      data, algorithm or its output port; a source of paraview.simple
    baseline     file; read, or written if asked for by the environment
    unit         unit of the surface: nm, um, mm, cm, m, km. A baseline in another unit is refused
    scene        name of the touched scene; default: the name of the file. A baseline of another scene is refused
    path         path of the hand, one row per tick: x, y, z or t, x, y, z [s, scene units] as rows, a file of such
                 columns, or poly data; default: the path of the baseline, and at first strokes over the six sides
    tolerance    in just noticeable differences (palpate.testing.compare); 1 is the threshold of perception
    differences  file.vtp that receives the differences, if there are any, for ParaView
    update       True: write the baseline; default: as set in the environment
    settings     of the filter Touch Along Path, by their names: Stiffness=500 [N/m] (the default here), Radius=2 [u]

    Beyond the path, the separate pieces of the surface are compared: no piece may appear, vanish, move by more than the
    reach of a hand, or change its area by 7 %. Returns the comparison; its `coverage` is the covered share of the
    surface. Data that cannot be compared raise Refused, a subclass of AssertionError, with one sentence.
    """
    if not 0 <= tolerance < math.inf:
        raise Refused(f"The tolerance {tolerance} is invalid: use a number of just noticeable differences, 0 or more.")
    baseline = Path(baseline)
    scene = scene or baseline.stem
    surface = data_of(surface)
    touch = Touch(unit, settings)
    if os.environ.get(UPDATE, "0") not in ("", "0") if update is None else update:
        return _update(surface, baseline, scene, path, touch, tolerance)
    if not baseline.exists():
        raise Refused(f"{baseline}: there is no such baseline yet; run the test once with {UPDATE}=1 to write the file.")
    known = Baseline.read(baseline)
    known.check(scene, touch, None if path is None else read_path(path), tolerance)
    same_size(known, surface)
    found = _felt(touch, known.path, surface, tolerance, known.force_N)
    if known.knows_pieces:
        found.changed = tuple(changed_pieces(known.coverage, found.coverage))
    if found.differs:
        if differences:
            write_differences(found, differences)
        raise AssertionError(text_of(found, known, differences, f"run the test again with {UPDATE}=1"))
    return found


def _update(surface, file, scene, path, touch, tolerance):
    """Keeps the path of a readable baseline that still meets the surface, unless another path is given."""
    if file.is_file():
        refuse_another_kind(file)
    way = None
    if path is not None:
        way = read_path(path)
    elif file.exists():
        way = Baseline.path_of(file, scene, touch)
    if way is None:
        way = strokes(surface, touch)
    found = _felt(touch, as_written(way), surface, tolerance)
    if path is None and not is_something(found.now_N, tolerance):  # the surface has shrunk away from the path that it was touched on
        found = _felt(touch, as_written(strokes(surface, touch)), surface, tolerance)
    _refuse_nothing(found, touch)
    Baseline.of(file, scene, touch, found, surface).write()
    return found


def _felt(touch, way, surface, tolerance, before_N=None):
    """Compares the forces along a path with the earlier forces (default: with themselves)."""
    now_N, proxies_u = touch.along(way, surface)
    found = compare(way, now_N if before_N is None else before_N, now_N, tolerance)
    if not touch.feels_field:
        there = now_N.any(axis=1) & isfinite(proxies_u).all(axis=1)
        found.coverage = covered(surface, proxies_u[there], touch.settings)
    return found


def _refuse_nothing(found, touch):
    """Refuses a baseline that a surface would pass of which nothing is left."""
    if is_something(found.now_N, found.tolerance):
        return
    if touch.feels_field:
        how = "give the path of the hand through places where the field acts"
    else:
        how = "give a path that meets the surface; for a volume set the field, such as FieldArray and FieldIsosurface"
    most_N = norm(found.now_N, axis=1).max()
    if most_N > NOTHING_N:
        raise Refused(f"The hand feels at most {most_N:.2g} N along its path, which {found.tolerance:g} just noticeable differences "
                      f"do not distinguish from zero: {how}, or use a larger Stiffness.")
    raise Refused(f"The hand touches nothing along its path: {how}.")
