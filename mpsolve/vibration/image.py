"""The Laplace image of the motion in float64, on arrays of σ̂: bodies, contact forces and rail.

M ÿ + C ẏ + K y = g − B f, w = G f, Bᵀy − w + r = h f with the compressions f = −λ, irregularities r and outer forces
g: A(σ)(y, λ) = (g, −r) with A = [[S, −B], [Bᵀ, G + h]]. Time is scaled as in problem.reduced, lengths and forces are
in the units of the problem.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property, lru_cache
from typing import Any

import numpy as np

from mpsolve.characteristic.bordering import distances_of
from mpsolve.characteristic.floats import Floats, Receptance
from mpsolve.numbers.arrays import Complexes, Integers, Reals
from mpsolve.problem.problem import Problem
from mpsolve.problem.reduced import Guide, reduce_problem, track_guide
from mpsolve.proof.effort import Effort
from mpsolve.tracks.waveguide import Track, Waveguide
from mpsolve.vehicles.vehicle import Pencil


@dataclass(frozen=True)
class Image:
    """A problem, and the exact places where its rail is watched.

    Channels are all coordinates of the vehicles, the contact forces from rear to front, the rail at the places.
    effort counts the σ̂ at which the equations are set up.
    """

    problem: Problem
    places: tuple[Fraction, ...]
    effort: Effort | None = field(default=None, compare=False, repr=False)

    @cached_property
    def pencil(self) -> Pencil:
        return self.problem.pencil

    @cached_property
    def guide(self) -> Guide:
        return self.receptance.guide

    @cached_property
    def receptance(self) -> Receptance:
        return _receptance(self.problem.track, self.problem.v)

    @property
    def rate(self) -> float:
        """σ = rate · σ̂, t̂ = rate · t."""
        return 2.0**-self.guide.time

    @property
    def channels(self) -> int:
        return self.size + self.contacts + len(self.places)

    @property
    def size(self) -> int:
        return self.pencil.size

    @property
    def contacts(self) -> int:
        return self.pencil.contacts

    @cached_property
    def _distances(self) -> tuple[tuple[Fraction, ...], Integers, Integers]:
        """Different distances, scaled; the number of that between each two contacts, and from places to contacts."""
        unit = Fraction(2) ** self.guide.length
        at, seen = ([x / unit for x in places] for places in (self.pencil.places, self.places))
        distances, rows = distances_of([*at, *seen], at)
        which = np.array(rows, int)
        return distances, which[: len(at)], which[len(at) :]

    @cached_property
    def _scaled(self) -> tuple[list[Reals], Reals, Reals, Reals, float]:
        """S₀, S₁, S₂, B, h with the bodies in units d: y = g d ŷ."""
        pencil, g = self.pencil, float(self.guide.g)
        K, C, M = (np.array(rows, float) for rows in (pencil.K, pencil.C, pencil.M))
        S = [rows * g * self.rate**k for k, rows in enumerate((K, C, M))]
        size = sum(np.abs(np.diag(rows)) for rows in S)
        d = np.exp2(-np.round(np.log2(np.where(size > 0, size, 1.0)) / 2))
        S = [d[:, None] * rows * d for rows in S]
        return S, d[:, None] * np.array(pencil.B, float), np.array(pencil.h, float) / g, d, g

    def matrices(self, sigma: Any) -> tuple[Complexes, Complexes]:
        """A(σ̂) of scaled bodies and contact forces, and Ĝ from the places to the contacts."""
        self.spend(len(sigma))
        S, B, h, _, _ = self._scaled
        distances, among, seen = self._distances
        n, m = self.size, self.contacts
        G = np.array(self.receptance(sigma, distances, slope=False)[0])
        A = np.zeros((len(sigma), n + m, n + m), complex)
        s = sigma[:, None, None]
        A[:, :n, :n] = S[0] + s * (S[1] + s * S[2])
        A[:, :n, n:], A[:, n:, :n] = -B, B.T
        A[:, n:, n:] = np.moveaxis(G[among], -1, 0) + np.diag(h)
        return A, np.moveaxis(G[seen], -1, 0)

    def column(self, force: Reals, irregularity: Any) -> Reals:
        """What stands on the right of A for forces on the coordinates and irregularities under the contacts."""
        _, _, _, d, g = self._scaled
        return np.concatenate([d * force, -np.asarray(irregularity) / g])

    def solve(self, sigma: Any, right: Any) -> Complexes:
        """The channels, shape (len(σ), channels), for `right` (len(σ), bodies + contacts)."""
        _, _, _, d, g = self._scaled
        A, seen = self.matrices(sigma)
        x = np.linalg.solve(A, np.asarray(right, complex)[..., None])[..., 0]
        n = self.size
        f = -x[:, n:]
        rail = g * (seen @ f[..., None])[..., 0]
        return np.concatenate([g * d * x[:, :n], f, rail], 1)

    @cached_property
    def felt(self) -> Floats:
        """Δ̂, without the motions that no contact feels."""
        return Floats(reduce_problem(self.problem))

    def phase(self, sigma: Any) -> Any:
        """Δ̂/|Δ̂|."""
        self.spend(len(sigma))
        return np.linalg.slogdet(self.felt.matrix(sigma))[0]

    def step(self, sigma: Any, known: Any) -> Any:
        """Newton's step to a zero of Δ̂, the known ones and their mirror images divided out."""
        self.spend(len(sigma))
        return self.felt.step(sigma, [*known, *(np.conj(z) for z in known if z.imag)])

    def spend(self, evaluations: int) -> None:
        """EffortError where the effort is spent."""
        if self.effort is not None:
            self.effort.spend(evaluations)


@lru_cache(maxsize=32)
def _receptance(track: Track | Waveguide, velocity: Fraction) -> Receptance:
    """Kept for the next call."""
    return Receptance(track_guide(track, velocity))
