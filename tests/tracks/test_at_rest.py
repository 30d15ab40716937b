"""Stability at rest against closed forms, and against the roots of D on dense grids of wavenumbers."""

from __future__ import annotations

from fractions import Fraction
from math import sqrt

import numpy as np
import pytest
from hypothesis import given
from track_models import DAMPED, RAIL, random_tracks

from mpsolve import tracks
from mpsolve.errors import InputError
from mpsolve.tracks.at_rest import Status, at_rest, lowest_cut
from mpsolve.tracks.waveguide import Waveguide

GRID = np.concatenate([[0.0], np.geomspace(1e-3, 1e3, 60)])


def growth(track: tracks.Track | Waveguide, p: float) -> float:
    """The largest Re s at the wavenumber p, from the coefficients of D themselves."""
    D = track.waveguide.dispersion
    line = np.zeros(max(j for _, j in D) + 1)
    for (i, j), c in D.items():
        line[j] += float(c) * p**i * (-1) ** (i // 2)
    return float(np.roots(line[::-1]).real.max())


@pytest.mark.parametrize(
    ("name", "status", "wavenumbers", "at_infinity"),
    [
        ("string", Status.STRICT, (), False),
        ("euler-bernoulli", Status.STRICT, (), False),
        ("rayleigh", Status.TOUCHING, (), True),
        ("timoshenko", Status.TOUCHING, (0,), True),
        ("two-layer", Status.STRICT, (), False),
        ("three-layer", Status.STRICT, (), False),
        ("slab", Status.STRICT, (), False),
        ("floating-ice", Status.TOUCHING, (0,), False),
    ],
)
def test_every_damped_track(name: str, status: Status, wavenumbers: tuple[float, ...], at_infinity: bool) -> None:
    found = at_rest(DAMPED[name])
    assert (found.status, found.wavenumbers, found.at_infinity) == (status, wavenumbers, at_infinity)


def test_pads_alone_touch_where_rail_and_sleepers_move_as_one() -> None:
    """Ω² = k_ballast/m_sleeper with EI p⁴ = m Ω²; rail damping alone touches at p = 0; a free string at p = 0."""
    pads = tracks.TwoLayer(**RAIL, k_pad="300e6", c_pad="3e4", m_sleeper=250, k_ballast="100e6")
    found = at_rest(pads)
    assert found.status is Status.TOUCHING
    assert found.wavenumbers == (pytest.approx((60.2 * 1e8 / 250 / 6.38e6) ** 0.25),)
    rail = tracks.EulerBernoulli(**RAIL, k="1e6", eta="1e-4")
    assert (at_rest(rail).status, at_rest(rail).wavenumbers) == (Status.TOUCHING, (0,))
    wire = tracks.String(T=1, m=1, c=1)
    assert (at_rest(wire).status, at_rest(wire).wavenumbers, at_rest(wire).at_infinity) == (
        Status.TOUCHING,
        (0,),
        False,
    )


@pytest.mark.parametrize("name", DAMPED)
def test_without_damping_a_track_is_undamped(name: str) -> None:
    track = DAMPED[name]
    values = {key: 0 if key.startswith(("c", "eta")) else value for key, value in track.parameters.items()}
    assert at_rest(type(track)(**values)).status is Status.UNDAMPED


def test_some_fields_may_be_undamped_for_themselves() -> None:
    """Two strings that do not feel each other, one damped: for every p a pair ±s stays."""
    first = tracks.String(T=1, m=1, k=1, c=1).waveguide.matrix[0][0]
    second = tracks.String(T=2, m=1, k=1).waveguide.matrix[0][0]
    falling = tracks.String(T=2, m=1, k=1).waveguide.matrix[0][0] | {(0, 0): Fraction(-1)}
    assert at_rest(Waveguide(((first, {}), ({}, second)))).status is Status.UNDAMPED
    assert at_rest(Waveguide(((first, {}), ({}, falling)))).status is Status.UNSTABLE


@pytest.mark.parametrize("damping", [0, 770])
@pytest.mark.parametrize(("excess", "status"), [(-1e-12, None), (0, Status.UNSTABLE), (1e-12, Status.UNSTABLE)])
def test_the_buckling_force(damping: int, excess: float, status: Status | None) -> None:
    """N = 2√(k EI) at p = (k/EI)^(1/4), here 2·10⁶ N and 1/m."""
    force = 2 * 10**6 * (1 + Fraction(excess))
    found = at_rest(tracks.EulerBernoulli(EI="1e6", m=60, k="1e6", c=damping, N=force))
    assert found.status is (status or (Status.STRICT if damping else Status.UNDAMPED))
    if status:
        assert found.buckles
        assert found.wavenumbers == (pytest.approx(1, rel=1e-5),)
        assert "buckles" in found.sentence
        assert "p = 1" in found.sentence


def test_too_much_compression_in_a_two_layer_track_buckles() -> None:
    found = at_rest(tracks.TwoLayer(**RAIL, k_pad="300e6", c_pad="3e4", m_sleeper=250, k_ballast="1e6", N="1e7"))
    assert (found.status, found.buckles) == (Status.UNSTABLE, True)


def test_an_active_element_grows_without_buckling() -> None:
    D = dict(DAMPED["euler-bernoulli"].waveguide.dispersion) | {(0, 1): Fraction(-1)}
    found = at_rest(Waveguide(((D,),)))
    assert (found.status, found.buckles) == (Status.UNSTABLE, False)
    follower = Waveguide((({(0, 3): Fraction(1), (0, 1): Fraction(1), (0, 0): Fraction(1)},),))
    assert at_rest(follower).status is Status.UNSTABLE  # s³ + s + 1: the first determinant is 0 without any pair ±s


@pytest.mark.parametrize(
    "matrix",
    [
        (({},),),
        (({(1, 0): Fraction(1), (0, 1): Fraction(1)},),),
        (({(2, 2): Fraction(-1), (0, 0): Fraction(1)},),),
        (({(2, 2): Fraction(1), (0, 2): Fraction(1), (0, 0): Fraction(1)},),),
    ],
)
def test_what_is_no_track_is_refused(matrix: object) -> None:
    """No wave at all, a track with a direction, a field without mass at p = 0 or at p = 1."""
    with pytest.raises(InputError, match="matrix"):
        at_rest(Waveguide(matrix))


@given(random_tracks())
def test_random_tracks_against_roots_on_a_grid(track: tracks.Track) -> None:
    """The growth on a grid never exceeds what is decided, and shows every instability that is."""
    found, rates = at_rest(track), [growth(track, p) for p in GRID]
    tolerance = [1e-6 * (1 + p**2) for p in GRID]
    if found.status is Status.UNSTABLE:
        here = growth(track, found.wavenumbers[0])
        assert here > 0 or (found.buckles and here > -1e-6)
    else:
        assert all(rate < tiny for rate, tiny in zip(rates, tolerance, strict=True))
    if found.status is Status.STRICT:
        low, high = lowest_cut(track)
        assert 0 < low < high < low * (1 + Fraction(1, 10**5))
        assert all(rate < -low + tiny for rate, tiny in zip(rates, tolerance, strict=True))


def test_the_lowest_cut_of_the_paper_s_rail() -> None:
    low, high = lowest_cut(DAMPED["euler-bernoulli"])
    truth = Fraction(770) / (2 * Fraction("60.2"))
    assert low <= truth <= high
    assert high - low < truth / 10**6
    over = tracks.EulerBernoulli(EI=1, m=1, k=1, c=4)  # overdamped: 2 − √(4 − 1) at p = 0
    low, high = lowest_cut(over, bits=40)
    assert low <= Fraction(2 - sqrt(3)) <= high
    assert high - low < Fraction(1, 10**12)


def test_the_lowest_cut_of_a_track_that_touches_or_buckles() -> None:
    assert lowest_cut(DAMPED["rayleigh"]) == (0, 0)
    with pytest.raises(InputError, match="buckles"):
        lowest_cut(tracks.EulerBernoulli(EI=1, m=1, k=1, c=1, N=3))


@pytest.mark.parametrize(
    "values",
    [
        {"EI": "1e300", "m": "1e-300", "k": "1e300", "c": "1e-100"},
        {"EI": "1e-300", "m": "1e300", "k": "1e-300", "c": "1e-250"},
    ],
)
def test_numbers_beyond_floats_are_decided_too(values: dict[str, str]) -> None:
    """Underdamped at every wavenumber: the height is c/(2m)."""
    low, high = lowest_cut(tracks.EulerBernoulli(**values))
    truth = Fraction(values["c"]) / (2 * Fraction(values["m"]))
    assert low <= truth <= high
    assert high - low < truth / 10**5
