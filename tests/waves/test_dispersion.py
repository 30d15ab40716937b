"""Dispersion curves against closed forms, against the equations themselves, and against numbers of others."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest

from mpsolve import dispersion
from mpsolve.errors import InputError
from mpsolve.tracks import EulerBernoulli, FloatingIce, Slab, String, ThreeLayer, Timoshenko, TwoLayer

P = np.linspace(0, 3, 200)
LAYERS = TwoLayer(EI=4, m=1, k_pad=30, m_sleeper=2, k_ballast=5, c_pad="0.4", c_ballast="0.1", eta="0.01")
SLAB = Slab(
    EI="1.29e7",
    m=120,
    k_pad="5e8",
    EI_slab=Fraction(30 * 10**9) * Fraction("1.25") * Fraction("0.35") ** 3 / 12,
    m_slab=Fraction(2500) * Fraction("1.25") * Fraction("0.35"),
)


def test_the_undamped_beam_has_two_real_branches() -> None:
    omega = dispersion(EulerBernoulli(EI="1/4", m=1, k=1, N="0.3"), P)
    truth = np.sqrt(P**4 / 4 - 0.3 * P**2 + 1)
    assert omega.shape == (200, 2)
    assert (omega.imag == 0).all()
    assert np.allclose(omega.real, np.stack([-truth, truth], 1), rtol=1e-14, atol=0)


def test_a_damped_string_keeps_its_branches_through_the_point_where_they_meet() -> None:
    """−Ω² + icΩ + p² + k = 0: overdamped for p² + k < c²/4."""
    omega = dispersion(String(T=1, m=1, k=1, c=4), P)
    root = np.sqrt((P**2 + 1 - 4).astype(complex))
    for k, value in enumerate(omega):
        assert np.allclose(sorted(value, key=lambda x: (x.real, x.imag)), sorted([2j - root[k], 2j + root[k]],
                           key=lambda x: (x.real, x.imag)), atol=1e-7)  # fmt: skip
    assert np.abs(np.diff(omega, axis=0)).max() < 0.25  # a square root: its steps are ≤ √(2 p dp)
    assert (omega.imag > 0).all()


@pytest.mark.parametrize(
    "track",
    [
        LAYERS,
        ThreeLayer(EI=4, m=1, k_pad=30, m_sleeper=2, k_ballast=5, m_ballast=7, k_ground=3, shear=2, c_pad="0.3"),
        Timoshenko(EI=4, m=1, S=9, J="0.5", k=1, c="0.2"),
        FloatingIce(B=100, h=1, rho_ice=9, rho_water=10, depth=2, c=3),
    ],
)
def test_every_value_makes_the_matrix_singular_and_branches_are_continuous(track: object) -> None:
    guide = track.waveguide  # type: ignore[attr-defined]
    p = np.linspace(0.05, 3, 150)
    omega = dispersion(guide, p)
    for k, wavenumber in enumerate(p):
        for value in omega[k]:
            matrix = np.array(
                [
                    [
                        sum(float(c) * (1j * wavenumber) ** i * (1j * value) ** j for (i, j), c in entry.items())
                        for entry in row
                    ]
                    for row in guide.matrix
                ]
            )
            sizes = np.linalg.svd(matrix / np.abs(matrix).max(1)[:, None], compute_uv=False)
            assert sizes[-1] < 1e-11
    assert np.abs(np.diff(omega, axis=0)).max() < 0.4
    assert (omega.imag > 0).all()


def test_fewer_wavenumbers_lead_to_the_same_branches() -> None:
    fine = dispersion(LAYERS, np.linspace(0, 3, 301))
    coarse = dispersion(LAYERS, np.linspace(0, 3, 7))
    assert np.allclose(coarse, fine[::50], rtol=1e-9)


def test_a_free_slab_track_meets_the_number_of_train_crit_speed() -> None:
    """TrainCritSpeed: at ω = 5.148… rad/s the lowest wave of this track without ground runs at 42.3205… m/s."""
    omega, speed = 5.148484848484848, 42.320550453416544
    lowest = dispersion(SLAB, [omega / speed])[0, 2].real
    assert lowest == pytest.approx(omega, rel=1e-9)
    both = 1.29e7 + 30e9 * 1.25 * 0.35**3 / 12, 120 + 2500 * 1.25 * 0.35
    assert np.sqrt(omega) * (both[0] / both[1]) ** 0.25 == pytest.approx(speed, rel=1e-5)  # the two as one beam


@pytest.mark.parametrize("p", [[], [np.nan], [[1.0]], "wave", [1j]])
def test_what_is_no_list_of_wavenumbers_is_refused(p: object) -> None:
    with pytest.raises(InputError, match="p: "):
        dispersion(LAYERS, p)
