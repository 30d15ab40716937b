"""Moving tracks with their places for the tests of passivity, and their receptances by residue sums."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np

from mpsolve import Problem, tracks, vehicles
from mpsolve.characteristic.floats import Receptance
from mpsolve.passivity.envelope import Envelope
from mpsolve.passivity.subject import Subject
from mpsolve.problem.family import Family, family_of
from mpsolve.problem.reduced import Guide, Reduced, reduce_problem

RAIL = tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c="770")
TWO = tracks.TwoLayer(
    EI="6.38e6", m="60.2", k_pad="300e6", c_pad="3e4", m_sleeper="250", k_ballast="100e6", c_ballast="8e4"
)
TRACKS: dict[str, tuple[Any, int]] = {
    "rail": (RAIL, 150),
    "rail, fast": (RAIL, 260),
    "kelvin-voigt": (tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", eta="1e-4"), 150),
    "string": (tracks.String(T=27000, m="1.07", k=500, c=2), 100),
    "timoshenko": (tracks.Timoshenko(EI="6.38e6", m="60.2", S="2.4e8", J="0.24", k="1e6", c="770"), 300),
    "two layers": (TWO, 900),
    "two layers, only the rail damped": (
        tracks.TwoLayer(EI="6.38e6", m="60.2", k_pad="300e6", m_sleeper="250", k_ballast="100e6", eta="1e-4"),
        100,
    ),
    "slab": (
        tracks.Slab(EI="6.4e6", m=60, k_pad="4e7", c_pad="1e4", EI_slab="1e8", m_slab=2000, k="5e7", c="5e4"),
        120,
    ),
}


def problem(name: str, count: int = 2, gap: str = "2.5") -> Problem:
    track, v = TRACKS[name]
    return Problem(track, [vehicles.Mass(900).at(str(float(gap) * k)) for k in range(count)], v=v)


def reduced_and_envelope(name: str, count: int = 2) -> tuple[Reduced, Envelope]:
    reduced = reduce_problem(problem(name, count))
    return reduced, Envelope(Subject.of_reduced(reduced), (), ())


def family_and_envelope(problem: Problem, over: dict[str, tuple[Any, Any]]) -> tuple[Family, Envelope]:
    family = family_of(problem, {path: (Fraction(a), Fraction(b)) for path, (a, b) in over.items()})
    low, high = (tuple(float(ends[k]) for ends in family.box) for k in (0, 1))
    return family, Envelope(Subject.of_family(family), low, high)


def least(guide: Guide, places: Any, q: Any) -> Any:
    """The least eigenvalue of −Im G(q), over the largest, in floats."""
    receptance = Receptance(guide)
    n = len(places)
    G = np.empty((len(q), n, n), complex)
    for i in range(n):
        for j in range(n):
            G[:, i, j] = receptance(1j * q, [places[i] - places[j]], False)[0][0]
    values = np.linalg.eigvalsh(-(G - np.swapaxes(G.conj(), 1, 2)) / 2j)
    return values[:, 0] / np.abs(values).max(1)
