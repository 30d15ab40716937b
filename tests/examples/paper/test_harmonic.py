"""Amplitudes of (36) against the paper's own formulas in mpmath, and in their limits."""

from __future__ import annotations

import pytest
from flint import arb
from oracle import Truth

from mpsolve import Case
from paper.cases import pair, single
from paper.harmonic import harmonic, superposed


@pytest.mark.parametrize(("alpha", "eta_b", "eta_m", "d"), [("0.5", "0", "40", "1"), ("0.9", "0.05", "70", "1.5")])
def test_amplitudes_are_the_residues_of_the_image(alpha: str, eta_b: str, eta_m: str, d: str) -> None:
    """(29) with F = 4/(iq), by the oracle's kernels: (q − q_j) times the image near q_j, times i."""
    case, truth = pair(alpha, eta_b, eta_m, d), Truth(pair(alpha, eta_b, eta_m, d), 40)
    mp, mass = truth.mp, truth.eta_m[0]

    def image(z):
        own, ahead, behind = (truth.kernel(g, z) for g in (0, truth.x[1], -truth.x[1]))
        first = (mp.pi - 2 * mass * z**2 * (own - behind)) * own
        second = (mp.pi - 2 * mass * z**2 * (own - ahead)) * behind
        return 4 / z * (first + second) / (truth.delta(z) * mp.pi**2)

    step = mp.mpf(10) ** -7
    for q, A in harmonic(case).terms:
        place = truth.middle(q)
        residue = step * (image(place + step) - image(place - step)) / 2
        assert abs(residue - truth.middle(A)) < 1e-9 * abs(residue)


def test_two_masses_at_one_place_are_one_doubled_mass() -> None:
    near, both = harmonic(pair("0.5", "0", "40", "0.0001")), harmonic(single("0.5", "0", "80"))
    assert float(near.amplitudes[0]) == pytest.approx(2 * float(both.amplitudes[0]), rel=1e-3)
    assert float(near.frequencies[0]) == pytest.approx(float(both.frequencies[0]), rel=1e-3)


def test_at_rest_the_static_displacement_is_one() -> None:
    steady = harmonic(Case(alpha="0", eta_b="0.1", eta_m="1")).steady
    assert steady.real.contains(arb(1))


def test_superposition_at_one_place_is_twice_one_mass() -> None:
    alone = single("0.5", "0", "40")
    twice = superposed(alone, "0.0001")
    assert float(twice) == pytest.approx(2 * float(harmonic(alone).amplitudes[0]), rel=1e-3)
