"""A Timoshenko beam on a viscoelastic Pasternak foundation: a rail with shear and rotary inertia."""

from __future__ import annotations

from fractions import Fraction
from typing import Annotated, Any, ClassVar

from mpsolve.numbers.model import Rational, nonnegative, positive, real
from mpsolve.tracks.rail import layer
from mpsolve.tracks.waveguide import Track


class Timoshenko(Track, frozen=True):
    """Deflection w and rotation φ: shear waves run at √(S/m), bending waves at √(EI/J).

    m ẅ − S (w″ − φ′) + (N − kp) w″ + c ẇ + k w = load and J φ̈ − EI φ″ − S (w′ − φ) = 0; the axial force acts on w′.
    """

    name: ClassVar[str] = "timoshenko"
    drawing: ClassVar[str] = (
        "   ══════●════════════   rail EI, S, m, J, N\n    ╪  ╪  ╪  ╪  ╪  ╪     foundation k, c, kp\n"
    )

    EI: Annotated[Rational, positive("N m²", "bending stiffness of the rail")]
    m: Annotated[Rational, positive("kg/m", "mass of the rail")]
    S: Annotated[Rational, positive("N", "shear stiffness of the rail, κGA")]
    J: Annotated[Rational, positive("kg m", "rotary inertia of the rail, ρI")]
    k: Annotated[Rational, nonnegative("N/m²", "stiffness of the foundation")] = Fraction(0)
    c: Annotated[Rational, nonnegative("N s/m²", "damping of the foundation")] = Fraction(0)
    kp: Annotated[Rational, nonnegative("N", "Pasternak shear modulus of the foundation")] = Fraction(0)
    N: Annotated[Rational, real("N", "axial force in the rail, compression positive")] = Fraction(0)

    @staticmethod
    def equations(x: Any) -> list[list[Any]]:
        deflection = (x.N - x.kp - x.S) * x.P**2 + x.m * x.s**2 + layer(x, x.k, x.c)
        rotation = x.S - x.EI * x.P**2 + x.J * x.s**2
        return [[deflection, x.S * x.P], [-x.S * x.P, rotation]]
