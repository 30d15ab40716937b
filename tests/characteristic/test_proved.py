"""Balls hold the residue sums of mpmath, are narrow, and say so where they cannot tell."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from residue import TRACKS, Residues, holds, random_track

from mpsolve.characteristic.floats import Floats
from mpsolve.characteristic.proved import Proved, split_ball
from mpsolve.characteristic.splitting import upper_count
from mpsolve.characteristic.symbol import Symbols
from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, arb, exact_ball, precision, square
from mpsolve.problem.problem import Problem
from mpsolve.problem.reduced import reduce_problem, track_guide
from mpsolve.tracks import EulerBernoulli
from mpsolve.vehicles import Bogie, Mass

XI = [Fraction(-7, 4), Fraction(0), Fraction(1, 2)]
SIGMA = [0.5 + 0.25j, 0.125 - 1.5j]


def receptances(guide: Any, sigma: Any) -> tuple[list[Any], list[Any], bool]:
    symbols = Symbols.of(guide)
    split = split_ball(symbols, sigma, upper_count(symbols.D))
    return *split.receptances(XI), split.signed


def check(track: Any, v: Fraction, bits: int = 200) -> None:
    guide = track_guide(track, v)
    truth = Residues(guide, 80)
    for s in SIGMA:
        with precision(bits):
            G, G_sigma, signed = receptances(guide, exact_ball(s))
        assert signed
        for x, value, slope in zip(XI, G, G_sigma, strict=True):
            assert holds(value, truth(x, s))
            assert abs(complex(slope) - complex(truth.slope(x, s))) < 1e-15 * (1 + abs(complex(slope)))
            assert max(float(value.rad()), float(slope.rad())) < 2.0 ** (40 - bits)


@pytest.mark.parametrize("size", [1, 2, 3])
@pytest.mark.parametrize("v", [Fraction(0), Fraction(1, 3), Fraction(17, 8)])
def test_random_tracks(size: int, v: Fraction) -> None:
    for seed in range(2):
        check(random_track(size, seed), v)


@pytest.mark.parametrize("name", TRACKS)
@pytest.mark.parametrize("share", [Fraction(0), Fraction(1, 2), Fraction(3, 2)])
def test_the_tracks_of_the_package(name: str, share: Fraction) -> None:
    still = track_guide(TRACKS[name], Fraction(0))
    check(TRACKS[name], share * Fraction(2) ** (still.length - still.time))


def test_the_table_of_upper_roots() -> None:
    """1 for a string, none when it is outrun; and so on for waves of beams and layers that are outrun."""
    fast = Fraction(200)
    count = lambda track, v: upper_count(Symbols.of(track_guide(track, v)).D)  # noqa: E731
    assert count(TRACKS["string"], Fraction(100)) == 1
    assert count(TRACKS["string"], fast) == 0
    for name in ("winkler", "euler-bernoulli", "kelvin-voigt", "two-layer", "timoshenko", "rayleigh"):
        assert count(TRACKS[name], Fraction(0)) == count(TRACKS[name], fast) == 2
    for name, at_rest, moving in (("three-layer", 3, 2), ("slab", 4, 4), ("floating-ice", 3, 3)):
        assert (count(TRACKS[name], Fraction(1)), count(TRACKS[name], fast)) == (at_rest, moving)
    shear, bending = (2.4e8 / 60.2) ** 0.5, (6.38e6 / 0.24) ** 0.5
    speeds = [Fraction(round(x)) for x in (0.9 * shear, 1.1 * shear, 1.1 * bending)]
    assert [count(TRACKS["timoshenko"], v) for v in speeds] == [2, 1, 0]
    assert [count(TRACKS["rayleigh"], v) for v in speeds] == [2, 2, 1]


def test_nothing_runs_ahead_of_a_string_that_is_outrun() -> None:
    G, _, _ = receptances(track_guide(TRACKS["string"], Fraction(200)), exact_ball(0.5 + 0.25j))
    assert G[1].contains(0)
    assert float(G[1].abs_upper()) < 1e-15
    assert not G[0].contains(0)


MEET = EulerBernoulli(EI="1/4", m=1, k="0.7", c="0.1", kp=1)
"""At rest and s = 1/2 its D = EI (P² − 2)² has two double roots, P = ±√2: G = e^{−a|ξ|}(1 + a|ξ|)/a³, a = √2."""


def test_an_exact_double_root() -> None:
    guide = track_guide(MEET, Fraction(0))
    with precision(300):
        G, G_sigma, signed = receptances(guide, acb(arb((1, -1 + guide.time))))
        assert signed
        a, unit = arb(2).sqrt(), arb((1, guide.length))
        for x, value in zip(XI, G, strict=True):
            distance = a * unit * abs(arb(x.numerator) / x.denominator)
            exact = (-distance).exp() * (1 + distance) / a**3
            scaled = value * (arb(guide.g.numerator) / guide.g.denominator)
            assert scaled.overlaps(acb(exact))
            assert scaled.rad() < 1e-70
        assert all(g.rad() < 1e-60 for g in G_sigma)


@pytest.mark.parametrize("power", [10, 24, 30, 60, 100])
def test_nearly_double_roots(power: int) -> None:
    """The discs of the roots, and the factors where discs cannot be told apart, meet the same truth."""
    guide = track_guide(MEET, Fraction(0))
    truth = Residues(guide, 200)
    s = (truth.mp.mpf(1) / 2 + truth.mp.mpf(2) ** -power) * 2**guide.time
    with precision(256):
        sigma = acb((arb(1) / 2 + arb((1, -power))) * arb((1, guide.time)))
        G, G_sigma, signed = receptances(guide, sigma)
    assert signed
    for x, value, slope in zip(XI, G, G_sigma, strict=True):
        assert holds(value, truth(x, s))
        assert float(value.rad()) < 1e-40
        assert abs(complex(slope) - complex(truth.slope(x, s))) < 1e-13


@pytest.mark.parametrize("half", [1e-9, 1e-4, 1e-3])
@pytest.mark.parametrize("name", ["winkler", "two-layer", "slab"])
def test_a_wide_ball_holds_every_point(name: str, half: float) -> None:
    guide = track_guide(TRACKS[name], Fraction(0))
    truth = Residues(guide, 40)
    with precision(64):
        G, G_sigma, signed = receptances(guide, exact_ball(0.5 + 0.25j) + square(half))
    assert signed
    for turn in (0, 1, -1, 1j, -1j, 1 + 1j, -1 - 1j):
        s = 0.5 + 0.25j + half * 0.999 * turn
        for x, value, slope in zip(XI, G, G_sigma, strict=True):
            assert holds(value, truth(x, s))
            assert holds(slope, truth.slope(x, s))
    for value, slope in zip(G, G_sigma, strict=True):
        assert float(value.rad()) < 30 * half * max(1, abs(complex(slope)))


def test_roots_that_collide_inside_a_ball() -> None:
    """Over it they are no functions of σ, but U and L are."""
    guide = track_guide(MEET, Fraction(0))
    truth = Residues(guide, 40)
    half = 1e-4
    with precision(64):
        G, _, signed = receptances(guide, acb(arb((1, -1 + guide.time))) + square(half))
    assert signed
    for turn in (1, -1, 1j, 1 + 1j):
        s = 0.5 * 2.0**guide.time + half * 0.999 * turn
        for x, value in zip(XI, G, strict=True):
            assert holds(value, truth(x, s))
            assert float(value.rad()) < 0.05


def test_roots_that_may_meet_beside_the_middle_of_a_ball() -> None:
    """At its middle they are apart, but over it no disc holds one root: the factors take over."""
    guide = track_guide(MEET, Fraction(0))
    truth = Residues(guide, 40)
    middle, half = (0.5 + 0.02j) * 2.0**guide.time, 0.04
    with precision(64):
        symbols = Symbols.of(guide)
        split = split_ball(symbols, exact_ball(middle) + square(half), 2)
        G = split.receptances(XI)[0]
    assert split.roots is None
    assert split.signed
    for turn in (0, 1, -1, 1j, -1j, 1 - 1j):
        s = middle + half * 0.999 * turn
        for x, value in zip(XI, G, strict=True):
            assert holds(value, truth(x, s))


def test_on_a_cut_the_sides_are_open() -> None:
    beam = track_guide(EulerBernoulli(EI="1/4", m=1, k=1), Fraction(3, 5))
    symbols = Symbols.of(beam)
    with precision(64):
        assert not split_ball(symbols, acb(0, 2.0 * 2.0**beam.time), 2).signed
        assert split_ball(symbols, acb(0.01, 2.0 * 2.0**beam.time), 2).signed


def test_a_ball_that_holds_a_branch_point_is_refused() -> None:
    beam = track_guide(EulerBernoulli(EI="1/4", m=1, k=1, c="0.1"), Fraction(3, 5))
    with precision(64), pytest.raises(PrecisionError, match="split the piece"):
        split_ball(Symbols.of(beam), acb(arb(0, 2), arb(0, 2)), 2)


def problems() -> dict[str, Problem]:
    beam = EulerBernoulli(EI="1/4", m=1, k=1, c="0.1")
    bogie = Bogie(wheel=1813, frame=2615, inertia=1476, wheelbase="2.5", k="2.4e6", c="3e4", k_contact="1.5e9")
    return {
        "pair": Problem(beam, [Mass(70).at(0), Mass(70).at("1.5")], "0.8"),
        "twenty masses": Problem(beam, [Mass(40).at(Fraction(3, 2) * i) for i in range(20)], "0.5"),
        "bogie": Problem(TRACKS["two-layer"], [bogie], 600),
    }


@pytest.mark.parametrize("name", problems())
def test_delta_against_float64_and_plain_elimination(name: str) -> None:
    reduced = reduce_problem(problems()[name])
    proved, sigma = Proved(reduced), 0.3 + 0.7j
    values = Floats(reduced).delta([sigma])
    with precision(100):
        found = proved.delta(exact_ball(sigma))
    with precision(400):
        plain = proved.matrices(exact_ball(sigma))[0].det()
        step = arb((1, -100))
        ends = [proved.matrices(exact_ball(sigma) + x)[0].det() for x in (step, -step)]
        rate = (ends[0] - ends[1]) / (2 * step)
        assert found[0].contains(plain)
        assert float(abs(found[1] - rate)) < 1e-20 * float(abs(rate))
    for ball, value in zip(found, values, strict=True):
        assert abs(complex(ball) / value[0] - 1) < 1e-11
        assert float(ball.rad()) < 1e-20 * abs(value[0])


@pytest.mark.parametrize("name", ["pair", "bogie"])
def test_delta_on_a_wide_ball(name: str) -> None:
    reduced = reduce_problem(problems()[name])
    half, middle = 1e-4, 0.3 + 0.7j
    with precision(64):
        value, slope = Proved(reduced).delta(exact_ball(middle) + square(half))
    turns = half * 0.999 * np.array([0, 1, -1, 1j, -1j, 1 + 1j, 1 - 1j])
    for exact, rate in zip(*Floats(reduced).delta(middle + turns), strict=True):
        assert value.contains(exact_ball(complex(exact)))
        assert slope.contains(exact_ball(complex(rate)))
    assert float(value.rad()) < 20 * half * abs(complex(slope))


def test_delta_of_the_conjugate() -> None:
    proved = Proved(reduce_problem(problems()["bogie"]))
    with precision(100):
        one, other = (proved.delta(acb(0.25, y))[0] for y in (0.5, -0.5))
        assert one.overlaps(other.conjugate())
        assert float(abs(one - other.conjugate())) < 1e-24


def test_the_sheet_must_be_known_on_a_cut() -> None:
    """The cut of this beam is Im q = c/2m, beyond a branch point: two p-roots are real there."""
    reduced = reduce_problem(problems()["pair"])
    cut = acb(-arb(1) / 20 * arb((1, reduced.guide.time)), 2)
    with precision(64):
        Proved(reduced, signed=False).delta(cut)
        with pytest.raises(PrecisionError, match="which side"):
            Proved(reduced).delta(cut)


EQUAL = [Fraction(3 * k, 4) for k in range(-5, 6)]
PLACES = [Fraction(k, 2) for k in (0, 1, 5, 6, 10, 11)]
BOGIES = [x - y for x in PLACES for y in PLACES[::-1]]  # in no order, some of them twice


@pytest.mark.parametrize("row", [EQUAL, BOGIES])
def test_distances_in_a_row_are_those_one_by_one(row: list[Fraction]) -> None:
    guide = track_guide(EulerBernoulli(EI="0.25", m=1, k=1, c="0.1"), Fraction(1, 2))
    symbols = Symbols.of(guide)
    with precision(128):
        split = split_ball(symbols, exact_ball(SIGMA[0]), upper_count(symbols.D))
        together, slopes = split.receptances(row)
        for x, value, slope in zip(row, together, slopes, strict=True):
            (one,), (rate,) = split.receptances([x])
            assert value.overlaps(one)
            assert slope.overlaps(rate)
            assert max(float(value.rad()), float(slope.rad())) < 2.0**-100
