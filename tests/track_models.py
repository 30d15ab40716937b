"""Tracks for tests: one typical record of each kind in SI, and random ones."""

from __future__ import annotations

from fractions import Fraction

from hypothesis import strategies as st

from mpsolve import tracks
from mpsolve.numbers.model import quantities

RAIL = {"EI": "6.38e6", "m": "60.2"}
DAMPED = {
    "string": tracks.String(T=27000, m="1.07", k=500, c=2),
    "euler-bernoulli": tracks.EulerBernoulli(**RAIL, k="1e6", c=770),
    "rayleigh": tracks.Rayleigh(**RAIL, J="0.24", k="1e6", c=770),
    "timoshenko": tracks.Timoshenko(**RAIL, S="2.4e8", J="0.24", k="1e6", c=770),
    "two-layer": tracks.TwoLayer(
        **RAIL, k_pad="300e6", c_pad="3e4", m_sleeper=250, k_ballast="100e6", c_ballast="8e4"
    ),
    "three-layer": tracks.ThreeLayer(
        **RAIL, k_pad="1.08e8", c_pad="1.25e5", m_sleeper=209, k_ballast="2.3e8", c_ballast="9.8e4",
        m_ballast=886, shear="1e7", k_ground="1.3e8", c_ground="5.2e4",
    ),
    "slab": tracks.Slab(
        EI="1.29e7", m=120, k_pad="5e8", c_pad="2.5e5", EI_slab="1.34e8", m_slab=1094, k="1e8", c="1e5"
    ),
    "floating-ice": tracks.FloatingIce(
        B="5e7", h="0.6", rho_ice=917, rho_water=1025, depth="6.8", g="9.8", c=100, eta="0.1"
    ),
}  # fmt: skip
"""By name; damped as their sources have them, or lightly."""


@st.composite
def random_tracks(draw: st.DrawFn) -> tracks.Track:
    """Any model with small rational parameters within their bounds; what may be 0 often is."""
    model = draw(st.sampled_from(tracks.CATALOGUE))
    values = {}
    for name, quantity in quantities(model).items():
        least = 1 if quantity.above == 0 or name == "k_ballast" else (0 if quantity.at_least == 0 else -20)
        values[name] = Fraction(draw(st.integers(least, 40)), draw(st.sampled_from([1, 4])))
    return model(**values)
