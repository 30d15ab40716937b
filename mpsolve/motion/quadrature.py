"""Gauss–Legendre panels on a path in the q plane, bisected until every one resolves what is integrated on it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np

from mpsolve.errors import PrecisionError

ORDER = 16
_TAIL = 2  # the last Legendre coefficients, which must be small
_DECAYS = (0.0, 3.0, 9.0)  # resolved at times τ when e^{iqτ} has fallen to e^{−c} on the panel, and at τ = 0
_LONGEST = 1e-7  # 1/τ of the longest times
_ROUNDS = 40
_NOISE = 3e-14  # of the values on a panel, as good as resolved in float64
_GAIN = 8.0  # a tail that a bisection does not lower so much is rounding, if it is
_SMALL, _SLIGHT = 1e-5, 1e-12  # this part of the values, or if they are no more than this on the panel
_GRAIN = 1e-14  # of q, next to a branch point: panels over less hold but a few float64 numbers q

Place = Callable[[Any], tuple[Any, Any]]


@dataclass(frozen=True)
class Panels:
    """Nodes u of a path and their weights, in order, and what the integrand left at each node."""

    nodes: Any
    weights: Any
    left: Any


@lru_cache(maxsize=1)
def rule() -> tuple[Any, Any, Any]:
    """Nodes and weights on [−1, 1], and the matrix that takes values to their last Legendre coefficients."""
    nodes, weights = np.polynomial.legendre.leggauss(ORDER)
    degree = np.arange(ORDER - _TAIL, ORDER)
    values = np.polynomial.legendre.legvander(nodes, ORDER - 1)[:, degree]
    return nodes, weights, (values * weights[:, None] * (degree + 0.5)).T


def adaptive_panels(
    place: Place,
    integrand: Callable[[Any, Any, Any], tuple[Any, Any]],
    breaks: Any,
    floor: float,
    tolerance: float,
    most: int,
) -> Panels:
    """Panels between `breaks` on which integrand(u, q, dq/du) and its product with e^{iqτ} are resolved, τ ≥ 0.

    place(u) = q, dq/du; integrand returns its values, shape (outputs, nodes), and what to leave at the nodes. A panel
    stays when its last Legendre coefficients times its length are below `tolerance`, or only rounding is left of
    them. e^{iqτ} is taken relative to its size on Im q = `floor`. Raises PrecisionError beyond `most` panels.
    """
    nodes, weights, _ = rule()
    low, high = np.asarray(breaks[:-1], float), np.asarray(breaks[1:], float)
    before = np.full(len(low), np.inf)
    done: list[tuple[Any, Any, Any]] = []
    kept = 0
    for _ in range(_ROUNDS):
        u = ((low + high) + (high - low) * nodes[:, None]).T / 2  # (panels, ORDER)
        q, rate = place(u.ravel())
        values, left = integrand(u.ravel(), q, rate)
        values = values.reshape(-1, *u.shape)
        tails = _tails(values, q.reshape(u.shape), floor)
        size, q = np.abs(values).max((0, 2)), q.reshape(u.shape)
        rounded = (tails <= _SMALL * size) | (size * (high - low) <= _SLIGHT)
        rounded &= (_GAIN * tails > before) | (tails <= _NOISE * size)
        rounded |= np.abs(q[:, -1] - q[:, 0]) < _GRAIN * np.abs(q[:, 0])
        wide = ~((tails * (high - low) <= tolerance) | rounded)
        done.append((low[~wide], high[~wide], left.reshape(u.shape)[~wide]))
        kept += len(done[-1][0])
        if not wide.any():
            break
        if kept + 2 * np.sum(wide) > most:
            raise PrecisionError(
                f"the transient part needs more than {most} panels of its integral: the masses are too light, or too "
                "far from each other or from ξ, for float64; take heavier masses or nearer positions"
            )
        middle = (low[wide] + high[wide]) / 2
        low, high = np.concatenate([low[wide], middle]), np.concatenate([middle, high[wide]])
        before = np.tile(tails[wide], 2)
    low, high, left = (np.concatenate([part[k] for part in done]) for k in (0, 1, 2))
    order = np.argsort(low)
    low, high = low[order, None], high[order, None]
    placed, weighed = ((low + high) + (high - low) * nodes) / 2, (high - low) * weights / 2
    return Panels(placed.ravel(), weighed.ravel(), left[order].ravel())


def _tails(values: Any, q: Any, floor: float) -> Any:
    """The largest of the last Legendre coefficients over outputs and the three times, one a panel."""
    _, _, last = rule()
    rise = q - 1j * floor
    middle = np.maximum(rise[:, ORDER // 2].imag, _LONGEST)[:, None]
    worst = np.zeros(len(q))
    for decay in _DECAYS:
        wave = np.exp(1j * rise * (decay / middle)) if decay else 1.0  # next to a branch point rounding shows
        tails = np.abs((values * wave) @ last.T).sum(-1)
        worst = np.maximum(worst, tails.max(0))
    return worst
