"""Candidates: where roots of Δ may be, by Newton's method in float64 from many points at once. Heuristic.

Nothing here is a proof: a `Candidate` becomes a root only in enclose.py, and whether all were found is
decided by the count in winding.py.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.fields import Float64
from mpsolve.model.branch import track
from mpsolve.model.characteristic import characteristic_rate
from mpsolve.model.limits import branch_points
from mpsolve.problem.case import Case

_STEPS = 30
_GRID = 200  # points along Re q, times the effort
_SMALLEST = 0.02  # smaller roots than this are looked for about 0


@dataclass(frozen=True)
class Candidate:
    """An approximate root in the half-plane Re q ≥ 0, and the size of the last Newton step there."""

    q: complex
    step: float


def seek(case: Case, radius: float, effort: int = 1) -> list[Candidate]:
    """Approximate roots with Re q ≥ 0 and |q − iη_b| < radius, sorted by modulus.

    `effort` (1, 2, …) multiplies the starting points.
    """
    model = track(case, Float64())
    around = branch_points(case) if case.cuts_on_line else []
    q = _starting_points(radius, around, effort) + 1j * model.eta_b
    if _least(model) < _SMALLEST:
        q = np.concatenate([q, _heavy(_least(model), effort)])
    if effort > 1 and case.cuts_on_line:
        q = np.concatenate([q, _along_the_cut(model.positions, around[0], effort) + 1j * model.eta_b])
    found = _reached(model, q, radius)
    if effort > 1 and found:  # many roots lie like beads on a few strings: look between those that were found
        between = _reached(model, _between(found, model.eta_b, effort), radius)
        found = _distinct(*(np.array([getattr(c, name) for c in [*found, *between]]) for name in ("q", "step")))
    return found


def _reached(model: Any, q: Any, radius: float) -> list[Candidate]:
    """Where Newton's method leads from the points q, without repetitions."""
    step = np.full(q.shape, np.inf)
    active = np.ones(q.shape, dtype=bool)
    with np.errstate(all="ignore"):
        for _ in range(_STEPS):
            move = _newton_step(model, q[active])
            q[active] += move
            step[active] = np.abs(move)
            active &= (step > 1e-14 * np.abs(q)) & (np.abs(q) < 4 * radius) & np.isfinite(q)
            if not active.any():
                break
    good = (step < 1e-9 * np.abs(q)) & (np.abs(q - 1j * model.eta_b) < radius) & (np.abs(q) > 1e-12 * _least(model))
    return _distinct(q[good], step[good])


def _newton_step(model: Any, q: Any) -> Any:
    value, slope = characteristic_rate(model, q)
    move = -value / slope
    size = np.abs(move)
    bound = 0.3 * np.abs(q) + 0.02  # a step of Newton's method far from a root is no more than a direction
    return move * np.minimum(1, bound / np.where(size > 0, size, 1))


def _starting_points(radius: float, around: list[float], effort: int) -> Any:
    """Polar grids in the right half-plane of r: about 0, dense towards both sides of the cut, and about the
    branch points, next to which light masses have their roots (at a distance like η_M²)."""
    moduli = np.geomspace(0.01, max(radius, 1.0), 12 * effort)
    turn = np.linspace(0, 1, 6 * effort + 1)[1:] ** 1.7 * np.pi / 2
    grids = [np.outer(moduli, np.exp(1j * np.concatenate([-turn[::-1], turn])))]
    near = np.geomspace(1e-13, 0.3, 10 * effort)
    spokes = np.exp(1j * np.pi * (np.arange(6 * effort) + 0.5) / (3 * effort))
    grids += [r * (1 + np.outer(near, spokes)) for r in around if r > 0]
    return np.concatenate([grid.ravel() for grid in grids])


def _least(model: Any) -> float:
    """The size of the smallest roots: a heavy mass swings on the stiffness of the beam, q² ~ 1/η."""
    return min(1.0, 1 / math.sqrt(sum(float(eta) for eta in model.eta_m)))


def _heavy(size: float, effort: int) -> Any:
    """Points about 0 of the size of the smallest roots."""
    moduli = np.geomspace(0.1 * size, 10 * size, 8 * effort)
    return np.outer(moduli, np.exp(1j * np.linspace(-1.5, 1.5, 8 * effort + 1))).ravel()


def _between(found: list[Candidate], eta_b: float, effort: int) -> Any:
    """A grid over the part of the plane in which roots were found, denser towards the line of the cuts."""
    q = np.array([c.q for c in found])
    along = np.linspace(0, 1.2 * float(q.real.max()), _GRID * effort)
    low, high = min(float(q.imag.min()) - eta_b, -0.1), max(float(q.imag.max()) - eta_b, 0.1)
    heights = eta_b + np.outer([low, high], [1.0, 0.4, 0.15, 0.05, 0.015]).ravel()
    return (along[:, None] + 1j * heights).ravel()


def _along_the_cut(positions: Any, start: float, effort: int) -> Any:
    """Points close to the cut on both sides: masses far apart have a root there for each half wave between them."""
    span = max(positions[-1] - positions[0], 1.0)
    along = np.linspace(0, 2, int(4 * effort * span) + 1)[1:] ** 2  # √(r − q_lm) goes with the wave number
    heights = np.array([0.1, 0.01, 0.001]) * np.minimum(along, 1)[:, None]
    return (start + along[:, None] + 1j * np.concatenate([-heights, heights], axis=1)).ravel()


def _distinct(q: Any, step: Any) -> list[Candidate]:
    found: list[Candidate] = []
    folded = np.where(q.real < -1e-10 * np.abs(q), -q.conj(), q)
    for k in np.argsort(step):
        z = complex(folded[k])
        if all(abs(z - other.q) > 1e-8 * abs(z) for other in found):
            found.append(Candidate(z, float(step[k])))
    return sorted(found, key=lambda c: abs(c.q))
