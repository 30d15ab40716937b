"""Whether a kind of track takes energy at rest whatever its parameters are: by the form of its equations alone.

Let A = Σ A_j(P) s^j. If for every odd j the Hermitian part of (−1)^((j − 1)/2) A_j(ip) is positive semidefinite, and
for even j A_j(ip) is Hermitian, then Im(N/D) ≤ 0 for Ω > 0 (SPEC2, section 6.1). Here the principal minors are
polynomials in y = p² and the parameters; where all their coefficients are ≥ 0, they are ≥ 0 for all parameters ≥ 0.
Or −Im(N conj D)/Ω itself has such coefficients.
"""

from __future__ import annotations

from functools import lru_cache
from itertools import combinations
from types import SimpleNamespace
from typing import Any

from flint import fmpq_mpoly_ctx

from mpsolve.numbers.model import Entries, Quantity, quantities
from mpsolve.tracks.waveguide import Track


@lru_cache(maxsize=64)
def passive_by_structure(kind: type[Track]) -> bool:
    """Whether every track of this kind is passive at rest, for all parameters that its bounds allow; False: unknown.

    Parameters that may be negative must not stand in the damping (odd powers of s).
    """
    known = quantities(kind)
    if not known or any(isinstance(one, Entries) for one in known.values()):
        return False
    context = fmpq_mpoly_ctx.get(("P", "s", *known), "lex")
    variables = dict(zip(("P", "s", *known), context.gens(), strict=True))
    rows = kind.equations(SimpleNamespace(**variables))
    entries = [[(context.constant(0) + entry).to_dict() for entry in row] for row in rows]
    signed = [k for k, one in enumerate(known.values()) if not _is_nonnegative(one)]
    powers = sorted({int(key[1]) for row in entries for entry in row for key in entry})
    if all(_holds(entries, j, context, signed) for j in powers):
        return True
    matrix = [[_polynomial(entry, context) for entry in row] for row in entries]
    kept = [k for k in range(len(matrix)) if k != kind.loaded]
    minor = [[matrix[a][b] for b in kept] for a in kept]
    return _takes(_determinant(matrix, context), _determinant(minor, context), context, signed)


def _is_nonnegative(quantity: Quantity) -> bool:
    return any(bound is not None and bound >= 0 for bound in (quantity.above, quantity.at_least))


def _takes(D: Any, N: Any, context: Any, signed: list[int]) -> bool:
    """Whether w of −Im(N conj D) = Ω w(y, z), z = Ω², has coefficients ≥ 0 alone."""
    halves = []
    for polynomial in (N, D):
        parts: tuple[dict[Any, Any], dict[Any, Any]] = ({}, {})
        for raw, c in polynomial.to_dict().items():
            key = tuple(map(int, raw))
            if key[0] % 2:
                return False
            parts[key[1] % 2][(key[0] // 2, key[1] // 2, *key[2:])] = c * (-1) ** (key[0] // 2 + key[1] // 2)
        halves.append([_polynomial(part, context) for part in parts])
    (nr, ni), (dr, di) = halves
    terms = (nr * di - ni * dr).to_dict()
    return all(c >= 0 and not any(key[2 + k] for k in signed) for key, c in terms.items())


def _holds(entries: Any, j: int, context: Any, signed: list[int]) -> bool:
    """The condition on A_j: for odd j on its minors, for even j A_j(P) = A_j(−P)ᵀ."""
    n = range(len(entries))
    parts = [[{key: c for key, c in entries[a][b].items() if int(key[1]) == j} for b in n] for a in n]
    mirrored = [[{key: c * (-1) ** int(key[0]) for key, c in parts[b][a].items()} for b in n] for a in n]
    if j % 2 == 0:
        return parts == mirrored
    matrix = []
    for a in n:
        row = []
        for b in n:
            even = _polynomial(parts[a][b], context) + _polynomial(mirrored[a][b], context)
            terms = {tuple(map(int, key)): c for key, c in even.to_dict().items()}
            if any(key[0] % 2 for key in terms) or any(key[2 + k] for key in terms for k in signed):
                return False
            turn = (-1) ** ((j - 1) // 2)
            in_y = {(key[0] // 2, 0, *key[2:]): c * turn * (-1) ** (key[0] // 2) for key, c in terms.items()}
            row.append(_polynomial(in_y, context))
        matrix.append(row)
    return all(
        all(c >= 0 for c in _determinant([[matrix[a][b] for b in some] for a in some], context).coeffs())
        for size in range(1, len(matrix) + 1)
        for some in combinations(n, size)
    )


def _polynomial(terms: dict[Any, Any], context: Any) -> Any:
    return context.from_dict(terms)


def _determinant(matrix: list[list[Any]], context: Any) -> Any:
    if not matrix:
        return context.constant(1)
    total = context.constant(0)
    for b, entry in enumerate(matrix[0]):
        minor = [row[:b] + row[b + 1 :] for row in matrix[1:]]
        total += (-1) ** b * entry * _determinant(minor, context)
    return total
