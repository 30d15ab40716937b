"""The power that a track takes, W/|D|² at wavenumber p and frequency Ω, over boxes of its parameters.

W = −Im(N conj D) at P = ip, s = iΩ. D and N are even in p, and each is r(y, z) + iΩ i(y, z) with y = p², z = Ω²:
W = Ω w with w = N_r D_i − N_i D_r, and |D|² = D_r² + z D_i². A track that is passive at rest has w ≥ 0.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

import numpy as np

from mpsolve.numbers.affine import Affine, constant, horner
from mpsolve.numbers.several import multiply, plus
from mpsolve.tracks.waveguide import halves, power

Terms = dict[tuple[int, ...], Fraction]
"""Σ c x₁^i x₂^j θ₁^k₁ … as {(i, j, k₁, …): c} with c ≠ 0."""


@dataclass(frozen=True)
class Power:
    """w, D_r and D_i in y = p², z = Ω² and the free parameters, whose names are given in order."""

    w: Terms
    real: Terms
    imaginary: Terms
    names: tuple[str, ...]

    @staticmethod
    def of(
        D: Mapping[tuple[int, ...], Fraction], N: Mapping[tuple[int, ...], Fraction], names: Sequence[str]
    ) -> Power:
        """From D and N at rest, polynomials in P, s and the parameters, even in P."""
        return Power(power(D, N), *halves(D), tuple(names))

    @cached_property
    def quotient(self) -> Quotient:
        """W/|D|²."""
        return Quotient(self, self.w, 1, 1)

    @cached_property
    def slope(self) -> Quotient:
        """∂/∂z of w/|D|²: (w_z |D|² − w ∂_z|D|²)/|D|⁴."""
        z: Terms = {(0, 1, *[0] * len(self.names)): Fraction(1)}
        square = plus(multiply(self.real, self.real), multiply(z, multiply(self.imaginary, self.imaginary)))
        return Quotient(self, _less(multiply(_slope(self.w), square), multiply(self.w, _slope(square))), 0, 2)

    @property
    def alpha(self) -> int:
        """|W|/|D|² falls at least as p^−α where waves run no faster than the load."""
        return self.quotient.alpha


@dataclass(frozen=True)
class Quotient:
    """Ω^odd · top(y, z)/|D|^(2·copies)."""

    power: Power
    top: Terms
    odd: int
    copies: int

    @cached_property
    def degrees(self) -> tuple[tuple[int, int], tuple[int, int]]:
        """Of what stands above and below: the degree in p, and that in p and Ω together."""
        below = [(2 * key[0], 2 * key[0] + 2 * key[1] + z)
                 for terms, z in ((self.power.real, 0), (self.power.imaginary, 1)) for key in terms]  # fmt: skip
        above = [(2 * key[0], 2 * key[0] + 2 * key[1] + self.odd) for key in self.top] or [(0, 0)]
        most = [max(column) for column in zip(*below, strict=True)]
        by_p, total = (max(column) for column in zip(*above, strict=True))
        return (by_p, total), (2 * self.copies * most[0], 2 * self.copies * most[1])

    @property
    def alpha(self) -> int:
        """It falls at least as p^−α where waves run no faster than the load."""
        (iw, nw), (i2, n2) = self.degrees
        return min(i2 - iw, n2 - nw)


def _less(a: Terms, b: Terms) -> Terms:
    return plus(a, {key: -c for key, c in b.items()})


def _slope(a: Terms) -> Terms:
    """∂/∂z."""
    return {(i, j - 1, *rest): j * c for (i, j, *rest), c in a.items() if j}


def value(terms: Terms, x: Affine, y: Affine, parameters: Sequence[Affine]) -> Affine:
    """The polynomial over boxes of its variables."""
    rows: dict[int, dict[int, list[tuple[tuple[int, ...], Fraction]]]] = {}
    for (i, j, *powers), c in terms.items():
        rows.setdefault(i, {}).setdefault(j, []).append((tuple(powers), c))
    outer: list[Affine | None] = []
    for i in range(max(rows, default=-1) + 1):
        row = rows.get(i, {})
        inner = [coefficient(row[j], parameters) if j in row else None for j in range(max(row, default=-1) + 1)]
        outer.append(horner(inner, y) if inner else None)
    return horner(outer, x)


def coefficient(monomials: Iterable[tuple[tuple[int, ...], Fraction]], parameters: Sequence[Affine]) -> Affine:
    total: Affine | None = None
    for powers, c in monomials:
        term = constant(c)
        for parameter, times in zip(parameters, powers, strict=True):
            for _ in range(times):
                term = term * parameter
        total = term if total is None else total + term
    return total if total is not None else Affine(np.zeros(()))


def moved(terms: Terms, change: Any) -> Terms:
    """The same coefficients with other powers of the first two variables: (i, j) → change(i, j)."""
    out: Terms = {}
    for (i, j, *rest), c in terms.items():
        key = (*change(i, j), *rest)
        out[key] = out.get(key, Fraction(0)) + c
    return out
