"""Reasons: the place, what lies there, and a remedy that fits."""

from __future__ import annotations

from typing import Any

import pytest

from mpsolve import Problem, tracks, vehicles
from mpsolve.errors import EffortError, PrecisionError
from mpsolve.outcome import Reason
from mpsolve.problem.line import on_line
from mpsolve.problem.reduced import Reduced, reduce_problem
from mpsolve.proof.cover import OpenPieceError
from mpsolve.spectrum.reasons import WavesMeetError, reason_of, sheet_reason

WIRE = reduce_problem(Problem(tracks.String(T=27_000, m="1.07", k=500, c=2), vehicles.Mass("8.5"), v=100))
ROOT = 15.641876611743 + 0.715988110564j
SPENT = EffortError(Reason("effort", "the effort of 5 evaluations is spent", {}, "more"))


def beam(v: str, c: str) -> Reduced:
    return reduce_problem(Problem(tracks.EulerBernoulli(EI="0.25", m=1, k=1, c=c), vehicles.Mass(7), v=v))


def test_effort_is_told_once() -> None:
    found = reason_of(WIRE, SPENT)
    assert (found.code, found.message) == ("effort", "the effort of 5 evaluations is spent")
    assert str(found).count("effort=Effort") == 1


def test_a_root_on_the_line_is_named() -> None:
    unit = float(WIRE.frequency_unit)
    found = reason_of(WIRE, OpenPieceError(ROOT / unit * (1 + 1e-9), 1e-9))
    assert found.code == "root-on-line"
    assert found.numbers["root"] == "15.64187661"
    assert "Rectangle" in found.remedy
    elsewhere = reason_of(WIRE, OpenPieceError(3 / unit + 0j, 1e-9))
    assert (elsewhere.code, elsewhere.numbers["re"]) == ("line", "3")


@pytest.mark.parametrize(
    ("v", "c", "remedy"),
    [
        ("0.5", "0.1", 'ask for "unstable"'),
        ("1.2", "0.1", 'ask for "unstable"'),
        ("0.5", "0", 'ask for "unstable"'),  # passive: nothing grows
        ("1.2", "0", 'give some damping, and ask for "unstable"'),
    ],
)
def test_what_helps_on_the_sheet(v: str, c: str, remedy: str) -> None:
    reduced = beam(v, c)
    line: Any = on_line(reduced)
    assert sheet_reason(line, reduced, PrecisionError("open")).remedy == remedy
    assert sheet_reason(line, reduced, SPENT).remedy.endswith(f", or {remedy}")


def test_waves_that_meet_have_a_rectangle_as_remedy() -> None:
    found = reason_of(beam("0.5", "0.1"), WavesMeetError())
    assert found.code == "waves-meet"
    assert "re_min > 0" in found.remedy
