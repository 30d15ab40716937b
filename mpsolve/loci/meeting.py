"""Where a root meets its mirror image −q̄ on the imaginary axis, and goes on as two imaginary roots, or the reverse.

In a disc round a point of the axis there are exactly two roots for every x̂ of a short interval: with the Taylor model
a + b₀u₀ + b₁u₁ + c₀₀u₀² + … ± e of the determinant's scalar, |a| + |b₀| + |b₁| + |c₀₁| + |c₁₁| + e < |c₀₀|, by
Rouché's theorem against c₀₀u₀². A pair that comes in at one end and two imaginary roots that leave at the other are
these two, and between they meet.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from mpsolve.characteristic.free_matrix import FreeMatrix
from mpsolve.loci.chain import Chain
from mpsolve.loci.room import Room
from mpsolve.loci.tube import scalar_over, tubes

_SIZES = 2.0 ** -np.arange(7.0, 2.0, -1.0)  # of |q̂|: radii of discs that are tried, small ones first
_LOST = 1 + 2.0**-40
_STEPS = 8


@dataclass(frozen=True)
class Meeting:
    """Two roots, a pair or two imaginary ones, lie within `radius` of i·height for low ≤ x̂ ≤ high."""

    height: float
    radius: float
    low: float
    high: float

    def holds(self, chain: Chain) -> bool:
        """Whether the root of the chain is one of the two."""
        away = abs(chain.q - 1j * self.height) + chain.radius
        return self.low <= chain.x <= self.high and bool(away * _LOST < self.radius)


def meeting_of(matrix: FreeMatrix, chain: Chain, room: Room) -> Meeting | None:
    """The meeting next to which a chain is stuck; None where none is proved."""
    size = abs(chain.q)
    found = _double(matrix, chain.q.imag, chain.x, size)
    if found is None:
        return None
    height, x, bend = found
    for share in _SIZES:
        radius = share * size
        half = 0.25 * bend * radius**2
        low, high = max(x - half, room.low), min(x + half, room.high)
        meeting = Meeting(height, radius, low, high)
        fits = room.fits(1j * height, radius, (low, high), chain.kind)
        if low < x < high and fits and meeting.holds(chain) and _two(matrix, height, radius, low, high):
            return meeting
    return None


def beyond(matrix: FreeMatrix, meeting: Meeting, chain: Chain, room: Room) -> list[Chain]:
    """What comes out at the far end of the meeting at which a chain is: two imaginary roots, or one with Re q > 0."""
    way, on_axis = chain.way, not chain.on_axis
    x = meeting.high if way > 0 else meeting.low
    s = scalar_over(
        matrix, np.array([1j * meeting.height]), np.array([meeting.radius]), np.array([x]), np.array([0.0])
    ).s
    root = np.sqrt(s.b[0] ** 2 - 4 * s.a * s.c[0])
    near = [complex((1j * meeting.height + meeting.radius * (w - s.b[0]) / (2 * s.c[0]))[0]) for w in (root, -root)]
    apart = abs(near[0] - near[1])
    places = [complex(0, q.imag) for q in near] if on_axis else [max(near, key=lambda q: q.real)]
    sizes = np.full(len(places), apart / 4)
    at = np.full(len(places), x)
    found = tubes(matrix, at, at, np.array(places), sizes)
    away = np.abs(found.middle - 1j * meeting.height) + found.inner
    fits = all(room.fits(q, rho, (x, x), chain.kind) for q, rho in zip(places, sizes.tolist(), strict=True))
    if not (fits and found.good.all() and (away * _LOST < meeting.radius).all()):
        return []
    if on_axis and not found.mirrored.all():
        return []
    if not on_axis and not (found.middle.real > found.inner).all():
        return []
    each = zip(found.middle.tolist(), found.inner.tolist(), strict=True)
    return [Chain(float(x), q, radius, way, on_axis=on_axis, kind=chain.kind) for q, radius in each]


def _double(matrix: FreeMatrix, height: float, x: float, size: float) -> tuple[float, float, float] | None:
    """In floats: (height, x̂) of the double root, and how far x̂ moves the square of the distance to it, inverted."""
    radius, half = size * 2.0**-10, size * 2.0**-14
    with np.errstate(all="ignore"):
        for _ in range(_STEPS):
            s = scalar_over(matrix, np.array([1j * height]), np.array([radius]), np.array([x]), np.array([half])).s
            a, (b0, b1), (c00, c01, _) = s.a[0], s.b[:, 0], s.c[:, 0]
            # s = 0 and ∂s/∂u₀ = 0, to first order in u₁
            u1 = (a - b0**2 / (4 * c00)) / (b0 * c01 / (2 * c00) - b1)
            u0 = -(b0 + c01 * u1) / (2 * c00)
            height, x = height + float((u0 * radius).imag), x + float((u1 * half).real)
            if not (np.isfinite(height) and np.isfinite(x)):
                return None
        bend = abs(c00 / radius**2) / abs(b1 / half) if b1 else np.inf
    return (height, x, float(bend)) if np.isfinite(bend) else None


def _two(matrix: FreeMatrix, height: float, radius: float, low: float, high: float) -> bool:
    at = low / 2 + high / 2
    half = max(high - at, at - low) * _LOST
    found = scalar_over(matrix, np.array([1j * height]), np.array([radius]), np.array([at]), np.array([half]))
    with np.errstate(all="ignore"):
        s = found.s
        c = np.abs(s.c)
        rest = np.abs(s.a) + np.abs(s.b).sum(0) + c[1] + c[2] + s.e
        return bool((found.good & np.isfinite(rest) & (rest * _LOST < c[0]))[0])
