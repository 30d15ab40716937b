"""A reduced problem about one point: polynomials in t = σ − iz and e = P − ip, exact up to one rounding each.

Next to a branch point floats of σ do not tell how far away it is; those of t do, however close. The waves e^{Pξ} are
e^{ipξ} times those in e. Points in floats of t stand for all that is within 2⁻⁵⁰ |t|: so for a float of σ too.
"""

from __future__ import annotations

from fractions import Fraction
from functools import cached_property
from math import comb
from typing import Any

import numpy as np

from mpsolve.characteristic.disc_matrix import Arrays
from mpsolve.characteristic.discs import Splittings, split
from mpsolve.characteristic.residues import told_apart
from mpsolve.characteristic.table import Table
from mpsolve.frozen import frozen
from mpsolve.numbers.arrays import Complexes, Reals, Truths
from mpsolve.numbers.jets import UP, Jet, U
from mpsolve.tracks.waveguide import Polynomial

_NEAR = 2.0**-50
_TURNS = ((1, 0), (0, 1), (-1, 0), (0, -1))


@frozen
class LocalArrays(Arrays):
    """The arrays of a reduced problem about σ = iz, P = ip."""

    z: Fraction
    p: Fraction

    @cached_property
    def D(self) -> Table:
        return self._moved(self.reduced.guide.D)

    @cached_property
    def N(self) -> Table:
        return self._moved(self.reduced.guide.N)

    def _about(self, *f: Fraction) -> list[Any]:
        z, (c0, c1, c2) = self.z, f
        return [complex(c0 - z * z * c2, z * c1), complex(c1, 2 * z * c2), complex(c2)]

    @property
    def shift(self) -> complex:
        return complex(0, float(self.p))

    def evaluate(self, m: Any, r: Any, up: int, nodes: Any = None) -> tuple[Splittings, Jet, Truths]:
        s, G, good = super().evaluate(m, _widened(m, r), up, nodes)
        distances, pairs = self.distances
        turn, lost = np.exp(self.shift * distances)[pairs], (8 + np.abs(self.shift * distances))[pairs]
        moved = G * turn
        return s, Jet(moved.a, moved.b, moved.e + 4 * U * lost * (np.abs(G.a) + np.abs(G.b) * r_of(G)), G.r), good

    def without_pole(
        self, m: Complexes, r: Reals, up: int, nodes: Complexes, at: complex
    ) -> tuple[Splittings, Jet, Jet, Truths]:
        return super().without_pole(m, _widened(m, r), up, nodes, at)

    def _moved(self, polynomial: Polynomial) -> Table:
        """Coefficients of e^i t^j, each rounded to nearest."""
        degree = max(i for i, _ in polynomial), max(j for _, j in polynomial)
        found: dict[tuple[int, int], list[Fraction]] = {}
        for (a, b), c in polynomial.items():
            for i in range(a + 1):
                for j in range(b + 1):
                    value = c * comb(a, i) * comb(b, j) * self.p ** (a - i) * self.z ** (b - j)
                    re, im = _TURNS[(a - i + b - j) % 4]
                    parts = found.setdefault((i, j), [Fraction(0), Fraction(0)])
                    parts[0], parts[1] = parts[0] + re * value, parts[1] + im * value
        d = np.zeros((degree[0] + 1, degree[1] + 1), complex)
        for key, (re_part, im_part) in found.items():
            d[key] = complex(float(re_part), float(im_part))
        return Table(d)


def r_of(G: Jet) -> Any:
    return G.r.reshape(-1, *[1] * (G.a.ndim - 1))


def _widened(m: Complexes, r: Reals) -> Reals:
    return np.maximum(r, _NEAR * np.abs(m)) * UP


def same_pair(whole: Arrays, near: LocalArrays, q: float, up: int) -> bool:
    """Whether U has the same roots in both splittings at the real q̂ that `split` makes there by itself.

    Each has all p-roots in discs of their own; where no disc of U here meets one of L there, their roots of U are the
    same, as they are as many.
    """
    t = np.array([1j * float(Fraction(q) - near.z)])
    one, other = split(whole.D, np.array([1j * q]), np.zeros(1), up), split(near.D, t, _NEAR * np.abs(t), up)
    (here, apart), (there, apart_too) = told_apart(whole.D, one), told_apart(near.D, other)
    if not (apart[0] and apart_too[0]):
        return False
    z, w = one.z[0], other.z[0] + near.shift
    room = np.abs(z[:, None] - w[None, :]) - (here.eps[0][:, None] + there.eps[0][None, :]) * UP
    slack = 16 * U * np.abs(z).max()
    return bool((room[:up, up:] > slack).all() and (room[up:, :up] > slack).all())
