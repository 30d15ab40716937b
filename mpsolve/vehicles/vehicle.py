"""What a vehicle is: bodies with M ÿ + C ẏ + K y = B λ, contacts at given places, a compliance in each contact.

λ are the contact forces on the vehicle; the rail under the contacts moves as w = −G λ, and Bᵀy − w + h λ = 0 with the
compliances h (0: a tight contact, 1/k_H: a linearised Hertz spring). Places are measured from the vehicle's middle,
x ahead.
"""

from __future__ import annotations

from fractions import Fraction
from typing import ClassVar

from mpsolve.errors import InputError
from mpsolve.frozen import frozen
from mpsolve.numbers.model import Model, rational, shown, typed, whole

Rows = tuple[tuple[Fraction, ...], ...]
Link = tuple[dict[int, Fraction], Fraction, Fraction]
"""A spring and damper side by side: how its lengthening depends on the coordinates, k, c."""
_MOST = 1000  # in a row


@frozen
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


@frozen
class Placed:
    """A vehicle whose middle is at `position`, in metres ahead of the origin of the moving frame."""

    vehicle: AnyVehicle
    position: Fraction

    def __repr__(self) -> str:
        return f"{self.vehicle!r}.at({typed(self.position)})"


class AnyVehicle(Model, frozen=True):
    """Base of the vehicles: what a new vehicle must say is its parameters and `pencil`."""

    name: ClassVar[str] = ""
    drawing: ClassVar[str] = ""

    @property
    def pencil(self) -> Pencil:
        """The equations of motion as exact data."""
        raise TypeError("a vehicle defines its pencil")

    def at(self, x: object) -> Placed:
        """This vehicle with its middle at x."""
        return Placed(self, rational(x, "position", "m", "place of the middle"))


def assemble(
    names: tuple[str, ...],
    masses: tuple[Fraction, ...],
    links: list[Link],
    contacts: list[tuple[Fraction, dict[int, Fraction]]],
    k_contact: Fraction | None,
) -> Pencil:
    """A vehicle from its masses, its links (lengthening in the coordinates, k, c), its contacts (place, motion)."""
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


def joined(parts: list[tuple[Pencil, Fraction, str]]) -> Pencil:
    """Several vehicles as one, each with the place of its middle and an ending for its names; contacts sorted."""
    order = sorted(
        (x + place, k, j) for k, (pencil, x, _) in enumerate(parts) for j, place in enumerate(pencil.places)
    )
    size = sum(pencil.size for pencil, _, _ in parts)
    blocks = {key: _square(size) for key in "MCK"}
    B = [[Fraction(0)] * len(order) for _ in range(size)]
    column = {(k, j): i for i, (_, k, j) in enumerate(order)}
    names: list[str] = []
    for k, (pencil, _, ending) in enumerate(parts):
        first = len(names)
        for key, matrix in blocks.items():
            for i, row in enumerate(getattr(pencil, key)):
                matrix[first + i][first : first + pencil.size] = row
        for i, row in enumerate(pencil.B):
            for j, value in enumerate(row):
                B[first + i][column[k, j]] = value
        names += [name + ending for name in pencil.names]
    h = tuple(parts[k][0].h[j] for _, k, j in order)
    M, C, K = (_rows(blocks[key]) for key in "MCK")
    return Pencil(M, C, K, _rows(B), tuple(place for place, _, _ in order), h, tuple(names))


def linked(pencil: Pencil, masses: dict[str, Fraction], links: list[Link]) -> Pencil:
    """`pencil` with further bodies behind its own, and links among all of them."""
    more = assemble((*pencil.names, *masses), (Fraction(0),) * pencil.size + tuple(masses.values()), links, [], None)
    wide = joined([(pencil, Fraction(0), ""), (_bodies(tuple(masses)), Fraction(0), "")])
    M, C, K = (_sum(getattr(wide, key), getattr(more, key)) for key in "MCK")
    return Pencil(M, C, K, wide.B, wide.places, wide.h, wide.names)


