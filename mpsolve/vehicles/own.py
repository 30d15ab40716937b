"""Anybody's own vehicle, given by its matrices."""

from __future__ import annotations

from fractions import Fraction
from typing import Annotated, Any, ClassVar

from mpsolve.errors import InputError
from mpsolve.numbers.model import Entries, Rational, Texts, contact_spring
from mpsolve.vehicles.vehicle import AnyVehicle, Pencil, checked_pencil


class Vehicle(AnyVehicle, frozen=True):
    """M ÿ + C ẏ + K y = B λ, with a row of B for each coordinate and a column for each contact.

    M, C, K: symmetric, positive semidefinite. places: where the contacts are, x ahead of the vehicle's middle.

    >>> Vehicle(M=[[900]], C=[[0]], K=[[0]], B=[[1]], places=[0]).pencil.names
    ('coordinate 1',)
    """

    name: ClassVar[str] = "matrices"
    drawing: ClassVar[str] = "   M ÿ + C ẏ + K y = B λ\n   ●     ●     ●     places\n"

    M: Annotated[Any, Entries("kg", "mass matrix", depth=2, alike=("kg m", "kg m²"))]
    C: Annotated[Any, Entries("N s/m", "damping matrix", depth=2, alike=("N s", "N m s"))]
    K: Annotated[Any, Entries("N/m", "stiffness matrix", depth=2, alike=("N", "N m"))]
    B: Annotated[Any, Entries("", "matrix of the contacts: one row for each coordinate", depth=2, alike=("m",))]
    places: Annotated[Any, Entries("m", "places of the contacts, ahead of the middle")]
    k_contact: Annotated[Rational | None, contact_spring()] = None
    names: Annotated[Any, Texts("", "names of the coordinates", optional=True)] = None

    def check(self) -> None:
        size, contacts = len(self.M), len(self.places)
        if not size or not contacts:
            key = "places" if size else "M"
            raise InputError(key, "is empty: a vehicle has at least one coordinate and one contact")
        for key, width in (("M", size), ("C", size), ("K", size), ("B", contacts)):
            rows = getattr(self, key)
            if len(rows) != size or any(len(row) != width for row in rows):
                raise InputError(key, f"is not {size} × {width}: give {size} rows of {width} numbers")
        if self.names is not None and len(self.names) != size:
            raise InputError("names", f"has {len(self.names)} names for {size} coordinates: give one for each")
        checked_pencil(self.pencil)

    @property
    def pencil(self) -> Pencil:
        names = self.names or tuple(f"coordinate {i}" for i in range(1, len(self.M) + 1))
        h = Fraction(0) if self.k_contact is None else 1 / self.k_contact
        return Pencil(self.M, self.C, self.K, self.B, self.places, (h,) * len(self.places), names)
