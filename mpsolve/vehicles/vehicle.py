"""What a vehicle is: bodies with M ÿ + C ẏ + K y = B λ, contacts at given places, a compliance in each contact.

λ are the contact forces on the vehicle; the rail under the contacts moves as w = −G λ, and Bᵀy − w + h λ = 0 with the
compliances h (0: a tight contact, 1/k_H: a linearised Hertz spring). Places are measured from the vehicle's middle,
x ahead.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any, ClassVar

from mpsolve.errors import InputError
from mpsolve.numbers.model import Model, rational

Rows = tuple[tuple[Fraction, ...], ...]


@dataclass(frozen=True)
class Pencil:
    """Exact matrices of a vehicle: M, C, K (n × n, symmetric), B (n × contacts), places and compliances h."""

    M: Rows
    C: Rows
    K: Rows
    B: Rows
    places: tuple[Fraction, ...]
    h: tuple[Fraction, ...]
    names: tuple[str, ...]

    @property
    def size(self) -> int:
        return len(self.M)

    @property
    def contacts(self) -> int:
        return len(self.places)


@dataclass(frozen=True)
class Placed:
    """A vehicle whose middle is at `position`, in metres ahead of the origin of the moving frame."""

    vehicle: Any
    position: Fraction


class Vehicle(Model, frozen=True):
    """Base of the vehicles: what a new vehicle must say is its parameters and `pencil`."""

    name: ClassVar[str] = ""
    drawing: ClassVar[str] = ""

    @property
    def pencil(self) -> Pencil:
        """The equations of motion as exact data."""
        raise TypeError("a vehicle defines its pencil")

    def at(self, x: object) -> Placed:
        """This vehicle with its middle at x."""
        return Placed(self, rational(x, "position"))


def assemble(
    names: tuple[str, ...],
    masses: tuple[Fraction, ...],
    links: list[tuple[dict[int, Fraction], Fraction, Fraction]],
    contacts: list[tuple[Fraction, dict[int, Fraction]]],
    k_contact: Fraction | None,
) -> Pencil:
    """A vehicle from its masses, its links (lengthening in the coordinates, k, c) and its contacts (place, motion)."""
    n = len(names)
    M, C, K = (_square(n) for _ in range(3))
    for i, mass in enumerate(masses):
        M[i][i] = mass
    for pattern, stiffness, damping in links:
        for i, x in pattern.items():
            for j, y in pattern.items():
                K[i][j] += stiffness * x * y
                C[i][j] += damping * x * y
    B = tuple(tuple(motion.get(i, Fraction(0)) for _, motion in contacts) for i in range(n))
    h = Fraction(0) if k_contact is None else 1 / k_contact
    places = tuple(place for place, _ in contacts)
    return Pencil(_rows(M), _rows(C), _rows(K), B, places, (h,) * len(places), names)


def checked_pencil(pencil: Pencil) -> Pencil:
    """`pencil`, or InputError where it is not a passive vehicle whose bodies are all held or have a mass."""
    for key in ("M", "C", "K"):
        rows = getattr(pencil, key)
        if any(rows[i][j] != rows[j][i] for i in range(len(rows)) for j in range(i)):
            raise InputError(key, "is not symmetric: give a symmetric matrix")
        if not _semidefinite(rows):
            raise InputError(key, "is not positive semidefinite, so the vehicle could give energy: check its entries")
    total = tuple(
        tuple(m + c + k for m, c, k in zip(*rows, strict=True))
        for rows in zip(pencil.M, pencil.C, pencil.K, strict=True)
    )
    loose = _loose(total)
    if loose is not None:
        raise InputError("M", f"leaves {pencil.names[loose]} without mass, spring and damper: leave the body out")
    if any(h < 0 for h in pencil.h):
        raise InputError("k_contact", "is negative: give a stiffness above 0, or none for a tight contact")
    return pencil


def _square(n: int) -> list[list[Fraction]]:
    return [[Fraction(0)] * n for _ in range(n)]


def _rows(matrix: list[list[Fraction]]) -> Rows:
    return tuple(tuple(row) for row in matrix)


def _semidefinite(rows: Rows) -> bool:
    """By elimination: no negative pivot, and a zero pivot only with a zero row."""
    a = [list(row) for row in rows]
    for k in range(len(a)):
        if a[k][k] < 0 or (a[k][k] == 0 and any(a[k][j] for j in range(k, len(a)))):
            return False
        if a[k][k] > 0:
            for i in range(k + 1, len(a)):
                factor = a[i][k] / a[k][k]
                for j in range(k, len(a)):
                    a[i][j] -= factor * a[k][j]
    return True


def _loose(rows: Rows) -> int | None:
    """The first coordinate whose pivot is 0 in a semidefinite matrix, or None where it is definite."""
    a = [list(row) for row in rows]
    for k in range(len(a)):
        if a[k][k] == 0:
            return k
        for i in range(k + 1, len(a)):
            factor = a[i][k] / a[k][k]
            for j in range(k, len(a)):
                a[i][j] -= factor * a[k][j]
    return None
