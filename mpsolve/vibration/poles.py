"""Which roots lie to the right of a line below the cuts: certified, or by a search in floats; how far cuts are."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any

import numpy as np

from mpsolve.errors import InputError, PrecisionError
from mpsolve.numbers.arrays import Reals
from mpsolve.numbers.float64 import companions
from mpsolve.problem.cases import as_problem
from mpsolve.problem.problem import Problem
from mpsolve.problem.reduced import Reduced, reduce_problem
from mpsolve.proof.effort import Effort
from mpsolve.spectrum.regions import Below, HalfPlane, Sheet
from mpsolve.spectrum.spectrum import Spectrum
from mpsolve.spectrum.unfelt import unfelt_frequencies
from mpsolve.tracks.at_rest import lowest_cut
from mpsolve.vibration.image import Image
from mpsolve.vibration.residues import Pole
from mpsolve.vibration.search import count_zeros, find_zeros, number

_TOUCHING = 1e-9
"""Scaled: a root that is nearer to a cut has no residue of its own in float64."""
_SHARE = 0.94
"""Of the height of the lowest cut: how far up roots are looked for."""
_REACH, _WIDER, _FURTHER = 8.0, 16.0, 3
"""How far out roots are looked for, scaled; and so much further, so often."""
_LONG = 4000
"""Points of a path on which waves turn so often that it is followed no further."""
_AXIS = 1e-3
"""Scaled: only what grows faster is looked for where the cuts begin at the axis."""
_POINTS, _ROUNDS, _CLOSER = 600, 4, 30.0
_FURTHEST = 4096.0


@dataclass(frozen=True)
class Poles:
    """All roots with Re σ > floor that are known, σ scaled, Im σ ≥ 0; the image has no cut in Re σ > cut.

    Others may be among them, of the whole sheet between the cuts: those that ring on an undamped track are.
    complete: whether the search found as many as it counted. neutral: how often σ = 0 is a root.
    """

    poles: tuple[Pole, ...]
    floor: float
    cut: float
    neutral: int
    complete: bool

    @property
    def growth(self) -> float:
        return max((pole.sigma.real for pole in self.poles), default=0.0)


def require_own(problem: Problem, spectrum: object) -> None:
    """InputError unless the spectrum is one of the problem, or none is given."""
    if spectrum is not None and not isinstance(spectrum, Spectrum):
        raise InputError("spectrum", f"is of type {type(spectrum).__name__}: give certify(problem)")
    if spectrum is not None and as_problem(spectrum.problem) != problem:
        raise InputError("spectrum", "is that of another problem: give certify(problem)")


def certified(image: Image, spectrum: Spectrum) -> Poles:
    """The roots of a certified spectrum of the same problem."""
    rate = image.rate
    cut = lowest(image)
    region = spectrum.region
    floor = 0.0
    if isinstance(region, Below):
        floor = -float(region.height) / rate
    roots = [(complex(root.q.mid()), root.multiplicity) for root in spectrum.roots]
    poles = [Pole(1j * q / rate, times) for q, times in roots if q.real >= 0]
    reduced = reduce_problem(image.problem)
    poles += _unfelt(reduced, rate)
    if isinstance(region, Sheet):
        poles = [replace(pole, room=room(image, pole.sigma)) if pole.sigma.real <= cut else pole for pole in poles]
        kept = tuple(pole for pole in poles if pole.sigma and (pole.room is None or pole.room > _TOUCHING))
        return Poles(kept, cut, cut, reduced.neutral, spectrum.proved)
    whole = isinstance(region, (Below, HalfPlane, Sheet)) and spectrum.proved
    return Poles(_right_of(poles, max(floor, cut)), max(floor, cut), cut, reduced.neutral, whole)


def searched(problem: Problem, effort: Effort | None = None) -> Poles:
    """The roots that Newton's method finds, as many as the argument of Δ counts; kept for the next call."""
    return _searched(Image(problem, (), effort))


