"""Passivity at rest against N/D on grids, and tracks that are broken on purpose."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from track_models import DAMPED, random_tracks

from mpsolve import tracks
from mpsolve.tracks.passive import passivity
from mpsolve.tracks.waveguide import Polynomial, Waveguide


def value(polynomial: Polynomial, p: float, omega: float) -> complex:
    return sum(float(c) * (1j * p) ** i * (1j * omega) ** j for (i, j), c in polynomial.items())


def power(guide: Waveguide, p: float, omega: float) -> float:
    """What the track takes from a unit force, up to a positive factor."""
    N, D = value(guide.numerator, p, omega), value(guide.dispersion, p, omega)
    return -omega * (N * D.conjugate()).imag / (abs(N * D) + 1e-300)


@pytest.mark.parametrize("name", DAMPED)
def test_every_track_is_passive(name: str) -> None:
    track = DAMPED[name]
    found = passivity(track)
    assert (found.passive, found.lossless, found.witness) == (True, False, None)
    values = {key: 0 if key.startswith(("c", "eta")) else given_ for key, given_ in track.parameters.items()}
    assert passivity(type(track)(**values)).lossless


@given(random_tracks())
def test_so_are_random_ones(track: tracks.Track) -> None:
    """Compression does no work at rest: a track that buckles is passive in this sense too."""
    assert passivity(track).passive


@given(random_tracks(), st.integers(1, 40), st.sampled_from(["c", "c_pad", "c_ballast", "eta"]))
def test_a_negative_damper_gives_energy(track: tracks.Track, size: int, key: str) -> None:
    """The parameters go into the equations past their bounds."""
    values = track.parameters
    if key in values:
        broken = _unchecked(track, key, Fraction(-size, 4))
        found = passivity(broken)
        if found.witness is not None:
            assert power(broken, *found.witness) < 1e-12
        grid = [power(broken, p, omega) for p in np.geomspace(0.1, 10, 12) for omega in np.geomspace(0.1, 10, 12)]
        assert min(grid) > -1e-9 or not found.passive


@pytest.mark.parametrize("name", DAMPED)
def test_an_undamped_track_with_one_negative_damper_is_active(name: str) -> None:
    track = DAMPED[name]
    key = "c" if "c" in track.parameters else "c_pad"
    broken = _unchecked(track, key, Fraction(-(10**6)))
    found = passivity(broken)
    assert not found.passive
    assert found.witness is not None
    assert power(broken, *found.witness) < 0


def test_a_window_of_activity_is_found_however_small() -> None:
    """−Im D/Ω = (y − 1)² + (z − 2)² − r²: active in a disc of the quadrant, passive where r² ≤ 0."""
    for radius, passive in ((Fraction(1, 10**20), False), (Fraction(0), True), (Fraction(-1, 10**20), True)):
        odd = {(4, 1): 1, (2, 1): 2, (0, 5): 1, (0, 3): 4, (0, 1): 5 - radius}
        D = {key: Fraction(c) for key, c in odd.items()} | {(0, 0): Fraction(1), (0, 6): Fraction(1)}
        found = passivity(Waveguide(((D,),)))
        assert found.passive is passive
        if found.witness is not None:
            assert found.witness == (pytest.approx(1), pytest.approx(2**0.5))


def test_a_push_by_another_field_is_not_passive() -> None:
    """A second field that drives the first without being driven: D is stable, the receptance is active somewhere."""
    guide = DAMPED["two-layer"].waveguide
    (a, b), (c, d) = guide.matrix
    active = Waveguide(((a, {key: -3 * x for key, x in b.items()}), (c, d)))
    assert passivity(guide).passive
    assert not passivity(active).passive


def _unchecked(track: tracks.Track, key: str, number: Fraction) -> Waveguide:
    """The equations with a parameter that the model refuses: each entry is linear in a damping."""
    zero = type(track)(**(track.parameters | {key: 0})).waveguide
    one = type(track)(**(track.parameters | {key: 1})).waveguide

    def entry(a: Polynomial, b: Polynomial) -> Polynomial:
        keys = {*a, *b}
        out = {k: a.get(k, Fraction(0)) + number * (b.get(k, Fraction(0)) - a.get(k, Fraction(0))) for k in keys}
        return {k: c for k, c in out.items() if c}

    rows = zip(zero.matrix, one.matrix, strict=True)
    return Waveguide(tuple(tuple(map(entry, a, b)) for a, b in rows), zero.loaded)
