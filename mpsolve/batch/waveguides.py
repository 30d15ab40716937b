"""D and N of one kind of track as arrays over parameters: expanded exactly in the parameters, evaluated in float64.

The expansion cancels in exact numbers (a pad's stiffness squared, say), so that the floats lose nothing by it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np

from mpsolve.tracks.waveguide import Track, Waveguide, symbolic

Key = tuple[int, int]


@dataclass(frozen=True)
class Expanded:
    """A polynomial Σ c P^i s^j: for each (i, j) the terms of c, exponents of the parameters and their factors."""

    terms: dict[Key, tuple[tuple[tuple[int, ...], float], ...]]
    names: tuple[str, ...]

    def at(self, values: Mapping[str, Any], size: int) -> dict[Key, Any]:
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
    rows = symbolic(kind, names)
    kept = [k for k in range(len(rows)) if k != kind.loaded]
    return _sorted(_determinant(rows), names), _sorted(
        _determinant([[rows[i][j] for j in kept] for i in kept]), names
    )


def _determinant(rows: Any) -> Any:
    if not rows:
        return None
    if len(rows) == 1:
        return rows[0][0]
    minors = [[[row[k] for k in range(len(row)) if k != j] for row in rows[1:]] for j in range(len(rows))]
    return sum((-1) ** j * rows[0][j] * _determinant(minors[j]) for j in range(len(rows)))


def _sorted(polynomial: Any, names: tuple[str, ...]) -> Expanded:
    if polynomial is None:
        return Expanded({(0, 0): (((0,) * len(names), 1.0),)}, names)
    out: dict[Key, list[tuple[tuple[int, ...], float]]] = {}
    for monomial, c in polynomial.to_dict().items():
        i, j, *exponents = (int(x) for x in monomial)
        out.setdefault((i, j), []).append((tuple(exponents), int(c.p) / int(c.q)))
    return Expanded({key: tuple(terms) for key, terms in out.items()}, names)
