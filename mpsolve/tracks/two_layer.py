"""A rail on pads, sleepers and ballast."""

from __future__ import annotations

from fractions import Fraction
from typing import Annotated, Any, ClassVar

from mpsolve.numbers.model import Rational, nonnegative, positive, real
from mpsolve.tracks.rail import layer, rail
from mpsolve.tracks.waveguide import Track


class TwoLayer(Track, frozen=True):
    """Rail, pads, sleepers as a distributed mass, ballast as springs and dampers."""

    name: ClassVar[str] = "two-layer"
    drawing: ClassVar[str] = (
        "   ══════●════════════   rail EI, m, N, eta\n"
        "    ╪  ╪  ╪  ╪  ╪  ╪     pads k_pad, c_pad\n"
        "    ▭  ▭  ▭  ▭  ▭  ▭     sleepers m_sleeper\n"
        "    ╪  ╪  ╪  ╪  ╪  ╪     ballast k_ballast, c_ballast\n"
    )

    EI: Annotated[Rational, positive("N m²", "bending stiffness of the rail")]
    m: Annotated[Rational, positive("kg/m", "mass of the rail")]
    k_pad: Annotated[Rational, positive("N/m²", "stiffness of the pads")]
    c_pad: Annotated[Rational, nonnegative("N s/m²", "damping of the pads")] = Fraction(0)
    m_sleeper: Annotated[Rational, nonnegative("kg/m", "mass of the sleepers")] = Fraction(0)
    k_ballast: Annotated[Rational, nonnegative("N/m²", "stiffness of the ballast")] = Fraction(0)
    c_ballast: Annotated[Rational, nonnegative("N s/m²", "damping of the ballast")] = Fraction(0)
    kp: Annotated[Rational, nonnegative("N", "shear modulus under the rail")] = Fraction(0)
    N: Annotated[Rational, real("N", "axial force in the rail, compression positive")] = Fraction(0)
    eta: Annotated[Rational, nonnegative("s", "Kelvin–Voigt damping of the rail, on EI")] = Fraction(0)

    @staticmethod
    def equations(x: Any) -> list[list[Any]]:
        pad, ballast = layer(x, x.k_pad, x.c_pad), layer(x, x.k_ballast, x.c_ballast)
        return [[rail(x) + pad, -pad], [-pad, x.m_sleeper * x.s**2 + pad + ballast]]
