"""The finite beam, (52) against (41) by one integrator, and the march of exact modes against scipy's solve_ivp.

Both sides solve the same modes, without what the modes beyond would add, so that they differ by their own errors
only. solve_ivp integrates the rearranged form (52) with the loosest tolerance that meets the error of the march.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from measure import median, seconds
from newmark import Beam, newmark

from mpsolve import Problem, tracks, vehicles
from mpsolve.finite.case import Case
from mpsolve.vehicles.load import Load

NEEDS = "the comparison needs scipy: pip install scipy"
LENGTH, START, MODES, TAU = 200.0, 40.0, 600, 100.0
MARCH_STEPS = 200
NEWMARK_STEPS, NEWMARK_TAU = 8, 0.4
CASES = [
    (alpha, eta_m, eta_b, distance)
    for eta_m, eta_b, alphas, distances in (
        (40, 0.0, (0.5, 0.9), (0.5, 4.5)),
        (70, 0.05, (0.5, 0.8, 0.9), (0.5, 1.5)),
    )
    for alpha in alphas
    for distance in distances
]


def problem(alpha: float, eta_m: float, eta_b: float, distance: float) -> Beam:
    places, force = np.array([START, START + distance]), np.array([2.0, 2.0])
    return Beam(LENGTH, MODES, alpha, 0.0, eta_b, np.full(2, eta_m), places, lambda _tau: force)


def march(beam: Beam, times: Any, steps: int) -> Any:
    """The same on the finite track: loads of 2 units are those of the beam."""
    track = tracks.EulerBernoulli(EI="0.25", m=1, k=1, c=2 * beam.eta_b)
    masses = [vehicles.Mass(m).at(x - START) for m, x in zip(beam.eta_m, beam.places, strict=True)]
    loads = [Load(2)] * len(masses)
    case = Case(Problem(track, masses, v=beam.alpha), loads, LENGTH, times, None, START, 1e-4)
    return case.solve(MODES, steps).rail[:, case.asked]


def compare_forms() -> None:
    beam = problem(0.5, 40.0, 0.0, 1.5)
    runs = {
        coupled: (lambda c=coupled: newmark(beam, NEWMARK_TAU, NEWMARK_STEPS, coupled=c)) for coupled in (True, False)
    }
    coupled, rearranged = (median(run, 3) for run in (runs[True], runs[False]))
    print(
        f"Newmark, {MODES} modes, {NEWMARK_STEPS} steps   coupled (41) {seconds(coupled)}   "
        f"rearranged (52) {seconds(rearranged)}   ratio {coupled / rearranged:.0f} (goal: 20)"
    )
    assert np.allclose(runs[True](), runs[False](), rtol=0, atol=1e-11)


def right_hand_side(beam: Beam) -> Callable[[float, Any], Any]:
    """(a_τ, a_ττ) of the rearranged form, with the contact forces from a system of the size of the masses."""
    k = np.arange(1, beam.count + 1) * (np.pi / beam.length)
    stiffness, alpha, eta = beam.stiffness(k), beam.alpha, beam.eta_m

    def slope(tau: float, y: Any) -> Any:
        a, rate = np.split(y, 2)
        angle = np.multiply.outer(beam.places + alpha * tau, k)
        shape, turn = np.sin(angle), alpha * k
        free = -2 * beam.eta_b * rate - stiffness * a
        felt = beam.force(tau) - eta * (shape @ (free - turn**2 * a) + 2 * np.cos(angle) @ (turn * rate))
        share = 2 / beam.length * shape
        force = np.linalg.solve(np.eye(len(eta)) + eta[:, None] * (shape @ share.T), felt)
        return np.concatenate([rate, free + force @ share])

    return slope


def compare_with_solver(integrate: Any, alpha: float, eta_m: float, eta_b: float, distance: float) -> None:
    beam = problem(alpha, eta_m, eta_b, distance)
    times = np.linspace(0, TAU, MARCH_STEPS + 1)
    fine = march(beam, times, 8 * MARCH_STEPS)
    error = np.abs(march(beam, times, MARCH_STEPS) - fine).max()
    ours = median(lambda: march(beam, times, MARCH_STEPS), 3)
    k = np.arange(1, MODES + 1) * (np.pi / LENGTH)
    shapes = np.sin(np.multiply.outer(beam.places[:, None] + alpha * times, k))
    slope, found = right_hand_side(beam), []
    for digits in range(3, 13):
        tolerances = {"rtol": 10.0**-digits, "atol": 10.0 ** -(digits + 1)}

        def theirs(tolerances: dict[str, float] = tolerances) -> None:
            answer = integrate(slope, (0, TAU), np.zeros(2 * MODES), method="DOP853", t_eval=times, **tolerances)
            found.append(np.einsum("jtk,kt->jt", shapes, answer.y[:MODES]))

        cost = median(theirs, 1)
        their_error = np.abs(found[-1] - fine).max()
        if their_error <= max(error, 1e-7):
            break
    print(
        f"α = {alpha}, η_M = {eta_m:g}, η_b = {eta_b}, d = {distance}   march {seconds(ours)} to {error:.0e}   "
        f"DOP853 {seconds(cost)} to {their_error:.0e} (rtol 1e-{digits})   ratio {cost / ours:.0f} (goal: 3)"
    )
    assert their_error < 10 * max(error, 1e-6)


def test_both_forms_agree() -> None:
    compare_forms()


def test_the_march_agrees_with_solve_ivp() -> None:
    integrate = pytest.importorskip("scipy.integrate", reason=NEEDS).solve_ivp
    compare_with_solver(integrate, 0.5, 40.0, 0.0, 1.5)


def main() -> None:
    compare_forms()
    try:
        from scipy.integrate import solve_ivp
    except ImportError:
        print(f"skipped: {NEEDS}")
        return
    for case in CASES:
        compare_with_solver(solve_ivp, *case)


if __name__ == "__main__":
    main()
