"""The masses on a finite beam, Section 4.1: an independent second way to the response, with its errors measured."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from typing import Any

from mpsolve.finite.beam.figures import Figures, Problem
from mpsolve.numbers.exact import Number
from mpsolve.problem.case import Case
from mpsolve.problem.load import loads_of
from mpsolve.problem.physical import PhysicalCase
from mpsolve.vehicles.load import Load


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

    tau: Any
    displacement: Any
    contact_forces: Any
    xi: Any
    shape: Any
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
    forces = loads_of(case, loads)
    if isinstance(case, PhysicalCase):
        case = case.dimensionless
    problem = Problem(case, forces, tau, xi, tolerance)
    given_figures = {"length": length, "modes": modes, "steps": steps, "start": start}
    problem.fixed = tuple(name for name, value in given_figures.items() if value is not None)
    figures = problem.first_figures(start, length)
    figures, ends = _settled(problem, figures, problem.widened, fixed=start is not None or length is not None)
    if modes is not None:
        figures = replace(figures, modes=problem.checked_modes(modes, figures.length))
    figures, cut = _settled(problem, figures, problem.richer, fixed=modes is not None)
    if steps is not None:
        given = problem.checked_steps(steps)
        figures = replace(figures, steps=given // 2)
        figures, late = _settled(problem, figures, lambda now: replace(now, steps=given), fixed=True)
        figures = replace(figures, steps=given)
    else:
        figures, late = _settled(problem, figures, problem.finer, fixed=False)
        figures = problem.finer(figures)
    found = problem.solve(figures)
    return BeamResponse(
        tau=problem.tau,
        displacement=found.deflection[: case.count],
        contact_forces=found.force,
        xi=problem.xi,
        shape=found.deflection[case.count :],
        **vars(figures),
        error=BeamError(late[0], cut[0], ends[0], late[1] + cut[1] + ends[1]),
    )


def _settled(
    problem: Problem, figures: Figures, better: Callable[[Figures], Figures], *, fixed: bool
) -> tuple[Figures, tuple[float, float]]:
    """Figures (the same if fixed) whose errors, as the change to `better` ones shows them, are small; the errors."""
    while True:
        now, next_figures = problem.solve(figures), better(figures)
        in_deflection, in_force = now.change(problem.solve(next_figures))
        error = 2 * in_deflection, 2 * in_force
        if fixed or error[0] <= problem.tolerance * max(1.0, now.largest):
            return figures, error
        figures = next_figures
