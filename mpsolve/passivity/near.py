"""−Im G(0, q)/q > 0 for one contact on boxes of q and parameters that may hold q = 0.

Φ = Ω φ(y, z) with φ = w/|D|², y = p², z = Ω². Waves p and −p together, over p > 0:

    −2π Im G(0, q)/q = ∫ φ(y, z₊) + φ(y, z₋) + 4 v² y φ_z dp,   z± = (q ± vp)²,

φ_z = (φ(y, z₊) − φ(y, z₋))/(z₊ − z₋), which is a quotient of polynomials (SPEC, section 6.6).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from mpsolve.numbers.affine import Affine, between
from mpsolve.numbers.arrays import Reals, Truths
from mpsolve.numbers.jets import TINY, UP, U
from mpsolve.passivity.envelope import Envelope
from mpsolve.passivity.power import Terms, value
from mpsolve.passivity.subject import Subject, cells

_CELLS = 1 << 14  # that are looked at at once, about


@dataclass(frozen=True)
class Near:
    """The test for 0 ≤ q ≤ reach over the box of parameters from low to high; all scaled."""

    subject: Subject
    low: tuple[float, ...]
    high: tuple[float, ...]
    reach: float

    @cached_property
    def envelope(self) -> Envelope:
        """Of φ_z at short waves."""
        return Envelope(self.subject, self.low, self.high, self.subject.power.slope, self.reach)

    def passes(self, low: Reals, high: Reals, side: int) -> Truths:
        """For boxes (q, parameters): whether −Im G(0, q)/q > 0 is proved on the whole box, at q = 0 its limit."""
        count = max(1, _CELLS // (8 * side))
        parts = [self._passes(low[k : k + count], high[k : k + count], side) for k in range(0, len(low), count)]
        return np.concatenate(parts) if parts else np.zeros(0, bool)

    @np.errstate(all="ignore")
    def _passes(self, low: Reals, high: Reals, side: int) -> Any:
        subject, middle = self.subject, low / 2 + high / 2
        spread = ((high - low) / np.maximum(np.abs(high + low), 1e-300))[:, 1:].max(1, initial=0.0)
        ends = np.maximum(cells(subject, middle[:, 0], middle[:, 1:], spread, side), 0)
        parameters = subject.parameters(low[:, 1:], high[:, 1:])
        q, v = between(low[:, :1], high[:, :1], "q"), subject.speed(parameters)
        p = between(ends[:, :-1], ends[:, 1:], "p")
        least, moved = _integrand(subject, p, q, v, parameters)
        length = ends[:, 1:] - ends[:, :-1]
        used = length > 0
        total = np.where(used, least * length, 0.0)
        slopes = [np.where(used, b * length, 0.0) for b in moved]
        size = np.abs(total).cumsum(1) + sum((np.abs(b).cumsum(1) for b in slopes), np.zeros_like(total))
        off = sum((np.abs(b.cumsum(1)) for b in slopes), np.zeros_like(total))
        lost = (off + self._tail(ends[:, 1:], np.ravel(v.high)) + 8192 * U * size) * UP
        return (total.cumsum(1) - lost > 0).any(1)  # the cells may end anywhere

    def _tail(self, end: Any, v: Reals) -> Any:
        """What 4 v² y φ_z takes away at most beyond each end."""
        beta = self.envelope.quotient.alpha
        if beta <= 3:
            return np.full(end.shape, np.inf)
        # Ω lies within beside·p of the line, for p ≥ 1
        C = np.where(end >= 1, self.envelope.constants(np.maximum(end, 1.0)), np.inf)
        return 4 * v[:, None] ** 2 * C * np.maximum(end, TINY) ** (3.0 - beta) / (beta - 3) * (1 + 64 * U)


def _integrand(
    subject: Subject, p: Affine, q: Affine, v: Affine, parameters: list[Affine]
) -> tuple[Reals, list[Reals]]:
    """On each cell a and b_k with integrand, averaged over p, ≥ a + Σ b_k ε_k."""
    ones = np.ones((max(len(q.a), len(p.a)), p.a.shape[1]))
    y, line = p.square(), v * p
    ahead, back = (_Side.at(subject, y, (line + q.times(sign)).square(), parameters) for sign in (1, -1))
    top, bottom = _difference(subject, y, ahead, back, parameters), ahead.square * back.square
    weight = line.square().times(4.0)
    sums = [one.w * one.square.inverse() for one in (ahead, back)]
    slope = top * bottom.inverse()
    below = ahead.least * back.least * (1 - 4 * U)
    given = np.where(top.low < 0, top.low / below, top.low / bottom.high)
    crude_slope = np.where(np.isfinite(given), given, np.where(top.low < 0, -np.inf, 0))
    crude_slope = np.where(crude_slope < 0, crude_slope * np.maximum(weight.high, 0), crude_slope * weight.low)
    crude = sum((np.maximum(f.low, 0) for f in sums), 0.0 * ones) + crude_slope - 64 * U * np.abs(crude_slope)
    form = sums[0] + sums[1] + weight * slope
    a, b = form.a * ones, {name: x * ones for name, x in form.b.items()}
    radius = p.b.get("p", np.zeros_like(p.a)) * ones
    off = (8 * U * np.abs(p.a) / np.maximum(radius, TINY) + 8 * (UP - 1)) * np.abs(b.get("p", 0 * ones))
    a = a - form.e - off * UP - 8 * U * np.abs(a)
    moved = {name: x for name, x in b.items() if name != "p"}
    least = a - sum((np.abs(x) for x in moved.values()), 0 * ones) * UP
    better = np.isfinite(least) & (least > crude)
    return np.where(better, a, crude), [np.where(better, x, 0.0) for x in moved.values()]


@dataclass(frozen=True)
class _Side:
    """z, w, D_r, D_i and |D|² at one of z₊ and z₋."""

    z: Affine
    w: Affine
    real: Affine
    imaginary: Affine
    square: Affine

    @staticmethod
    def at(subject: Subject, y: Affine, z: Affine, parameters: list[Affine]) -> _Side:
        power = subject.power
        w, real, imaginary = (value(a, y, z, parameters) for a in (power.w, power.real, power.imaginary))
        return _Side(z, w, real, imaginary, real.square() + z * imaginary.square())

    @property
    def least(self) -> Any:
        """A lower bound ≥ 0 of |D|²."""
        parts = (np.maximum(np.maximum(f.low, -f.high), 0) ** 2 for f in (self.real, self.imaginary))
        real, imaginary = parts
        return np.maximum(
            np.maximum(self.square.low, 0), (real + np.maximum(self.z.low, 0) * imaginary) * (1 - 8 * U)
        )


def _difference(subject: Subject, y: Affine, one: _Side, other: _Side, parameters: list[Affine]) -> Affine:
    """(w₊ B₋ − w₋ B₊)/(z₊ − z₋), B = |D|²: a polynomial."""
    power = subject.power
    w, real, imaginary = (divided(a, y, one.z, other.z, parameters) for a in (power.w, power.real, power.imaginary))
    square = real * (one.real + other.real) + one.imaginary.square()
    square = square + other.z * (imaginary * (one.imaginary + other.imaginary))
    return w * other.square - other.w * square


def divided(terms: Terms, y: Affine, a: Affine, b: Affine, parameters: list[Affine]) -> Affine:
    """(f(y, a) − f(y, b))/(a − b): z^j becomes a^{j−1} + a^{j−2} b + … + b^{j−1}."""
    total = Affine(np.zeros(()))
    symmetric = Affine(np.ones(()))
    power = Affine(np.ones(()))  # of b
    for j in range(1, max((key[1] for key in terms), default=0) + 1):
        row = {(i, 0, *rest): c for (i, k, *rest), c in terms.items() if k == j}
        if row:
            total = total + value(row, y, a, parameters) * symmetric
        power = power * b
        symmetric = symmetric * a + power
    return total
