"""Receptances next to a branch point, in coordinates about it, against mpmath's roots at many digits."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import mpmath as mp
import numpy as np
import pytest

from mpsolve import tracks, vehicles
from mpsolve.characteristic import local
from mpsolve.characteristic.disc_matrix import Arrays
from mpsolve.characteristic.discs import Splittings, split
from mpsolve.characteristic.local import LocalArrays, same_pair
from mpsolve.characteristic.paths import Paths
from mpsolve.characteristic.start import start
from mpsolve.characteristic.table import Table
from mpsolve.problem.line import on_line
from mpsolve.problem.problem import Problem
from mpsolve.problem.reduced import Reduced, reduce_problem
from mpsolve.spectrum.branch_loops import edge_points
from mpsolve.spectrum.near_loop import about

UP = 2


def made(v: str = "0.67", c: str = "0.1") -> tuple[Arrays, LocalArrays]:
    track = tracks.EulerBernoulli(EI="1/4", m=1, k=1, c=c)
    line = on_line(reduce_problem(Problem(track, [vehicles.Mass(7), vehicles.Mass(3).at("1.5")], v=v)))
    assert line is not None
    paths = Paths(Arrays(line.lower), start(line.lower.guide))
    point = edge_points(line)[0]
    arrays = paths.arrays
    assert isinstance(arrays, Arrays)
    return arrays, about(paths.arrays.reduced, point.exact, point.pole)


def truth(reduced: Reduced, sigma: mp.mpc, x: Fraction) -> mp.mpc:
    """By residues; on the real axis of q the sides are those just below it."""
    D = reduced.guide.D
    c = [sum(mp.mpf(f.numerator) / f.denominator * sigma**j for (i, j), f in D.items() if i == k) for k in range(5)]
    roots = mp.polyroots(c[::-1], maxsteps=500, extraprec=400)
    roots.sort(key=lambda p: p.real)
    side, sign = (roots[:UP], 1) if x >= 0 else (roots[UP:], -1)
    N = reduced.guide.N[0, 0]
    slope = [k * c[k] for k in range(1, 5)][::-1]
    return sign * sum(
        mp.mpf(N.numerator) / N.denominator * mp.exp(p * mp.mpf(x.numerator) / x.denominator) / mp.polyval(slope, p)
        for p in side
    )


@pytest.mark.parametrize("size", ["1e-3", "1e-9", "1e-18", "1e-24"])
@pytest.mark.parametrize("turn", [-0.9, -0.5, -0.1])
def test_receptances_hold_the_truth_however_close(size: str, turn: float) -> None:
    _, near = made()
    with mp.workdps(80):
        t = complex(mp.mpf(size) * mp.expjpi(turn))
        _, G, good = near.evaluate(np.array([1j * t]), np.zeros(1), UP)
        assert good[0]
        z = mp.mpf(near.z.numerator) / near.z.denominator
        places = near.reduced.places
        for i, a in enumerate(places):
            for j, b in enumerate(places):
                wanted = truth(near.reduced, 1j * (z + mp.mpc(t)), a - b)
                off = abs(mp.mpc(complex(G.a[0, i, j])) - wanted)
                assert off <= G.e[0, i, j] + abs(G.b[0, i, j]) * float(G.r[0])
                assert G.e[0, i, j] < 1e-9 * abs(wanted)


def test_a_disc_holds_what_is_inside() -> None:
    _, near = made("1.3")
    t, r = np.array([2e-15 - 1e-15j]), np.array([2e-16])
    _, G, good = near.evaluate(1j * t, r, UP)
    assert good[0]
    for turn in np.exp(2j * np.pi * np.arange(5) / 5):
        inner = 0.99 * r[0] * turn
        _, g, _ = near.evaluate(1j * t + inner, np.zeros(1), UP)
        off = np.abs(G.a + G.b * inner - g.a)
        assert (off <= G.e + g.e + np.abs(g.b) * g.r).all()


def test_splittings_far_and_near_are_compared() -> None:
    whole, near = made()
    z = float(near.z)
    assert same_pair(whole, near, z * 0.99, UP)
    assert same_pair(whole, near, z * 1.01, UP)
    elsewhere = LocalArrays(near.reduced, near.z, near.p + 1)
    assert same_pair(whole, elsewhere, z * 1.01, UP)  # any P will do


def test_the_other_pair_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    """The two roots that nearly meet are exchanged near the branch point."""
    whole, near = made()

    def exchanged(D: Table, m: Any, r: Any, up: int) -> Splittings:
        s = split(D, m, r, up)
        if D is not near.D:
            return s
        order = list(range(4))
        a, b = np.abs(s.z[0, :up]).argmin(), up + np.abs(s.z[0, up:]).argmin()
        order[a], order[b] = b, a
        return split(D, m, r, up, s.z[:, order])

    monkeypatch.setattr(local, "split", exchanged)
    assert not same_pair(whole, near, float(near.z) * 0.99, UP)
    assert not same_pair(whole, near, float(near.z) * 1.01, UP)
