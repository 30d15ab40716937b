"""Ranges that hold the speed of short waves: parts on both sides, and what is left out by name."""

from __future__ import annotations

import json
from dataclasses import replace
from fractions import Fraction
from math import sqrt
from types import SimpleNamespace
from typing import Any

import pytest
from flint import arb

from mpsolve import Effort, Problem, tracks, vehicles
from mpsolve.outcome import Reason, Status
from mpsolve.ranges import parted as module
from mpsolve.ranges.crossed import Crossings, speeds_within
from mpsolve.ranges.crossings import crossings
from mpsolve.ranges.onset import Kind, Onset, _read, onset
from mpsolve.ranges.parted import parted, speeds_above
from mpsolve.ranges.unstable import shared, unstable_ranges

WIRE = tracks.String(T=27000, m="1.07", k=500, c=2)
SPEED = sqrt(27000 / 1.07)
BEAM = tracks.Timoshenko(EI="6.38e6", m="60.2", S="2.4e8", J="0.24", k="1e6", c=770)
RAIL = Problem(BEAM, [vehicles.Mass(3000).at(0)], v=1)


def test_one_contact_on_a_wire_leaves_out_the_speed_alone() -> None:
    problem = Problem(WIRE, [vehicles.Mass(20).at(0)], v=100)
    found = crossings(problem, over={"v": (0, 300)})
    (left,) = found.left_out
    assert (found.proved, found.crossings, found.counts) == (True, (), (0, 0))
    assert float(left.value) == pytest.approx(SPEED, rel=1e-14)
    assert left.start.overlaps(left.value)
    assert left.end.overlaps(left.value)
    assert "158.851" in found.note
    assert json.loads(found.to_json())["left_out"][0]["name"].startswith("waves of the string")
    assert onset(problem, over={"v": (0, 300)}).kind is Kind.STABLE
    assert unstable_ranges(problem, over={"v": (0, 300)}).intervals == ()


def test_two_contacts_on_a_wire_are_proved_next_to_the_speed() -> None:
    problem = Problem(WIRE, [vehicles.Mass(20).at(0), vehicles.Mass(20).at(30)], v=100)
    found = crossings(problem, over={"v": (120, 300)}, check=False, effort=Effort(evaluations=2000))
    assert found.status is Status.UNVERIFIED, found.reason
    assert [(part.proved, set(part.counts or ())) for part in found.parts] == [(True, {0})] * 2
    (left,) = found.left_out
    assert left.is_point
    assert left.value.overlaps(arb(SPEED, 1e-9))


def test_a_range_that_ends_below_a_speed_is_proved_as_far_as_can_be() -> None:
    problem = Problem(WIRE, [vehicles.Mass(20).at(0), vehicles.Mass(20).at(30)], v=100)
    below = {"v": (Fraction(100), Fraction(157))}
    (speed,) = speeds_above(problem, below)
    assert float(speed.ball) == pytest.approx(SPEED)
    assert speeds_above(problem, {"v": (Fraction(100), Fraction(140))}) == []  # too far below
    assert speeds_above(problem, {"v": (Fraction(100), Fraction(160))}) == []  # below the range's end
    found = parted(problem, below, [speed], fake(problem, lambda _, high: high > 150), None, None)  # type: ignore[arg-type]
    (left,) = found.left_out
    assert (found.status, found.reason.code, left.is_point) == (Status.UNDECIDED, "left-out", False)
    assert (float(left.start), float(left.end)) == (pytest.approx(SPEED * 15 / 16), 157)
    first = _read(found, Onset(problem, below, **shared(found)))
    assert first.kind is Kind.UNDECIDED
    assert first.known["stable"] == [list(found.parts[0].over["v"])]
    below = {"v": (Fraction(100), Fraction(156))}
    whole = parted(problem, below, [speed], fake(problem, lambda *_: False), None, None)  # type: ignore[arg-type]
    assert (whole.proved, whole.left_out, whole.parts[0].over["v"][1]) == (True, (), 156)


