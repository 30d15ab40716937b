"""The edge of the cut by its real wavenumber p, over any arithmetic: z = vp + √(f/m), f = EI p⁴ − T p² + k − c²/4m.

All of the cut with Re z ≥ 0, on both of its edges, is had so, and so are mirror images (z < 0). The other p-roots ir
are those of a real cubic in r.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from mpsolve.numbers.arrays import Complexes, Reals, Truths
from mpsolve.problem.family import Family

if TYPE_CHECKING:
    from mpsolve.numbers.several import Several


@dataclass(frozen=True)
class Edge:
    """z, its slope in p times 2 √(mf) > 0 (for its sign), σ = iz − η, and the cubic's coefficients, ascending."""

    z: Any
    lean: Any
    sigma: Any
    cubic: Sequence[Any]


def beam(family: Family) -> list[Several]:
    """EI, T, k, m, c, v and the numerator as polynomials in the parameters."""
    zero = family.ring.constant(0)
    D = family.D_rest
    keys = ((4, 0), (2, 0), (0, 0), (0, 2), (0, 1))
    return [*(D.get(key, zero) for key in keys), family.v, family.N_rest[0, 0]]


def edge(p: Any, coefficients: Sequence[Any], root: Callable[[Any, Any], Any]) -> Edge:
    """At wavenumber p; root(f, m): √(f/m)."""
    EI, T, k, m, c, v = coefficients
    eta = c * m.times(2).inverse()
    square = p * p
    S = root((EI * square + -T) * square + k + -(m * eta * eta), m)
    z = v * p + S
    lean = v * m * S.times(2) + (EI * square).times(4) * p + -(T * p).times(2)
    A, B = -(T + m * v * v), (m * v * z).times(2)
    cubic = ((EI * square + A) * p + B, EI * square + A, EI * p, EI)
    return Edge(z, lean, z.times(1j) + -eta, cubic)


def sides(cubic: Reals, p: Reals, z: Reals, v: Any, side: int) -> tuple[Complexes, Truths]:
    """In floats, by rows: (the roots r of b, a′, b′, whether they are real).

    side −1: the edge seen from below, where upper real p-roots have dz/dp < 0; +1: from above.
    """
    monic = cubic / cubic[:, 3:]
    companion = np.zeros((len(p), 3, 3))
    companion[:, 0, 1] = companion[:, 1, 2] = 1
    companion[:, 2] = -monic[:, :3]
    r = np.linalg.eigvals(companion) + 0j
    most = np.abs(r).max(1, keepdims=True)
    real = (np.abs(r.imag) < 1e-13 * most).all(1)
    alone = np.abs(r.imag).argmin(1)
    partner = (z[:, None] - v[:, None] * r.real).argmax(1)  # on the branch with S > 0
    first = np.where(real, partner, alone)
    rest = np.stack([(first + 1) % 3, (first + 2) % 3], 1)
    others = np.take_along_axis(r, rest, 1)
    order = np.where(real, side * others.real.T, -others.imag.T).argsort(0)  # of two real ones dz/dp falls with r
    others = np.take_along_axis(others, order.T, 1)
    b = np.take_along_axis(r, first[:, None], 1).real + 0j
    others = np.where(real[:, None], others.real + 0j, others)
    others[~real, 1] = others[~real, 0].conj()
    return np.concatenate([b, others], 1), real
