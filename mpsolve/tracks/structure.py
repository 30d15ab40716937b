"""Whether a track, or a kind of track whatever its parameters are, takes energy at rest: by its equations alone.

Let A = Σ A_j(P) s^j. If for every odd j the Hermitian part of (−1)^((j − 1)/2) A_j(ip) is positive semidefinite, and
for even j A_j(ip) is Hermitian, then Im(N/D) ≤ 0 for Ω > 0 (SPEC2, section 6.1). Here the principal minors are
polynomials in y = p² and the parameters; where all their coefficients are ≥ 0, they are ≥ 0 for all parameters ≥ 0.
Or −Im(N conj D)/Ω itself has such coefficients. Of one track's own numbers the minors' signs are decided.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import lru_cache
from itertools import combinations
from typing import Any

from flint import fmpq_poly

from mpsolve.numbers.model import Entries, Quantity, quantities
from mpsolve.numbers.realroots import as_fmpq, negative_point
from mpsolve.numbers.several import Ring, plus
from mpsolve.tracks.waveguide import Matrix, Track, Waveguide, cofactor, determinant, mapped, over_ring, power, scaled


@lru_cache(maxsize=64)
def passive_by_structure(kind: type[Track]) -> bool:
    """Whether every track of this kind is passive at rest, for all parameters that its bounds allow; False: unknown.

    Parameters that may be negative must not stand in the damping (odd powers of s).
    """
    known = quantities(kind)
    if not known or any(isinstance(one, Entries) for one in known.values()):
        return False
    ring = Ring(tuple(known), (Fraction(0),) * len(known))
    matrix = over_ring(kind, dict(zip(known, ring.variables, strict=True)), ring)
    signed = [k for k, one in enumerate(known.values()) if not _is_nonnegative(one)]
    if _passive(matrix, lambda minor: _at_least_zero(minor, signed)):
        return True
    D, N = determinant(matrix), cofactor(matrix, kind.loaded)
    even = not any(i % 2 for i, _ in (*D, *N))
    return even and _at_least_zero(power(D, N), signed)


@lru_cache(maxsize=64)
def passive_by_equations(guide: Waveguide) -> bool:
    """Whether the track's equations show it, as a checker asks (SPEC2, section 6.1); False: unknown."""
    return _passive(guide.matrix, lambda minor: negative_point(_in_y(minor)) is None)


def own_damping(guide: Waveguide) -> tuple[Fraction, int] | None:
    """(c, i), even i ≥ 2, if the loaded field has the damping c p^i of its own: the track is passive without it.

    Then |N/D| ≤ 1/(|s| c p^i) for Re s ≥ 0 (SPEC2, section 6.2).
    """
    loaded, entry = guide.loaded, guide.matrix[guide.loaded][guide.loaded]
    i = max((i for i, j in entry if j == 1), default=0)
    c = entry.get((i, 1), Fraction(0)) * (-1) ** (i // 2)
    if i < 2 or i % 2 or c <= 0:
        return None
    rows = [list(row) for row in guide.matrix]
    rows[loaded][loaded] = {key: x for key, x in entry.items() if key != (i, 1)}
    return (c, i) if passive_by_equations(Waveguide(tuple(map(tuple, rows)), loaded)) else None


def balanced(matrix: Matrix, loaded: int) -> Matrix:
    """The same equations, those of the other rows times numbers that let them show passivity; else as they are."""
    factors, open_ = {loaded: Fraction(1)}, [loaded]
    while open_:
        i = open_.pop()
        for j, entry in enumerate(matrix[i]):
            other = mapped(matrix[j][i], lambda a, _, c: c * (-1) ** a)
            if j not in factors and entry and entry.keys() == other.keys():
                key = next(iter(entry))
                factors[j] = factors[i] * entry[key] / other[key]
                open_.append(j)
    found = tuple(tuple(scaled(entry, factors.get(i, Fraction(1))) for entry in row) for i, row in enumerate(matrix))
    shown = passive_by_equations(Waveguide(matrix, loaded)) or not passive_by_equations(Waveguide(found, loaded))
    return matrix if shown else found


def _in_y(minor: Mapping[tuple[int, int], Fraction]) -> fmpq_poly:
    top = max((i for i, _ in minor), default=-1)
    return fmpq_poly([as_fmpq(minor.get((i, 0), Fraction(0))) for i in range(top + 1)])


def _is_nonnegative(quantity: Quantity) -> bool:
    return any(bound is not None and bound >= 0 for bound in (quantity.above, quantity.at_least))


def _at_least_zero(polynomial: Mapping[Any, Any], signed: list[int]) -> bool:
    """Whether all coefficients are ≥ 0, and no parameter that may be negative is in them."""
    return all(x >= 0 and not any(e[k] for k in signed) for c in polynomial.values() for e, x in c)


def _passive(matrix: Any, fine: Callable[[Any], bool]) -> bool:
    """fine: whether a minor is proved to be ≥ 0."""
    return all(_holds(matrix, j, fine) for j in sorted({j for row in matrix for entry in row for _, j in entry}))


def _holds(matrix: Any, j: int, fine: Callable[[Any], bool]) -> bool:
    """The condition on A_j: for odd j on its minors, for even j A_j(P) = A_j(−P)ᵀ."""
    n = range(len(matrix))
    parts = [[{(i, 0): c for (i, k), c in matrix[a][b].items() if k == j} for b in n] for a in n]
    mirrored = [[{(i, 0): c * (-1) ** i for (i, _), c in parts[b][a].items()} for b in n] for a in n]
    if j % 2 == 0:
        return parts == mirrored
    twice = [[plus(parts[a][b], mirrored[a][b]) for b in n] for a in n]
    if any(i % 2 for row in twice for entry in row for i, _ in entry):
        return False
    turn = (-1) ** ((j - 1) // 2)
    in_y = [[{(i // 2, 0): c * (turn * (-1) ** (i // 2)) for (i, _), c in x.items()} for x in row] for row in twice]
    groups = [some for size in range(1, len(in_y) + 1) for some in combinations(n, size)]
    minors: Any = (determinant(tuple(tuple(in_y[a][b] for b in some) for a in some)) for some in groups)
    return all(map(fine, minors))
