"""A bogie: a frame with bounce and pitch on two wheelsets, and an optional body on its middle."""

from __future__ import annotations

from fractions import Fraction
from typing import Annotated, ClassVar

from mpsolve.errors import InputError
from mpsolve.numbers.model import Quantity, Rational, contact_spring, nonnegative, positive
from mpsolve.vehicles.vehicle import AnyVehicle, Pencil, assemble, linked


class Bogie(AnyVehicle, frozen=True):
    """Two wheelsets on k, c under a rigid frame (a two-axle wagon: its body); a body on k2, c2 over its middle."""

    name: ClassVar[str] = "bogie"
    drawing: ClassVar[str] = (
        "       [ body ]\n         ╪╪      k2, c2\n   ┌─────────────┐ frame, inertia\n"
        "   ╪             ╪ k, c\n  (M)           (M) wheel\n   ●             ●\n   ←  wheelbase  →\n"
    )

    wheel: Annotated[Rational, positive("kg", "mass of one wheelset on one rail")]
    frame: Annotated[Rational, positive("kg", "mass of the frame")]
    inertia: Annotated[Rational, positive("kg m²", "pitch inertia of the frame")]
    wheelbase: Annotated[Rational, positive("m", "distance between the wheelsets")]
    k: Annotated[Rational, nonnegative("N/m", "stiffness of the primary suspension of one wheelset")]
    c: Annotated[Rational, nonnegative("N s/m", "damping of the primary suspension of one wheelset")] = Fraction(0)
    k_contact: Annotated[Rational | None, contact_spring()] = None
    body: Annotated[
        Rational | None, Quantity("kg", "mass of the body", above=0, optional=True, without="no body")
    ] = None
    k2: Annotated[Rational, nonnegative("N/m", "stiffness of the secondary suspension")] = Fraction(0)
    c2: Annotated[Rational, nonnegative("N s/m", "damping of the secondary suspension")] = Fraction(0)

    def check(self) -> None:
        if not (self.k or self.c):
            raise InputError("k", "and c are both 0, so nothing carries the frame: give a spring or a damper")
        if self.body is None and (self.k2 or self.c2):
            raise InputError("body", "is missing for the secondary suspension k2, c2: give its mass")
        if self.body is not None and not (self.k2 or self.c2):
            raise InputError(
                "k2",
                "and c2 are both 0, so nothing carries the body: give a spring or a damper, "
                "or add its mass to the frame's",
            )

    @property
    def pencil(self) -> Pencil:
        one, arm = Fraction(1), self.wheelbase / 2
        names = ("rear wheel", "front wheel", "frame bounce", "frame pitch")
        masses = (self.wheel, self.wheel, self.frame, self.inertia)
        links = [({2: one, 3: -arm, 0: -one}, self.k, self.c), ({2: one, 3: arm, 1: -one}, self.k, self.c)]
        bogie = assemble(names, masses, links, [(-arm, {0: one}), (arm, {1: one})], self.k_contact)
        if self.body is None:
            return bogie
        return linked(bogie, {"body": self.body}, [({4: one, 2: -one}, self.k2, self.c2)])
