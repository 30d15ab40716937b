"""Where the lowest root lies: inside or at an end, growing or decaying, beside straight cuts and others."""

from __future__ import annotations

import pytest
from flint import arb
from lowest_roots import assert_lowest, pair

from mpsolve import Problem, certify, tracks, vehicles, worst
from mpsolve.numbers.balls import precision
from mpsolve.problem.family import Family
from mpsolve.ranges import line, lowest
from mpsolve.ranges.seen import Seen
from mpsolve.spectrum.candidates import Area


@pytest.mark.parametrize(
    ("ends", "where", "at"),
    [(("1.3", "1.6"), "start", "1.3"), (("0.6", "1"), "end", "1"), (("1.1232885", "1.3"), "inside", None)],
)
def test_at_an_end_of_the_range_too(ends: tuple[str, str], where: str, at: str | None) -> None:
    """A minimum at an end was undecided once; there Im q rises from the end, and the value is that number."""
    found = worst(pair("0.99", "0.5"), over={"gap[0]": ends}, check=False)
    assert (found.proved, found.where) == (True, where), found.reason
    if at is not None:
        with precision(200):
            assert found.value.overlaps(arb(at))  # type: ignore[union-attr]
        assert found.lower <= float(at) <= found.upper  # type: ignore[operator]
    assert_lowest(pair("0.99", "0.5"), "gap[0]", found, [*ends], "unstable")


def test_where_all_are_stable_it_is_the_least_damped_root() -> None:
    """Below the critical velocity nothing grows: among roots below the cuts, here at Im q = 0.5, as far as reach."""
    case = pair("0.3", "0.5")
    found = worst(case, over={"gap[0]": ("0.5", 3)}, check=False)
    assert found.proved, found.reason
    assert found.growth < 0  # type: ignore[operator]
    assert found.reach == 2
    # found by another proof: a minimum of the old search over the whole sheet
    assert abs(float(found.value.mid()) - 2.08462889362238) < 1e-13  # type: ignore[union-attr]
    assert_lowest(case, "gap[0]", found, ["0.5", "1", "2", "2.1", "3"], ("below", "0.2"))


def test_cuts_may_leave_their_line() -> None:
    """With an axial force of 0.9 the cuts are no straight line: the old proof refused such a case."""
    case = pair("0.5", "0.5", eta_n="0.9")
    found = worst(case, over={"gap[0]": ("0.5", 3)}, check=False)
    assert (found.proved, found.where) == (True, "inside"), found.reason
    assert_lowest(case, "gap[0]", found, ["0.5", "1", "1.1", "1.2", "3"], "unstable")


def test_next_to_an_end_one_line_tells_all(monkeypatch: pytest.MonkeyPatch) -> None:
    """Both of its crossings lie in the range, so that no second line is asked for."""
    asked = []
    monkeypatch.setattr(lowest, "cross_line", lambda *some: asked.append(some) or line.cross_line(*some))
    found = worst(pair("0.99", "0.5"), over={"gap[0]": (1, 5)}, check=False)
    assert (found.where, len(asked)) == ("inside", 1)
    assert abs(float(found.value.mid()) - 1.12328854764379) < 1e-13  # type: ignore[union-attr]


def test_a_certified_root_below_the_one_that_floats_saw_is_taken_up(monkeypatch: pytest.MonkeyPatch) -> None:
    """The bounce of a coach was not seen far below the waves of its track, and a minute led to nothing."""
    track = tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e8", c="1e5")
    sprung = Problem(track, vehicles.Oscillator(wheel=1000, body=10000, k="1e6", c="1e4"), v=60)
    other = next(root.q for root in certify(sprung, check=False).roots if root.q.real > 300)

    def wrong(family: Family, low: float, high: float, _area: Area) -> Seen:
        return Seen((low + high) / 2, complex(other) / float(family.frequency_unit), (high - low) / 16)

    monkeypatch.setattr(lowest, "least_seen", wrong)
    found = worst(sprung, over={"v": (50, 80)}, check=False)
    assert (found.proved, found.where) == (True, "start"), found.reason
    at_50 = certify(sprung.changed("v", 50), check=False)
    assert all(found.q.imag.overlaps(root.q.imag) or root.q.imag > found.q.imag for root in at_50.roots)  # type: ignore[union-attr]
