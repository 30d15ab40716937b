"""Induced frequencies of as many cases as there are elements in arrays."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.errors import InputError
from mpsolve.fast.cases import Cases
from mpsolve.fast.follow import Outcome, follow
from mpsolve.fast.order import alike
from mpsolve.parallel.pool import run
from mpsolve.progress import Progress

CHUNK = 16_384  # cases at a time, which bounds the memory: about 150 MB a process


@dataclass(frozen=True)
class Frequencies:
    """Induced frequencies on the whole physical sheet, below and above the cut line, in float64.

    q: complex128, shape (…, n), in each case sorted by (Re q, Im q), then nan; n is the largest count.
    count: int, shape (…): the number of roots, −1 where unresolved. outcome: int8, shape (…), see `Outcome`.
    Only where the outcome is CERTIFIED are count and roots proved; the sign of an Im q next to 0 is float64's. A
    tracked root is good to about 1e-14 |q|, divided by its relative distance to the nearest other root of the case.

    What float64 leaves open is certified, for 64 cases and one in 512. Beyond that, or where this fails too, cases
    stay unresolved; most of them have
        a root next to the cut: η_b = 0 within about 1e-4 of α_C on either side; any η_b within as much of an α where
        a root comes out of the cut; light masses, η_M below 0.1, whose roots are next to the branch point;
        two roots within about 1e-8 of one another: masses far apart, d above 20 or so;
        very many roots: α above 20 or so; a case with more than 64 is not followed;
        a parameter so large or small that the phase along the cut is too long to be followed, or overflows.
    """

    q: Any
    count: Any
    outcome: Any

    @property
    def status(self) -> Any:
        """The outcomes as text, shape (…): "certified", "tracked" or "unresolved"."""
        return np.array([outcome.name.lower() for outcome in Outcome])[self.outcome]

    @property
    def unstable(self) -> Any:
        """The number of roots with Im q < 0, −1 where unresolved, shape (…)."""
        with np.errstate(invalid="ignore"):
            return np.where(self.count < 0, -1, (self.q.imag < 0).sum(axis=-1))


def frequencies(
    alpha: Any,
    eta_b: Any,
    eta_m: Any,
    d: Any,
    eta_n: Any = 0,
    eta_s: Any = 0,
    mass_ratio: Any = 1,
    *,
    workers: int = 1,
    tell: Progress | None = None,
) -> Frequencies:
    """The induced frequencies of masses eta_m at 0 and mass_ratio·eta_m at d, (26), for arrays that broadcast.

    A number, list or array each, read as float64: alpha ≥ 0, 0 ≤ eta_b < 1, eta_m > 0, d ≥ 0 (0: the masses are
    one), eta_s ≥ 0, mass_ratio ≥ 0 (0: a single mass, whatever d is), eta_n − eta_s < √(1 − eta_b²). InputError
    for all else. workers: processes, spawned, so that a script with more than one must call this under
    `if __name__ == "__main__":`. tell(stage, fraction) hears of the progress.

    >>> frequencies([0.66, 0.67], 0.05, 70, 1.5).unstable.tolist()
    [0, 2]
    """
    arrays = _checked(alpha, eta_b, eta_m, d, eta_n, eta_s, mass_ratio)
    shape = arrays[0].shape
    cases = _cases(*(a.ravel() for a in arrays))
    order = alike(cases)
    jobs = [cases[order[k : k + CHUNK]] for k in range(0, len(order), CHUNK)]
    results = run(follow, jobs, workers, tell, "following")
    width = max((2 * q.shape[1] for q, _ in results), default=0)
    q, outcome = np.full((len(order), width), np.nan, complex), np.zeros(len(order), np.int8)
    for k, (half, known) in enumerate(results):
        place = order[k * CHUNK : (k + 1) * CHUNK]
        q[place, : 2 * half.shape[1]] = _whole(half, jobs[k].eta_b == 0)
        outcome[place] = known
    count = np.isfinite(q).sum(axis=1)
    n = int(count.max(initial=0))
    count = np.where(outcome == Outcome.UNRESOLVED, -1, count)
    return Frequencies(q[:, :n].reshape(*shape, n), count.reshape(shape), outcome.reshape(shape))


def _cases(alpha: Any, eta_b: Any, eta_m: Any, d: Any, eta_n: Any, eta_s: Any, ratio: Any) -> Cases:
    single = (d == 0) | (ratio == 0)
    with np.errstate(over="ignore"):
        return Cases(
            alpha,
            eta_n - eta_s,
            eta_b,
            np.where(single, eta_m * (1 + ratio), eta_m),
            np.where(single, 0.0, eta_m * ratio),
            np.where(single, 1.0, d),
        )


def _whole(half: Any, undamped: Any) -> Any:
    """Roots with Re q ≥ 0 and their mirror images −q̄, for η_b = 0 exactly in pairs q, q̄ as well; sorted."""
    half = half.copy()
    with np.errstate(invalid="ignore"):
        for k in range(half.shape[1]):
            for j in range(half.shape[1]):
                pair = undamped & (half[:, k].imag > 0)
                pair &= np.abs(half[:, k] - half[:, j].conj()) < 1e-10 * np.abs(half[:, k])
                half[pair, k] = half[pair, j].conj()
        return np.sort(np.concatenate([half, np.where(half.real > 0, -half.conj(), np.nan)], axis=1), axis=1)


_BOUNDS: dict[str, tuple[str, Callable[[Any], Any]]] = {
    "alpha": ("below 0", lambda v: v >= 0),
    "eta_b": ("not within 0 ≤ eta_b < 1, where the cuts lie on a line", lambda v: (v >= 0) & (v < 1)),
    "eta_m": ("not above 0", lambda v: v > 0),
    "d": ("below 0", lambda v: v >= 0),
    "eta_n": ("not a number", lambda v: v == v),
    "eta_s": ("below 0", lambda v: v >= 0),
    "mass_ratio": ("below 0", lambda v: v >= 0),
}


def _checked(*values: Any) -> list[Any]:
    """Float64 arrays of one shape; InputError names the first element that breaks a bound."""
    arrays: list[Any] = []
    for (name, (stated, holds)), value in zip(_BOUNDS.items(), values, strict=True):
        if np.ma.is_masked(value):
            raise InputError(name, "has masked entries: give a number everywhere, or leave those cases out")
        try:
            array = np.asarray(value)
            if array.dtype.kind not in "iuf":
                raise TypeError
        except (TypeError, ValueError):
            raise InputError(name, "is no array of real numbers: give a number, a list or an array of them") from None
        array = array.astype(float)
        _require(name, array, np.isfinite(array), "not finite: give finite numbers")
        _require(name, array, holds(array), f"{stated}: give values within the bound")
        arrays.append(array)
    try:
        arrays = list(np.broadcast_arrays(*arrays))
    except ValueError:
        shapes = ", ".join(f"{name} {array.shape}" for name, array in zip(_BOUNDS, arrays, strict=True))
        raise InputError("alpha", f"and the others do not broadcast: their shapes are {shapes}") from None
    with np.errstate(over="ignore"):
        axial = arrays[4] - arrays[5]
    rest = (
        "gives eta_n − eta_s not below √(1 − eta_b²), so that the cuts leave their line or the beam buckles: lower it"
    )
    _require("eta_n", arrays[4], axial < np.sqrt(1 - arrays[1] ** 2), rest)
    return arrays


def _require(name: str, array: Any, holds: Any, stated: str) -> None:
    if not holds.all():
        first = tuple(int(k) for k in np.argwhere(~holds)[0])
        where = f"{list(first)} " if first else ""
        raise InputError(name, f"{where}is {array[first]:g}, {stated}")
