"""The far theorem over boxes of parameters, against residue sums at points of the box."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from passive_subjects import RAIL, TRACKS, family_and_envelope, least, reduced_and_envelope

from mpsolve import Problem, tracks, vehicles
from mpsolve.characteristic.floats import Receptance
from mpsolve.passivity.far import far, least_gap, slopes


@pytest.mark.parametrize("name", TRACKS)
def test_beyond_it_the_matrix_is_passive(name: str) -> None:
    reduced, envelope = reduced_and_envelope(name, 3)
    X = far(envelope)
    assert X is not None
    assert (least(reduced.guide, reduced.places, X * np.geomspace(1, 20, 40)) > -1e-13).all()
    assert X < 100


def test_over_parameters() -> None:
    pair = Problem(RAIL, [vehicles.Mass(900), vehicles.Mass(900).at("2.5")], v=150)
    over = {"track.k": (5e5, 15e5), "track.c": (400, 1200), "gap[0]": (2, 3), "v": (0, 160)}
    family, envelope = family_and_envelope(pair, over)
    X = far(envelope)
    assert X is not None
    assert X < 20
    rng = np.random.default_rng(5)
    low, high = np.array(envelope.low), np.array(envelope.high)
    for _ in range(60):
        x = [Fraction(float(t)) for t in low + rng.uniform(0, 1, 4) * (high - low)]
        places = [place.at(x) for place in family.places]
        assert least(family.guide(x), places, X * np.exp(rng.uniform(0, 2, 1)))[0] > 0
    gap = least_gap(envelope.subject, np.array([envelope.low]), np.array([envelope.high]))
    smallest = min(float(family.places[1].at([*map(Fraction, envelope.low[:2]), Fraction(g), Fraction(1)])
                         - family.places[0].at([*map(Fraction, envelope.low[:2]), Fraction(g), Fraction(1)]))
                   for g in (envelope.low[2], envelope.high[2]))  # fmt: skip
    assert gap == pytest.approx(smallest)
    assert gap <= smallest


def test_none_beyond_the_speed_of_short_waves() -> None:
    wire = tracks.String(T=27000, m="1.07", k=500, c=2)
    pair = Problem(wire, [vehicles.Mass(9), vehicles.Mass(9).at(20)], v=100)
    _, envelope = family_and_envelope(pair, {"v": (100, 170)})
    assert far(envelope, most=1e4) is None


def test_slopes_of_a_beam() -> None:
    _, envelope = reduced_and_envelope("rail")
    assert slopes(envelope.subject, np.zeros((1, 0))) == [Fraction(1, 2)]


@pytest.mark.parametrize("name", ["rail", "string", "two layers"])
def test_one_real_point_closes_the_half_plane(name: str) -> None:
    """Lemma 3 of SPEC2, section 6.7, in floats: where R²λ > 18XM/π, the mobility is passive on all of |σ| = R."""
    reduced, envelope = reduced_and_envelope(name, 2)
    receptance, places, X = Receptance(reduced.guide), reduced.places, far(envelope)
    assert X is not None

    def mobility(sigma: Any) -> Any:
        G = np.empty((len(sigma), 2, 2), complex)
        for i in range(2):
            for j in range(2):
                G[:, i, j] = receptance(sigma, [places[i] - places[j]], False)[0][0]
        return sigma[:, None, None] * G

    def hermitian(sigma: Any) -> Any:
        V = mobility(sigma)
        return np.linalg.eigvalsh((V + np.swapaxes(V.conj(), 1, 2)) / 2)

    M = np.abs(hermitian(1j * np.linspace(1e-4, X, 4000))).max()
    R = next(R for R in 2.0 ** np.arange(1, 40) * X
             if R * hermitian(np.array([R + 0j]))[0, 0] > 18 * X * M / np.pi)  # fmt: skip
    assert R < 2.0**36 * X
    arc = R * np.exp(1j * np.linspace(0, np.pi / 2, 2000)[:-1])
    assert (hermitian(arc)[:, 0] > 0).all()


def test_a_string_over_a_wide_range_of_velocities_is_halved() -> None:
    wire = tracks.String(T=1, m=1, k=1, c="0.1")
    pair = Problem(wire, [vehicles.Mass(10), vehicles.Mass(10).at("1.5")], v="0.5")
    family, envelope = family_and_envelope(pair, {"v": (0, 0.9)})
    X = far(envelope)
    assert X is not None
    for v in (0.1, 0.5, 0.8, 0.9):
        x = [Fraction(v) / family.units[0]]
        places = [place.at(x) for place in family.places]
        assert (least(family.guide(x), places, X * np.geomspace(1, 4, 12)) > -1e-13).all()
