"""∫ |V|² Φ dp as a Hermitian matrix over cells of wavenumber, and whether it is positive definite over a box.

Over a cell p = m ± h, with x = hΔ: ∫ e^{ipΔ} dp = 2h e^{imΔ} sin(x)/x and ∫ ((p − m)/h) e^{ipΔ} dp =
2ih e^{imΔ} (sin x − x cos x)/x².
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.numbers.affine import Affine
from mpsolve.numbers.arrays import Complexes, Integers, Reals, Truths
from mpsolve.numbers.jets import TINY, UP, U, exponential
from mpsolve.proof.definite import positive_definite

_SERIES = 12


@dataclass(frozen=True)
class Density:
    """On each cell Φ ≥ a + b_p ε_p + Σ b_k ε_k; middle, half: of the cells."""

    middle: Any
    half: Reals
    a: Any
    b: dict[str, Reals]
    turn: Reals
    takes: Truths

    def ended(self, tail: Reals) -> tuple[Density, Reals]:
        """The same with cells up to one end of each box, where most is left; and what is given beyond it.

        tail: what is given beyond the end of each cell, at most.
        """
        length = 2 * self.half
        total = (self.a * length).cumsum(1)
        off = sum((np.abs((b * length).cumsum(1)) for b in self.b.values()), np.zeros_like(total))
        left = total - off - tail
        last = np.argmax(np.where(np.isnan(left), -np.inf, left), axis=1)
        used = np.arange(length.shape[1]) <= last[:, None]
        b = {name: np.where(used, x, 0.0) for name, x in self.b.items()}
        a, turn = np.where(used, self.a, 0.0), np.where(used, self.turn, 0.0)
        return Density(self.middle, self.half, a, b, turn, self.takes), tail[np.arange(len(last)), last]

    def taking(self, rows: Integers) -> Density:
        """Those of some boxes, with 0 in place of what the track may give."""
        takes = self.takes[rows]
        b = {name: np.where(takes, x[rows], 0.0) for name, x in self.b.items()}
        a, turn = np.where(takes, self.a[rows], 0.0), np.where(takes, self.turn[rows], 0.0)
        return Density(self.middle[rows], self.half[rows], a, b, turn, takes)


def positive(density: Density, tail: Reals) -> Any:
    """One contact: the integral itself; what is linear over a cell adds nothing."""
    length = 2 * density.half
    total = (density.a * length).sum(1)
    lost = (np.abs(density.a) * length).sum(1) * 4096 * U
    moved = sum((np.abs((b * length).sum(1)) for b in density.b.values()), np.zeros_like(total))
    lost = lost + sum(((np.abs(b) * length).sum(1) for b in density.b.values()), np.zeros_like(total)) * 4096 * U
    return total - (moved + lost + tail) * UP > 0


def definite(density: Density, distances: list[Affine], number: Integers, tail: Reals) -> Any:
    """Several contacts: whether H₀ + Σ ε_k H_k + E − tail is positive definite.

    distances: the different distances; number[i, j], i > j: which one.
    """
    n, boxes = len(number), len(tail)
    names = sorted({*density.b, *(name for d in distances for name in d.b)})
    H = np.zeros((boxes, 1 + len(names), n, n), complex)
    E = np.zeros((boxes, n, n))
    parts = [_diagonal(density, names), *(_entry(density, d, names) for d in distances)]
    for i in range(n):
        H[:, :, i, i], E[:, i, i] = parts[0]
        for j in range(i):
            values, lost = parts[1 + number[i, j]]
            H[:, :, i, j], H[:, :, j, i] = values, values.conj()
            E[:, i, j] = E[:, j, i] = lost
    H[:, 0] -= tail[:, None, None] * UP * np.eye(n)
    return positive_definite(H, E)


def _diagonal(density: Density, names: list[str]) -> tuple[Reals, Reals]:
    length = 2 * density.half
    rows = [density.a, *(density.b.get(name, np.zeros_like(density.a)) for name in names)]
    values = np.stack([(row * length).sum(1) for row in rows], 1)
    lost = sum((np.abs(row) * length).sum(1) for row in rows) * 4096 * U
    return values, lost * UP + TINY


def _entry(density: Density, distance: Affine, names: list[str]) -> tuple[Complexes, Reals]:
    """The entry of a pair of places at this distance: middle and slopes over the boxes, a bound of the rest."""
    ones = np.ones((len(density.a), 1))
    D = distance.a * ones
    x = density.half * np.abs(D)
    phase, lost = exponential(1j * density.middle * D)
    flat, flat_lost = _sinc(x)
    bend, bend_lost = _bend(x)
    cell = phase * (2 * density.half * flat)
    skew = phase * (2j * density.half * bend * np.sign(D))
    rows = {name: density.b.get(name, np.zeros_like(density.a)) for name in names}
    values = [(density.a * cell + density.turn * skew).sum(1)]
    for name, row in rows.items():
        grown = (row * cell).sum(1)
        if name in distance.b:
            grown = grown + 1j * np.ravel(distance.b[name] * ones) * (density.a * density.middle * cell).sum(1)
        values.append(grown)
    slopes = sum((np.abs(row) for row in rows.values()), np.abs(density.turn))
    size = np.abs(density.a) + slopes
    delta = (distance.spread + distance.e) * ones
    far = np.abs(density.middle) + density.half
    rounding = (64 + density.a.shape[1]) * 16 * U * (1 + far * (delta + np.abs(D)))
    error = size * (lost + flat_lost + bend_lost + rounding)
    error = error + delta * (np.abs(density.a) * density.half + slopes * far) + size * (far * delta) ** 2 / 2
    error = error + np.abs(density.a) * far * distance.e * ones
    return np.stack(values, 1), (error * 2 * density.half).sum(1) * UP + TINY


def _sinc(x: Reals) -> tuple[Reals, Reals]:
    """sin(x)/x for x ≥ 0, and a bound of its error."""
    small = x < 1
    y = np.where(small, x * x, 0)
    series, term = np.ones_like(x), np.ones_like(x)
    for k in range(1, _SERIES):
        term = -term * y / (2 * k * (2 * k + 1))
        series = series + term
    with np.errstate(all="ignore"):
        e, lost = exponential(1j * np.where(small, 1.0, x))
        far = e.imag / x
    return np.where(small, series, far), np.where(small, 64 * U, lost * 2 + 64 * U)


def _bend(x: Reals) -> tuple[Reals, Reals]:
    """(sin x − x cos x)/x² for x ≥ 0, and a bound of its error."""
    small = x < 1
    y = np.where(small, x * x, 0)
    term = np.where(small, x, 0) / 3
    series = term
    for k in range(1, _SERIES):
        term = -term * y / (2 * k * (2 * k + 3))
        series = series + term
    with np.errstate(all="ignore"):
        e, lost = exponential(1j * np.where(small, 1.0, x))
        far = (e.imag - x * e.real) / (x * x)
    return np.where(small, series, far), np.where(small, 64 * U, lost * 4 + 64 * U)
