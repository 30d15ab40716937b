"""A floating sheet of ice on shallow water: an ice road. Forces and vehicles are per metre of its width."""

from __future__ import annotations

from fractions import Fraction
from typing import Annotated, Any, ClassVar

from mpsolve.numbers.model import Rational, nonnegative, positive
from mpsolve.tracks.rail import layer
from mpsolve.tracks.waveguide import Track


class FloatingIce(Track, frozen=True):
    """A plate with deflection w on shallow water with velocity potential φ; a strip one metre wide.

    B (1 + η ∂t) w⁗ + rho_ice h ẅ + c ẇ + rho_water (g w + φ̇) = load, and rho_water (ẇ + depth φ″) = 0:
    with the factor rho_water the equations show that plate and water give each other what the other loses.
    """

    name: ClassVar[str] = "floating-ice"
    drawing: ClassVar[str] = (
        "   ▔▔▔▔▔▔●▔▔▔▔▔▔▔▔▔▔▔▔   ice B, h, rho_ice, c, eta\n"
        "   ~ ~ ~ ~ ~ ~ ~ ~ ~ ~   water rho_water, depth, g\n"
        "   ░░░░░░░░░░░░░░░░░░░   ground\n"
    )

    B: Annotated[Rational, positive("N m", "bending stiffness of the plate, per metre of width")]
    h: Annotated[Rational, positive("m", "thickness of the ice")]
    rho_ice: Annotated[Rational, positive("kg/m³", "density of the ice")]
    rho_water: Annotated[Rational, positive("kg/m³", "density of the water")]
    depth: Annotated[Rational, positive("m", "depth of the water, much less than the wavelength")]
    g: Annotated[Rational, positive("m/s²", "acceleration of gravity")] = Fraction(980665, 100000)
    c: Annotated[Rational, nonnegative("N s/m³", "damping of the deflection")] = Fraction(0)
    eta: Annotated[Rational, nonnegative("s", "Kelvin–Voigt damping of the plate, on B")] = Fraction(0)

    @staticmethod
    def equations(x: Any) -> list[list[Any]]:
        weight = x.rho_water * x.g
        plate = x.B * (1 + x.eta * x.s) * x.P**4 + x.rho_ice * x.h * x.s**2 + layer(x, weight, x.c)
        return [[plate, x.rho_water * x.s], [-x.rho_water * x.s, -x.rho_water * x.depth * x.P**2]]
