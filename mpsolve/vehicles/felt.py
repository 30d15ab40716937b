"""Which motions of a vehicle its contacts feel: exact linear algebra that takes the others out.

In the inner product of H = M + C + K the space splits into the least one that holds B and is kept by M, C, K, and
its complement, whose motions no contact feels. Among the felt coordinates those with K x = 0 and Bᵀx = 0 are neutral:
their row of [S, −B] has the factor σ, which is divided out.
"""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache
from typing import NamedTuple

from mpsolve.frozen import frozen
from mpsolve.numbers.linear import Echelon, Vector, completed, congruent, dot, image, kernel, solved, taken, units
from mpsolve.vehicles.vehicle import Pencil, Rows


@frozen
class Parts:
    """Felt part (neutral coordinates last) and unfelt part of a pencil, in the coordinates of `basis` (columns).

    basis is None where nothing had to change. unfelt: the (M, C, K) that are left over.
    """

    M: Rows
    C: Rows
    K: Rows
    B: Rows
    neutral: int
    basis: Rows | None
    unfelt: tuple[Rows, Rows, Rows] | None


def split_felt(pencil: Pencil) -> Parts:
    """The felt and the unfelt part of a vehicle. Vehicles of a train are split one by one, and equal ones once."""
    whole = Parts(pencil.M, pencil.C, pencil.K, pencil.B, 0, None, None)
    if _definite_at_rest(pencil):
        return whole
    groups = _components((pencil.M, pencil.C, pencil.K), pencil.B)
    split = [(bodies, _split(*_taken(pencil, bodies, contacts))) for bodies, contacts in groups]
    if all(own is None for _, own in split):
        return whole
    n, columns = len(pencil.M), _Columns([], [], [])
    for bodies, found in split:
        own = found or _Columns(units(len(bodies)), [], [])
        for mine, yours in zip(columns, own, strict=True):
            mine += [_lifted(vector, bodies, n) for vector in yours]
    return _in_basis(pencil, columns)


class _Columns(NamedTuple):
    """A basis: coordinates that are felt, neutral ones, unfelt ones."""

    kept: list[Vector]
    neutral: list[Vector]
    unfelt: list[Vector]


def _components(maps: tuple[Rows, ...], B: Rows) -> list[tuple[tuple[int, ...], tuple[int, ...]]]:
    """Bodies and contacts of the vehicles that nothing but the track joins."""
    n, seen, out = len(B), set[int](), []
    touched = [{j for j, x in enumerate(row) if x} for row in B]
    for first in range(n):
        if first in seen:
            continue
        group, open_ = {first}, [first]
        while open_:
            i = open_.pop()
            near = {j for j in range(n) if any(rows[i][j] for rows in maps) or touched[i] & touched[j]} - group
            group |= near
            open_ += near
        seen |= group
        out.append((tuple(sorted(group)), tuple(sorted(set().union(*(touched[i] for i in group))))))
    return out


def _taken(pencil: Pencil, bodies: tuple[int, ...], contacts: tuple[int, ...]) -> list[Rows]:
    """M, C, K and B of some of the bodies."""
    each = ((pencil.M, bodies), (pencil.C, bodies), (pencil.K, bodies), (pencil.B, contacts))
    return [tuple(tuple(rows[i][j] for j in cells) for i in bodies) for rows, cells in each]


def _lifted(vector: Vector, bodies: tuple[int, ...], n: int) -> Vector:
    """The same motion among n coordinates."""
    out = [Fraction(0)] * n
    for i, x in zip(bodies, vector, strict=True):
        out[i] = x
    return out


@lru_cache(maxsize=64)
def _split(M_: Rows, C_: Rows, K_: Rows, B_: Rows) -> _Columns | None:
    """The basis of one vehicle, None where nothing has to change."""
    M, C, K, B = ([list(row) for row in rows] for rows in (M_, C_, K_, B_))
    n, contacts = len(M), len(B[0])
    H = [[M[i][j] + C[i][j] + K[i][j] for j in range(n)] for i in range(n)]
    forces = [[row[j] for row in B] for j in range(contacts)]
    felt = _felt(H, (M, C, K), forces)
    neutral = _projected(kernel([*K, *forces], n), felt, H)
    if len(felt) == n and not neutral:
        return None
    unfelt = kernel([image(H, vector) for vector in felt], n)
    return _Columns(completed(neutral, felt), neutral, unfelt)


def _in_basis(pencil: Pencil, basis_: _Columns) -> Parts:
    """The pencil in the coordinates of these columns."""
    M, C, K, B = ([list(row) for row in rows] for rows in (pencil.M, pencil.C, pencil.K, pencil.B))
    columns = [*basis_.kept, *basis_.neutral, *basis_.unfelt]
    basis = tuple(tuple(column[i] for column in columns) for i in range(len(M)))
    size = len(basis_.kept) + len(basis_.neutral)
    parts = [congruent(rows, columns, columns) for rows in (M, C, K)]
    head = [tuple(tuple(row[:size]) for row in rows[:size]) for rows in parts]
    tail = [tuple(tuple(row[size:]) for row in rows[size:]) for rows in parts]
    new_B = tuple(
        tuple(dot(column, [row[j] for row in B]) for j in range(len(pencil.places))) for column in columns[:size]
    )
    rest = (tail[0], tail[1], tail[2]) if basis_.unfelt else None
    return Parts(head[0], head[1], head[2], new_B, len(basis_.neutral), basis, rest)


def _definite_at_rest(pencil: Pencil) -> bool:
    """Every coordinate is in direct contact by a column of its own: nothing can be unfelt or neutral."""
    columns = [[row[j] for row in pencil.B] for j in range(pencil.contacts)]
    touched = {column.index(x) for column in columns for x in column if x and sum(map(bool, column)) == 1}
    return len(touched) == pencil.size


def _felt(H: list[Vector], maps: tuple[list[Vector], ...], start: list[Vector]) -> list[Vector]:
    """A basis, reduced, of the least space that holds H⁻¹ start and is kept by H⁻¹M, H⁻¹C, H⁻¹K."""
    echelon: Echelon = {}
    queue = [solved(H, vector) for vector in start]
    while queue:
        vector = queue.pop(0)
        if taken(vector, echelon):
            queue += [solved(H, image(rows, vector)) for rows in maps]
    return list(echelon.values())


def _projected(vectors: list[Vector], felt: list[Vector], H: list[Vector]) -> list[Vector]:
    """A basis of the H-orthogonal projections of `vectors` on the felt space."""
    gram = congruent(H, felt, felt)
    weights = [solved(gram, image(felt, image(H, vector))) for vector in vectors]
    return completed([], [image(zip(*felt, strict=True), one) for one in weights])
