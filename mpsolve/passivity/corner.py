"""The velocity at which −Im G(0, q)/q vanishes at q = 0, and that it is the first loss in its neighbourhood.

F(q, v) = −Re G_σ(iq) is even in q, and −Im G(0, q) = ∫₀^q F dq. Let v_p be a zero of F(0, v). If F_qq(q, v_p) > 0
for 0 ≤ q ≤ r, and F_v < 0 there for u ≤ v ≤ v_p, then −Im G > 0 for 0 < q ≤ r, u ≤ v < v_p, and just above v_p
small q have −Im G < 0 (SPEC, section 6.6).
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np

from mpsolve.errors import PrecisionError
from mpsolve.numbers.arrays import Integers, Reals
from mpsolve.numbers.balls import acb, arb, precision
from mpsolve.passivity.cover import Moving
from mpsolve.proof.effort import Effort
from mpsolve.proof.newton import isolated, polished, real_part, sharpened
from mpsolve.proof.subdivide import subdivide

_BITS = 96
_PARTS, _DEEPEST = 1500, 16  # boxes at most; halvings of one
_WIDTHS = tuple(5e-3 / 5**k for k in range(7))


@dataclass(frozen=True)
class _Slope:
    """−F(0, v) = Re G_σ(0) as a function of v, with its slope."""

    moving: Moving

    def value(self, v: acb) -> acb:
        return self.both(v)[0]

    def slope(self, v: Any) -> acb:
        return self.both(v)[1]

    def both(self, v: acb) -> tuple[acb, acb]:
        found = self.moving.germ(acb(0), arb(v.real), 1)
        return acb(found.value[1].real), acb(found.by_velocity[1].real)


@dataclass(frozen=True)
class Corner:
    """The loss: `value`, a ball of the scaled velocity; proved on 0 < q ≤ reach, below ≤ v < value."""

    value: arb
    below: float
    reach: float


def velocity_of_loss(moving: Moving, near: float, bits: int) -> Any:
    """The zero of G_σ(0) next to `near` as a ball of that many bits, the only one in some box."""
    f = _Slope(moving)
    with precision(_BITS):
        found = isolated(f, polished(f, acb(near)), arb(near))
    return sharpened(f, found.image, bits, real_part).real


def corner(moving: Moving, value: arb, effort: Effort) -> Corner | None:
    """The neighbourhood of a loss in which it is proved to be the first, as wide as is found quickly."""
    with precision(_BITS):
        reach = _reach(moving, value)
        for width in _WIDTHS:
            below = float(value.mid()) * (1 - width)
            for r in (reach, reach / 4, reach / 16):
                if not _seems_to_fall(moving, below, value, r):
                    continue
                if _bends(moving, value, r, effort) and _falls(moving, below, value, r, effort):
                    return Corner(value, below, float(r))
    return None


def _seems_to_fall(moving: Moving, below: float, value: arb, reach: float) -> bool:
    """Whether F_v < 0 at a few points: where it is not, no proof is tried."""
    top = float(value.mid())
    points = [(x * reach, below + y * (top - below)) for x in (0.0, 0.5, 1.0) for y in (0.0, 0.5, 1.0)]
    try:
        return all(moving.germ(acb(0, q), arb(v), 1).by_velocity[1].real > 0 for q, v in points)
    except PrecisionError:
        return False


def _reach(moving: Moving, value: arb) -> float:
    """In balls without proof: how far F_qq stays of one size."""
    v, r = arb(value.mid()), 2.0**-20
    first = 6 * moving.germ(acb(0), v, 3).value[3].real
    while r < 0.5:
        if not 6 * moving.germ(acb(0, 2 * r), v, 3).value[3].real > first / 3:
            break
        r *= 2
    return r


def _bends(moving: Moving, value: arb, reach: float, effort: Effort) -> bool:
    """Whether F_qq > 0 for 0 ≤ q ≤ reach at the velocity of the loss."""

    def holds(a: float, b: float) -> bool:
        q0 = arb(a / 2 + b / 2)
        q = q0.union(arb(a)).union(arb(b))
        try:
            at, wide = moving.germ(acb(0, q0), value, 3), moving.germ(acb(0, q), value, 4)
        except PrecisionError:
            return False
        return bool(6 * at.value[3].real - abs(q - q0).upper() * abs(24 * wide.value[4]) > 0)

    waiting, tried = [(0.0, float(reach), 0)], 0
    while waiting:
        a, b, depth = waiting.pop()
        tried += 1
        effort.spend(1)
        if not holds(a, b):
            if depth > _DEEPEST or tried > _PARTS:
                return False
            m = a / 2 + b / 2
            waiting += [(a, m, depth + 1), (m, b, depth + 1)]
    return True


def _falls(moving: Moving, below: float, value: arb, reach: float, effort: Effort) -> bool:
    """Whether F_v < 0 for 0 ≤ q ≤ reach, below ≤ v ≤ value, and a little beyond: F = −Im G_q for real q."""
    low = np.array([0.0, below])
    high = np.array([float(reach), float(value.mid()) * (1 + 2.0**-40)])

    def judge(a: Any, b: Reals) -> tuple[Any, Integers]:
        return moving.waves.rises(a, b).astype(np.int8), ((b - a) / (high - low)[:, None]).argmax(0)

    return not len(subdivide(low, high, judge, effort, smallest=2.0**-9).tree.open)


def unscaled(moving: Moving) -> Fraction:
    """v = v̂ · this."""
    guide = moving.guide
    return Fraction(2) ** (guide.length - guide.time)
