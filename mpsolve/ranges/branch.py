"""A root as a function of the parameter over boxes, where it is proved to bend or to rise.

Over a box of (q′, x) the reduced determinant s is a Taylor model in complex u, |u_i| ≤ 1, with a remainder that is
analytic there and at most e: in |u_i| ≤ 1/2 its derivatives are at most 2e, its second ones 8e, 4e, 8e (Cauchy).
Interval Newton encloses the only root in a square of u₀ for all x at once; then with s(u₀(u₁), u₁) = 0

    u₀′ = −s₁/s₀,    u₀″ = −(s₁₁ + 2 s₀₁ u₀′ + s₀₀ u₀′²)/s₀.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any, Self

import numpy as np

from mpsolve.characteristic.boxes import Boxes
from mpsolve.characteristic.free_matrix import FreeMatrix
from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, arb, precision
from mpsolve.numbers.quadratic import Quadratic, pairs
from mpsolve.proof.vanishing import scalar

SIDE = 0.35
"""Half of the square of u₀ in which a branch is followed: it lies in |u₀| < 1/2."""
_PARTS = 4  # of the interval of u₁ of a box
_WIDER = 1.05  # than the interval: half of a box along x
_SLACK = 1.7  # more than the root moves, half of the square of u₀
_SHARPER = 3
_BITS = 64


@dataclass(frozen=True)
class Part:
    """A box of (q̂′, x̂) in which there is one root, in a square round q, for each real x̂ from one end to the other.

    rises, bends: balls of the first and of the second derivative of its imaginary part by u₁.
    """

    q: float
    x: float
    r_q: float
    r_x: float
    ends: tuple[arb, arb]
    last: acb
    rises: tuple[Any, ...]
    bends: tuple[Any, ...]

    def holds(self, q: Any, x: Any) -> bool:
        """Whether a root in a ball q at x in a ball x is that of the part: in the square, x between the ends."""
        with precision(max(_BITS, int(arb(x).mid().bits()) + 32)):
            u = (acb(q) - arb(self.q)) / arb(self.r_q)
            fits = bool(abs(u.real) < arb(SIDE) and abs(u.imag) < arb(SIDE))
            return fits and self.ends[0].union(self.ends[1]).contains(arb(x))


class Followed:
    """A curve in parts, with balls of the first (`rises`) and second derivative (`bends`) of the height of each."""

    parts: tuple[Any, ...]

    @property
    def valley(self) -> tuple[int, int] | None:
        """The parts between which it does not provably fall before, and rise behind; None if it does not.

        The first of them and the one after the last.
        """
        first = next((k for k, part in enumerate(self.parts) if not _all(part.rises, -1)), len(self.parts))
        last = next((k for k in range(len(self.parts), 0, -1) if not _all(self.parts[k - 1].rises, 1)), 0)
        return (first, last) if first < last else None

    def bends_up(self, first: int, last: int) -> bool:
        """Whether it is proved to be convex over these parts."""
        return all(_all(part.bends, 1) for part in self.parts[first:last])

    @property
    def rises(self) -> bool:
        """Whether it is proved to grow with the parameter."""
        return all(_all(part.rises, 1) for part in self.parts)

    @property
    def falls(self) -> bool:
        """Whether it is proved to become smaller."""
        return all(_all(part.rises, -1) for part in self.parts)


def _all(balls: Sequence[Any], sign: int) -> bool:
    return all(bool(sign * ball > 0) for ball in balls)


@dataclass(frozen=True)
class Tube(Followed):
    """One root, followed through parts whose ends are common; its height is its imaginary part."""

    parts: tuple[Part, ...]

    def holds(self, q: Any, x: Any) -> bool:
        """Whether a root in a ball q at x in a ball x is the one that is followed."""
        return any(part.holds(q, x) for part in self.parts)


def tube(matrix: FreeMatrix, points: Any, edges: list[Any]) -> Tube | None:
    """The root followed over neighbouring intervals of x̂ between edges (balls); None where it is not proved.

    points: floats q̂ near the root at each edge, and in the middle of each interval, in turn.
    """
    middles = points[1::2]
    x = [float(edge) for edge in edges]
    away = [
        max(abs(a - m), abs(b - m)) + abs(m.imag) for a, m, b in zip(points[::2], middles, points[2::2], strict=False)
    ]
    m = np.array([[q.real for q in middles], [(a + b) / 2 for a, b in pairwise(x)]])
    r = np.array([[_SLACK * a / SIDE for a in away], [_WIDER * (b - a) for a, b in pairwise(x)]])
    A, G = matrix(Boxes(m, r))
    reduced = scalar(A, G.good)
    if not (reduced.good & np.isfinite(reduced.s.e)).all():
        return None
    parts: list[Part] = []
    for k, ends in enumerate(pairwise(edges)):
        part = _part(Model.of(reduced.s, k), m[:, k].tolist(), r[:, k].tolist(), ends)
        if part is None or (parts and not part.holds(parts[-1].last, ends[0])):
            return None
        parts.append(part)
    return Tube(tuple(parts))


def _part(model: Model, at: Sequence[float], size: Any, ends: tuple[arb, arb]) -> Part | None:
    with precision(_BITS):
        low, high = ((arb(x) - arb(at[1])) / arb(size[1]) for x in ends)
        if not (abs(low) < arb(0.5) and abs(high) < arb(0.5)):
            return None
        inner = [low + (high - low) * arb(k) / _PARTS for k in range(_PARTS + 1)]
        found = [model.branch(a.union(b)) for a, b in pairwise(inner)]
        if any(one is None for one in found):
            return None
        known = [one for one in found if one is not None]
        last = arb(at[0]) + known[-1][0] * arb(size[0])
    rises, bends = tuple(one[1].imag for one in known), tuple(one[2].imag for one in known)
    return Part(at[0], at[1], size[0], size[1], ends, last, rises, bends)


@dataclass(frozen=True)
class Model:
    """The coefficients of 1, u_i and u_i u_j (i ≤ j), and a bound of the remainder, which is analytic on |u_i| ≤ 1.

    Its slopes, and second derivatives, are bounded on |u_i| ≤ 1/2.
    """

    k: list[Any]
    e: Any
    m: int

    @classmethod
    def of(cls, s: Quadratic, n: int, turn: Any = 1, size: float = 1.0) -> Self:
        """That of box n, times a number that is no larger than `size`."""
        return cls([acb(complex(c[n])) * turn for c in s.k], arb(float(s.e[n])) * size, s.m)

    def _rest(self, share: int) -> acb:
        ball = arb(0, (self.e * share).upper())
        return acb(ball, ball)

    def value(self, *u: Any) -> Any:
        terms = [c * x for c, x in zip(self.k[1:], u, strict=False)]
        terms += [c * u[i] * u[j] for c, (i, j) in zip(self.k[1 + self.m :], pairs(self.m), strict=True)]
        return sum(terms, self.k[0] + self._rest(1))

    def slopes(self, *u: Any) -> list[Any]:
        out = [b + self._rest(2) for b in self.k[1 : 1 + self.m]]
        for c, (i, j) in zip(self.k[1 + self.m :], pairs(self.m), strict=True):
            out[i] += c * u[j]
            out[j] += c * u[i]
        return out

    def second(self, *u: Any) -> Any:
        """The second derivative along a direction: twice Σ c_ij u_i u_j, and what the remainder adds."""
        each = zip(self.k[1 + self.m :], pairs(self.m), strict=True)
        return sum((2 * (c + self._rest(4)) * u[i] * u[j] for c, (i, j) in each), acb(0))

    def branch(self, t: Any) -> tuple[acb, acb, acb] | None:
        """(u₀, u₀′, u₀″) for all t in a real ball; None where the root is not enclosed in the square."""
        side = arb(0, SIDE)
        box = acb(side, side)
        for k in range(_SHARPER):
            middle = box.mid()
            s0 = self.slopes(box, t)[0]
            if s0.contains(0):
                return None
            image = middle - self.value(middle, t) / s0
            if not k and not box.contains_interior(image):
                return None
            box = _met(box, image)
        s0, s1 = self.slopes(box, t)
        first = -s1 / s0
        return box, first, -self.second(first, 1) / s0


def _met(one: Any, other: acb) -> acb:
    """The part that both boxes share, which holds what each holds."""
    return acb(_smaller(one.real, other.real), _smaller(one.imag, other.imag))


def _smaller(one: Any, other: arb) -> Any:
    try:
        return one.intersection(other)
    except ValueError:
        raise PrecisionError("two enclosures of one root do not meet") from None
