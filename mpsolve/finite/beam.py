"""The masses of a case on a finite beam, Section 4.1: an independent second way to the response, its errors measured.

The march is that of any finite track. Here its figures are found: length, modes and steps that a tolerance needs.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from mpsolve.errors import InputError
from mpsolve.finite.answer import Answer
from mpsolve.finite.case import FEWEST_STEPS, MOST_STEPS, MOST_WORK, positive, share
from mpsolve.finite.case import Case as Track
from mpsolve.numbers.arrays import Reals
from mpsolve.numbers.exact import Number
from mpsolve.numbers.float_list import checked_times, float_list
from mpsolve.numbers.model import whole
from mpsolve.problem.case import Case
from mpsolve.problem.load import loads_of
from mpsolve.problem.physical import PhysicalCase
from mpsolve.vehicles.load import Load
from mpsolve.vibration.case_motion import units_of

LONGEST_STEP = 0.5
SHORTEST_WAVE = 2 / 3
"""Wavelength of the last mode, at first: three modes a unit of length."""
MOST_MODES = 40_000


@dataclass(frozen=True)
class BeamError:
    """Errors of the deflections, in w_st: measured estimates, none of them a bound.

    They do not tell of times below 1/k², k the wavenumber of the last mode, where the infinite beam still bends in
    shorter waves; there every deflection is tiny, but the contact forces err by some 1e-3 of the forces.

    time: twice the largest change from half as many steps; modes: to a third more modes; ends: to twice the distances
    from the supports. Twice is enough where the better figures halve the error. force: the sum of the same three of
    the contact forces, in unit forces; without damping the short waves that the supports send back move the forces
    much more than the deflections.
    """

    time: float
    modes: float
    ends: float
    force: float

    @property
    def total(self) -> float:
        """The sum of the three errors of the deflections."""
        return self.time + self.modes + self.ends


@dataclass(frozen=True)
class BeamResponse:
    """Float64 results on a finite beam, not proved.

    tau (t,): times; displacement (n, t): w0_j in units of w_st of the unit force; contact_forces (n, t): between
    mass j and beam, compression positive, over the unit force; xi (m,) and shape (m, t): deflections at
    chosen moving coordinates ξ.
    start: distance of the first mass from the left support at τ = 0; length, modes, steps: the figures used.
    """

    tau: Reals
    displacement: Reals
    contact_forces: Reals
    xi: Reals
    shape: Reals
    start: float
    length: float
    modes: int
    steps: int
    error: BeamError


def finite_beam(
    case: Case | PhysicalCase,
    loads: Iterable[Load] | None = None,
    tau: Iterable[Number] | Number = (),
    *,
    xi: Iterable[Number] | Number = (),
    tolerance: float = 1e-4,
    start: float | None = None,
    length: float | None = None,
    modes: int | None = None,
    steps: int | None = None,
) -> BeamResponse:
    """The motion from rest at the times `tau`, ascending, on a simply supported beam; float64, errors measured.

    loads: one for each mass, by default those of `loads_of`. start: of the first mass from the left support; with
    `length` alone (or `start` alone) the load begins and ends equally far from the supports. steps: equal ones, up to
    the last time. Figures that are not given are raised until each error of the deflections that they cause, as
    measured, is below `tolerance` · max(1, largest deflection); given ones stay, whatever error they cause.

    InputError names the argument that cannot be used: for a beam that the load would leave, the length needed;
    where the figures grow beyond what can be computed, what to change. Source: (40)–(55).

    >>> import numpy as np
    >>> finite_beam(Case(alpha="0.5", eta_b="0.2", eta_m=10), tau=[0, 60]).displacement.round(3)
    array([[0.   , 1.204]])
    """
    given = {"length": length, "modes": modes, "steps": steps, "start": start}
    fixed = tuple(name for name, value in given.items() if value is not None)
    beam = _Beam(case, loads_of(case, loads), tau, xi, tolerance, fixed)
    figures = beam.first_figures(start, length)
    figures, ends = beam.settled(figures, beam.widened, fixed=start is not None or length is not None)
    if modes is not None:
        figures = replace(figures, modes=whole(modes, "modes", beam.least_modes(figures.length), MOST_MODES))
    figures, cut = beam.settled(figures, _richer, fixed=modes is not None)
    if steps is None:
        figures, late = beam.settled(figures, _finer, fixed=False)
        figures = _finer(figures)
    else:
        figures = replace(figures, steps=whole(steps, "steps", FEWEST_STEPS, MOST_STEPS))
        _, late = beam.settled(replace(figures, steps=figures.steps // 2), lambda _: figures, fixed=True)
    found, count = beam.solve(figures), len(beam.masses)
    return BeamResponse(
        tau=beam.tau,
        displacement=found.rail[:count],
        contact_forces=found.force,
        xi=beam.xi,
        shape=found.rail[count:],
        **vars(figures),
        error=BeamError(late[0], cut[0], ends[0], late[1] + cut[1] + ends[1]),
    )


@dataclass(frozen=True)
class _Figures:
    """What the finite model adds to the problem: dimensionless lengths, and counts."""

    start: float
    length: float
    modes: int
    steps: int


def _richer(figures: _Figures) -> _Figures:
    """A third more modes."""
    return replace(figures, modes=math.ceil(figures.modes * 4 / 3))


def _finer(figures: _Figures) -> _Figures:
    """Twice as many steps."""
    return replace(figures, steps=2 * figures.steps)


class _Beam:
    """A case, its loads, and the times and moving coordinates that are asked for, checked; answers are kept.

    masses, points: where the masses and all that is watched stand, from the first mass. In τ, ξ and w_st.
    """

    def __init__(
        self, case: Case | PhysicalCase, loads: tuple[Load, ...], tau: Any, xi: Any, tolerance: float, fixed: Any
    ) -> None:
        ratios = case.dimensionless if isinstance(case, PhysicalCase) else case
        moved = tuple(x - ratios.positions[0] for x in ratios.positions)
        self.units = units_of(replace(ratios, positions=moved))
        self.tau, self.xi = checked_times(tau), float_list(xi, "xi")
        if not self.tau.size or self.tau[-1] <= 0 or np.any(np.diff(self.tau) <= 0):
            raise InputError("tau", "is not an ascending list of times from 0 on: give at least one time above 0")
        self.tolerance, self.fixed = share(tolerance, "tolerance"), fixed
        self.masses = np.array(moved, float)
        self.points = np.concatenate([self.masses, self.xi - float(ratios.positions[0])])
        self.lowest = float(self.points.min())
        self.loads = self.units.loads(loads, 1 / self.units.w_st)
        self.alpha, self.axial = float(ratios.alpha), float(ratios.axial)
        self.fastest = max((abs(float(one.frequency)) for one in loads if one.amplitude), default=0.0)
        self._answers: dict[_Figures, Answer] = {}

    @property
    def reach(self) -> float:
        """From the rearmost point at τ = 0 to the foremost one at the end."""
        return float(self.points.max()) - self.lowest + self.alpha * float(self.tau[-1])

    def first_figures(self, start: float | None, length: float | None) -> _Figures:
        """Figures to begin with; InputError where the load would not stay on the beam."""
        start = None if start is None else positive(start, "start")
        if length is not None:
            length = positive(length, "length")
        else:
            length = self.reach + 2 * (self._static_margin() if start is None else start + self.lowest)
        track = self._track(start, length)
        shortest = max(2 * math.pi / SHORTEST_WAVE, 3 * self._travelling(), 4 * math.sqrt(2 * self.fastest))
        steps = track.first_steps
        while steps * LONGEST_STEP < float(self.tau[-1]):
            steps *= 2
        return _Figures(track.origin, length, math.ceil(length * shortest / math.pi), steps)

    def _static_margin(self) -> float:
        """Where the deflection under a resting force falls to the tolerance: by the least Im p > 0 of D(p, 0)."""
        p = np.roots([1, 0, -4 * self.axial, 0, 4])
        return math.log(1 / self.tolerance) / float(min(p.imag[p.imag > 0]))

    def _travelling(self) -> float:
        """The wavenumber beyond which a steady force radiates nothing: ω² > α²k² above."""
        return 2 * math.sqrt(max(self.axial + self.alpha**2, 0.0))

    def least_modes(self, length: float) -> int:
        """Beyond which modes follow the load as if at rest."""
        return math.ceil(1.25 * length * self._travelling() / math.pi) + 3

    def widened(self, figures: _Figures) -> _Figures:
        """Twice the distances from the supports, or the static margin more, with the same modes a length."""
        least = self._static_margin()
        left = figures.start + self.lowest
        right = figures.length - left - self.reach
        length = figures.length + max(left, least) + max(right, least)
        modes = math.ceil(figures.modes * length / figures.length)
        return replace(figures, start=figures.start + max(left, least), length=length, modes=modes)

    def settled(
        self, figures: _Figures, better: Callable[[_Figures], _Figures], *, fixed: bool
    ) -> tuple[_Figures, tuple[float, float]]:
        """Figures (the same if fixed) whose errors, as the change to `better` ones shows them, are small; these."""
        while True:
            now, next_figures = self.solve(figures), better(figures)
            rail, _, force = now.change(self.solve(next_figures))
            error = 2 * rail, 2 * force
            if fixed or error[0] <= self.tolerance * max(1.0, float(np.abs(now.rail).max())):
                return figures, error
            figures = next_figures

    def solve(self, figures: _Figures) -> Answer:
        """The answer at the times asked for, kept; InputError where it is beyond what can be computed."""
        excess = figures.modes > MOST_MODES or figures.steps > MOST_STEPS or figures.modes * figures.steps > MOST_WORK
        if excess:
            stated = f"needs {figures.modes} modes and {figures.steps} steps or more, beyond what is computed"
            remedy = f"lower {' or '.join(self.fixed)}" if self.fixed else "raise it, or end tau earlier"
            raise InputError(self.fixed[0] if self.fixed else "tolerance", f"{stated}: {remedy}")
        if figures not in self._answers:
            track = self._track(figures.start, figures.length)
            try:
                found = track.solve(figures.modes, figures.steps, beyond=True)
            except InputError as error:
                raise error.under("tau" if error.key == "times" else error.key) from None
            rail, force = found.rail[:, track.asked], float(self.units.w_st) * found.force[:, track.asked]
            self._answers[figures] = replace(found, rail=rail, force=force)
        return self._answers[figures]

    def _track(self, start: float | None, length: float) -> Track:
        return Track(self.units.problem, self.loads, length, self.tau, self.points, start, self.tolerance)