def checked_pencil(pencil: Pencil) -> Pencil:
    """`pencil`, or InputError where it is not a passive vehicle whose bodies are all held and move by forces."""
    for key in ("M", "C", "K"):
        rows = getattr(pencil, key)
        if any(rows[i][j] != rows[j][i] for i in range(len(rows)) for j in range(i)):
            raise InputError(key, "is not symmetric: give a symmetric matrix")
        if _pivots(rows) is None:
            raise InputError(key, "is not positive semidefinite, so the vehicle could give energy: check its entries")
    loose = _loose(_sum(_sum(pencil.M, pencil.C), pencil.K))
    if loose is not None:
        raise InputError("M", f"leaves {pencil.names[loose]} without mass, spring and damper: leave the body out")
    touch = tuple(
        tuple(sum((a * b for a, b in zip(x, y, strict=True)), Fraction(0)) for y in pencil.B) for x in pencil.B
    )
    loose = _loose(_sum(_sum(pencil.C, pencil.K), touch))
    if loose is not None:
        stated = f"and C leave {pencil.names[loose]} free to move without any spring, damper or contact"
        raise InputError("K", f"{stated}: hold the body, or leave it out")
    for j in range(pencil.contacts):
        if not any(row[j] for row in pencil.B):
            raise InputError("B", f"has only zeros for contact {j + 1}: let every contact touch a body")
    if any(h < 0 for h in pencil.h):
        raise InputError("k_contact", "is negative: give a stiffness above 0, or none for a tight contact")
    return pencil


def _bodies(names: tuple[str, ...]) -> Pencil:
    zero = _rows(_square(len(names)))
    return Pencil(zero, zero, zero, ((),) * len(names), (), (), names)


def _sum(a: Rows, b: Rows) -> Rows:
    return tuple(tuple(x + y for x, y in zip(*rows, strict=True)) for rows in zip(a, b, strict=True))


def _square(n: int) -> list[list[Fraction]]:
    return [[Fraction(0)] * n for _ in range(n)]


def _rows(matrix: list[list[Fraction]]) -> Rows:
    return tuple(tuple(row) for row in matrix)


def _pivots(rows: Rows) -> list[Fraction] | None:
    """Of symmetric elimination; None where one is negative, or 0 with a row that is not: semidefinite is neither."""
    a, out = [list(row) for row in rows], []
    for k in range(len(a)):
        pivot = a[k][k]
        if pivot < 0 or (not pivot and any(a[k][k:])):
            return None
        out.append(pivot)
        for i in range(k + 1, len(a)) if pivot else ():
            factor = a[i][k] / pivot
            a[i][k:] = [x - factor * y for x, y in zip(a[i][k:], a[k][k:], strict=True)]
    return out


def _loose(rows: Rows) -> int | None:
    """The first coordinate whose pivot is 0 in a semidefinite matrix, or None where it is definite."""
    return next((k for k, pivot in enumerate(_pivots(rows) or ()) if not pivot), None)


def train(vehicle: AnyVehicle, count: int, spacing: object) -> tuple[Placed, ...]:
    """`count` copies of a vehicle whose middles are `spacing` > 0 apart, the rearmost at x = 0.

    >>> from mpsolve.vehicles import Mass
    >>> [str(placed.position) for placed in train(Mass(900), 3, "2.5")]
    ['0', '5/2', '5']
    """
    if not isinstance(vehicle, AnyVehicle):
        raise InputError("vehicle", f"is of type {type(vehicle).__name__}: give one of mpsolve.vehicles, not placed")
    count = whole(count, "count", 1, _MOST)
    gap = rational(spacing, "spacing", "m", "distance of the vehicles")
    if gap <= 0:
        raise InputError("spacing", f"is {shown(gap, spacing)}, but must be above 0: give the distance in m")
    return tuple(vehicle.at(k * gap) for k in range(count))
