"""Candidates: where roots of Δ may be, by Newton's method in float64 from many points at once. Heuristic.

Nothing here is a proof: a `Candidate` becomes a root only in enclose.py, and whether all were found is
decided by the count in winding.py.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.fields import Float64
from mpsolve.model.branch import track
from mpsolve.model.characteristic import characteristic_rate
from mpsolve.model.limits import branch_points
from mpsolve.model.parameters import Case

_STEPS = 30


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
    if effort > 1 and case.cuts_on_line:
        q = np.concatenate([q, _along_the_cut(model.positions, around[0], effort) + 1j * model.eta_b])
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
    good = (step < 1e-9 * np.abs(q)) & (np.abs(q - 1j * model.eta_b) < radius) & (np.abs(q) > 1e-12)
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
