"""Every track of the package is passive by its form; one that gives energy is not told to be."""

from __future__ import annotations

from typing import Annotated, Any

import pytest

from mpsolve import tracks
from mpsolve.numbers.model import Rational, nonnegative, positive, real
from mpsolve.tracks.structure import passive_by_structure
from mpsolve.tracks.waveguide import Track

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
