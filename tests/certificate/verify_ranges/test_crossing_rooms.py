"""Crossings of certificates over ranges: their rooms, balls, directions, and the counts between them."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest
from flint import acb, arb, fmpq

from mpsolve.certificate import verify_ranges as vr

BOX = ((fmpq(1), fmpq(2)),)
Content = dict[str, Any]


def zero(x: float, gained: int, radius: float = 2.0**-9) -> vr.Zero:
    return vr.Zero(
        (), (fmpq(1), fmpq(1, 2**9)), (fmpq(*x.as_integer_ratio()), fmpq(*radius.as_integer_ratio())), gained
    )


ONE, TWO = zero(1.25, 2), zero(1.75, -2)
CLAIM = {"counts": [0, 2, 0], "directions": [2, -2]}
CLAIMS: dict[str, tuple[list[vr.Zero], dict[str, Any], float, int, str]] = {
    "right, from before": ([TWO, ONE], CLAIM, 1.0, 0, ""),
    "right, from between": ([ONE, TWO], CLAIM, 1.5, 2, ""),
    "right, one outside": ([ONE, TWO, zero(3.0, 2)], CLAIM, 2.0, 0, ""),
    "another number at the base": ([ONE, TWO], CLAIM, 1.5, 0, "the number at the base"),
    "the base at a crossing": ([ONE, TWO], CLAIM, 1.25, 2, "base lies at a crossing"),
    "the base in its ball": ([ONE, TWO], CLAIM, 1.25 + 2.0**-10, 2, "base lies at a crossing"),
    "another direction": ([ONE, TWO], CLAIM | {"directions": [2, 2]}, 1.5, 2, "not those of the claim"),
    "counts that do not follow": ([ONE, TWO], CLAIM | {"counts": [0, 2, 2]}, 1.5, 2, "do not fit the crossings"),
    "counts of a mirror": ([ONE, TWO], CLAIM | {"counts": [2, 2, 0]}, 1.5, 2, "do not fit the crossings"),
    "one left out": ([ONE, TWO], {"counts": [0, 2], "directions": [2]}, 1.5, 2, "in place of 2"),
    "a crossing at an end": ([ONE, zero(2.0, -2)], CLAIM, 1.5, 2, "at an end of the range"),
    "a ball across an end": ([zero(0.999, 2), TWO], CLAIM, 1.5, 2, "at an end of the range"),
    "balls that meet": ([ONE, zero(1.25 + 2.0**-9, -2)], CLAIM, 1.5, 0, "not told apart"),
}


@pytest.mark.parametrize("name", CLAIMS)
def test_counts_between_crossings(name: str) -> None:
    zeros, claim, at, unstable, why = CLAIMS[name]
    base = [fmpq(*at.as_integer_ratio())]
    if not why:
        assert "2 crossings" in vr.crossings(claim, zeros, BOX, base, unstable)[0]
    else:
        with pytest.raises(vr.Refused, match=why):
            vr.crossings(claim, zeros, BOX, base, unstable)


ROOM = [[[1, -2], [1, 0]], [[5, -2], [3, -1]]]  # 1/4 ≤ q ≤ 1, 5/4 ≤ x ≤ 3/2
Q, X = {"middle": "0x5", "exponent": -3, "radius": [1, -30]}, {"middle": "0xb", "exponent": -3, "radius": [1, -30]}
AT_ZERO = {"room": [[[-1, 0], [1, 0]], ROOM[1]], "q": Q | {"middle": "0x0"}, "x": X}
RIGHT = {"room": ROOM, "q": Q, "x": X}


def family(left: int = 1000) -> Any:
    some = vr.spectra.Bodies([], None, [], [], 0, 0)
    return vr.Family(None, some, BOX, None, None, None, left)  # type: ignore[arg-type]


def read(
    monkeypatch: pytest.MonkeyPatch, value: Content, slope_q: complex, slope_x: complex, left: int = 1000
) -> Any:
    """With s = slope_q·u + slope_x·w on the balls."""
    k = [acb(0), acb(slope_q), acb(slope_x), acb(0), acb("1e-3"), acb(0)]
    monkeypatch.setattr(vr, "Waves", lambda *_: None)
    monkeypatch.setattr(vr.spectra, "Bordered", lambda *_: None)
    monkeypatch.setattr(vr, "check_alone", lambda *_: None)
    monkeypatch.setattr(vr, "slopes", lambda *_: (k[1:3], [arb("3e-3")] * 2, k, arb("1e-3")))
    return vr.read_zero(value, family(left))


@pytest.mark.parametrize(("value", "number"), [(RIGHT, 2), (AT_ZERO, 1)])
def test_a_crossing_goes_the_way_its_slopes_say(monkeypatch: pytest.MonkeyPatch, value: Content, number: int) -> None:
    """Im q′ = −Im(s_x/s_q) < 0: the root comes to grow."""
    assert read(monkeypatch, value, 1, 1j).gained == number
    assert read(monkeypatch, value, 1, -1j).gained == -number


WRONG: dict[str, tuple[Content, complex, str]] = {
    "q outside its room": (RIGHT | {"q": Q | {"middle": "0x9"}}, 1j, "not inside its room"),
    "x outside its room": (RIGHT | {"x": X | {"middle": "0xd"}}, 1j, "not inside its room"),
    "a ball across its room": (RIGHT | {"q": Q | {"radius": [1, -1]}}, 1j, "not inside its room"),
    "a room turned": (RIGHT | {"room": [ROOM[0][::-1], ROOM[1]]}, 1j, "not inside its room"),
    "half a room round 0": (AT_ZERO | {"room": [[[-1, -1], [1, 0]], ROOM[1]]}, 1j, "not symmetric"),
    "a room across 0": (RIGHT | {"room": [[[-1, 0], [1, 0]], ROOM[1]]}, 1j, "may lie at q = 0"),
    "a ball across 0": (
        {"room": [[[-1, 0], [1, 0]], ROOM[1]], "q": Q | {"middle": "0x1", "radius": [1, -2]}, "x": X},
        1j,
        "may lie at q = 0",
    ),
    "along the axis": (RIGHT, 1, "not proved to lie in its balls"),
    "nearly along the axis": (RIGHT, 1 + 0.004j, "without crossing it"),
}


@pytest.mark.parametrize("name", WRONG)
def test_a_crossing_is_refused(monkeypatch: pytest.MonkeyPatch, name: str) -> None:
    value, slope, why = WRONG[name]
    with pytest.raises(vr.Refused, match=why):
        read(monkeypatch, value, 1, slope)


def test_the_work_of_crossings_with_many_digits_is_bounded(monkeypatch: pytest.MonkeyPatch) -> None:
    long = RIGHT | {"q": Q | {"radius": [1, -5000]}}
    assert read(monkeypatch, long, 1, 1j).gained == 2
    with pytest.raises(vr.Refused, match="more work"):
        read(monkeypatch, long, 1, 1j, 40)


@pytest.mark.parametrize(("bend", "fine"), [(0.1, True), (3.0, True), (100.0, False)])
def test_a_room_holds_one_crossing(monkeypatch: pytest.MonkeyPatch, bend: float, fine: bool) -> None:
    """s = u + i·w + bend·u²/2 about the crossing: boxes round it are made smaller until it is one to one there."""
    proved: list[Any] = []
    some = family()
    monkeypatch.setattr(vr.Family, "prove", lambda _, kind, box: proved.append((kind, box)))

    def slopes(_: Any, sides: Any) -> Any:
        r = [float(arb(r)) for _, r in sides]
        return [acb(r[0]), acb(0, r[1])], [arb(bend * r[0] ** 2), arb(0)], [], arb(0)

    monkeypatch.setattr(vr, "slopes", slopes)
    room, at, radius = (
        ((fmpq(1, 4), fmpq(1)), (fmpq(5, 4), fmpq(3, 2))),
        (fmpq(5, 8), fmpq(11, 8)),
        (fmpq(1, 99),) * 2,
    )
    if fine:
        vr.check_alone(some, room, at, radius)
        assert len(proved) == (0 if bend < 1 else 8)
    else:
        with pytest.raises(vr.Refused, match="two crossings"):
            vr.check_alone(some, room, at, radius)
    monkeypatch.setattr(vr, "slopes", lambda *_: ([acb(0), acb(0)], [arb(1)] * 2, [], arb(0)))
    with pytest.raises(vr.Refused, match="two crossings"):
        vr.check_alone(replace(some), room, at, (fmpq(0), fmpq(0)))
