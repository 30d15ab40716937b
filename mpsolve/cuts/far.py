"""A frequency beyond which tight masses have no root on the cut, the same for all values of the parameter.

With τ = c₀λ², u = 1/λ the p-roots are λP̂, P̂⁴ + 1 + δ = 0, where |δ| ≤ ε(|P̂|) for all parameters and |u| ≤ 1/W, so
that each root lies within r of its place c at u = 0 and 1/D_P within ω of 1/(4c³) (Rouché). What SPEC2, 8.5 needs of
the waves follows, and with it that Δ ≠ 0 beyond: below the cut, and above it, where η has the other sign.
"""

from __future__ import annotations

from itertools import pairwise

from mpsolve.characteristic.free_proved import value_at
from mpsolve.cuts.edge import beam
from mpsolve.numbers.balls import acb, arb, precision, rational_ball
from mpsolve.numbers.plain import outward
from mpsolve.problem.family import Family
from mpsolve.problem.line import on_line
from mpsolve.spectrum.far_line import Waves, free_beyond
from mpsolve.spectrum.premises import tight_masses

_MOST = 1024.0
_SLACK = 1e-9  # far above the rounding of the few operations on bounds


def wavenumber_of(family: Family, W: float) -> tuple[float, float]:
    """(P, z): on the cut |p| ≤ P where Re z < z = c₀W², for all parameters."""
    with precision(64):
        EI, T, k, m, c, v, _ = _coefficients(family)
        rest = k - c * c / (4 * m)
        reach = (EI / m).sqrt().upper() * arb(W) ** 2
        steep = arb((EI / m).sqrt().lower()) / 2  # S ≥ p² √(EI/m)/2 where EI p⁴/4 ≥ |T| p² + |k′|
        speed, pull, stiff = (arb(abs(y).upper()) for y in (v, T / EI, rest / EI))
        P = (speed + (speed * speed + 4 * steep * reach).sqrt()) / (2 * steep)
        least = 2 * (pull.sqrt() + stiff.sqrt().sqrt()) + 1
        return outward(P.max(least), up=True) * (1 + 2.0**-20), outward(reach, up=True)


def far_reach(family: Family) -> float | None:
    """W, so that no root lies on the cut where Re z ≥ c₀W²; None where no theorem tells."""
    line = on_line(family.base)
    if line is None or not tight_masses(line):
        return None
    with precision(64):
        EI, T, k, m, c, v, _ = _coefficients(family)
        scale = (EI / m).sqrt()
        eta = c / (2 * m)
        sizes = (2 * v / scale, (T + m * v * v) / EI, (k - m * eta * eta) / EI, eta / scale)
        first, second, third, active = (outward(arb(abs(y).upper()), up=True) for y in sizes)
        gap = _gap(family)
    W = 2.0
    while W <= _MOST:
        waves = _waves(first / W, second / W**2, third / W**4)
        if waves is not None and free_beyond(len(family.places), active / W**2 * (1 + _SLACK), gap, W, waves):
            return W
        W *= 1.25
    return None


def _gap(family: Family) -> float:
    """At most the least distance of two places."""
    places = sorted(family.places)
    gaps = [value_at(b - a, _box(family)).real for a, b in pairwise(places)]
    return min((outward(gap, up=False) for gap in gaps), default=0.0)


def _coefficients(family: Family) -> list[arb]:
    return [value_at(c, _box(family)).real for c in beam(family)]


def _box(family: Family) -> list[acb]:
    return [acb(rational_ball(a).union(rational_ball(b))) for a, b in family.box]


def _waves(first: float, second: float, third: float) -> Waves | None:
    """δ = first·P̂ + second·P̂² + third at most, in moduli."""
    r = (first + second + third) / 4
    while r <= 0.3:
        far = 1 + r
        lost = first * far + second * far**2 + third
        image = (lost + 6 * r**2 + 4 * r**3 + r**4) / 4 * (1 + _SLACK)
        if image <= r:
            break
        r = image * 1.01
    else:
        return None
    turned = (4 * (3 * r + 3 * r**2 + r**3) + first + 2 * second * (1 + r)) * (1 + _SLACK)
    if turned >= 2:
        return None
    omega = turned / (4 * (4 - turned)) * (1 + _SLACK)
    return Waves(2 * omega, 8 * omega + 16 * omega**2, 8 * omega, r, 0.25 + omega)
