"""The receptance vanishes at infinity: exponents against residues in floats, and premises that must be missed."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from track_models import DAMPED

from mpsolve import Problem, tracks, vehicles
from mpsolve.numbers.several import multiply
from mpsolve.passivity.decay import edges, in_s, overtakes, slowest_short_wave, vanishes
from mpsolve.problem.reduced import reduce_problem
from mpsolve.tracks.waveguide import Polynomial, moving

V = {"string": 100, "floating-ice": 5, "rayleigh": 4000, "timoshenko": 1500}
ONE: Polynomial = {(0, 0): Fraction(1)}


def guide(name: str) -> tuple[Polynomial, Polynomial, Fraction]:
    waveguide, v = DAMPED[name].waveguide, Fraction(V.get(name, 200))
    return moving(waveguide.dispersion, v), moving(waveguide.numerator, v), v


def weights(D: Polynomial, N: Polynomial, sigma: complex) -> Any:
    """The largest |N/D_P| over the p-roots with Re P < 0, in floats."""
    rows = np.zeros(max(i for i, _ in D) + 1, complex)
    for (i, j), c in D.items():
        rows[i] += float(c) * sigma**j
    roots = np.roots(rows[::-1])
    slope = np.polyval(np.polyder(rows[::-1]), roots)
    top = sum(float(c) * roots**i * sigma**j for (i, j), c in N.items())
    return np.abs(top / slope)[roots.real < 0]


@pytest.mark.parametrize("name", DAMPED)
def test_every_track_vanishes_at_infinity(name: str) -> None:
    D, N, v = guide(name)
    assert vanishes(D, N, v)


@pytest.mark.parametrize("name", ["string", "euler-bernoulli", "rayleigh", "timoshenko"])
@pytest.mark.parametrize("turn", [1, np.exp(1.4j), np.exp(-0.7j)])
def test_the_exponent_is_the_rate_in_every_direction(name: str, turn: complex) -> None:
    D, N, _ = guide(name)
    far, farther = (weights(D, N, size * turn).max() for size in (1e7, 1e8))
    rate = np.log10(farther / far)
    assert rate == pytest.approx(float(max(edge.weight for edge in edges(D, N))), abs=0.05)


def test_waves_of_one_speed_are_not_proved() -> None:
    line = {(2, 0): Fraction(1), (0, 2): Fraction(-1), (0, 1): Fraction(-1), (0, 0): Fraction(-1)}
    assert vanishes(line, ONE, Fraction(0))
    assert not vanishes(multiply(line, line), ONE, Fraction(0))


def test_a_receptance_that_stays_is_not_proved() -> None:
    line = {(2, 0): Fraction(1), (0, 2): Fraction(-1), (0, 0): Fraction(-1)}
    assert not vanishes(line, {(0, 1): Fraction(1)}, Fraction(0))
    assert not vanishes({(2, 0): Fraction(1), (1, 2): Fraction(-1)}, ONE, Fraction(0))  # a root 0 for every σ


def test_carried_roots_count() -> None:
    D, N, v = guide("two-layer")
    assert not vanishes(D, N, v + 1)  # the double root σ/v of the edge is no longer told apart
    slow = in_s(D, v)
    s, sigma = 0.3 + 2j, 5 - 1j
    P = (sigma - s) / float(v)
    direct = sum(float(c) * P**i * sigma**j for (i, j), c in D.items())
    assert sum(float(c) * s**i * sigma**j for (i, j), c in slow.items()) == pytest.approx(direct, rel=1e-9)


def test_sleepers_at_critical_damping_are_not_proved() -> None:
    """b(s) with a double root: two waves that are carried along do not come apart."""
    b: Polynomial = {(0, 2): Fraction(1), (0, 1): Fraction(2), (0, 0): Fraction(1)}
    rail: Polynomial = {(4, 0): Fraction(1), (0, 2): Fraction(1), (0, 1): Fraction(1), (0, 0): Fraction(1)}
    D = multiply(rail, b)
    v = Fraction(1, 2)
    assert not vanishes(moving(D, v), moving(b, v), v)


def guide_of(track: object, v: int) -> Any:
    return reduce_problem(Problem(track, [vehicles.Mass(900).at(0)], v=v)).guide


def test_a_string_is_overtaken_at_the_speed_of_its_waves() -> None:
    wire = tracks.String(T=400, m=1, k=500, c=2)  # waves at 20 m/s
    slow, fast = (guide_of(wire, v) for v in (19, 21))
    assert slowest_short_wave(slow) / float(slow.v) == pytest.approx(20 / 19)
    assert not overtakes(slow, slow.v)
    assert overtakes(fast, fast.v)


def test_the_slower_of_two_kinds_of_waves_counts() -> None:
    """Shear waves at √(S/m) = 2000 m/s, bending waves at √(EI/J) = 5000 m/s; a beam's run ever faster."""
    beam = {"EI": "6e6", "m": "60", "k": "1e6", "c": "770"}
    guide = guide_of(tracks.Timoshenko(**beam, S="2.4e8", J="0.24"), 100)
    assert slowest_short_wave(guide) / float(guide.v) == pytest.approx(20)
    assert slowest_short_wave(guide_of(tracks.EulerBernoulli(**beam), 100)) == float("inf")
