"""Every track of the package is passive by its form; one that gives energy is not told to be."""

from __future__ import annotations

from fractions import Fraction
from typing import Annotated, Any

import numpy as np
import pytest

from mpsolve import tracks
from mpsolve.certificate import verify2 as v2
from mpsolve.numbers.model import Rational, nonnegative, positive, real
from mpsolve.tracks.structure import own_damping, passive_by_equations, passive_by_structure
from mpsolve.tracks.waveguide import Track, Waveguide

KINDS = [tracks.String, tracks.EulerBernoulli, tracks.Rayleigh, tracks.Timoshenko, tracks.TwoLayer, tracks.ThreeLayer,
         tracks.Slab, tracks.FloatingIce]  # fmt: skip


@pytest.mark.parametrize("kind", KINDS)
def test_all_are_passive(kind: type[Track]) -> None:
    assert passive_by_structure(kind)


class Pumped(Track, frozen=True):
    """A damper that pushes: c₂ stands with the wrong sign."""

    m: Annotated[Rational, positive("kg/m", "mass")]
    c: Annotated[Rational, nonnegative("N s/m²", "damping")]
    c2: Annotated[Rational, nonnegative("N s", "push")]

    @staticmethod
    def equations(x: Any) -> list[list[Any]]:
        return [[x.m * x.s**2 + x.c * x.s + x.c2 * x.s * x.P**2 - x.P**2 + 1]]


class Coupled(Track, frozen=True):
    """Two strings with dampers between them and a free number in the damping."""

    c: Annotated[Rational, real("N s/m²", "damping of any sign")]

    @staticmethod
    def equations(x: Any) -> list[list[Any]]:
        pad = x.c * x.s + 1
        return [[x.s**2 - x.P**2 + pad, -pad], [-pad, x.s**2 - x.P**2 + pad]]


class Skewed(Track, frozen=True):
    """Stiffnesses that do no work as a whole would need a symmetric matrix."""

    k: Annotated[Rational, positive("N/m²", "stiffness")]

    @staticmethod
    def equations(x: Any) -> list[list[Any]]:
        return [[x.s**2 - x.P**2 + x.k, x.k], [-x.k, x.s**2 + x.s + x.k]]


@pytest.mark.parametrize("kind", [Pumped, Coupled, Skewed])
def test_others_are_not_told_to_be(kind: type[Track]) -> None:
    assert not passive_by_structure(kind)


LAYERS: dict[str, Any] = {"EI": 4, "m": 1, "k_pad": 3, "m_sleeper": 2, "k_ballast": 5}


def test_the_damping_that_the_rail_has_of_its_own() -> None:
    assert own_damping(tracks.TwoLayer(**LAYERS, eta="0.5").waveguide) == (2, 4)  # EI η
    assert own_damping(tracks.TwoLayer(**LAYERS, eta="0.5", c_pad=1).waveguide) == (2, 4)
    assert own_damping(tracks.TwoLayer(**LAYERS, c_pad=1).waveguide) is None
    assert own_damping(tracks.Timoshenko(EI=1, m=1, S=1, J=1, c=1).waveguide) is None


def test_damping_that_is_shared_is_not_its_own() -> None:
    """Dampers that bend with the difference of two beams: without the rail's entry they would give energy."""
    P4, s = {(4, 1): Fraction(1)}, {(4, 0): Fraction(1), (0, 2): Fraction(1), (0, 0): Fraction(1)}
    less = {(4, 1): Fraction(-1)}
    shared = Waveguide(((s | P4, less), (less, s | P4)), 0)
    assert passive_by_equations(shared)
    assert own_damping(shared) is None
    more = Waveguide(((s | {(4, 1): Fraction(3)}, less), (less, s | P4)), 0)
    assert own_damping(more) is None  # all of it is more than its own


def test_an_odd_power_damps_nothing() -> None:
    """D = s²(1 + p²/4) + s + 1 + p⁴, N = 1: |N/D| = 1/|s| at resonance for all p, whatever s P³ in the entry says."""
    off = {(1, 1): Fraction(-1, 2), (2, 0): Fraction(1)}
    rail = {(0, 2): Fraction(1), (0, 1): Fraction(1), (0, 0): Fraction(1), (4, 0): Fraction(2), (3, 1): Fraction(-1)}
    guide = Waveguide(((rail, off), (off, {(0, 0): Fraction(1)})), 0)
    assert passive_by_equations(guide)
    assert own_damping(guide) is None
    terms = {(4, 0): "1", (0, 0): "1", (0, 1): "1", (0, 2): "1", (2, 2): "-1/4"}
    assert guide.dispersion == {key: Fraction(x) for key, x in terms.items()}
    rows = [[[[i, j, str(x)] for (i, j), x in entry.items()] for entry in row] for row in guide.matrix]
    track = v2.read_track({"matrix": rows, "loaded": 0}, "1")
    v2.check_passive(v2.RING, track.rows, ())
    assert v2.own_damping(track) is None


@pytest.mark.parametrize("name", ["two", "three"])
def test_the_receptance_in_wavenumber_is_bounded_by_it(name: str) -> None:
    track = (
        tracks.TwoLayer(**LAYERS, eta="0.5", c_pad="0.01")
        if name == "two"
        else tracks.ThreeLayer(**LAYERS, m_ballast=3, k_ground=1, shear=2, eta="0.5")
    )
    guide, rng = track.waveguide, np.random.default_rng(5)
    c, i = own_damping(guide) or (0, 0)
    for _ in range(500):
        p, s = np.exp(rng.normal(0, 2)), complex(rng.exponential(0.1) * (rng.uniform() < 0.7), rng.normal(0, 3))
        D, N = (sum(float(x) * (1j * p) ** a * s**b for (a, b), x in part.items())
                for part in (guide.dispersion, guide.numerator))  # fmt: skip
        assert abs(N / D) * abs(s) * float(c) * p**i <= 1 + 1e-9
