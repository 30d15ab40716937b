"""The point receptance G(0, σ) of a moving track as a Taylor polynomial in σ, and its slope in v, in balls.

G = Σ N/D_P over the p-roots with Re P < 0, P = P(σ, v). Series in t = σ − σ₀ carry a dual part for v. With balls for
σ₀ and v the coefficients hold those at every point of the balls.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from flint import acb_series

from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, acb_poly, arb, bits_now, rational_ball, square
from mpsolve.tracks.waveguide import Polynomial

_TRIES = 12  # radii of a disc round a root
_POLISH = 12  # steps of Newton's method


@dataclass(frozen=True)
class Germ:
    """G(σ₀ + t) = Σ value[k] t^k + …, and the derivatives of these coefficients in v."""

    value: tuple[Any, ...]
    by_velocity: tuple[Any, ...]


@dataclass(frozen=True)
class _Dual:
    """a + ε b with ε² = 0, ε the change of the velocity."""

    a: Any
    b: Any

    def __add__(self, other: _Dual) -> _Dual:
        return _Dual(self.a + other.a, self.b + other.b)

    def __sub__(self, other: _Dual) -> _Dual:
        return _Dual(self.a - other.a, self.b - other.b)

    def __mul__(self, other: _Dual) -> _Dual:
        return _Dual(self.a * other.a, self.a * other.b + self.b * other.a)

    def __truediv__(self, other: _Dual) -> _Dual:
        quotient = self.a / other.a
        return _Dual(quotient, (self.b - quotient * other.b) / other.a)


def germ(D: Polynomial, N: Polynomial, upper: int, sigma: Any, v: Any, order: int) -> Germ:
    """The germ at the balls sigma and v > 0, of D and N at rest; upper: how many roots have Re P < 0 in Re σ > 0.

    Re σ ≥ 0. The roots' sides are read off their balls, on the axis too: a root with Re P ≠ 0 keeps its side as
    σ moves into Re σ > 0, where none changes it. `PrecisionError` where balls are too wide.
    """
    roots = [root for root in root_balls(D, sigma, v) if not root.real > 0]
    if len(roots) != upper or not all(root.real < 0 for root in roots):
        raise PrecisionError("p-roots are not told apart into those of either side: split the ball")
    size = order + 1
    total = _Dual(_series([0], size), _series([0], size))
    for root in roots:
        total = total + _residue(D, N, root, sigma, v, size)
    return Germ(_coefficients(total.a, size), _coefficients(total.b, size))


def root_balls(D: Polynomial, sigma: Any, v: Any) -> list[Any]:
    """Balls with one root P each, all of them, over the balls sigma and v; `PrecisionError` where they may meet."""
    wide, middle = _at(D, sigma, v), _at(D, acb(sigma).mid(), arb(v).mid())
    if wide[wide.degree()].contains(0):
        raise PrecisionError("the leading coefficient may vanish: split the ball")
    centre = acb_poly([c.mid() for c in middle.coeffs()])
    try:
        near = [_polished(centre, root.mid()) for root in centre.roots()]
    except ValueError:
        raise PrecisionError("two p-roots meet") from None
    slope = wide.derivative()
    balls = [_newton(wide, slope, root) for root in near]
    for k, one in enumerate(balls):
        if any(one.overlaps(other) for other in balls[:k]):
            raise PrecisionError("p-roots may meet: split the ball")
    return balls


def _polished(f: Any, root: Any) -> Any:
    """A point nearer to a root of f, by steps that double its digits; nothing is proved."""
    slope = f.derivative()
    for _ in range(_POLISH):
        step = (f(root) / slope(root)).mid()
        if not step.is_finite() or step.abs_upper() <= root.abs_upper() * arb(2) ** (8 - bits_now()):
            break
        root = (root - step).mid()
    return root


def _newton(f: Any, slope: Any, root: Any) -> Any:
    value = f(root)
    first = value / slope(root)
    radius = 1.25 * first.abs_upper() if first.is_finite() else arb("inf")
    for _ in range(_TRIES):
        disc = root + square(radius)
        image = root - value / slope(disc)
        if image.is_finite() and disc.contains_interior(image):
            return image
        radius = radius * 1.5 + arb(2) ** -1000
    raise PrecisionError("a p-root is not isolated over the ball: split it")


def _at(D: Polynomial, sigma: Any, v: Any) -> Any:
    """D(P, σ − vP) as a polynomial in P."""
    s = acb_poly([sigma, -v])
    powers = [acb_poly([1])]
    for _ in range(max(j for _, j in D)):
        powers.append(powers[-1] * s)
    out = acb_poly([0])
    for (i, j), c in D.items():
        out += acb_poly([0] * i + [rational_ball(c)]) * powers[j]
    coefficients = out.coeffs()
    while len(coefficients) > 1 and coefficients[-1] == 0:
        coefficients.pop()
    return acb_poly(coefficients)


def _residue(D: Polynomial, N: Polynomial, root: Any, sigma: Any, v: Any, size: int) -> _Dual:
    """N/D_P along the root, whose constant coefficient the ball `root` holds."""
    one, zero = _series([1], size), _series([0], size)
    time, speed = _Dual(_series([sigma, 1], size), zero), _Dual(_series([v], size), one)
    P = _Dual(_series([root], size), zero)
    whole, slope = _both(D, P, time - speed * P, speed, size)
    over = 1 / slope.a[0]
    own: list[Any] = [root]
    dual: list[Any] = []
    for k in range(size):  # D(P) = 0 order by order: what is not yet known of P enters the next one linearly
        if k:
            own.append(-whole.a[k] * over)
            P = _Dual(_series(own, size), _series(dual, size) if dual else zero)
            whole = _sum(D, P, time - speed * P, size)
        dual.append(-whole.b[k] * over)
        P = _Dual(P.a, _series(dual, size))
        whole = _sum(D, P, time - speed * P, size)
    _, slope = _both(D, P, time - speed * P, speed, size)
    return _sum(N, P, time - speed * P, size) / slope


def _both(D: Polynomial, P: _Dual, s: _Dual, v: _Dual, size: int) -> tuple[_Dual, _Dual]:
    """D and its total derivative in P, where ds/dP = −v."""
    by_P = {(i - 1, j): i * c for (i, j), c in D.items() if i}
    by_s = {(i, j - 1): j * c for (i, j), c in D.items() if j}
    return _sum(D, P, s, size), _sum(by_P, P, s, size) - v * _sum(by_s, P, s, size)


def _sum(polynomial: Polynomial, P: _Dual, s: _Dual, size: int) -> _Dual:
    zero = _Dual(_series([0], size), _series([0], size))
    rows: dict[int, dict[int, Any]] = {}
    for (i, j), c in polynomial.items():
        rows.setdefault(i, {})[j] = c
    total = zero
    for i in range(max(rows, default=-1), -1, -1):
        row, inner = rows.get(i, {}), zero
        for j in range(max(row, default=-1), -1, -1):
            inner = inner * s
            if j in row:
                inner = inner + _Dual(_series([rational_ball(row[j])], size), zero.b)
        total = total * P + inner
    return total


def _series(coefficients: Sequence[Any], size: int) -> Any:
    return acb_series(list(coefficients)[:size], prec=size)


def _coefficients(series: Any, size: int) -> tuple[Any, ...]:
    return tuple(series[k] for k in range(size))
