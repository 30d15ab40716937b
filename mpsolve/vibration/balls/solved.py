"""Bounds of the solution of linear equations with whole discs of coefficients, by an approximate inverse."""

from __future__ import annotations

from typing import Any

from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb_mat, arb, arb_mat
from mpsolve.vibration.balls.scatter import Waves

Disc = tuple[Any, Any]
"""A middle and a radius."""


def solved(rows: list[list[Disc]], right: list[Any], waves: Waves | None = None) -> list[Any]:
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
