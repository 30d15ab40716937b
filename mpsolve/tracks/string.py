"""A string on a viscoelastic foundation: a contact wire."""

from __future__ import annotations

from fractions import Fraction
from typing import Annotated, Any, ClassVar

from mpsolve.numbers.model import Rational, nonnegative, positive
from mpsolve.tracks.waveguide import Track


class String(Track, frozen=True):
    """T w″ = m ẅ + c ẇ + k w + load: waves run at √(T/m)."""

    name: ClassVar[str] = "string"
    drawing: ClassVar[str] = "   ──────●────────────   string T, m\n    ╪  ╪  ╪  ╪  ╪  ╪     foundation k, c\n"

    T: Annotated[Rational, positive("N", "tension")]
    m: Annotated[Rational, positive("kg/m", "mass of the string")]
    k: Annotated[Rational, nonnegative("N/m²", "stiffness of the foundation")] = Fraction(0)
    c: Annotated[Rational, nonnegative("N s/m²", "damping of the foundation")] = Fraction(0)

    @staticmethod
    def equations(x: Any) -> list[list[Any]]:
        return [[-x.T * x.P**2 + x.m * x.s**2 + x.c * x.s + x.k]]
