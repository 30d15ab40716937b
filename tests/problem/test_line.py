"""The beam that is undamped on the line of its cuts: against the damped one, minima over p, and closed formulas."""

from __future__ import annotations

from fractions import Fraction
from math import sqrt
from typing import Any

import numpy as np
import pytest

from mpsolve import tracks, vehicles
from mpsolve.characteristic.floats import Floats
from mpsolve.problem.line import Line, line_height, on_line
from mpsolve.problem.problem import Problem
from mpsolve.problem.reduced import reduce_problem

PAPER = {"EI": "1/4", "m": 1, "k": 1}


def problem(alpha: object, eta_b: object = "0.05", N: object = 0, masses: int = 2) -> Problem:
    track = tracks.EulerBernoulli(**PAPER, c=2 * Fraction(str(eta_b)), N=max(Fraction(str(N)), Fraction(0)),
                                  kp=max(-Fraction(str(N)), Fraction(0)))  # fmt: skip
    return Problem(track, [vehicles.Mass(3 + j).at(Fraction(3 * j, 2)) for j in range(masses)], v=alpha)


def line(*given: Any, **named: Any) -> tuple[Line, float]:
    reduced = reduce_problem(problem(*given, **named))
    found = on_line(reduced)
    assert found is not None
    return found, float(reduced.frequency_unit)


@pytest.mark.parametrize("q", [0.3 - 0.2j, 0.7 + 0.01j, 1.1 + 0.3j, -0.4 + 0.6j])
def test_both_halves_have_the_determinant_of_the_problem(q: complex) -> None:
    """Below the line at τ = σ + η, above it at −τ; up to one constant."""
    found, unit = line("0.8", "0.1", "0.2")
    tau = 1j * np.array([q, q + 0.05j]) / unit + float(found.height)
    half = found.lower if q.imag < 0.1 else found.upper
    value = Floats(half).delta(tau if q.imag < 0.1 else -tau)[0]
    truth = Floats(reduce_problem(problem("0.8", "0.1", "0.2"))).delta(tau - float(found.height))[0]
    assert value == pytest.approx(truth, rel=1e-10)


@pytest.mark.parametrize(
    ("alpha", "eta_b", "N"), [(0.67, 0.05, 0), (1.2, 0.3, 0), (0.3, 0.05, 0.8), (0.5, 0.2, -0.5)]
)
def test_branch_points_are_where_waves_keep_up_with_the_load(alpha: float, eta_b: float, N: float) -> None:
    """Extrema of z = αp ± ½√(p⁴ − 4Np² + 4β²) over real p, by the sign of its slope on a grid."""
    found, unit = line(str(alpha), str(eta_b), str(N))
    p = np.linspace(-6, 6, 400_001)
    z = alpha * p + 0.5 * np.sqrt(p**4 - 4 * N * p**2 + 4 * (1 - eta_b**2))
    turns = np.flatnonzero(np.diff(np.sign(np.diff(z)))) + 1
    wanted = sorted(abs(z[k]) for k in turns)
    got = [float(x) * unit for x, _ in found.branch_points]
    assert [x for x in got if min(abs(np.array(wanted) - x)) < 1e-7] == pytest.approx(wanted, abs=1e-8)
    assert found.joined is bool(z.min() < 0)


def test_three_kinds_of_meeting_at_rest() -> None:
    """p⁴ = w⁴, two pairs at ±p, and a pair at p = 0: how often each is a root of the discriminant."""
    for N, wanted in (
        ("0", [(1, 3)]),
        ("0.5", [(sqrt(1 - 0.25), 2), (1, 1)]),
        ("-0.5", [(sqrt(1 - 0.25), 2), (1, 1)]),
    ):
        found, unit = line("0", "0", N)
        got = [(float(x) * unit, k) for x, k in found.branch_points]
        assert [k for _, k in got] == [k for _, k in wanted]
        assert [x for x, _ in got] == pytest.approx([x for x, _ in wanted], rel=1e-14)


def test_passive_from_the_papers_radius_on() -> None:
    """|r|² = max(A, 0)² − β²; the mobility's real part is negative for some p just inside."""
    found, unit = line("1.2", "0.1")
    A, beta2 = 1.44, 1 - 0.01
    assert float(found.passive_from) * unit**2 == pytest.approx(A**2 - beta2, rel=1e-14)
    tau = 0.3 * np.exp(0.2j) * sqrt(A**2 - beta2) / 0.3
    p = np.linspace(-5, 5, 20_001)
    for scale, passive in ((0.99, False), (1.01, True)):
        s = scale * tau - 1j * 1.2 * p
        assert bool(((scale * tau / (p**4 / 4 + beta2 + s**2)).real > 0).all()) is passive
    assert line("0.9", "0.1")[0].passive_from == 0


def test_the_gap_ends_at_the_first_branch_point() -> None:
    found, unit = line("0.67")
    end = 0.42684555358946347 / unit
    assert found.in_gap(Fraction(end * (1 - 1e-12)))
    assert not found.in_gap(Fraction(end * (1 + 1e-12)))
    assert not line("1.2")[0].in_gap(Fraction(0))


@pytest.mark.parametrize(
    "track",
    [
        tracks.EulerBernoulli(**PAPER, c=2),
        tracks.EulerBernoulli(**PAPER, c=1, N=1),
        tracks.EulerBernoulli(**PAPER, c="0.1", eta="0.01"),
        tracks.String(T=1, m=1, k=1, c="0.1"),
        tracks.Rayleigh(EI=1, m=1, J="0.1", k=1, c="0.1"),
    ],
    ids=["critical damping", "compression", "rail damping", "string", "Rayleigh"],
)
def test_other_tracks_have_no_line(track: tracks.Track) -> None:
    assert line_height(track) is None
    assert on_line(reduce_problem(Problem(track, [vehicles.Mass(1)], v="0.3"))) is None


def test_the_height_in_units_of_the_problem() -> None:
    assert line_height(tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c=770)) == Fraction(770, 120)
