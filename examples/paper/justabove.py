"""Conclusion (i), just above α_C: one or two equal masses without damping are unstable there, by a Nyquist count.

With N = 0 and A = α² = 1 + e², the p-roots of D are m ± ih and −m ± ih'. Near the branch point q* that opens where
the cuts have joined, h = ez is a local coordinate with z = 0 at q*. There m² = A + 1 + ν, ν = e⁴ω, h' = e·h̃ with
h̃² = −(z² + 2 − 2e²ω), q = e² q̂, and F(z) = z·Δ is analytic in z. All this holds down to e = 0, so one ball of e
covers every α up to a bound. The open quarter disc Re z > 0 > Im z, |z| < R, is part of the lower half-plane of q.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from typing import Any

import flint

from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import precision

acb, arb = flint.acb, flint.arb
_BITS, _HALVINGS = 64, 8
_RADIUS = Fraction(1, 2)

STEPS = (
    "At real q, from below, K(x_i − x_j) = P∫ − iπ Σ sgn(q − αp) e^{ip(x_i − x_j)}/|D_p| over the real p-roots. For "
    "q > q* these are −m ± k', k' = |h'| < m, with q − αp > 0. So M = I/a − [K], a = 2η_M q²/π, has a positive "
    "definite imaginary part (for two masses: where 0 < k'd < π), and its eigenvalues lie in the upper half-plane.",
    "Near q* let h = ez, with m ± ih the two p-roots that meet there: F(z) = z·det(I − a[K]) is analytic in the "
    "quarter disc Re z ≥ 0 ≥ Im z, |z| ≤ 1/2, also as e² = α² − 1 → 0: balls of e that reach down to 0 prove the "
    "next steps for every α of a strip at once.",
    "Re dq/d(z²) > 0: inside it Im q < 0. So no p-root turns real there, and since at one point m + ih and −m + ih' "
    "are the upper ones, F is z·Δ.",
    "From z = 0 by −i/2 to 1/2, F does not meet the ray i·[0, ∞); Re F < 0 at 0, while Re F > 0 and |a[K]| < 1 at "
    "1/2. From there back to 0 arg F is the sum of the arguments of the eigenvalues. So F turns once along this "
    "edge: there is exactly one root inside, and it is unstable.",
)


@lru_cache(maxsize=64)
def unstable_up_to(alpha: str, eta_m: str, d: str | None) -> bool:
    """Whether one mass (d None), or two at the distance d, are proved unstable for every α with 1 < α ≤ `alpha`."""
    with precision(_BITS):
        end = (_real(alpha) ** 2 - 1).sqrt()
        mass, distance = _real(eta_m), None if d is None else _real(d)
        return _everywhere(lambda part: _turns_once(end * part, mass, distance))


def _real(x: Any) -> Any:
    value = Fraction(x)
    return arb(value.numerator) / value.denominator


def _everywhere(holds: Callable[[Any], bool]) -> bool:
    """Whether a test holds on balls that cover [0, 1]: halved where it does not, up to a limit."""
    pending = [(Fraction(0), Fraction(1), 0)]
    while pending:
        low, high, depth = pending.pop()
        if holds(_real(low).union(_real(high))):
            continue
        if depth == _HALVINGS:
            return False
        middle = (low + high) / 2
        pending += [(low, middle, depth + 1), (middle, high, depth + 1)]
    return True


@dataclass(frozen=True)
class _Roots:
    """The p-roots m ± iez and −m ± ie·other over a ball of z², and q̂ with its derivative by z²."""

    m: Any
    other: Any
    q_hat: Any
    rate: Any
    lean: Any  # (m − m at ω = 0)/e: m itself is real there


def _roots(e: Any, square: Any) -> _Roots:
    """PrecisionError where the balls are too wide."""
    eps = e * e
    A = 1 + eps
    omega = _omega(eps, square)
    nu, gap, turned = eps * eps * omega, square + 1 - eps * omega, square + 2 - 2 * eps * omega
    middle = A + 1 + nu
    if not (middle.real > 0 and turned.real > 0):
        raise PrecisionError("a square root of the strip is not enclosed: ask for less of it")
    m, alpha = middle.sqrt(), A.sqrt()
    slope = 8 * A * (1 + nu) + (eps * gap) ** 2 - 2 * (1 + nu) * eps * gap
    nu_rate = -2 * (1 + nu) * eps * gap / slope  # dν/d(z²) over e²
    rate = (m * (1 - nu_rate) + gap * eps * nu_rate / (2 * m)) / (2 * alpha)
    return _Roots(m, 1j * turned.sqrt(), gap * m / (2 * alpha), rate, e**3 * omega / (m + (A + 1).sqrt()))


def _omega(eps: Any, square: Any) -> Any:
    """The one ω with |Re ω|, |Im ω| ≤ 1 and 4A ω(2 + ν) = −(1 + ν)(z² + 1 − e²ω)², which maps this box into it."""
    box = acb(arb(0, 1), arb(0, 1))
    for k in range(8):
        nu = eps * eps * box
        image = -(1 + nu) * (square + 1 - eps * box) ** 2 / (4 * (1 + eps) * (2 + nu))
        if not k and not box.contains_interior(image):
            raise PrecisionError("a p-root of the strip is not enclosed: ask for less of it")
        box = image
    return box


@dataclass(frozen=True)
class _Value:
    """F = z + b·rest with b = 2η_M e³ q̂², and `size`, a bound for |z|·|a[K]|/|b|."""

    F: Any
    b: Any
    rest: Any
    size: Any


def _value(e: Any, z: Any, eta_m: Any, d: Any | None) -> _Value:
    found = _roots(e, z * z)
    m, other, h, h_other = found.m, found.other, e * z, e * found.other
    X, X_low = (2 * m + 1j * h) ** 2 + h_other**2, (2 * m - 1j * h) ** 2 + h_other**2
    Y, Y_low = (2 * m - 1j * h_other) ** 2 + h * h, (2 * m + 1j * h_other) ** 2 + h * h
    b, single = 2 * eta_m * e**3 * found.q_hat**2, 1 / X + z / (other * Y)
    size = 1 / abs(X) + abs(z / (other * Y))
    if d is None:
        return _Value(z - b * single, b, -single, size)
    ahead, behind = (((side * 2j * m - h - h_other) * d).exp() for side in (1, -1))
    minor = (
        2 * d * e * _one_minus_exp(2 * h * d) / (X * X_low)
        + (1 - ahead) / (other * X * Y_low)
        + (1 - behind) / (other * X_low * Y)
        + z * (1 - (-2 * h_other * d).exp()) / (other**2 * Y * Y_low)
    )
    rest = b * minor - 2 * single
    return _Value(z + b * rest, b, rest, size + _larger(size, 1 / abs(X_low) + abs(z / (other * Y_low))))


def _larger(a: Any, b: Any) -> Any:
    return arb(max(a.upper(), b.upper()))


def _one_minus_exp(x: Any) -> Any:
    """(1 − e^{−x})/x, entire."""
    return (-x / 2).exp() * (0.5j * x).sinc()


def _turns_once(e: Any, eta_m: Any, d: Any | None) -> bool:
    """The second to the fourth step, and the condition of the first, for a ball of e ≥ 0."""
    R = _real(_RADIUS)
    reach = arb(0).union(R)
    try:
        return (
            _maps_below(e, R, reach, d)
            and _everywhere(lambda t: bool(_value(e, acb(R * t, -reach), eta_m, d).F.is_finite()))
            and _everywhere(lambda t: _down(_value(e, acb(0, -R * t), eta_m, d)))
            and _everywhere(lambda t: _along(_value(e, R * (-0.5j * acb.pi() * t).exp(), eta_m, d)))
            and _ends(_value(e, acb(0), eta_m, d), _value(e, acb(R), eta_m, d), R)
        )
    except PrecisionError:
        return False


def _maps_below(e: Any, R: Any, reach: Any, d: Any | None) -> bool:
    """The third step; and on the real segment k' < m, and k'd < π for two masses."""
    disc = acb(arb(0, R * R), arb(0, R * R))
    middle = R * (-0.25j * acb.pi()).exp()
    inside, real = _roots(e, middle * middle), _roots(e, acb(reach * reach))
    turn = e * real.other.imag
    apart = turn < real.m.real and (d is None or turn * d < arb.pi())
    sheet = middle.real > abs(inside.lean.imag) and inside.other.real > abs(inside.lean.imag)
    return bool(_roots(e, disc).rate.real > 0 and sheet and apart)


def _down(value: _Value) -> bool:
    """At z = −it, where b is real: off the ray i·[0, ∞), for every b > 0 of the ball."""
    return bool(value.rest.real < 0 or value.F.imag < 0)


def _along(value: _Value) -> bool:
    return bool(value.F.real > 0 or value.F.imag < 0)


def _ends(first: _Value, last: _Value, R: Any) -> bool:
    return bool(first.rest.real < 0 and last.F.real > 0 and abs(last.b) * last.size < R)
