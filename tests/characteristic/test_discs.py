"""Splittings and receptances on discs against p-roots and residues at 45 digits: held, and not much wider."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from receptance_truth import Receptance
from track_models import DAMPED, random_tracks

from mpsolve.characteristic.discs import Splittings, linked, split
from mpsolve.characteristic.residues import receptances
from mpsolve.characteristic.table import Table
from mpsolve.errors import InputError, PrecisionError
from mpsolve.problem.reduced import Guide, track_guide

DISTANCES = np.array([-1.5, -0.125, 0.0, 0.0625, 2.0])


def some_discs(seed: int, count: int = 6) -> tuple[Any, Any]:
    """Discs in Re σ > 0, thin ones among them."""
    rng = np.random.default_rng(seed)
    m = 10.0 ** rng.uniform(-1, 1, count) + 1j * rng.normal(size=count) * 2
    r = m.real * 10.0 ** rng.uniform(-5, -0.5, count)
    r[::3] = 0
    return m, r


def coefficients(truth: Receptance, s: Splittings, k: int, sigma: Any) -> list[Any]:
    """a_k = U(z_k)/U₀'(z_k) of the true factors, upper nodes first."""
    mp, out = truth.mp, []
    for part, roots in zip((slice(0, s.up), slice(s.up, None)), truth.roots(sigma), strict=True):
        z = [mp.mpc(x) for x in s.z[k, part]]
        for i, x in enumerate(z):
            below = mp.fprod(x - y for j, y in enumerate(z) if j != i)
            out.append(mp.fprod(x - root for root in roots) / below)
    return out


def check(guide: Guide, seed: int, points: int = 3) -> int:
    """Every proved splitting and receptance holds the truth at points of the rim; how many discs were proved."""
    truth, (m, r) = Receptance(guide), some_discs(seed)
    up = len(truth.roots(m[0])[0])
    s = split(Table.of(guide.D), m, r, up)
    G = receptances(Table.of(guide.N), Table.of(guide.D), s, DISTANCES)
    for k in np.flatnonzero(s.good):
        for sigma in truth.rim(m[k], float(r[k]), points if r[k] else 1):
            for a, tight, box in zip(coefficients(truth, s, k, sigma), s.tight[k], s.box[k], strict=True):
                assert abs(a) <= float(tight) < float(box)
            if not G.good[k]:
                continue
            for j, x in enumerate(DISTANCES):
                a, b = (truth.mp.mpc(part[k, j]) for part in (G.jet.a, G.jet.b))
                off = abs(truth.value(float(x), sigma) - a - b * (sigma - truth.mp.mpc(m[k])))
                assert off <= float(G.jet.e[k, j]), (k, x)
    return int(G.good.sum())


@pytest.mark.parametrize("name", DAMPED)
@pytest.mark.parametrize("v", ["0", "20", "70"])
def test_the_truth_is_held_on_every_track(name: str, v: str) -> None:
    assert check(track_guide(DAMPED[name], Fraction(v)), len(name) + int(v)) >= 2


@settings(max_examples=12)
@given(random_tracks(), st.sampled_from([Fraction(0), Fraction(1, 3), Fraction(2), Fraction(9)]), st.integers(0, 99))
def test_the_truth_is_held_on_random_tracks(track: Any, v: Fraction, seed: int) -> None:
    try:
        guide = track_guide(track, v)
        check(guide, seed, points=2)
    except (InputError, PrecisionError):
        return


def test_a_root_on_the_wrong_side_is_not_linked_nor_found() -> None:
    guide = track_guide(DAMPED["euler-bernoulli"], Fraction(40))
    D = Table.of(guide.D)
    m = np.array([1.0 + 0.2j])
    right = split(D, m, np.zeros(1), 2)
    order = [2, 1, 0, 3]  # U takes a growing root in place of a decaying one
    wrong = Splittings(m, right.r, right.z[:, order], 2, right.box, right.tight, right.good, right.T, right.error)
    assert linked(right, right).all()
    assert not linked(right, wrong).any()
    assert not linked(wrong, right).any()


def test_what_is_known_too_roughly_is_neither_linked_nor_told_apart() -> None:
    guide = track_guide(DAMPED["euler-bernoulli"], Fraction(40))
    D, N = Table.of(guide.D), Table.of(guide.N)
    s = split(D, np.array([1.0 + 0.2j]), np.array([1e-3]), 2)
    thin = split(D, s.m, 0 * s.r, 2)
    assert linked(s, thin).all()
    assert receptances(N, D, s, DISTANCES).good.all()
    for k in range(4):
        tight = np.where(np.arange(4) == k, 1.0, 0.0)
        assert not linked(s, replace(thin, tight=thin.tight + tight * s.box)).any()
        # U or L with coefficients that large may have a root anywhere
        assert not receptances(N, D, replace(s, tight=s.tight + 9 * tight), DISTANCES).good.any()
        assert not linked(replace(s, box=s.box * (1 - tight)), thin).any()


@pytest.mark.parametrize("name", DAMPED)
def test_neighbours_are_linked_within_a_disc_and_not_across_a_cut(name: str) -> None:
    guide = track_guide(DAMPED[name], Fraction(10))
    truth, D = Receptance(guide), Table.of(guide.D)
    m, r = np.array([0.8 + 0.5j]), np.array([1e-3])
    up = len(truth.roots(m[0])[0])
    disc, thin = split(D, m, r, up), split(D, m + r, 0 * r, up)
    assert linked(disc, thin).all()
    far = split(D, m + 2.0, 0 * r, up)
    assert not linked(disc, far).any()
