"""Simple p-roots and their weights N/D_P over boxes, as models: each root alone in a disc round its node.

D(z + x) = Σ c_i x^i. With |D_P − c| ≤ K < |c| on a disc round z, c the slope at the middle of the box, x ↦ x − D/c
contracts there: D has at most one root in the disc, and one within |D(z + x₀)|/(|c| − K) of any z + x₀ whose
neighbourhood of that size lies in it. This holds for complex u, |u_i| ≤ 1, so the root is analytic there.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import comb
from typing import Any

import numpy as np

from mpsolve.characteristic.boxes import at
from mpsolve.numbers.jets import TINY, UP, U
from mpsolve.numbers.quadratic import Quadratic

_ROUNDS = 3  # of Newton's method with a fixed slope: each gives one order more
_ROOM = 2.0  # of the disc, over what the root moves


@dataclass(frozen=True)
class FreeRoots:
    """Roots P and weights N/D_P as models of shape (boxes, roots), where `good`; radius: of the discs they are in."""

    P: Quadratic
    w: Quadratic
    radius: Any
    good: Any


@np.errstate(all="ignore")
def free_roots(D: Quadratic, N: Quadratic, z: Any, least: Any) -> FreeRoots:
    """The root near each node z, shape (boxes, roots); each disc is at least as large as `least`."""
    c, n = taylor(D, z), taylor(N, z)
    slope = c[1].k[0]
    x = _exact(c[0].times(-1 / slope))
    for _ in range(_ROUNDS):
        x = _exact(x + horner(c, x).times(-1 / slope))
    rest = horner(c, x).size
    moved = x.size
    radius = (_ROOM * moved + 4 * rest / np.abs(slope) + least) * UP + TINY
    bend = sum((i * a.size * radius ** (i - 1) for i, a in enumerate(c) if i > 1), c[1].spread) * (1 + 64 * U)
    low = np.abs(slope) * (1 - 16 * U) - bend
    e = rest / low * (1 + 16 * U) + TINY
    good = (low > 0) & ((moved + e) * UP <= radius) & np.isfinite(e)
    root = Quadratic(x.k, np.where(good, e, np.inf), x.m)
    slopes = [a.times(float(i)) for i, a in enumerate(c) if i]
    w = horner(n, root) * horner(slopes, root).inverse()
    k = root.k.copy()
    k[0] = k[0] + z
    return FreeRoots(Quadratic(k, (root.e + 4 * U * np.abs(k[0])) * UP, root.m), w, radius, good)


def taylor(polynomial: Quadratic, z: Any) -> list[Quadratic]:
    """The coefficients of x^i in the polynomial at z + x, each of the shape of z."""
    top = polynomial.k.shape[-1]
    out = []
    for i in range(top):
        factors = np.array([float(comb(j, i)) for j in range(i, top)])
        out.append(at(polynomial[:, i:].times(factors), z))
    return out


def horner(c: list[Quadratic], x: Quadratic) -> Quadratic:
    """Σ c_i x^i."""
    total = c[-1]
    for a in c[-2::-1]:
        total = total * x + a
    return total


def _exact(x: Quadratic) -> Quadratic:
    """The polynomial itself."""
    return Quadratic(x.k, np.zeros(x.e.shape), x.m)
