"""Fields for dual numbers that hold where an upper p-root meets a lower one: (1 − e^{izx})/z is entire in z."""

from __future__ import annotations

import math
from typing import Any

import flint
import numpy as np

from mpsolve.discs import DiscField, Discs, exponential_quotient, where
from mpsolve.dual import Dual
from mpsolve.fields import Ball, laplace_det

acb, arb = flint.acb, flint.arb
_TERMS = 32


class DualDiscs(DiscField):
    """Dual numbers over discs; `scaled_characteristic` takes the roots a, c as the pair that may meet."""

    def one_minus_exp(self, z: Any, x: Any) -> Any:
        """With w = izx: −ix E(w), E(w) = (e^w − 1)/w, and its slopes x² E'(w) z'."""
        value = super().one_minus_exp(z.value, x)
        rate = quotient_rate_discs(z.value * x * self.i) * x * x
        return Dual(value, [rate * slope for slope in z.slopes])

    def choose(self, _: Any, apart: Any, bordered: Any) -> Any:
        """Of value and slopes the narrower discs, box by box."""
        return [_narrower(one, two) for one, two in zip(apart(), bordered(), strict=True)]


def _narrower(one: Any, two: Any) -> Any:
    if isinstance(one, Dual):
        slopes = [_narrower(a, b) for a, b in zip(one.slopes, two.slopes, strict=True)]
        return Dual(_narrower(one.value, two.value), slopes)
    return where(~(two.r <= one.r), one, two)  # nan loses


def quotient_rate_discs(w: Discs) -> Discs:
    """E'(w) = ∫₀¹ t e^{tw} dt = Σ w^k/(k! (k + 2)), entire in w."""
    close = w.upper <= 2
    m, series = np.where(close, w.m, 0), np.full_like(w.m, 1 / (_TERMS + 2))
    for k in range(_TERMS, 0, -1):
        series = 1 / (k + 1) + series * m / k
    # |E''| ≤ e^{|w|}/3 and |E'| ≤ e^{|w|}/2, with e^{|w|} ≤ e² < 7.4 where |w| ≤ 2; the rest is below 2^−80
    near = Discs(series, np.where(close, 2.5 * w.r + 3.7 * 2.0**-44, np.inf))
    far = (w.exp() - exponential_quotient(w)) * w.inverse()
    return where(near.r < far.r, near, far)


class EntireBalls:
    """A `Ball` field for R·Δ along the edge, whose pair (a, c) may meet."""

    def __init__(self, field: Ball) -> None:
        self.ball, self.bits, self.pi, self.i = field, field.bits, field.pi, field.i

    def one_minus_exp(self, z: Any, x: Any) -> Any:
        """(1 − e^{izx})/z, of balls or of dual numbers over balls."""
        if not isinstance(z, Dual):
            return self.ball.one_minus_exp(acb(z), x)
        value = self.ball.one_minus_exp(acb(z.value), x)
        rate = quotient_rate(self.i * z.value * x, self.bits) * x * x
        return Dual(value, [rate * slope for slope in z.slopes])

    def det(self, rows: Any) -> Any:
        return laplace_det(rows)

    def nearest_pair_first(self, z: Any) -> Any:
        """The roots as they are: a and c are the pair that may meet."""
        return z

    def choose(self, _z: Any, _apart: Any, bordered: Any) -> Any:
        """Always the form that holds where a and c meet."""
        return bordered()


def quotient_rate(w: Any, bits: int) -> Any:
    """E'(w) = Σ w^k/(k! (k + 2)) over a ball, by (e^w − E(w))/w off 0."""
    if w.abs_lower() > 0.5:
        wave = w.exp()
        return (wave - (wave - 1) / w) / w
    if not w.abs_upper() < 2:
        return acb("nan")
    terms = 8
    while terms - math.lgamma(terms + 1) / math.log(2) > -bits - 4:  # 2^n/n! < 2^−bits
        terms += 1
    power, total = acb(1), acb(0)
    for k in range(terms):
        total += power / (k + 2)
        power = power * w / (k + 1)
    rest = arb(0, (8 * power.abs_upper()).upper())  # the terms after |w|^n/n! shrink by 2/(n + 1) or more
    return total + acb(rest, rest)
