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
from mpsolve.vehicles.vehicle import Pencil, Rows

Vector = list[Fraction]


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
        own = found or _Columns(_units(len(bodies)), [], [])
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


def _units(n: int) -> list[Vector]:
    return [[Fraction(int(i == k)) for i in range(n)] for k in range(n)]


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
    felt = _simple(_closure(H, (M, C, K), forces))
    neutral = _project(_kernel([*K, *forces], n), felt, H)
    if len(felt) == n and not neutral:
        return None
    unfelt = _kernel([_times(H, vector) for vector in felt], n)
    return _Columns(_complete(neutral, felt), neutral, unfelt)


def _in_basis(pencil: Pencil, basis_: _Columns) -> Parts:
    """The pencil in the coordinates of these columns."""
    M, C, K, B = ([list(row) for row in rows] for rows in (pencil.M, pencil.C, pencil.K, pencil.B))
    columns = [*basis_.kept, *basis_.neutral, *basis_.unfelt]
    basis = tuple(tuple(column[i] for column in columns) for i in range(len(M)))
    size = len(basis_.kept) + len(basis_.neutral)
    parts = [_congruent(rows, columns) for rows in (M, C, K)]
    head = [tuple(tuple(row[:size]) for row in rows[:size]) for rows in parts]
    tail = [tuple(tuple(row[size:]) for row in rows[size:]) for rows in parts]
    new_B = tuple(
        tuple(_dot(column, [row[j] for row in B]) for j in range(len(pencil.places))) for column in columns[:size]
    )
    rest = (tail[0], tail[1], tail[2]) if basis_.unfelt else None
    return Parts(head[0], head[1], head[2], new_B, len(basis_.neutral), basis, rest)


def _definite_at_rest(pencil: Pencil) -> bool:
    """Every coordinate is in direct contact by a column of its own: nothing can be unfelt or neutral."""
    columns = [[row[j] for row in pencil.B] for j in range(pencil.contacts)]
    touched = {column.index(x) for column in columns for x in column if x and sum(map(bool, column)) == 1}
    return len(touched) == pencil.size


def _closure(H: list[Vector], maps: tuple[list[Vector], ...], start: list[Vector]) -> list[Vector]:
    """A basis of the least space that holds H⁻¹ start and is kept by H⁻¹M, H⁻¹C, H⁻¹K."""
    basis: list[Vector] = []
    echelon: list[Vector] = []
    queue = [_solve(H, vector) for vector in start]
    while queue:
        vector = queue.pop(0)
        if _independent(vector, echelon):
            basis.append(vector)
            queue += [_solve(H, _times(rows, vector)) for rows in maps]
    return basis


def _simple(vectors: list[Vector]) -> list[Vector]:
    """The basis of the same space with as many zeros as elimination gives: those of a chain are nearly parallel."""
    out: list[Vector] = []
    for vector in vectors:
        rest = list(vector)
        for row in out:
            lead = next(i for i, x in enumerate(row) if x)
            rest = [a - rest[lead] * b for a, b in zip(rest, row, strict=True)]
        lead = next(i for i, x in enumerate(rest) if x)
        rest = [x / rest[lead] for x in rest]
        out = [[a - row[lead] * b for a, b in zip(row, rest, strict=True)] for row in out]
        out.append(rest)
    return out


def _independent(vector: Vector, echelon: list[Vector]) -> bool:
    """Add `vector` to the echelon form if it is new."""
    rest = list(vector)
    for row in echelon:
        lead = next(i for i, x in enumerate(row) if x)
        if rest[lead]:
            factor = rest[lead] / row[lead]
            rest = [a - factor * b for a, b in zip(rest, row, strict=True)]
    if any(rest):
        echelon.append(rest)
        echelon.sort(key=lambda row: next(i for i, x in enumerate(row) if x))
        return True
    return False


def _project(vectors: list[Vector], felt: list[Vector], H: list[Vector]) -> list[Vector]:
    """A basis of the H-orthogonal projections of `vectors` on the felt space."""
    gram = [[_dot(a, _times(H, b)) for b in felt] for a in felt]
    out: list[Vector] = []
    echelon: list[Vector] = []
    for vector in vectors:
        weights = _solve(gram, [_dot(a, _times(H, vector)) for a in felt])
        image = [sum((w * a[i] for w, a in zip(weights, felt, strict=True)), Fraction(0)) for i in range(len(vector))]
        if _independent(image, echelon):
            out.append(image)
    return out


def _complete(first: list[Vector], space: list[Vector]) -> list[Vector]:
    """Vectors of `space` that, with `first`, are a basis of it."""
    echelon: list[Vector] = []
    for vector in first:
        _independent(vector, echelon)
    return [vector for vector in space if _independent(vector, echelon)]


def _kernel(rows: list[Vector], n: int) -> list[Vector]:
    """A basis of the common kernel of the rows."""
    echelon: list[Vector] = []
    for row in rows:
        _independent(row, echelon)
    leads = [next(i for i, x in enumerate(row) if x) for row in echelon]
    out = []
    for free in (i for i in range(n) if i not in leads):
        vector = [Fraction(0)] * n
        vector[free] = Fraction(1)
        for row, lead in sorted(zip(echelon, leads, strict=True), key=lambda pair: -pair[1]):
            rest = sum((row[i] * vector[i] for i in range(lead + 1, n)), Fraction(0))
            vector[lead] = -rest / row[lead]
        out.append(vector)
    return out


def _solve(rows: list[Vector], right: Vector) -> Vector:
    """The solution of a regular system."""
    a = [[*row, x] for row, x in zip(rows, right, strict=True)]
    n = len(a)
    for k in range(n):
        pivot = next(i for i in range(k, n) if a[i][k])
        a[k], a[pivot] = a[pivot], a[k]
        for i in range(n):
            if i != k and a[i][k]:
                factor = a[i][k] / a[k][k]
                a[i] = [x - factor * y for x, y in zip(a[i], a[k], strict=True)]
    return [a[k][n] / a[k][k] for k in range(n)]


def _times(rows: list[Vector], vector: Vector) -> Vector:
    return [_dot(row, vector) for row in rows]


def _dot(a: Vector, b: Vector) -> Fraction:
    return sum((x * y for x, y in zip(a, b, strict=True) if x and y), Fraction(0))


def _congruent(rows: list[Vector], columns: list[Vector]) -> list[Vector]:
    images = [_times(rows, column) for column in columns]
    return [[_dot(a, image) for image in images] for a in columns]
