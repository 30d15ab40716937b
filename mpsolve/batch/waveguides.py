"""D and N of one kind of track as arrays over parameters: expanded exactly in the parameters, evaluated in float64.

The expansion cancels in exact numbers (a pad's stiffness squared, say), so that the floats lose nothing by it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from typing import Any

import numpy as np

from mpsolve.numbers.arrays import Reals
from mpsolve.numbers.several import Ring
from mpsolve.tracks.waveguide import Track, Waveguide, over_ring

Key = tuple[int, int]


@dataclass(frozen=True)
class Expanded:
    """A polynomial Σ c P^i s^j: for each (i, j) the terms of c, exponents of the parameters and their factors."""

    terms: dict[Key, tuple[tuple[tuple[int, ...], float], ...]]
    names: tuple[str, ...]

    def at(self, values: Mapping[str, Any], size: int) -> dict[Key, Reals]:
        """c for each (i, j) as arrays of this size; values: arrays, or numbers, by name."""
        out = {}
        for key, terms in self.terms.items():
            total = np.zeros(size)
            for exponents, factor in terms:
                term: Any = factor
                for name, power in zip(self.names, exponents, strict=True):
                    if power:
                        term = term * values[name] ** power
                total = total + term
            out[key] = total
        return out


def expanded(track: Track | Waveguide) -> tuple[Expanded, Expanded]:
    """D and N of the track with its parameters left open; a bare waveguide has none."""
    if isinstance(track, Track):
        return _of_kind(type(track), tuple(track.parameters))
    plain = [
        Expanded({key: (((), float(c)),) for key, c in polynomial.items()}, ())
        for polynomial in (track.waveguide.dispersion, track.waveguide.numerator)
    ]
    return plain[0], plain[1]


@lru_cache(maxsize=64)
def _of_kind(kind: type[Track], names: tuple[str, ...]) -> tuple[Expanded, Expanded]:
    ring = Ring(names, (Fraction(0),) * len(names))
    free = Waveguide(over_ring(kind, dict(zip(names, ring.variables, strict=True)), ring), kind.loaded)
    return _expanded(free.dispersion, ring), _expanded(free.numerator, ring)


def _expanded(polynomial: Any, ring: Ring) -> Expanded:
    terms = {key: tuple((e, float(x)) for e, x in ring.constant(c)) for key, c in polynomial.items()}
    return Expanded(terms, ring.names)
