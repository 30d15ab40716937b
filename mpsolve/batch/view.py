"""What a problem looks like now, in float64: the cuts, and the induced frequencies in a window. Nothing is proved."""

from __future__ import annotations

import time
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from mpsolve.errors import InputError, MpsolveError
from mpsolve.numbers.arrays import Complexes
from mpsolve.problem.problem import Problem
from mpsolve.problem.reduced import reduce_problem
from mpsolve.spectrum.candidates import Area, search
from mpsolve.tracks.at_rest import lowest_cut
from mpsolve.waves.dispersion import dispersion

_CUT_POINTS = 240


@dataclass(frozen=True)
class Window:
    """|Re q| ≤ width, −depth ≤ Im q ≤ height, in rad/s."""

    width: float
    depth: float
    height: float

    def zoomed(self, factor: float) -> Window:
        return Window(self.width * factor, self.depth * factor, self.height * factor)


@dataclass(frozen=True)
class View:
    """roots: complex, shape (n,), both of each pair, as far as they were found; cuts: complex arrays, one a branch.

    height: up to here no cut is met, and roots were looked for. refused: why there is nothing to see, or "".
    """

    problem: Problem
    window: Window
    roots: Complexes = field(default_factory=lambda: np.zeros(0, complex))
    cuts: tuple[Complexes, ...] = ()
    height: float = 0.0
    refused: str = ""
    seconds: float = 0.0

    @property
    def growing(self) -> int:
        """How many of the roots found have Im q < 0."""
        return int((self.roots.imag < 0).sum())


def fitting_window(problem: Problem) -> Window:
    """A window that shows the lowest cuts and what lies between them."""
    low = float(lowest_cut(problem.track)[1])
    first = np.abs(dispersion(problem.track, [0.0])[0].real)
    width = 2.0 * float(min((x for x in first if x > 0), default=max(low, 1.0)))
    height = min(2 * low, width) or width / 4
    return Window(width, height / 2, height)


def look(problem: Problem, window: Window | None = None, near: Any = (), quick: bool = False) -> View:
    """The view of a problem; `near`: roots of a neighbouring problem, from which the search starts too.

    quick: a coarse grid only, for what is looked at for a moment.

    Never raises for a problem that cannot be: the view says why.
    """
    start = time.perf_counter()
    shown = window or Window(1.0, 0.5, 0.5)
    try:
        shown = window or fitting_window(problem)
        reduced = reduce_problem(problem)
        unit = float(reduced.frequency_unit)
        height = free_height(problem, shown)
        area = Area(0.0, shown.width / unit, -shown.depth / unit, height / unit)
        hints = np.abs(np.real(near)) / unit + 1j * np.imag(near) / unit
        right = search(reduced, area, hints, 1 if quick else 2) * unit
        roots = np.array(sorted({*right.tolist(), *(-right.conj()).tolist()}, key=lambda q: (q.real, q.imag)))
        cuts = cuts_in(problem, shown)
    except InputError as error:
        return View(problem, shown, refused=str(error), seconds=time.perf_counter() - start)
    except (MpsolveError, np.linalg.LinAlgError) as error:
        return View(
            problem, shown, refused=f"cannot be computed in floats: {error}", seconds=time.perf_counter() - start
        )
    return View(problem, shown, roots.astype(complex), cuts, height, "", time.perf_counter() - start)


def free_height(problem: Problem, window: Window) -> float:
    """How far up in the window there is no cut, with some room."""
    return min(float(lowest_cut(problem.track)[0]) * 15 / 16, window.height)


def cuts_in(problem: Problem, window: Window) -> tuple[Complexes, ...]:
    """q = vp + Ω_k(p) for the wavenumbers that lead into the window."""
    v, track = float(problem.v), problem.track.waveguide
    reach = 1.0
    for _ in range(60):  # until all branches have left the window, or go on for ever
        ends = dispersion(track, [reach])[0] + v * reach
        if (np.abs(ends.real) > window.width).all() or reach > 1e4:
            break
        reach *= 1.5
    p = reach * np.linspace(-1, 1, _CUT_POINTS) ** 3
    omega = dispersion(track, p)
    return tuple(v * p + omega[:, k] for k in range(omega.shape[1]))
