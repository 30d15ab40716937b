"""The point receptance G(0, σ) of a moving track as a Taylor polynomial in σ, and its slope in v, in balls.

G = Σ N/D_P over the p-roots with Re P < 0, P = P(σ, v). Series in t = σ − σ₀ carry a dual part for v. With balls for
σ₀ and v the coefficients hold those at every point of the balls.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, TypeVar, cast

from flint import acb_series

from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, acb_poly, arb, bits_now, rational_ball, square
from mpsolve.tracks.waveguide import Polynomial, moved, slope_in_s

C = TypeVar("C")
Local = dict[tuple[int, int], Any]
"""Σ c P^i s^j about some point, with balls."""
_TRIES = 12  # radii of a disc round a root
_POLISH = 12  # steps of Newton's method


@dataclass(frozen=True)
class Germ:
    """G(σ₀ + t) = Σ value[k] t^k + …, and the derivatives of these coefficients in v."""

    value: tuple[acb, ...]
    by_velocity: tuple[acb, ...]


@dataclass(frozen=True)
class _Dual:
    """a + ε b with ε² = 0, ε the change of the velocity."""

    a: Any
    b: acb_series

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


def root_balls(D: Polynomial, sigma: Any, v: arb) -> list[acb]:
    """Balls with one root P each, all of them, over the balls sigma and v; `PrecisionError` where they may meet."""
    wide, middle = _at(D, sigma, v), _at(D, acb(sigma).mid(), arb(v).mid())
    if wide[wide.degree()].contains(0):
        raise PrecisionError("the leading coefficient may vanish: split the ball")
    centre = acb_poly([c.mid() for c in middle.coeffs()])
    try:
        near = [_polished(centre, root.mid()) for root in centre.roots()]
    except ValueError:
        raise PrecisionError("two p-roots meet") from None
    balls = [_newton(D, root, sigma, v) for root in near]
    for k, one in enumerate(balls):
        if any(one.overlaps(other) for other in balls[:k]):
            raise PrecisionError("p-roots may meet: split the ball")
    return balls


def _polished(f: Any, root: acb) -> acb:
    """A point nearer to a root of f, by steps that double its digits; nothing is proved."""
    slope = f.derivative()
    for _ in range(_POLISH):
        step = (f(root) / slope(root)).mid()
        if not step.is_finite() or step.abs_upper() <= root.abs_upper() * arb(2) ** (8 - bits_now()):
            break
        root = (root - step).mid()
    return root


def _newton(D: Polynomial, root: acb, sigma: Any, v: arb) -> acb:
    """Interval Newton for δ in P = root + δ, about a thin point, so that balls stand for small departures only."""
    time, about = _centre(root, sigma, v)
    local = _shifted(D, root, about)
    by_P, by_s = _slopes(local)
    value = _value(local, acb(0), time, acb)

    def slope(disc: acb) -> acb:
        s = time - v * disc
        return _value(by_P, disc, s, acb) - v * _value(by_s, disc, s, acb)

    first = value / slope(acb(0))
    radius = 1.25 * first.abs_upper() if first.is_finite() else arb("inf")
    for _ in range(_TRIES):
        disc = square(radius)
        image = -value / slope(disc)
        if image.is_finite() and disc.contains_interior(image):
            return root + image
        radius = radius * 1.5 + arb(2) ** -1000
    raise PrecisionError("a p-root is not isolated over the ball: split it")


def _centre(root: acb, sigma: Any, v: arb) -> tuple[acb, acb]:
    """(the ball of s − s₀ at P = root, the thin s₀) for s = σ − vP."""
    middle, speed = acb(sigma).mid(), arb(v).mid()
    about = (middle - speed * root).mid()
    return (middle - speed * root - about) + (sigma - middle) - (v - speed) * root, about


def _shifted(polynomial: Polynomial, P: acb, s: acb) -> Local:
    """The coefficients about a thin point: those of (P′ − P)^i (s′ − s)^j."""
    return moved(moved({key: acb(rational_ball(c)) for key, c in polynomial.items()}, 0, P), 1, s)


def _slopes(local: Local) -> tuple[Local, Local]:
    """∂/∂P and ∂/∂s."""
    by_P = {(i - 1, j): i * c for (i, j), c in local.items() if i}
    return by_P, slope_in_s(local)


def _value(local: Local, P: C, s: C, number: Callable[[acb], C]) -> C:
    """Σ c P^i s^j, its coefficients made numbers of the kind of P and s."""
    total: Any = number(acb(0))
    for row in reversed(_rows(local)):
        inner: Any = number(acb(0))
        for c in reversed(row):
            inner = inner * s + number(c)
        total = total * P + inner
    return cast(C, total)


def _rows(local: Local) -> list[list[acb]]:
    rows = [[acb(0)] for _ in range(max((i for i, _ in local), default=-1) + 1)]
    for (i, j), c in local.items():
        rows[i] += [acb(0)] * (j + 1 - len(rows[i]))
        rows[i][j] = c
    return rows


def _at(D: Polynomial, sigma: Any, v: arb) -> acb_poly:
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


def _residue(D: Polynomial, N: Polynomial, root: acb, sigma: Any, v: arb, size: int) -> _Dual:
    """N/D_P along the root, whose constant coefficient the ball `root` holds."""
    one, zero = _series([1], size), _series([0], size)
    thin = root.mid()
    offset, about = _centre(thin, sigma, v)
    d, n = _shifted(D, thin, about), _shifted(N, thin, about)
    by_P, by_s = _slopes(d)

    def value(local: Local, P: _Dual, s: _Dual) -> _Dual:
        return _value(local, P, s, lambda c: _Dual(_series([c], size), zero))

    # s − s₀ = offset + t − v (P − thin), and ε stands for a change −P of s
    time, speed = _Dual(_series([offset, 1], size), -_series([thin], size)), _Dual(_series([v], size), one)

    def along(own: Sequence[acb], dual: Sequence[acb]) -> tuple[_Dual, _Dual]:
        P = _Dual(_series(own, size), _series(dual, size) if dual else zero)
        return P, time - speed * P

    own: list[Any] = [root - thin]
    dual: list[Any] = []
    P, s = along(own, dual)
    slope = value(by_P, P, s) - speed * value(by_s, P, s)
    over = 1 / slope.a[0]
    for k in range(size):  # D(P) = 0 order by order: what is not yet known of P enters the next one linearly
        if k:
            own.append(-value(d, P, s).a[k] * over)
            P, s = along(own, dual)
        dual.append(-value(d, P, s).b[k] * over)
        P, s = along(own, dual)
    slope = value(by_P, P, s) - speed * value(by_s, P, s)
    return value(n, P, s) / slope


def _series(coefficients: Sequence[Any], size: int) -> acb_series:
    return acb_series(list(coefficients)[:size], prec=size)


def _coefficients(series: acb_series, size: int) -> tuple[acb, ...]:
    return tuple(series[k] for k in range(size))
