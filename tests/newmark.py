"""Newmark's average acceleration for the coupled equations (41)–(45) and for the rearranged ones (46)–(55): a truth.

Second order, for comparison: both forms give the same numbers, at O(modes³) and at O(masses · modes) a step.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np

from mpsolve.finite.beam.figures import Problem
from mpsolve.finite.beam.march import Loading
from mpsolve.finite.beam.modes import Beam
from mpsolve.numbers.exact import Number
from mpsolve.problem.case import Case
from mpsolve.problem.load import loads_of
from mpsolve.problem.physical import PhysicalCase
from mpsolve.vehicles.load import Load


def coupled_beam(
    case: Case | PhysicalCase,
    loads: Iterable[Load] | None = None,
    tau: Number = 10,
    *,
    start: float,
    length: float,
    modes: int,
    steps: int,
) -> tuple[Any, Any]:
    """The plain coupled form (41) on a beam with these figures, for comparison with `finite_beam`; float64.

    The times (steps + 1,) from 0 to tau and the deflections of the masses there (n, steps + 1), in w_st. Costs
    O(modes³) a step. loads and units as for `finite_beam`. Raises InputError for a beam that the masses would leave.
    """
    forces = loads_of(case, loads)
    whole = case.dimensionless if isinstance(case, PhysicalCase) else case
    problem = Problem(whole, forces, tau, (), 1e-4)
    figures = problem.first_figures(start, length)
    modes, steps = problem.checked_modes(modes, figures.length), problem.checked_steps(steps)
    beam = Beam(figures.length, modes, problem.alpha, problem.axial, problem.eta_b, tail=False)
    loading = Loading(problem.eta_m, figures.start + problem.gaps, problem.applied)
    return np.linspace(0.0, problem.duration, steps + 1), newmark(
        beam, loading, problem.duration, steps, coupled=True
    )


def newmark(beam: Beam, loading: Loading, duration: float, steps: int, *, coupled: bool) -> Any:
    """Deflections of the masses at the ends of `steps` equal steps, (n, steps + 1), from rest; float64.

    The modes beyond beam.count are left out whatever beam.tail says. coupled: solve for all modes at once, as (41)
    stands; otherwise for one contact force a mass, the modes being diagonal.
    """
    k = np.arange(1, beam.count + 1) * (np.pi / beam.length)
    stiffness, h = beam.stiffness(k), duration / steps
    solve = _coupled if coupled else _rearranged
    a, rate, acceleration = np.zeros((3, beam.count))
    found = np.zeros((len(loading.eta_m), steps + 1))
    for step in range(steps + 1):
        tau = step * h
        angle = np.multiply.outer(loading.places + beam.alpha * tau, k)
        shape, slope = np.sin(angle), beam.alpha * k * np.cos(angle)
        curve = -((beam.alpha * k) ** 2) * shape
        ahead = h / 2 if step else 0.0  # at τ = 0 the equations give the acceleration that a and rate = 0 need
        a = a + 2 * ahead * rate + ahead**2 * acceleration
        rate = rate + ahead * acceleration
        # a = a + ahead² acceleration and rate = rate + ahead acceleration at the new time
        diagonal = 1 + 2 * beam.eta_b * ahead + stiffness * ahead**2
        restoring = 2 * beam.eta_b * rate + stiffness * a
        moving = shape + 2 * ahead * slope + ahead**2 * curve  # of w0_ττ in the acceleration, (3) to (6)
        known = loading.force(tau) - loading.eta_m * (2 * slope @ rate + curve @ a)
        acceleration = solve(diagonal, 2 / beam.length * shape, loading.eta_m[:, None] * moving, restoring, known)
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
