"""A coach: a long body with bounce and pitch on two bogies."""

from __future__ import annotations

from fractions import Fraction
from typing import Annotated, ClassVar

from mpsolve.errors import InputError
from mpsolve.numbers.model import Part, Rational, nonnegative, positive
from mpsolve.vehicles.bogie import Bogie
from mpsolve.vehicles.vehicle import AnyVehicle, Pencil, joined, linked


class Coach(AnyVehicle, frozen=True):
    """A body on k2, c2 over the middle of each of two equal bogies, which have no body of their own."""

    name: ClassVar[str] = "coach"
    drawing: ClassVar[str] = (
        "  ┌──────────────────────────┐ body, inertia\n"
        "  └──╪╪──────────────────╪╪──┘ k2, c2\n"
        "   ┌────┐              ┌────┐  bogie\n"
        "   ●    ●              ●    ●\n"
        "     ←      pivots      →\n"
    )

    body: Annotated[Rational, positive("kg", "mass of the body on one rail")]
    inertia: Annotated[Rational, positive("kg m²", "pitch inertia of the body")]
    bogie: Annotated[Bogie, Part("", "bogie under each end", kind=Bogie)]
    pivots: Annotated[Rational, positive("m", "whole distance between the middles of the bogies")]
    k2: Annotated[Rational, nonnegative("N/m", "stiffness of the secondary suspension of one bogie")] = Fraction(0)
    c2: Annotated[Rational, nonnegative("N s/m", "damping of the secondary suspension of one bogie")] = Fraction(0)

    def check(self) -> None:
        if self.bogie.body is not None:
            raise InputError("bogie", "has a body of its own: leave its body, k2 and c2 out, the coach has them")
        if not (self.k2 or self.c2):
            raise InputError("k2", "and c2 are both 0, so nothing carries the body: give a spring or a damper")

    @property
    def pencil(self) -> Pencil:
        one, arm, frame = Fraction(1), self.pivots / 2, 2
        bogie = self.bogie.pencil
        both = joined([(bogie, -arm, " of the rear bogie"), (bogie, arm, " of the front bogie")])
        bounce, pitch = both.size, both.size + 1
        links = [
            ({bounce: one, pitch: -arm, frame: -one}, self.k2, self.c2),
            ({bounce: one, pitch: arm, bogie.size + frame: -one}, self.k2, self.c2),
        ]
        return linked(both, {"body bounce": self.body, "body pitch": self.inertia}, links)
