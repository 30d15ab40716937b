"""A Rayleigh beam on a viscoelastic Pasternak foundation: a rail whose cross-sections have rotary inertia."""

from __future__ import annotations

from fractions import Fraction
from typing import Annotated, Any, ClassVar

from mpsolve.numbers.model import Rational, nonnegative, positive, real
from mpsolve.tracks.rail import layer, rail
from mpsolve.tracks.waveguide import Track


class Rayleigh(Track, frozen=True):
    """EI (1 + η ∂t) w⁗ + (N − kp) w″ + m ẅ − J ẅ″ + c ẇ + k w = load: short waves run at √(EI/J)."""

    name: ClassVar[str] = "rayleigh"
    drawing: ClassVar[str] = (
        "   ══════●════════════   rail EI, m, J, N, eta\n    ╪  ╪  ╪  ╪  ╪  ╪     foundation k, c, kp\n"
    )

    EI: Annotated[Rational, positive("N m²", "bending stiffness of the rail")]
    m: Annotated[Rational, positive("kg/m", "mass of the rail")]
    J: Annotated[Rational, positive("kg m", "rotary inertia of the rail, ρI")]
    k: Annotated[Rational, nonnegative("N/m²", "stiffness of the foundation")] = Fraction(0)
    c: Annotated[Rational, nonnegative("N s/m²", "damping of the foundation")] = Fraction(0)
    kp: Annotated[Rational, nonnegative("N", "Pasternak shear modulus of the foundation")] = Fraction(0)
    N: Annotated[Rational, real("N", "axial force in the rail, compression positive")] = Fraction(0)
    eta: Annotated[Rational, nonnegative("s", "Kelvin–Voigt damping of the rail, on EI")] = Fraction(0)

    @staticmethod
    def equations(x: Any) -> list[list[Any]]:
        return [[rail(x) - x.J * x.P**2 * x.s**2 + layer(x, x.k, x.c)]]