def fake(problem: Problem, stuck: Any) -> Any:
    """An answer that is proved, with one crossing at each multiple of 1000, unless it is stuck."""

    def find(over: dict[str, Any], _: Any) -> Crossings:
        low, high = over["v"]
        if stuck(low, high):
            return Crossings(problem, over, Status.UNDECIDED, Reason("x", "it is stuck", {}, ""))
        at = [x for x in range(0, 10_000, 1000) if low < x < high]
        counts = (2 * int(low // 1000), *(2 * x // 1000 for x in at))
        return Crossings(problem, over, Status.PROVED, crossings=tuple(map(crossing, at)), counts=counts)

    return find


def crossing(at: int) -> Any:
    return SimpleNamespace(value=at, q=1, direction=2)


def joined(stuck: Any, low: int = 0, high: int = 7000) -> Crossings:
    over = {"v": (Fraction(low), Fraction(high))}
    speeds = speeds_within(RAIL, over)
    found: Crossings = parted(RAIL, over, speeds, fake(RAIL, stuck), None, None)  # type: ignore[arg-type]
    return found


def test_the_parts_between_two_speeds() -> None:
    """1996.7 and 5155.9 m/s."""
    found = joined(lambda *_: False)
    assert [c.value for c in found.crossings] == [1000, 3000, 4000, 5000, 6000]
    assert [part.counts for part in found.parts] == [
        (0, 2),
        (4, 6, 8, 10),
        (10, 12),
    ]  # what crosses at 2000 is left out
    assert [float(x.start) / float(x.value) for x in found.left_out] == pytest.approx([63 / 64] * 2, rel=1e-6)
    assert [float(x.end) / float(x.value) for x in found.left_out] == pytest.approx([65 / 64] * 2, rel=1e-6)


def test_strips_stop_where_one_is_open() -> None:
    found = joined(lambda _, high: 0.95 * 1996.67 < float(high) < 1996.67)
    assert (found.status, found.reason and found.reason.code) == (Status.UNDECIDED, "left-out")
    assert float(found.left_out[0].start) / float(found.left_out[0].value) == pytest.approx(15 / 16, rel=1e-6)


def test_an_open_part_leaves_the_whole_open() -> None:
    found = joined(lambda low, _: low > 5155)
    assert (found.status, found.counts) == (Status.UNDECIDED, None)
    assert found.reason is not None
    assert "beside shear waves" in found.reason.message
    assert len(found.known["proved"]) == 2


def test_a_part_too_short_to_be_proved_is_left_out_whole() -> None:
    """Of (1996.7, 2000] nothing is known, so that only what ends at 1965 is; and so at the start."""
    last = joined(lambda *_: False, 0, 2000)
    assert (last.proved, float(last.left_out[0].end)) == (False, 2000)
    assert "to 2000 m/s (shear waves" in last.reason.message  # type: ignore[union-attr]
    first = joined(lambda *_: False, 1990, 4500)
    assert (first.proved, float(first.left_out[0].start)) == (False, 1990)


def test_an_open_part_is_left_out_whole() -> None:
    found = joined(lambda low, _: low > 5155)
    assert float(found.left_out[1].end) == 7000


def test_what_grows_behind_the_first_speed_is_not_said_of_the_start() -> None:
    found = joined(lambda *_: False, 1990, 4500)
    read = _read(found, Onset(RAIL, found.over, **shared(found)))
    assert (read.status, read.kind, read.reason and read.reason.code) == (
        Status.UNDECIDED,
        Kind.UNDECIDED,
        "left-out",
    )


def test_an_onset_behind_a_gap_is_not_told_and_the_gap_is_named() -> None:
    """It may lie in the gap. Before a gap it is told."""
    found = joined(lambda *_: False, 1990, 4500)
    (part,) = found.parts
    found = replace(found, parts=(replace(part, parts=(), counts=(0, *part.counts[1:])),))  # type: ignore[misc]
    read = _read(found, Onset(RAIL, found.over, **shared(found)))
    assert read.kind is Kind.UNDECIDED
    assert "v from 1990 to" in read.reason.message  # type: ignore[union-attr]
    found = joined(lambda *_: False, 500, 4500)
    read = _read(found, Onset(RAIL, found.over, **shared(found)))
    assert (read.proved, read.kind, read.value, read.left_out) == (True, Kind.CROSSES, 1000, ())


def test_an_answer_begins_where_its_first_part_does() -> None:
    """Where waves are lost at rest a part from 0 on begins a little above it."""
    over = {"v": (Fraction(0), Fraction(300))}

    def find(ranges: Any, _: Any) -> Crossings:
        low, high = ranges["v"]
        return Crossings(RAIL, {"v": (low or Fraction(1), high)}, Status.PROVED, counts=(0,))

    wire = Problem(WIRE, [vehicles.Mass(20).at(0), vehicles.Mass(20).at(30)], v=100)
    found = parted(wire, over, speeds_within(wire, over), find, lambda r, _: find(r, None), None)
    assert found.over["v"] == (1, 300)


@pytest.mark.slow
def test_the_first_part_decides_an_onset() -> None:
    """Above its shear waves nothing is proved of the beam, which the onset at 330 m/s does not ask."""
    found = onset(RAIL, over={"v": (300, 2100)}, check=False, effort=Effort(seconds=60))
    assert (found.proved, found.kind) == (True, Kind.CROSSES), found.reason
    assert float(found.value) == pytest.approx(329.780659548998, rel=1e-12)


def test_the_certificate_of_a_part_is_not_that_of_the_strip_beside_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "last_strip", lambda *_: SimpleNamespace())
    wire = Problem(WIRE, [vehicles.Mass(20).at(0), vehicles.Mass(20).at(30)], v=100)
    (speed,) = speeds_within(wire, {"v": (Fraction(100), Fraction(200))})
    own = {"v": (Fraction(100), Fraction(150))}
    found = Crossings(wire, own, Status.PROVED, counts=(0,), certificate="of 100 to 150")
    whole = module._up_to(wire, found, speed, None)
    assert (whole.status, whole.certificate) == (Status.UNVERIFIED, None)
    assert [(part.over, part.certificate) for part in whole.parts[:1]] == [(own, "of 100 to 150")]
    assert (whole.parts[1].status, whole.parts[1].certificate) == (Status.UNVERIFIED, None)
