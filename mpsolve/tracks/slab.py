"""A rail on pads on a continuous slab, which lies on a viscoelastic foundation."""

from __future__ import annotations

from fractions import Fraction
from typing import Annotated, Any, ClassVar

from mpsolve.numbers.model import Rational, nonnegative, positive
from mpsolve.tracks.rail import layer
from mpsolve.tracks.waveguide import Track


class Slab(Track, frozen=True):
    """Two Euler–Bernoulli beams, the rail and the slab, with the pads between them."""

    name: ClassVar[str] = "slab"
    drawing: ClassVar[str] = (
        "   ══════●════════════   rail EI, m\n"
        "    ╪  ╪  ╪  ╪  ╪  ╪     pads k_pad, c_pad\n"
        "   ████████████████████  slab EI_slab, m_slab\n"
        "    ╪  ╪  ╪  ╪  ╪  ╪     foundation k, c\n"
    )

    EI: Annotated[Rational, positive("N m²", "bending stiffness of the rail")]
    m: Annotated[Rational, positive("kg/m", "mass of the rail")]
    k_pad: Annotated[Rational, positive("N/m²", "stiffness of the pads")]
    c_pad: Annotated[Rational, nonnegative("N s/m²", "damping of the pads")] = Fraction(0)
    EI_slab: Annotated[Rational, nonnegative("N m²", "bending stiffness of the slab under one rail")] = Fraction(0)
    m_slab: Annotated[Rational, nonnegative("kg/m", "mass of the slab under one rail")] = Fraction(0)
    k: Annotated[Rational, nonnegative("N/m²", "stiffness of the foundation")] = Fraction(0)
    c: Annotated[Rational, nonnegative("N s/m²", "damping of the foundation")] = Fraction(0)

    @staticmethod
    def equations(x: Any) -> list[list[Any]]:
        pad = layer(x, x.k_pad, x.c_pad)
        rail = x.EI * x.P**4 + x.m * x.s**2
        slab = x.EI_slab * x.P**4 + x.m_slab * x.s**2 + layer(x, x.k, x.c)
        return [[rail + pad, -pad], [-pad, slab + pad]]
