"""A rigid mass on the rail."""

from __future__ import annotations

from fractions import Fraction
from typing import Annotated, ClassVar

from mpsolve.numbers.model import Rational, positive
from mpsolve.vehicles.vehicle import AnyVehicle, Pencil, assemble


class Mass(AnyVehicle, frozen=True):
    """A mass M in tight contact with the rail: an unsprung wheelset."""

    name: ClassVar[str] = "mass"
    drawing: ClassVar[str] = "   (M)\n   ═●═\n"

    M: Annotated[Rational, positive("kg", "mass on one rail")]

    @property
    def pencil(self) -> Pencil:
        return assemble(("wheel",), (self.M,), [], [(Fraction(0), {0: Fraction(1)})], None)