@lru_cache(maxsize=32)
def _searched(image: Image) -> Poles:
    reduced = reduce_problem(image.problem)
    cut = lowest(image)
    floor = _SHARE * cut if cut else _AXIS
    reach = _REACH * max(1.0, natural(image))
    count, path = count_zeros(image, floor, reach)
    for _ in range(_FURTHER):  # fast loads may shake a track at high frequencies
        reach *= _WIDER
        try:
            more, longer = count_zeros(image, floor, reach)
        except PrecisionError:
            break
        if len(longer) > _LONG:
            break
        if more > count:
            count, path = more, longer
    unfelt = _right_of(_unfelt(reduced, image.rate), floor)
    found = find_zeros(image, floor, count, path)
    return Poles((*unfelt, *found), floor, cut, reduced.neutral, number(found) == count)


def natural(image: Image) -> float:
    """The highest frequency of the vehicle on a rigid rail or free, scaled."""
    pencil = image.pencil
    M, K, B = (np.array(rows, float) for rows in (pencil.M, pencil.K, pencil.B))
    h = np.array(pencil.h, float)
    highest = 0.0
    for stiff in (K, K + (B[:, h > 0] / h[h > 0]) @ B[:, h > 0].T):
        heavy = np.diag(M) > 0
        if heavy.any():
            inner = np.linalg.lstsq(M[np.ix_(heavy, heavy)], stiff[np.ix_(heavy, heavy)], rcond=None)[0]
            highest = max(highest, float(np.sqrt(np.abs(np.linalg.eigvals(inner)).max())))
    return highest / image.rate


def lowest(image: Image) -> float:
    """Re σ of the lowest cut, scaled: none lies to the right."""
    return -float(lowest_cut(image.problem.track)[0]) / image.rate


def _unfelt(reduced: Reduced, rate: float) -> list[Pole]:
    roots = [1j * complex(q.mid()) / rate for q in unfelt_frequencies(reduced.parts) if q.real >= 0]
    return [Pole(complex(z.real, 0.0 if abs(z.imag) < 1e-12 * abs(z) else z.imag)) for z in roots]


def _right_of(poles: list[Pole], floor: float) -> tuple[Pole, ...]:
    return tuple(pole for pole in poles if pole.sigma.real > floor and pole.sigma)


def room(image: Image, sigma: complex) -> float:
    """The distance of σ from the nearest cut, scaled; nothing is proved by it."""
    guide = image.guide
    rows = np.zeros((max(i for i, _ in guide.D) + 1, max(j for _, j in guide.D) + 1))
    for (i, j), c in guide.D.items():
        rows[i, j] = float(c)
    low, high, best, at = 1e-9, 2.0, np.inf, 0.0
    while high < _FURTHEST:  # as far as waves of some branch are as slow as σ
        p = _grid(low, high)
        found = _distances(rows, p, sigma)
        if found.min() < best:
            best, at = float(found.min()), float(p[int(np.argmin(found))])
        low, high = high, 2 * high
    width = max(abs(at), 1.0) * 0.05
    for _ in range(_ROUNDS):
        p = at + np.linspace(-width, width, _POINTS)
        found = _distances(rows, p, sigma)
        best, at, width = min(best, float(found.min())), float(p[int(np.argmin(found))]), width / _CLOSER
    return best


def _grid(low: float, high: float) -> Reals:
    positive = np.linspace(low, high, _POINTS)
    return np.concatenate([-positive[::-1], positive])


def _distances(rows: Reals, p: Reals, sigma: complex) -> Any:
    """From σ to the nearest root of D(ip, ·) at each p."""
    powers = (1j * p[:, None]) ** np.arange(len(rows))
    D = powers @ rows
    lead = np.abs(D).max(1)
    degree = D.shape[1] - 1
    while degree and (np.abs(D[:, degree]) < 1e-14 * lead).all():
        degree -= 1
    companion = companions(D[:, : degree + 1])
    companion[~np.isfinite(companion).all((1, 2))] = np.nan_to_num(np.inf)
    return np.abs(np.linalg.eigvals(companion) - sigma).min(1)
