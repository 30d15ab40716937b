"""What passivity is asked of: a moving track and the places of its contacts, with parameters left free.

All is scaled as in `Guide`; the free parameters are variables, each polynomial in them a {powers: coefficient}.

Wavenumbers are cut into cells that are fine near the waves of the track, in floats; nothing rests on the choice.
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
from mpsolve.numbers.float64 import companions
from mpsolve.numbers.several import plus
from mpsolve.passivity.power import Power, coefficient
from mpsolve.problem.reduced import Guide, Reduced
from mpsolve.tracks.passive import passivity
from mpsolve.tracks.structure import passive_by_structure
from mpsolve.tracks.waveguide import Track, carried

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


_REACH = 12.0  # of the cells, in the largest wavenumber that counts
_FAR = 100.0  # times the median: a root that is as good as infinite
_LEAST = 1e-6  # of the reach: the width that is given to a wave without damping


def cells(subject: Subject, q: Any, x: Reals, spread: Reals, side: int) -> Reals:
    """The ends of cells of wavenumber, ascending, shape (boxes, ends), for q and the parameters at points.

    spread: by how much q and the parameters vary about them, relative: cells need not be finer than what that blurs.
    side: the number of cells on each side of a wave.
    """
    v = floats_of(subject.v.items(), x)
    roots = wavenumbers(subject, q, v, x)
    size = np.abs(roots)
    size = np.where(size < _FAR * np.median(size, axis=1)[:, None], size, 0)
    reach = _REACH * np.maximum(size.max(1), 1e-6)
    width = np.maximum(np.abs(roots.imag), (np.abs(roots.real) * spread[:, None] + _LEAST * reach[:, None]) / 2)
    steps = np.sinh(
        np.linspace(-1, 1, 2 * side + 1)[None, None, :] * np.arcsinh(2 * reach[:, None] / width)[..., None]
    )
    ends = (roots.real[:, :, None] + width[:, :, None] * steps).reshape(len(q), -1)
    with np.errstate(all="ignore"):
        turn = np.where(v > 0, q / v, reach)
    ends = np.concatenate([ends, -reach[:, None], reach[:, None], turn[:, None]], axis=1)
    return np.sort(np.clip(ends, -reach[:, None], reach[:, None]), axis=1)


def wavenumbers(subject: Subject, q: Any, v: Reals, x: Reals) -> Any:
    """The roots p of D(ip, i(q − vp)), shape (boxes, degree)."""
    rows = subject.rows
    degree = max(i + j for i, j in rows)
    D = np.zeros((len(q), degree + 1), complex)
    turned = {(i, j): floats_of(terms, x) * 1j ** (i + j) for (i, j), terms in rows.items()}
    for (i, j), c in carried(turned, v).items():
        D[:, i] += c * q**j
    used = np.flatnonzero(np.abs(D).max(0) > 0)
    D, powers = D[:, : used[-1] + 1], np.arange(used[-1] + 1)
    with np.errstate(all="ignore"):  # in units of about the least root, so that no coefficient is lost beside others
        unit = np.nanmin((np.abs(D[:, :1] / D[:, 1:])) ** (1 / powers[1:]), axis=1, initial=np.inf)
    unit = np.where(np.isfinite(unit) & (unit > 0), unit, 1.0)[:, None]
    D = D * unit**powers
    least = 1e-12 * np.abs(D).max(1)
    D[:, -1] = np.where(np.abs(D[:, -1]) > least, D[:, -1], least)
    C = companions(D)
    return np.linalg.eigvals(np.where(np.isfinite(C), C, 0)) * unit
