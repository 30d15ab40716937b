"""The p-roots at a ball of σ in balls of their own, proved, at the precision that is set.

With approximations z_1 … z_n of the p-roots and W_k = D(z_k)/(lead Π (z_k − z_i)), D/lead is the characteristic
polynomial of diag(z) − W·1ᵀ; by Gershgorin each group of the discs |P − z_k| ≤ n|W_k| that is apart from the others
holds as many roots as it has discs (Smith). At a thin σ interval Newton sharpens the discs at doubling precision.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from mpsolve.characteristic.symbol import Symbol, horner, slope_in_P
from mpsolve.errors import PrecisionError
from mpsolve.numbers.arrays import Complexes
from mpsolve.numbers.balls import acb, acb_poly, arb, bits_now, exact_ball, is_thin, precision, square
from mpsolve.numbers.float64 import companions

_NEAR = 2.0**-12
"""Roots that are nearer than this, relative to the largest root, are taken together."""
_ABERTH = 40  # steps
_FIRST_BITS = 80
"""Interval Newton starts here, from discs of some 45 bits round float64's roots."""


class Orders:
    """A symbol about the midpoint of σ: `orders[j]`, a polynomial in P, is the coefficient of (σ − middle)^j.

    At a thin σ there is one order alone, with σ itself.
    """

    def __init__(self, symbol: Symbol, sigma: Any) -> None:
        self.thin = is_thin(sigma)
        self.size = len(symbol.rows)
        if self.thin:
            self.orders = [acb_poly([row(sigma) for row in symbol.balls()])]
            self.step = acb(0)
            return
        middle = sigma.mid()
        about = acb_poly([middle, 1])
        rows = [row(about) for row in symbol.balls()]
        self.orders = [acb_poly([row[j] for row in rows]) for j in range(max(row.length() for row in rows))]
        self.step = sigma - middle

    def __call__(self, z: Any) -> Any:
        """The value over the ball of σ, at an exact z."""
        return self.orders[0](z) if self.thin else horner([a(z) for a in self.orders], self.step)

    def about(self, z: Any) -> list[acb]:
        """The coefficients of (P − z)^i over the ball of σ: balls only where σ and P depart from their middles."""
        moved = acb_poly([z, 1])
        shifted = [a(moved) for a in self.orders]
        return [horner([a[i] for a in shifted], self.step) for i in range(self.size)]

    @property
    def wide(self) -> acb_poly:
        """The polynomial in P over the ball of σ."""
        if self.thin:
            return self.orders[0]
        return acb_poly([horner([a[i] for a in self.orders], self.step) for i in range(self.size)])


def leading(D: Any, degree: int) -> Any:
    """The leading coefficient; `PrecisionError` where it may be 0."""
    lead = D[degree]
    if lead.contains(0) or not lead.is_finite():
        raise PrecisionError("the leading coefficient of the dispersion may be 0: split the piece")
    return lead


def float_roots(D: Any, degree: int) -> Complexes:
    """Roots of the midpoint polynomial in float64, those of smallest real part first."""
    coefficients = np.array([complex(D[i]) for i in range(degree + 1)])
    (companion,) = companions(coefficients[None])
    if not np.isfinite(companion).all():
        raise PrecisionError("the dispersion polynomial is out of float64's range here")
    z = np.linalg.eigvals(companion)
    return z[np.argsort(z.real)]


