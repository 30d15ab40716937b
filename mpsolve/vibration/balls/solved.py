"""Bounds of the solution of linear equations with whole discs of coefficients, by an approximate inverse.

Contacts far out: waves that run to and fro between obstacles, each bounded by what it reflects at most.
N_ij = α_i e^{P(x_i − x_j)} ahead of contact j and β_i e^{P'(x_i − x_j)} behind it. What the contacts from i on
reflect of a wave is Γ_i = ((1 − α_i − β_i) Z − α_i)/(1 + β_i Z), where Z is Γ_{i+1} with the way to and fro, and
det(I + N) = Π (1 + β_i Z_i). Phases are unknown, so that Z runs through a disc round 0; its image is a disc too, with
the radius |1 − α||1 − β| |Z|/(1 − |βZ|²).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from flint import acb

from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb_mat, arb, arb_mat

Disc = tuple[Any, Any]
"""A middle and a radius."""
_UNDER = "what the contacts reflect far out is not under control: lower the path, or give fewer contacts"


def solved(rows: list[list[Disc]], right: list[Any], waves: Waves | None = None) -> list[arb]:
    """Bounds of |x| for all matrices of these discs, |right| bounded; PrecisionError where one may be singular.

    With an inverse R of the middles, |R A − I| ≤ E; where E u < u for some u > 0, |A⁻¹| ≤ (I − E)⁻¹ |R|. With waves
    A + T is meant: |R (A + T) − M| ≤ F with M = I + diag(R) T, E = |M⁻¹| F, and |M⁻¹| |R| stands for |R|.
    """
    n = len(rows)
    middle = acb_mat([[m.mid() for m, _ in row] for row in rows])
    spread = arb_mat([[r + abs(m - m.mid()) for m, r in row] for row in rows])
    try:
        inverse = acb_mat([[x.mid() for x in row] for row in middle.inv().tolist()])
        one = acb_mat([[int(i == j) for j in range(n)] for i in range(n)])
        size, off = (
            arb_mat([[abs(x) for x in row] for row in a.tolist()]) for a in (inverse, inverse * middle - one)
        )
        off = size * spread + off
        if waves is not None:
            aside = arb_mat([[size[i, j] if i != j else arb(0) for j in range(n)] for i in range(n)])
            scattered = waves.inverse(inverse)
            off, size = scattered * (off + aside * waves.sizes), scattered * size
        E = arb_mat([[arb(x.upper()) for x in row] for row in off.tolist()])
        left = arb_mat([[int(i == j) - E[i, j] for j in range(n)] for i in range(n)])
        u = left.solve(arb_mat([[1]] * n))
        u = arb_mat([[x.mid()] for row in u.tolist() for x in row])
        if not all(u[i, 0] > 0 and (E * u)[i, 0] < u[i, 0] for i in range(n)):
            raise ZeroDivisionError
        x = left.solve(size * arb_mat([[value] for value in right]))
    except ZeroDivisionError:
        raise PrecisionError(
            "the equations may be singular over a cell, or far out: split it, or go further"
        ) from None
    return [abs(row[0]) for row in x.tolist()]


@dataclass(frozen=True)
class Waves:
    """The travelling waves between contacts, −T of the equations.

    chain: the rows of these contacts from rear to front. ahead, behind: balls of the receptance's wave. to_and_fro:
    bounds of what a wave grows by over each gap, both ways. sizes: bounds of all entries of T.
    """

    chain: tuple[int, ...]
    ahead: Any
    behind: acb
    to_and_fro: tuple[arb, ...]
    sizes: arb_mat

    def inverse(self, inverse: acb_mat) -> arb_mat:
        """Bounds of the entries of (I + diag(inverse) T)⁻¹."""
        size = self.sizes.nrows()
        own = [-inverse[k, k] for k in self.chain]
        largest = max((abs(g) * self.sizes[i, j] for g, i in zip(own, self.chain, strict=True) for j in range(size)),
                      key=lambda x: float(x.upper()))  # fmt: skip
        bound = entries([g * self.ahead for g in own], [g * self.behind for g in own], self.to_and_fro, largest)
        chained = set(self.chain)
        return arb_mat([[bound if {i, j} <= chained else arb(int(i == j)) for j in range(size)] for i in range(size)])


def entries(alpha: Sequence[Any], beta: Sequence[acb], to_and_fro: Sequence[Any], largest: arb) -> arb:
    """A bound of every entry of (I + N)⁻¹, |N_ij| ≤ largest, by Hadamard's inequality; PrecisionError without one."""
    n, Z, floor = len(alpha), arb(0), arb(1)
    for a, b, grown in zip(reversed(alpha), reversed(beta), (*reversed(to_and_fro), arb(0)), strict=True):
        turn = abs(b) * Z
        if not turn < 1:
            raise PrecisionError(_UNDER)
        floor = floor * (1 - turn)
        middle = abs(-a - (1 - a - b) * b.conjugate() * Z**2) / (1 - turn**2)
        Z = arb(((middle + abs(1 - a) * abs(1 - b) * Z / (1 - turn**2)) * grown).upper())
    row = (1 + (n - 1) * largest**2).sqrt()
    return arb((row ** (n - 1) / floor).upper())
