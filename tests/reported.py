"""Problems of several kinds, certified once, and written by hand where a kind is hard to meet."""

from __future__ import annotations

from fractions import Fraction
from functools import cache

from mpsolve import Problem, Spectrum, certify
from mpsolve.spectrum.regions import HalfPlane
from mpsolve.tracks import EulerBernoulli, String, TwoLayer
from mpsolve.vehicles import Mass, Oscillator

WIRE = Problem(String(T=27_000, m="1.07", k=500, c=2), [Mass("8.5")], v=100)
BALLAST = {"k_pad": "300e6", "c_pad": "3e4", "m_sleeper": 250, "k_ballast": "100e6", "c_ballast": "8e4"}
FAST = Problem(TwoLayer(EI="6380430", m="60.2", **BALLAST), [Mass(900)], v=1420)
SPRUNG = Problem(
    EulerBernoulli(EI="6.4e6", m=60, k="1e6", c=770), [Oscillator(wheel=1000, body=5000, k="1e6", c="1e4")], v=60
)


@cache
def wire() -> Spectrum:
    """Stable, below a height."""
    return certify(WIRE, digits=20, check=False)


@cache
def fast() -> Spectrum:
    """Unstable."""
    return certify(FAST, region="unstable", digits=20, check=False)


def without_theorem(unstable: int = 0) -> Spectrum:
    """An answer in a half-disc."""
    region = HalfPlane(Fraction(1000))
    note = "no passivity beyond a frequency"
    return Spectrum(WIRE, region, 15, wire().status, count=unstable, unstable=unstable, note=note)