def sharp_roots(D: list[Any], z: Any) -> list[acb]:
    """Exact numbers near the roots of the midpoint polynomial, smallest real part first, from floats near them.

    By Ehrlich's and Aberth's iteration, to more than half of the precision that is set; nothing is proved here.
    """
    f = acb_poly([x.mid() for x in D])
    slope, size = f.derivative(), max(map(abs, z))
    found = [acb(complex(x)) + acb(complex(1, k)) * (2.0**-30 * size) for k, x in enumerate(z)]  # none the same
    for _ in range(_ABERTH):
        change = arb(0)
        for k, x in enumerate(found):
            step = f(x) / slope(x)
            step = step / (1 - step * sum((1 / (x - y) for i, y in enumerate(found) if i != k), acb(0)))
            if not step.is_finite():
                raise PrecisionError("p-roots cannot be told apart: raise the precision")
            found[k], change = (x - step).mid(), change.max(step.abs_upper())
        if change < arb(2) ** (-bits_now() // 2) * size:  # the next step is its third power
            return sorted(found, key=lambda x: float(x.real))
    raise PrecisionError("p-roots cannot be told apart: raise the precision")


def apart(z: Any) -> bool:
    """Whether the roots keep their distance; a matter of method, nothing is proved by it."""
    size = np.abs(z).max()
    gaps = np.abs(z[:, None] - z[None, :]) + size * np.eye(len(z))
    return bool(size > 0 and (gaps > _NEAR * size).all()) or len(z) == 1


def root_balls(symbol: Symbol, sigma: Any, z: Any) -> list[acb]:
    """Balls round the floats or exact z, each with one root of D for all σ; `PrecisionError` where they may touch."""
    target = bits_now()
    if not is_thin(sigma):
        local = Orders(symbol, sigma)
        nodes = [x if isinstance(x, acb) else exact_ball(complex(x)) for x in z]
        values, radii = discs(local, local.wide, nodes)
        return [_newton(local, *one) for one in zip(nodes, values, radii, strict=True)]
    ladder = [target]
    while ladder[0] > _FIRST_BITS:
        ladder.insert(0, max(ladder[0] // 2 + 12, _FIRST_BITS))
    with precision(ladder[0]):
        local = Orders(symbol, sigma)
        D = local.wide
        nodes = [x if isinstance(x, acb) else exact_ball(complex(x)) for x in z]
        values, radii = discs(local, D, nodes)
        slope = D.derivative()
        balls = [x + square(r) for x, r in zip(nodes, radii, strict=True)]
        balls = [_smaller(b, x - v / slope(b)) for b, x, v in zip(balls, nodes, values, strict=True)]
        balls = [_smaller(b, b.mid() - D(b.mid()) / slope(b)) for b in balls]
    for bits in ladder[1:]:
        with precision(bits // 2 + 16):
            slopes = [slope(b) for b in balls]
        with precision(bits):
            D = acb_poly([row(sigma) for row in symbol.balls()])
            balls = [_smaller(b, b.mid() - D(b.mid()) / s) for b, s in zip(balls, slopes, strict=True)]
            slope = D.derivative()
    return balls


def _smaller(ball: Any, image: Any) -> Any:
    return image if image.is_finite() and image.rad() < ball.rad() else ball


def discs(local: Orders, D: Any, z: Sequence[Any]) -> tuple[list[acb], list[arb]]:
    """The values of D at the nodes, and radii of discs round them with one root each, apart from each other."""
    n = len(z)
    lead = abs(leading(D, n))
    values, radii = [local(x) for x in z], []
    for k, x in enumerate(z):
        spread = lead
        for i, other in enumerate(z):
            if i != k:
                spread = spread * abs(x - other)
        radii.append(arb((n * abs(values[k]) / spread).upper()) if spread > 0 else arb("inf"))
    for k, x in enumerate(z):
        if not all(abs(x - z[i]) > radii[k] + radii[i] for i in range(k)):
            raise PrecisionError("two p-roots cannot be told apart over the ball: split the piece")
    return values, radii


def _newton(local: Orders, x: Any, value: acb, radius: arb) -> Any:
    """The image of the disc under interval Newton where it is smaller: it holds the one root of the disc."""
    disc = x + square(radius)
    about = slope_in_P(local.about(x))
    for _ in range(2):
        image = x - value / horner(about, disc - x)
        if not image.is_finite() or image.rad() > disc.rad():
            break
        disc = image
    return disc
