"""The p-roots far out, by the edges of Newton's polygon, proved for all |σ| ≥ R.

P = σ^w (z₀ + z₁ζ + …), ζ = σ^{−1/b}, w = a/b. Waves that stay where they are on the track have P near σ/v; where
several do, as those of sleepers without bending, it is s = σ − vP that goes as σ^w with w < 1.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import combinations, pairwise
from typing import Any

from flint import fmpq_poly

from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, acb_poly, arb, rational_ball, square
from mpsolve.passivity.decay import Edge, edges, in_s
from mpsolve.tracks.waveguide import Polynomial

_GROWN, _FINEST = 30, 60
_TOGETHER = "p-roots far out cannot be told apart: go further"


@dataclass(frozen=True)
class FarRoot:
    """P = σ^w (z₀ + z₁ζ + rest), |rest| ≤ left |ζ|², and N/D_P = σ^{−γ} weight, for all |σ| ≥ R.

    z: the ball of P/σ^w. parts: w₀, w₁, off of the weight, w₀ + w₁ζ to within off. neutral: z₀ i^w is imaginary,
    exactly: the wave neither grows nor decays to leading order. still: the ball of s where P = (σ − s)/v = (σ − s)z₀.
    """

    power: Fraction
    z0: acb
    z1: acb
    left: Any
    z: Any
    gamma: Fraction
    weight: acb
    neutral: bool
    still: Any = None
    parts: tuple[acb, acb, arb] | None = None

    def at(self, sigma: Any) -> Any:
        """The ball of P at one σ."""
        if self.still is not None:
            return (sigma - self.still) * self.z0
        return (sigma.log() * rational_ball(self.power)).exp() * self.z


def far_roots(D: Polynomial, N: Polynomial, v: Fraction, radius: arb) -> list[FarRoot]:
    """All p-roots of D(P, σ) for |σ| ≥ radius, apart from each other; PrecisionError where that is not proved."""
    out: list[FarRoot] = []
    for edge in edges(D, N):
        if not 0 <= edge.slope <= 1:
            stated = f"p-roots that go as σ^({edge.slope}) are beyond what is proved"
            raise PrecisionError(f"{stated} of the motion in balls")
        rest, still = edge.without(1 / v) if edge.slope == 1 and v else (edge.roots, 0)
        out += _along(D, N, edge, rest if still > 1 else edge.roots, radius)
        if still > 1:
            out += _still(D, N, v, radius)
    if len(out) != max(i for i, _ in D):
        raise PrecisionError("not all p-roots far out are known: take another track")
    if any(
        one.z.overlaps(other.z)
        for one in out
        for other in out
        if one.power == 1 and one.still is None and other.still is not None
    ):
        raise PrecisionError(_TOGETHER)
    for one, other in pairwise(sorted({root.power for root in out})):
        low = max(abs(root.z).upper() for root in out if root.power == one) * power_of(radius, one)
        high = min(abs(root.z).lower() for root in out if root.power == other) * power_of(radius, other)
        if not low < high:
            raise PrecisionError(_TOGETHER)
    return out


def power_of(radius: arb, power: Fraction) -> Any:
    """radius^power."""
    return (radius.log() * rational_ball(power)).exp()


def turn(power: Fraction) -> acb:
    """i^power."""
    return acb(0, rational_ball(power / 2) * arb.pi()).exp()


def _still(D: Polynomial, N: Polynomial, v: Fraction, radius: arb) -> list[FarRoot]:
    """The p-roots with P = (σ − s)/v, s = σ^w (…), w < 1."""
    moved, over = in_s(D, v), in_s(N, v)
    slow = (edge for edge in edges(moved, over) if edge.slope < 1)
    found = [root for edge in slow for root in _along(moved, over, edge, edge.roots, radius)]
    _apart(found)
    if any(root.power for root in found):
        raise PrecisionError("waves that stay on the track far out are beyond what is proved of the motion in balls")
    z0 = acb(rational_ball(1 / v))
    out = []
    for root in found:
        z = z0 * (1 - square(abs(root.z).upper() / radius))
        weight = -root.weight * z0
        root = replace(root, parts=None)
        out.append(replace(root, power=Fraction(1), z0=z0, z=z, weight=weight, neutral=True, still=root.z))
    return out


def _scaled(polynomial: Polynomial, power: Fraction) -> tuple[int, dict[tuple[int, int], Fraction]]:
    """m and the terms z^i ζ^k of polynomial(z ζ^{−a}, ζ^{−b}) ζ^m."""
    a, b = power.numerator, power.denominator
    m = max(a * i + b * j for i, j in polynomial)
    return m, {(i, m - a * i - b * j): c for (i, j), c in polynomial.items()}


def _along(D: Polynomial, N: Polynomial, edge: Edge, roots: fmpq_poly, radius: arb) -> list[FarRoot]:
    """The roots of one edge, of which `roots` are looked at, or some of them."""
    power, gamma = edge.slope, -edge.weight
    b = power.denominator
    m, terms = _scaled(D, power)
    over = _scaled(N, power)[1]
    zeta = arb(power_of(radius, Fraction(-1, b)).upper())
    starts = _starts(roots)
    odd = len({(i + j) % 2 for i, j in D if m == power.numerator * i + b * j}) > 1
    out = []
    for z0 in starts:
        about = _about(terms, z0)
        z1, Y = _kept(about, zeta)
        z = z0 + square(zeta * (abs(z1) + Y))
        slope = {(k, j - 1): j * c for (k, j), c in about.items() if j}
        parts = _ratio(_split(_about(over, z0), z1, Y, zeta), _split(slope, z1, Y, zeta), zeta)
        weight = parts[0] + square(abs(parts[1]) * zeta + parts[2])
        neutral = not odd and _neutral(z0, power, starts)
        out.append(FarRoot(power, z0, z1, Y / zeta, z, gamma, weight, neutral, None, parts))
    _apart(out)
    return out


def _split(a: Mapping[tuple[int, int], Any], z1: acb, Y: arb, zeta: arb) -> tuple[acb, acb, arb]:
    """f₀, f₁ and off with Σ a_kj ζ^(k + j) (z₁ + y)^j = f₀ + f₁ζ to within off, |y| ≤ Y."""
    zero = acb(0)
    first = a.get((1, 0), zero) + a.get((0, 1), zero) * z1
    off = abs(a.get((0, 1), zero)) * Y * zeta
    off += sum((abs(c) * zeta ** (k + j) * (abs(z1) + Y) ** j for (k, j), c in a.items() if k + j > 1), arb(0))
    return a.get((0, 0), zero), first, arb(off.upper())


def _ratio(N: tuple[acb, acb, arb], D: tuple[Any, Any, Any], zeta: arb) -> tuple[acb, acb, arb]:
    """The same of a quotient."""
    w0 = N[0] / D[0]
    w1 = (N[1] - w0 * D[1]) / D[0]
    least = abs(D[0]) - abs(D[1]) * zeta - D[2]
    if not least > 0:
        raise PrecisionError(_TOGETHER)
    off = (N[2] + abs(w0) * D[2] + abs(w1) * zeta * (abs(D[1]) * zeta + D[2])) / least
    return w0, w1, arb(off.upper())


def _starts(edge: fmpq_poly) -> list[acb]:
    """The roots z₀, which must be simple."""
    try:
        return list(acb_poly([acb(arb(c)) for c in edge.coeffs()]).roots())
    except ValueError:
        raise PrecisionError("p-roots that meet far out are beyond what is proved of the motion in balls") from None


def _neutral(z0: acb, power: Fraction, starts: list[acb]) -> bool:
    """z₀ i^w is its own mirror image at the imaginary axis: that is a root too, and no other is near."""
    turned = [z * turn(power) for z in starts]
    own = z0 * turn(power)
    mirror = -own.conjugate()
    return bool(own.overlaps(mirror)) and sum(1 for z in turned if z.overlaps(mirror)) == 1


def _apart(roots: list[FarRoot]) -> None:
    if any(one.z.overlaps(other.z) for one, other in combinations(roots, 2) if one.power == other.power):
        raise PrecisionError(_TOGETHER)


def _about(terms: Mapping[tuple[int, int], Fraction], z0: acb) -> dict[tuple[int, int], acb]:
    """a_kj, the coefficients of ζ^k (z − z₀)^j."""
    a = {}
    for k in sorted({k for _, k in terms}):
        row = {i: c for (i, j), c in terms.items() if j == k}
        part = acb_poly([acb(rational_ball(row.get(i, Fraction(0)))) for i in range(max(row) + 1)])(acb_poly([z0, 1]))
        a.update({(k, j): c for j, c in enumerate(part.coeffs())})
    return a


def _kept(a: Mapping[tuple[int, int], Any], zeta: arb) -> tuple[acb, arb]:
    """z₁ and Y: for each |ζ| ≤ zeta one root z₀ + ζ(z₁ + y) has |y| ≤ Y, by Rouché's theorem.

    y solves a₀₁ y + Σ a_kj ζ^(k+j−1) (z₁ + y)^j = 0, k + j ≥ 2.
    """
    z1, size = -a.get((1, 0), acb(0)) / a[0, 1], abs(a[0, 1])
    near = abs(z1)
    rest = [(k + j - 1, j, abs(c)) for (k, j), c in a.items() if k + j >= 2]
    Y = arb(0)
    for _ in range(_GROWN):
        moved = arb((sum((c * zeta**e * (near + Y) ** j for e, j, c in rest), arb(0)) / size).upper())
        if moved < Y:
            return z1, Y
        Y = moved * arb(1.1) + arb(2) ** -_FINEST
    raise PrecisionError(_TOGETHER)
