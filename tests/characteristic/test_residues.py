"""Receptances on discs are not much wider than they need be, and roots that are not told apart give none."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from receptance_truth import Receptance
from track_models import DAMPED

from mpsolve.characteristic import discs, residues
from mpsolve.characteristic.discs import split
from mpsolve.characteristic.residues import receptances, told_apart
from mpsolve.characteristic.table import Table
from mpsolve.numbers.jets import Jet, U
from mpsolve.problem.reduced import track_guide
from mpsolve.tracks.waveguide import Polynomial

DISTANCES = np.array([-1.5, -0.125, 0.0, 0.0625, 2.0])


@pytest.mark.parametrize("name", DAMPED)
def test_widths(name: str) -> None:
    """Thin: rounding only. On a disc: of the order of what the second derivative leaves (sides of a sum cancel)."""
    guide = track_guide(DAMPED[name], Fraction(10))
    truth, D, N = Receptance(guide), Table.of(guide.D), Table.of(guide.N)
    m = np.array([0.7 + 0.4j, 1.5 + 2j])
    up = len(truth.roots(m[0])[0])
    thin = receptances(N, D, split(D, m, np.zeros(2), up), DISTANCES)
    assert thin.good.all()
    size = np.abs(thin.jet.a) + 1e-3 * np.abs(thin.jet.a).max()
    assert (thin.jet.e <= 1e6 * U * size).all()
    r = np.full(2, 1e-3)
    wide = receptances(N, D, split(D, m, r, up), DISTANCES)
    assert wide.good.all()
    for k in range(2):
        seconds = []
        for j, x in enumerate(DISTANCES):
            h = truth.mp.mpf("0.001")
            values = [truth.value(float(x), truth.mp.mpc(m[k]) + d) for d in (h, -h, 1j * h, -1j * h)]
            a = truth.mp.mpc(wide.jet.a[k, j])
            seconds.append(float(max(abs(values[0] + values[1] - 2 * a), abs(values[2] + values[3] - 2 * a)) / 2))
        assert wide.jet.e[k].max() <= 150 * max(seconds), (wide.jet.e[k], seconds)


def test_an_expansion_holds_the_largest_value_and_is_no_wider() -> None:
    """All coefficients positive: at e = eps, t = r every term is at its largest."""
    rng = np.random.default_rng(3)
    c = rng.uniform(0.1, 1, (1, 1, 4, 3)) + 0j
    eps, r = 0.3, 0.2
    root = Jet(np.array([[0.05 + 0j]]), np.array([[0.5 + 0j]]), np.array([[0.15]]), np.array([r]))
    grid, powers = eps ** np.arange(4)[None, None, :], r ** np.arange(3)[None, :]
    got = residues._expand(c, 0 * c.real, root, grid, powers)
    most = float(np.einsum("bkij,bki,bj->", c.real, grid, powers))
    assert got.size[0, 0] == pytest.approx(most, rel=1e-9)
    lost = residues._expand(c, 0.01 * c.real, root, grid, powers)
    assert lost.size[0, 0] == pytest.approx(1.01 * most, rel=1e-9)


def polynomial(roots: list[float]) -> Polynomial:
    """Π (P − root) + σ·0: D of a track whose roots do not move, but for a term in σ that is tiny."""
    out = np.poly(roots)[::-1]
    D = {(i, 0): Fraction(float(c)) for i, c in enumerate(out)}
    D[0, 1] = Fraction(1, 10**9)
    return D


def test_two_nodes_of_one_side_at_the_same_root_do_not_count_it_twice(monkeypatch: pytest.MonkeyPatch) -> None:
    D = Table.of(polynomial([-1.0, -1.5, 50.0, 60.0]))
    N = Table.of({(0, 0): Fraction(1)})
    m, r = np.array([0.01 + 0j]), np.zeros(1)
    nodes = np.array([[-1.0 + 0j, -1.02 + 0j, 50.0 + 0j, 60.0 + 0j]])
    monkeypatch.setattr(discs, "side_nodes", lambda *_: nodes)
    s = split(D, m, r, 2)
    assert s.good.all()  # the splitting itself may have any nodes
    assert not receptances(N, D, s, np.array([0.0])).good.any()


def test_a_disc_between_two_roots_is_not_taken_for_one_of_them(monkeypatch: pytest.MonkeyPatch) -> None:
    D = Table.of(polynomial([-1.0, -1.001, 50.0, 60.0]))
    nodes = np.array([[-1.00025 + 0j, -1.00075 + 0j, 50.0 + 0j, 60.0 + 0j]])
    monkeypatch.setattr(discs, "side_nodes", lambda *_: nodes)
    s = split(D, np.array([0.01 + 0j]), np.zeros(1), 2)
    assert s.good.all()
    assert not told_apart(D, s)[1].any()


def test_no_root_ahead_leaves_nothing_ahead() -> None:
    guide = track_guide(DAMPED["string"], Fraction(300))
    m, r = np.array([0.5 + 0.2j, 2j]), np.array([1e-3, 0.0])
    s = split(Table.of(guide.D), m, r, 0)
    G = receptances(Table.of(guide.N), Table.of(guide.D), s, DISTANCES)
    assert G.good.all()
    assert (G.jet.a[:, 2:] == 0).all()
    assert (G.jet.e[:, 2:] == 0).all()
    truth = Receptance(guide)
    assert not truth.roots(0.5 + 0.2j)[0]
    assert abs(complex(truth.value(-1.5, 0.5 + 0.2j)) - G.jet.a[0, 0]) <= G.jet.e[0, 0]
