"""What passivity is asked of: a moving track and the places of its contacts, with parameters left free.

All is scaled as in `Guide`; the free parameters are variables, each polynomial in them a {powers: coefficient}.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, Any

import numpy as np

from mpsolve.errors import PrecisionError
from mpsolve.numbers.affine import Affine, between
from mpsolve.numbers.arrays import Integers, Reals
from mpsolve.numbers.several import plus
from mpsolve.passivity.power import Power, coefficient
from mpsolve.problem.reduced import Guide, Reduced
from mpsolve.tracks.passive import passivity
from mpsolve.tracks.structure import passive_by_structure
from mpsolve.tracks.waveguide import Track

if TYPE_CHECKING:
    from mpsolve.problem.family import Family

Free = Mapping[tuple[int, ...], Fraction]
"""A polynomial in the free parameters."""


@dataclass(frozen=True)
class Subject:
    """power: that of the track at rest; D: its dispersion in P, s and the parameters; v and places as polynomials.

    own: as in `Guide`, where the track has no free parameters.
    """

    power: Power
    D: Mapping[tuple[int, ...], Fraction]
    v: Free
    places: tuple[Free, ...]
    own: tuple[Fraction, int] | None = None

    @staticmethod
    def of_guide(guide: Guide, places: Sequence[Fraction] = (Fraction(0),), free_velocity: bool = False) -> Subject:
        """A track without free parameters, or with the velocity as the only one (in units of `Guide.v`)."""
        names = ("v",) if free_velocity else ()
        D, N = ({(*key, *[0] * len(names)): c for key, c in a.items()} for a in (guide.D_rest, guide.N_rest))
        v: Free = {(1,): Fraction(1)} if free_velocity else {(): guide.v}
        return Subject(Power.of(D, N, names), D, v, tuple({(0,) * len(names): x} for x in places), guide.own)

    @staticmethod
    def of_reduced(reduced: Reduced) -> Subject:
        return Subject.of_guide(reduced.guide, reduced.places)

    @staticmethod
    def of_family(family: Family) -> Subject:
        """The family's track, velocity and places; its parameters x̂ in its order.

        PrecisionError where the track is not known to be passive at rest for all parameters: by the form of its
        equations, or exactly where its own parameters are fixed.
        """
        track = family.problem.track
        fixed = not _is_free(family)
        if not (
            passivity(track).passive if fixed else isinstance(track, Track) and passive_by_structure(type(track))
        ):
            raise PrecisionError("the track is not known to take energy at rest for all these parameters")
        D, N = (
            {(*key, *powers): c for key, row in a.items() for powers, c in row}
            for a in (family.D_rest, family.N_rest)
        )
        return Subject(Power.of(D, N, family.paths), D, dict(family.v), tuple(dict(place) for place in family.places))

    @property
    def rows(self) -> dict[tuple[int, int], list[tuple[tuple[int, ...], Fraction]]]:
        """For each P^i s^j of D its coefficient, a polynomial in the parameters."""
        out: dict[tuple[int, int], list[tuple[tuple[int, ...], Fraction]]] = {}
        for (i, j, *powers), c in self.D.items():
            out.setdefault((i, j), []).append((tuple(powers), c))
        return out

    @property
    def names(self) -> tuple[str, ...]:
        return self.power.names

    def parameters(self, low: Reals, high: Reals) -> list[Affine]:
        """The parameters over boxes: arrays of shape (boxes, parameters) → forms of shape (boxes, 1)."""
        return [between(low[:, k : k + 1], high[:, k : k + 1], name) for k, name in enumerate(self.names)]

    def speed(self, parameters: Sequence[Affine]) -> Affine:
        return coefficient(self.v.items(), parameters)

    def distances(self, parameters: Sequence[Affine]) -> tuple[list[Affine], Integers]:
        """The different ξ_i − ξ_j, i > j, over the boxes, and the number of each; −1 on and above the diagonal."""
        n = len(self.places)
        number = np.full((n, n), -1)
        kept: dict[Any, int] = {}
        for i in range(n):
            for j in range(i):
                key = frozenset(plus(self.places[i], {key: -c for key, c in self.places[j].items()}).items())
                number[i, j] = kept.setdefault(key, len(kept))
        return [coefficient(key, parameters) for key in kept], number


def _is_free(family: Family) -> bool:
    """Whether a parameter of the track at rest is left free."""
    return any(any(powers) for a in (family.D_rest, family.N_rest) for row in a.values() for powers, _ in row)


def floats_of(terms: Iterable[tuple[tuple[int, ...], Fraction]], x: Reals) -> Reals:
    """A polynomial in the parameters at points x (points, parameters), in floats."""
    total = np.zeros(len(x))
    for powers, c in terms:
        total = total + float(c) * np.prod(x ** np.array(powers, int), axis=1)
    return total
