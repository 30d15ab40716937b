"""Ranges of velocities are covered where no root of the row is real, and never beyond a root that is."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
from endless_rows import masses

from mpsolve import Effort
from mpsolve.endless.convective import cover_row
from mpsolve.endless.row_scope import RowScope, judge_of, row_scope
from mpsolve.ranges.judge import NONZERO, PASSIVE

THRESHOLD = Fraction("0.1901469010")  # in floats


def scope(low: str, high: str) -> RowScope:
    return row_scope(masses("0.15"), Fraction(low), Fraction(high))


def test_up_to_a_little_below_the_threshold() -> None:
    found = cover_row(scope("0.18", "0.192"), THRESHOLD, Effort(evaluations=100_000))
    assert found.reason is None
    assert found.top is not None
    assert 0 < THRESHOLD - found.top < Fraction("1e-8")


def test_not_beyond_it() -> None:
    found = cover_row(scope("0.1895", "0.192"), Fraction("0.1905"), Effort(evaluations=20_000))
    assert found.top is None or found.top < THRESHOLD


def test_a_box_with_a_real_root_stays_open() -> None:
    here = scope("0.18", "0.2")
    judge, unit = judge_of(here), float(here.family.units[0])
    root = np.array([0.2494775, float(THRESHOLD) / unit, 2.0502262])  # where it is real for the first time
    for size in (1e-2, 1e-4, 1e-6):
        kind, _ = judge((root - size)[:, None], (root + size)[:, None])
        assert kind[0] == 0
    away = root + np.array([0.0, -0.02, 0.0])
    assert judge((away - 1e-3)[:, None], (away + 1e-3)[:, None])[0][0] in (NONZERO, PASSIVE)


def test_spent_effort_is_said() -> None:
    found = cover_row(scope("0.1", "0.192"), THRESHOLD, Effort(evaluations=100))
    assert found.top is None
    assert found.reason is not None
    assert found.reason.code == "effort"


def test_what_was_covered_before_the_effort_ended_is_kept() -> None:
    found = cover_row(scope("0.1", "0.192"), THRESHOLD, Effort(evaluations=6000))
    assert found.reason is not None
    assert found.top is not None
    assert Fraction("0.105") < found.top < Fraction("0.189")
