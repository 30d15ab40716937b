"""A sprung mass: a wheel with a body on a spring and a damper."""

from __future__ import annotations

from fractions import Fraction
from typing import Annotated, ClassVar

from mpsolve.errors import InputError
from mpsolve.numbers.model import Rational, contact_spring, nonnegative, positive
from mpsolve.vehicles.vehicle import AnyVehicle, Pencil, assemble


class Oscillator(AnyVehicle, frozen=True):
    """A wheel on the rail, and a body on k, c over it: a quarter of a car."""

    name: ClassVar[str] = "oscillator"
    drawing: ClassVar[str] = "  [ body ]\n     ╪╪   k, c\n    (M)   wheel\n     ●    k_contact\n"

    wheel: Annotated[Rational, positive("kg", "mass of the wheel on one rail")]
    body: Annotated[Rational, positive("kg", "mass of the body over it")]
    k: Annotated[Rational, nonnegative("N/m", "stiffness of the suspension")] = Fraction(0)
    c: Annotated[Rational, nonnegative("N s/m", "damping of the suspension")] = Fraction(0)
    k_contact: Annotated[Rational | None, contact_spring()] = None

    def check(self) -> None:
        if not (self.k or self.c):
            raise InputError(
                "k",
                "and c are both 0, so nothing carries the body: give a spring or a damper, "
                "or add its mass to the wheel's",
            )

    @property
    def pencil(self) -> Pencil:
        one = Fraction(1)
        links = [({1: one, 0: -one}, self.k, self.c)]
        masses = (self.wheel, self.body)
        return assemble(("wheel", "body"), masses, links, [(Fraction(0), {0: one})], self.k_contact)
