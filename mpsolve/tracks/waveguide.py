"""What a track is: exact equations of motion in P = ∂/∂x and s = ∂/∂t at rest.

With x ahead in the moving frame, everything varies as e^{Px + σt}, where P = ip, σ = iq, and a material point of
the track sees s = σ − vP (= iΩ, Ω = q − vp). A track is a square matrix A(P, s) of polynomials with real
coefficients, and the number of the row that carries the contacts: A u = e λ, displacement of the rail u₀ = (N/D) λ
with D = det A and N the cofactor of that row.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import lru_cache
from math import comb
from types import SimpleNamespace
from typing import Any, ClassVar

from mpsolve.frozen import frozen
from mpsolve.numbers.model import Model
from mpsolve.numbers.several import K, Ring, Several, multiply, plus

Polynomial = dict[tuple[int, int], Fraction]
"""Σ c P^i s^j as {(i, j): c} with c ≠ 0."""
Matrix = tuple[tuple[Polynomial, ...], ...]


class Track(Model, frozen=True):
    """Base of the tracks: what a new track must say is its parameters and `equations`."""

    drawing: ClassVar[str] = ""
    name: ClassVar[str] = ""
    loaded: ClassVar[int] = 0

    @staticmethod
    def equations(x: Any) -> list[list[Any]]:  # noqa: ARG004 — each track says them
        """The matrix A(P, s), written over `x.P`, `x.s` and the parameters; any ring will do."""
        raise TypeError("a track defines its equations")

    @property
    def waveguide(self) -> Waveguide:
        """The equations with these parameters, as exact data."""
        return self.with_values({})

    def with_values(self, changed: Mapping[str, Fraction]) -> Waveguide:
        """The same with some parameters changed; the bounds of a track's parameters do not hold here."""
        ring = Ring(("P", "s"), (Fraction(0), Fraction(0)))
        P, s = ring.variables
        rows = self.equations(SimpleNamespace(P=P, s=s, **(self.parameters | dict(changed))))
        matrix: Any = tuple(tuple(ring.constant(entry).terms for entry in row) for row in rows)
        return Waveguide(matrix, self.loaded)


def over_ring(kind: type[Track], values: Mapping[str, Any], ring: Ring) -> Any:
    """The equations of a kind of track as polynomials in P and s, with coefficients in the ring of its parameters."""
    wide = Ring(("P", "s", *ring.names), (Fraction(0), Fraction(0), *ring.point))
    lifted = {
        name: Several(wide, {(0, 0, *exponents): c for exponents, c in ring.constant(value)})
        for name, value in values.items()
    }
    P, s, *_ = wide.variables
    rows = kind.equations(SimpleNamespace(P=P, s=s, **lifted))
    return tuple(tuple(_in_P_and_s(wide.constant(entry), ring) for entry in row) for row in rows)


def _in_P_and_s(entry: Several, ring: Ring) -> dict[tuple[int, int], Several]:
    out: dict[tuple[int, int], dict[tuple[int, ...], Fraction]] = {}
    for (i, j, *rest), c in entry:
        out.setdefault((i, j), {})[tuple(rest)] = c
    return {key: Several(ring, terms) for key, terms in out.items()}


@frozen
class Waveguide:
    """The equations of a track as data: `matrix` of polynomials in P and s, and the row that carries the contacts."""

    matrix: Matrix
    loaded: int = 0

    def __hash__(self) -> int:
        return hash((self.loaded, tuple(tuple(frozenset(entry.items()) for entry in row) for row in self.matrix)))

    @property
    def dispersion(self) -> Polynomial:
        """D(P, s) = det A."""
        return dict(_dispersion(self))

    @property
    def numerator(self) -> Polynomial:
        """N(P, s): the cofactor of the loaded row."""
        return cofactor(self.matrix, self.loaded)

    @property
    def waveguide(self) -> Waveguide:
        """Itself, so that a problem takes a track or its bare equations alike."""
        return self


def scaled(a: Polynomial, factor: Fraction) -> Polynomial:
    return {key: value * factor for key, value in a.items()} if factor else {}


def mapped(a: Polynomial, change: Callable[[int, int, Fraction], Fraction]) -> Polynomial:
    """Each coefficient c of P^i s^j replaced by change(i, j, c)."""
    out = {(i, j): change(i, j, value) for (i, j), value in a.items()}
    return {key: value for key, value in out.items() if value}


@lru_cache(maxsize=64)
def _dispersion(waveguide: Waveguide) -> Polynomial:
    """Kept, as the same few tracks are asked for it again and again."""
    return determinant(waveguide.matrix)


def determinant(matrix: Matrix) -> Polynomial:
    """By expansion along the first row: tracks have few fields."""
    if not matrix:
        return {(0, 0): Fraction(1)}
    terms = []
    for j, entry in enumerate(matrix[0]):
        if entry:
            minor = tuple(tuple(row[k] for k in range(len(row)) if k != j) for row in matrix[1:])
            terms.append(scaled(multiply(entry, determinant(minor)), Fraction(-1) ** j))
    return plus(*terms)


def cofactor(matrix: Matrix, row: int) -> Polynomial:
    """Of the diagonal entry in that row."""
    kept = [k for k in range(len(matrix)) if k != row]
    return determinant(tuple(tuple(matrix[i][j] for j in kept) for i in kept))


def moving(a: Polynomial, velocity: Fraction) -> Polynomial:
    """The polynomial in P and σ that is left when s = σ − vP."""
    return {key: value for key, value in carried(a, velocity).items() if value}


def carried(a: Mapping[tuple[int, int], Any], velocity: Any) -> dict[tuple[int, int], Any]:
    """The same for any coefficients and velocity, arrays too; some may be 0."""
    out: dict[tuple[int, int], Any] = {}
    for (i, j), c in a.items():
        for k in range(j + 1):
            term = c * (comb(j, k) * (-velocity) ** k)
            out[i + k, j - k] = out[i + k, j - k] + term if (i + k, j - k) in out else term
    return out


def moved(a: Mapping[tuple[int, int], Any], axis: int, by: Any) -> dict[tuple[int, int], Any]:
    """a(P + by, s) for axis 0, a(P, s + by) for axis 1, whatever the coefficients are; some may be 0."""
    out: dict[tuple[int, int], Any] = {}
    for key, c in a.items():
        for k in range(key[axis] + 1):
            at = (key[0], k) if axis else (k, key[1])
            term = c * (comb(key[axis], k) * by ** (key[axis] - k))
            out[at] = out[at] + term if at in out else term
    return out


def slope_in_s(a: Mapping[tuple[int, int], Any]) -> dict[tuple[int, int], Any]:
    """The derivative in s, or in σ."""
    return {(i, j - 1): j * c for (i, j), c in a.items() if j}


def power(D: Mapping[K, Any], N: Mapping[K, Any]) -> dict[K, Any]:
    """w with −Im(N conj D) = Ω w(y, z) at P = ip, s = iΩ, y = p², z = Ω², for D and N even in P."""
    (dr, di), (nr, ni) = halves(D), halves(N)
    return plus(multiply(nr, di), {key: -c for key, c in multiply(ni, dr).items()})


def halves(polynomial: Mapping[K, Any]) -> tuple[dict[K, Any], dict[K, Any]]:
    """r and i in y and z: what is even in P is r + iΩ i at P = ip, s = iΩ; further variables are left as they are."""
    out: tuple[dict[Any, Any], dict[Any, Any]] = ({}, {})
    for (i, j, *rest), c in polynomial.items():
        out[j % 2][(i // 2, j // 2, *rest)] = c * (-1) ** (i // 2 + j // 2)
    return out
