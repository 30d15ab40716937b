"""Unstable velocities and the first onset against known values, single certified cases and tracked roots."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import flint
import pytest
from oracle import Truth

from mpsolve import Case, Exact
from mpsolve.certificate.sheet import certify_sheet as certify
from mpsolve.errors import InputError
from mpsolve.fields import ball_arithmetic
from mpsolve.stability.velocities import onset_velocity, unstable_velocities

STEP = Fraction(1, 10**8)


def counts_beside(ball: Any, eta_b: str, eta_m: Any, positions: Any) -> list[int | None]:
    """Unstable roots 10⁻⁸ below and above the velocity."""
    with ball_arithmetic(200):
        alpha = Fraction(ball.str(20, radius=False))
    cases = [Case(alpha=alpha + h, eta_b=eta_b, eta_m=eta_m, positions=positions) for h in (-STEP, STEP)]
    return [certify(case, digits=15, region="unstable").unstable for case in cases]


def is_known(ball: Any, text: str) -> bool:
    """The ball agrees with the decimal to its last digit."""
    with ball_arithmetic(200):
        return bool(ball.overlaps(flint.arb(f"{text} +/- 2e-{len(text.split('.')[1])}")))


@pytest.mark.parametrize(
    ("eta_m", "positions", "alpha", "known"),
    [
        (70, None, ("0.9", "1.2"), "1.0749004571386740524"),
        ((70, 70), (0, 1), ("0.9", "1"), "0.96195748632180021651"),
        ((70, 70), (0, "1.5"), ("0.6", "0.7"), "0.66691895728454957327"),
        ((90, 50), (0, "1.5"), ("0.9", "1"), ""),
    ],
)
def test_onset(eta_m: Any, positions: Any, alpha: Any, known: str) -> None:
    onset = onset_velocity("0.05", eta_m, positions, alpha=alpha, digits=20)
    assert onset.proved
    if known:
        assert is_known(onset.alpha, known)
    assert onset.alpha.rad() < abs(onset.alpha) * flint.arb(10) ** -20
    assert counts_beside(onset.alpha, "0.05", eta_m, positions) == [0, 2]
    assert abs(onset.stable_below - float(onset.alpha.mid())) < 1e-15
    assert onset.certificate is not None


def test_the_real_frequency_of_an_onset_is_a_root_that_goes_down() -> None:
    onset = onset_velocity("0.05", (70, 70), (0, "1.5"), alpha=("0.6", "0.7"))
    truth = Truth(Case(alpha=1, eta_b="0.05", eta_m=(70, 70), positions=(0, "1.5")), 45)
    mp = truth.mp
    with ball_arithmetic(200):
        alpha, q = (mp.mpf(ball.str(40, radius=False)) for ball in (onset.alpha, onset.q))
    heights = []
    for h in (-(mp.mpf(10) ** -8), 0, mp.mpf(10) ** -8):
        truth.alpha = alpha + h
        heights.append(truth.root(q).imag)
    assert heights[0] > 0 > heights[2]
    assert abs(heights[1]) < mp.mpf(10) ** -27


def test_an_interval_that_closes_and_a_second_onset() -> None:
    """Two masses of 50 at 1.5: unstable, stable again, unstable."""
    ranges = unstable_velocities("0.05", (50, 50), (0, "1.5"), alpha=("0.65", "1"), digits=20)
    assert ranges.proved
    assert ranges.unknown == ranges.strips == ()
    first, second = ranges
    known = "0.69584385924996672513", "0.88609089575556319254", "0.96719848239897487232"
    for ball, text in zip((first.start, first.end, second.start), known, strict=True):
        assert is_known(ball, text)
    assert counts_beside(first.end, "0.05", (50, 50), (0, "1.5")) == [2, 0]
    assert second.end == 1
    assert second.q_end is None
    assert (first.roots, second.roots) == (2, 2)
    for q, text in (
        (first.q_start, "0.181056711371312"),
        (first.q_end, "0.153945236472262"),
        (second.q_start, "0.1430332"),
    ):
        assert is_known(q, text)
    assert ranges.certificate is not None


@pytest.mark.slow
def test_the_whole_range_of_the_documentation() -> None:
    ranges = unstable_velocities("0.05", (50, 50), (0, "1.5"))
    assert ranges.proved
    assert len(ranges) == 2
    assert ranges[0].start.overlaps(unstable_velocities("0.05", (50, 50), (0, "1.5"), alpha=("0.6", "0.7"))[0].start)


def test_a_range_that_is_unstable_from_its_start() -> None:
    (interval,) = unstable_velocities("0.05", 70, alpha=("1.1", "1.2"))
    assert interval.start.overlaps(flint.arb("1.1"))
    assert interval.end.overlaps(flint.arb("1.2"))
    assert interval.q_start is None
    assert interval.q_end is None
    assert interval.roots == 2


@pytest.mark.parametrize(
    ("eta_b", "eta_m", "alpha"),
    [
        ("0.05", 70, ("0.7", "0.99")),
        pytest.param("0.3", 500, ("0", "0.95"), marks=pytest.mark.slow),
        pytest.param("0.01", 5, ("0.5", "0.9"), marks=pytest.mark.slow),
    ],
)
def test_one_damped_mass_is_stable_below_the_critical_velocity(eta_b: str, eta_m: int, alpha: Any) -> None:
    ranges = unstable_velocities(eta_b, eta_m, alpha=alpha)
    assert ranges.proved
    assert len(ranges) == 0
    onset = onset_velocity(eta_b, eta_m, alpha=alpha)
    assert onset.proved
    assert onset.alpha is None
    assert onset.stable_below == float(alpha[1])


@pytest.mark.slow
def test_masses_that_are_close_act_as_their_sum() -> None:
    single = onset_velocity("0.1", 70, alpha=("1", "1.3"))
    merged = onset_velocity("0.1", (40, 30), (0, 0), alpha=("1", "1.3"))
    near = onset_velocity("0.1", (40, 30), (0, "0.05"), alpha=("1", "1.3"))
    assert single.alpha.overlaps(merged.alpha)
    assert 0 < abs(float(near.alpha - single.alpha)) < 1e-2


def test_without_damping_the_energy_decides_below_the_critical_velocity() -> None:
    stable = unstable_velocities(0, (70, 70), (0, 1), alpha=(0, "0.9999"))
    assert stable.proved
    assert len(stable) == 0
    open_above = unstable_velocities(0, (70, 70), (0, 1), alpha=("0.5", "1.1"))
    assert not open_above.proved
    ((start, end),) = open_above.unknown
    assert 0.999 < start <= 1
    assert 1 < end < 1.05
    (above,) = open_above  # from the end of the strip on: proved by the cut points and a certified count
    assert (above.q_start, above.q_end) == (None, None)
    assert above.end.overlaps(Exact("1.1").ball())
    assert above.roots == certify(Case(alpha="1.08", eta_b=0, eta_m=(70, 70), positions=(0, 1)), digits=15).unstable
    assert above.roots == 2
    closed = unstable_velocities(0, (70, 70), (0, 1), alpha=("1.06", "1.1"))
    assert closed.proved
    assert [interval.roots for interval in closed] == [2]
    onset = onset_velocity(0, (70, 70), (0, 1), alpha=("0.5", "1.1"))
    assert not onset.proved
    assert onset.alpha is None
    assert onset.stable_below <= 1


def test_an_undecided_range_makes_no_claim(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("mpsolve.stability.passages._BUDGET", 40)
    ranges = unstable_velocities("0.05", (50, 50), (0, "1.5"), alpha=("0.65", "1"))
    assert not ranges.proved
    assert ranges.certificate is None
    assert ranges.reason
    assert all(any(low <= t <= high for low, high in ranges.unknown) for t in (0.69584, 0.88609, 0.9672))
    assert not onset_velocity("0.05", (50, 50), (0, "1.5"), alpha=("0.65", "1")).proved


@pytest.mark.parametrize("alpha", [(1, 0.5), (1, 1), (-0.1, 1), 3, ("root4(2)", 2), (0, 1, 2), (0, "nan")])
def test_ranges_that_are_none_are_refused(alpha: Any) -> None:
    with pytest.raises(InputError, match="alpha"):
        unstable_velocities("0.05", 70, alpha=alpha)
