"""Newmark's average acceleration for the coupled equations (41)–(45) and for the rearranged ones (46)–(55): a truth.

Second order, for comparison: both forms give the same numbers, at O(modes³) and at O(masses · modes) a step.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np


@dataclass(frozen=True)
class Beam:
    """A simply supported beam of dimensionless `length`, in so many modes, under masses of velocity `alpha`.

    eta_m, places (n,): the masses, from the left support at τ = 0. force(τ) (n,): 2η_C + 2η_A sin(ω̂τ + φ).
    """

    length: float
    count: int
    alpha: float
    axial: float
    eta_b: float
    eta_m: Any
    places: Any
    force: Callable[[float], Any]

    def stiffness(self, k: Any) -> Any:
        """ω² of the wavenumber k; positive for N < 1."""
        return k**4 / 4 - self.axial * k**2 + 1


def newmark(beam: Beam, duration: float, steps: int, *, coupled: bool) -> Any:
    """Deflections of the masses at the ends of `steps` equal steps, (n, steps + 1), from rest; float64.

    coupled: solve for all modes at once, as (41) stands, at O(modes³) a step; otherwise for one contact force a mass,
    the modes being diagonal.
    """
    k = np.arange(1, beam.count + 1) * (np.pi / beam.length)
    stiffness, h = beam.stiffness(k), duration / steps
    solve = _coupled if coupled else _rearranged
    a, rate, acceleration = np.zeros((3, beam.count))
    found = np.zeros((len(beam.eta_m), steps + 1))
    for step in range(steps + 1):
        tau = step * h
        angle = np.multiply.outer(beam.places + beam.alpha * tau, k)
        shape, slope = np.sin(angle), beam.alpha * k * np.cos(angle)
        curve = -((beam.alpha * k) ** 2) * shape
        ahead = h / 2 if step else 0.0  # at τ = 0 the equations give the acceleration that a and rate = 0 need
        a = a + 2 * ahead * rate + ahead**2 * acceleration
        rate = rate + ahead * acceleration
        # a = a + ahead² acceleration and rate = rate + ahead acceleration at the new time
        diagonal = 1 + 2 * beam.eta_b * ahead + stiffness * ahead**2
        restoring = 2 * beam.eta_b * rate + stiffness * a
        moving = shape + 2 * ahead * slope + ahead**2 * curve  # of w0_ττ in the acceleration, (3) to (6)
        known = beam.force(tau) - beam.eta_m * (2 * slope @ rate + curve @ a)
        acceleration = solve(diagonal, 2 / beam.length * shape, beam.eta_m[:, None] * moving, restoring, known)
        a = a + ahead**2 * acceleration
        rate = rate + ahead * acceleration
        found[:, step] = shape @ a
    return found


def _coupled(diagonal: Any, shape: Any, inertia: Any, restoring: Any, known: Any) -> Any:
    """(41): [diagonal + shapeᵀ inertia] a_ττ = shapeᵀ known − restoring."""
    return np.linalg.solve(np.diag(diagonal) + shape.T @ inertia, shape.T @ known - restoring)


def _rearranged(diagonal: Any, shape: Any, inertia: Any, restoring: Any, known: Any) -> Any:
    """(52): diagonal · a_ττ − shapeᵀ f = −restoring and inertia a_ττ + f = known; the f by their Schur complement."""
    free = -restoring / diagonal
    answer = inertia @ (shape / diagonal).T
    force = np.linalg.solve(np.eye(len(known)) + answer, known - inertia @ free)
    return free + force @ shape / diagonal
