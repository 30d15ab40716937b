"""The crossings of the real axis round the least one over a second parameter: alone in a hole, and a valley in it.

Over a box of (q, x, y) the reduced determinant s is a Taylor model in u, |u_i| ≤ 1 (see `branch`). In the half of the
box s is injective in real (u₀, u₁) for each u₂: with J its slopes by u₀ and u₁ at the middle, |J⁻¹| times what they
vary by has a norm below 1. So there is one crossing at most for each y. The interval Newton step in two real
unknowns encloses it for all y of a part, and gives its rate x′ = du₁/du₂ by s₀u₀′ + s₁u₁′ + s₂ = 0.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np

from mpsolve.characteristic.boxes import Boxes
from mpsolve.characteristic.free_matrix import FreeMatrix
from mpsolve.numbers.arrays import Complexes, Reals, Truths
from mpsolve.numbers.balls import acb, arb, arb_mat, precision
from mpsolve.numbers.jets import U
from mpsolve.numbers.quadratic import Quadratic
from mpsolve.proof.vanishing import scalar
from mpsolve.ranges.branch import Followed, Model

HALF = 0.49  # of a box: where crossings are alone
_BITS = 64
_SIDE = 0.4
_SHARPER = 3
REGULAR = 0.9
_TURNED = 1 + 2.0**-40  # more than the modulus of a float next to the unit circle


def alone(matrix: FreeMatrix, middle: Any, size: Reals) -> Truths:
    """Which boxes (columns) have one crossing at most for each y, in their halves."""
    A, G = matrix(Boxes(middle, size))
    reduced = scalar(A, G.good)
    return reduced.good & one_for_each(reduced.s)


def one_for_each(s: Quadratic) -> Truths:
    """Boxes (three variables) in whose half s is injective in the first two of them."""
    return unevenness(s) < REGULAR


def unevenness(s: Quadratic) -> Reals:
    """A bound of by how much the slopes by the first two variables vary in half a box, times their inverse; or ∞.

    Below 1 the map is injective in them for each value of the third: with J the real slopes at the middle, the means
    of the slopes between two points are J(I + E), |E| ≤ N entry by entry, and this is the spectral radius of N.
    """
    with np.errstate(all="ignore"):
        g0, g1, _ = s.b
        c00, c01, c02, c11, c12, _ = s.c
        rest = 2 * solved_size(g0, g1, s.e)
        n = [
            solved(g0, g1, pure) + solved(g0, g1, mixed) / 2 + solved(g0, g1, along) / 2 + rest
            for pure, mixed, along in ((c00, c01, c02), (c11, c01, c12))
        ]
        (a, c), (b, d) = n
        worst = ((a + d) / 2 + np.sqrt(((a - d) / 2) ** 2 + b * c)) * (1 + 64 * U)
        return np.where(np.isfinite(worst), worst, np.inf)


def solved(g0: Complexes, g1: Complexes, z: Complexes) -> Reals:
    """Bounds of |w| for real w with g₀w₀ + g₁w₁ = z; ∞ where there may be none."""
    lost = 8 * U
    det = np.abs((g0.conj() * g1).imag) - lost * np.abs(g0) * np.abs(g1)
    size = np.abs(z)
    w = np.stack([
        np.abs((z.conj() * g1).imag) + lost * size * np.abs(g1),
        np.abs((g0.conj() * z).imag) + lost * size * np.abs(g0),
    ])  # fmt: skip
    return np.where(det > 0, w / det * (1 + 16 * U), np.inf)


def solved_size(g0: Complexes, g1: Complexes, size: Reals) -> Reals:
    """The same for all z of a modulus."""
    with np.errstate(all="ignore"):
        det = np.abs((g0.conj() * g1).imag) - 8 * U * np.abs(g0) * np.abs(g1)
        return np.where(det > 0, np.stack([np.abs(g1), np.abs(g0)]) * size / det * (1 + 16 * U), np.inf)


class Part(NamedTuple):
    """A box (low, high) of (q̂, x̂) in which a crossing is the only one, and balls that hold it, for all y of a part.

    rises, bends: balls of x′ and x″.
    """

    low: Reals
    high: Reals
    place: tuple[Any, Any]
    rises: tuple[Any, ...]
    bends: tuple[Any, ...]


@dataclass(frozen=True)
class Ridge(Followed):
    """The curve of crossings over y from one end to the other, in parts between edges; its height is x̂."""

    edges: tuple[arb, ...]
    parts: tuple[Part, ...]

    @property
    def is_valley(self) -> bool:
        """Whether it falls, then is convex, and then rises: lowest where its rate is 0, if there is such a point."""
        return self.valley is not None and self.bends_up(*self.valley)

    def within(self, middle: Any, size: Reals) -> bool:
        """Whether all of it lies in the half of a box, in q̂ and x̂."""
        with precision(_BITS):
            return all(
                bool(abs(ball - arb(float(m))) < arb(float(r)) / 2)
                for part in self.parts
                for ball, m, r in zip(part.place, middle, size, strict=False)
            )

    def holds(self, state: tuple[Any, ...], y: Any) -> bool:
        """Whether a crossing in balls at y in a ball is the one that is followed."""
        with precision(_BITS + 64):
            for part, ends in zip(self.parts, pairwise(self.edges), strict=True):
                inside = all(
                    bool(s > arb(float(a))) and bool(s < arb(float(b)))
                    for s, a, b in zip(state, part.low, part.high, strict=True)
                )
                if inside and ends[0].union(ends[1]).contains(arb(y)):
                    return True
        return False


def ridge(
    matrix: FreeMatrix, path: Callable[[Any], Any], edges: list[arb], slack: float, least: float
) -> Ridge | None:
    """The crossings followed over neighbouring intervals of ŷ; None where that is not proved. path: floats.

    Boxes reach `slack` times as far as the path, and `least` of their length along ŷ along the others (scaled units).
    """
    y = np.array([float(edge) for edge in edges])
    middles = (y[:-1] + y[1:]) / 2
    here, before, behind = (np.array(path(at)) for at in (middles, y[:-1], y[1:]))
    away, along = np.maximum(np.abs(before - here), np.abs(behind - here)), 1.05 * (y[1:] - y[:-1])
    m = np.concatenate([here, middles[None]])
    r = np.concatenate([np.maximum(slack * away / _SIDE, least * along), along[None]])
    A, G = matrix(Boxes(m, r))
    reduced = scalar(A, G.good)
    if not (reduced.good & np.isfinite(reduced.s.e)).all():
        return None
    parts: list[Part] = []
    with precision(_BITS):
        for k, ends in enumerate(pairwise(edges)):
            turned = acb(
                complex(reduced.s.b[0, k].conjugate() / abs(reduced.s.b[0, k]))
            )  # s₀ nearly real: less wrapping
            model = _Model.of(reduced.s, k, turned, _TURNED)
            low, high = ((arb(end) - arb(m[2, k])) / arb(r[2, k]) for end in ends)
            found = model.rates(low.union(high)) if abs(low) < 0.5 and abs(high) < 0.5 else None
            if found is None:
                return None
            place = arb(m[0, k]) + found[0] * arb(r[0, k]), arb(m[1, k]) + found[1] * arb(r[1, k])
            half = _SIDE * r[:2, k]
            parts.append(Part(m[:2, k] - half, m[:2, k] + half, place, found[2:3], found[3:]))
    return Ridge(tuple(edges), tuple(parts))


class _Model(Model):
    """Of three variables, the last of them free."""

    def rates(self, t: arb) -> tuple[arb, arb, arb, arb] | None:
        """(u₀, u₁, u₁′, u₁″) of the only crossing in the square, for all t in a ball; None where none is."""
        u = w = arb(0, _SIDE)
        for k in range(_SHARPER):
            middle = (arb(u.mid()), arb(w.mid()))
            s0, s1, _ = self.slopes(acb(u), acb(w), acb(t))
            J = arb_mat([[s0.real, s1.real], [s0.imag, s1.imag]])
            value = self.value(acb(middle[0]), acb(middle[1]), acb(t))
            try:
                step = J.solve(arb_mat([[value.real], [value.imag]]))
            except ZeroDivisionError:
                return None
            image = (middle[0] - step[0, 0], middle[1] - step[1, 0])
            if not k and not (u.contains_interior(image[0]) and w.contains_interior(image[1])):
                return None
            u, w = u.intersection(image[0]), w.intersection(image[1])
        s0, s1, s2 = self.slopes(acb(u), acb(w), acb(t))
        turn = (s0.conjugate() * s1).imag
        if turn.contains(0):
            return None
        along, up = -(s2 * s1.conjugate()).imag / (s0 * s1.conjugate()).imag, -(s0.conjugate() * s2).imag / turn
        return u, w, up, -(s0.conjugate() * self.second(along, up, 1)).imag / turn
