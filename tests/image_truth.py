"""The third way: the Laplace image of a problem's motion by mpmath, inverted by de Hoog's method at single times.

The equations M ÿ + C ẏ + K y = g − B f, w = G f, Bᵀy − w = h f are solved as they stand, with p-roots of the scaled
track from mpmath: nothing of the package's formulas, paths, panels or residues is used.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import mpmath
import numpy as np
from receptance_truth import Receptance

from mpsolve.problem.problem import Problem
from mpsolve.problem.reduced import track_guide


class Image:
    """Of constant forces g on the coordinates and sin waves: g(t) = Σ direction (c + a sin(ωt + φ))."""

    def __init__(
        self, problem: Problem, terms: list[tuple[Any, float, float, float, float]], places: list[Any]
    ) -> None:
        self.pencil, self.terms, self.places = problem.pencil, terms, places
        self.truth = Receptance(track_guide(problem.track, problem.v), 25)
        self.guide = track_guide(problem.track, problem.v)

    def at(self, sigma: Any) -> Any:
        """Coordinates, contact forces, rail at the places; mpmath column."""
        mp, pencil = self.truth.mp, self.pencil
        n, m = pencil.size, pencil.contacts
        number = self.truth.number
        scaled = mp.mpc(sigma) * mp.mpf(2) ** self.guide.time
        unit, g = Fraction(2) ** self.guide.length, number(self.guide.g)
        known: dict[Fraction, Any] = {}

        def G(xi: Fraction) -> Any:
            if xi not in known:
                known[xi] = g * self.truth.value(xi / unit, scaled)
            return known[xi]

        A = mp.zeros(n + m, n + m)
        right = mp.zeros(n + m, 1)
        for i in range(n):
            for j in range(n):
                A[i, j] = number(pencil.K[i][j]) + sigma * (number(pencil.C[i][j]) + sigma * number(pencil.M[i][j]))
            for j in range(m):
                A[i, n + j] = A[n + j, i] = number(pencil.B[i][j])
            for direction, c, a, omega, phase in self.terms:
                wave = a * (omega * mp.cos(phase) + sigma * mp.sin(phase)) / (sigma**2 + mp.mpf(omega) ** 2)
                right[i] += mp.mpf(float(direction[i])) * (c / sigma + wave)
        for i in range(m):
            for j in range(m):
                A[n + i, n + j] = -G(pencil.places[i] - pencil.places[j]) - (number(pencil.h[i]) if i == j else 0)
        x = mp.lu_solve(A, right)
        rail = [sum(G(Fraction(at) - pencil.places[j]) * x[n + j] for j in range(m)) for at in self.places]
        return [*x, *rail]

    def inverted(self, t: float, degree: int = 30) -> Any:
        """All of them at one time."""
        size = self.pencil.size + self.pencil.contacts + len(self.places)
        kept: dict[Any, Any] = {}

        def image(sigma: Any, k: int) -> Any:
            key = complex(sigma)
            if key not in kept:
                kept[key] = self.at(sigma)
            return kept[key][k]

        return np.array(
            [
                float(mpmath.invertlaplace(lambda s, k=k: image(s, k), t, method="dehoog", degree=degree))
                for k in range(size)
            ]
        )
