"""A rail on pads, sleepers, a layer of ballast with mass and shear, and the ground."""

from __future__ import annotations

from fractions import Fraction
from typing import Annotated, Any, ClassVar

from mpsolve.errors import InputError
from mpsolve.numbers.model import Rational, nonnegative, positive, real
from mpsolve.tracks.rail import layer
from mpsolve.tracks.waveguide import Track


class ThreeLayer(Track, frozen=True):
    """Rail, sleepers and ballast as distributed masses on pads, ballast springs and the ground."""

    name: ClassVar[str] = "three-layer"
    drawing: ClassVar[str] = (
        "   ══════●════════════   rail EI, m, N, eta\n"
        "    ╪  ╪  ╪  ╪  ╪  ╪     pads k_pad, c_pad\n"
        "    ▭  ▭  ▭  ▭  ▭  ▭     sleepers m_sleeper\n"
        "    ╪  ╪  ╪  ╪  ╪  ╪     ballast k_ballast, c_ballast\n"
        "    ▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒     ballast m_ballast, shear\n"
        "    ╪  ╪  ╪  ╪  ╪  ╪     ground k_ground, c_ground\n"
    )

    EI: Annotated[Rational, positive("N m²", "bending stiffness of the rail")]
    m: Annotated[Rational, positive("kg/m", "mass of the rail")]
    k_pad: Annotated[Rational, positive("N/m²", "stiffness of the pads")]
    c_pad: Annotated[Rational, nonnegative("N s/m²", "damping of the pads")] = Fraction(0)
    m_sleeper: Annotated[Rational, nonnegative("kg/m", "mass of the sleepers")] = Fraction(0)
    k_ballast: Annotated[Rational, nonnegative("N/m²", "stiffness between sleepers and ballast")] = Fraction(0)
    c_ballast: Annotated[Rational, nonnegative("N s/m²", "damping between sleepers and ballast")] = Fraction(0)
    m_ballast: Annotated[Rational, nonnegative("kg/m", "mass of the ballast that moves")] = Fraction(0)
    shear: Annotated[Rational, nonnegative("N", "shear stiffness of the ballast along the track")] = Fraction(0)
    k_ground: Annotated[Rational, nonnegative("N/m²", "stiffness of the ground")] = Fraction(0)
    c_ground: Annotated[Rational, nonnegative("N s/m²", "damping of the ground")] = Fraction(0)
    N: Annotated[Rational, real("N", "axial force in the rail, compression positive")] = Fraction(0)
    eta: Annotated[Rational, nonnegative("s", "Kelvin–Voigt damping of the rail, on EI")] = Fraction(0)

    def check(self) -> None:
        if not (self.k_ballast or self.c_ballast):
            stated = "and c_ballast are both 0, so the sleepers and the ballast do not feel each other"
            raise InputError("k_ballast", f"{stated}: give one of them, or take TwoLayer")

    @staticmethod
    def equations(x: Any) -> list[list[Any]]:
        pad, ballast = layer(x, x.k_pad, x.c_pad), layer(x, x.k_ballast, x.c_ballast)
        rail = x.EI * (1 + x.eta * x.s) * x.P**4 + x.N * x.P**2 + x.m * x.s**2
        below = x.m_ballast * x.s**2 + layer(x, x.k_ground, x.c_ground) - x.shear * x.P**2
        return [
            [rail + pad, -pad, 0 * pad],
            [-pad, x.m_sleeper * x.s**2 + pad + ballast, -ballast],
            [0 * pad, -ballast, ballast + below],
        ]
