"""A bogie on two layers: infinite track, finite track, and scipy's solve_ivp on the same modal equations."""

from __future__ import annotations

from typing import Any

import numpy as np
from measure import median, seconds
from scipy.integrate import solve_ivp

from mpsolve import certify, critical_velocities, finite_track, read_problem, response
from mpsolve.finite.carriage import carriage
from mpsolve.finite.discretization import discretized
from mpsolve.vehicles.loads import outer_forces

PROBLEM = read_problem("examples/two_layer_bogie.toml").problem
MANY, SOME = np.linspace(0, 2, 2000), np.linspace(0, 2, 200)
LENGTH, MODES, LAST = 60.0, 1000, 0.02


def infinite() -> None:
    spectrum = certify(PROBLEM, check=False)
    whole = median(lambda: response(PROBLEM, times=MANY, places=[0, "1.28", 2, -2], spectrum=spectrum), 5)
    one = median(lambda: response(PROBLEM, times=SOME, places=[0], spectrum=spectrum), 9)
    bare = median(lambda: response(PROBLEM, times=SOME, places=[0]), 9)
    print(f"2,000 times × 4 places {seconds(whole)} with the roots (goal: 1 s)")
    print(f"200 times × 1 place {seconds(one)} with the roots (goal: 100 ms), {seconds(bare)} with kept ones")
    print(f"critical velocities {seconds(median(lambda: critical_velocities(PROBLEM.track), 5))} (goal: 0.2 s)")


def finite() -> None:
    times = np.linspace(0.05, 0.4, 8)
    whole = median(lambda: finite_track(PROBLEM, length=LENGTH, modes=MODES, times=times, tolerance=1e-4), 3)
    print(f"finite track, {MODES} modes, to 0.4 s, tolerance 1e-4 {seconds(whole)} (goal: 5 s)")
    short = np.linspace(0.005, LAST, 4)
    known = finite_track(PROBLEM, length=LENGTH, modes=MODES, times=short, steps=4000)
    mine: dict[str, Any] = {}

    def march() -> None:
        mine["rail"] = finite_track(PROBLEM, length=LENGTH, modes=MODES, times=short, tolerance=1e-4).rail

    def scipy() -> None:
        mine["scipy"] = modal(short, known.start, 1e-3)

    ours, theirs = median(march, 3), median(scipy, 1)
    size = np.abs(known.rail).max()
    off = [np.abs(mine[key] - known.rail).max() / size for key in ("rail", "scipy")]
    print(f"to {LAST} s: finite track {seconds(ours)} (error {off[0]:.1e}), solve_ivp {seconds(theirs)} "
          f"(error {off[1]:.1e}): {theirs / ours:.0f} times (goal: 3)")  # fmt: skip


def modal(times: Any, start: float, tolerance: float) -> Any:
    """The same equations, M a″ + C a′ + K a = forces of the Hertz springs, by scipy's DOP853."""
    track = discretized(PROBLEM.track.waveguide, LENGTH, MODES)
    inverse = np.linalg.inv(track.mass)
    pencil, outer = PROBLEM.pencil, outer_forces(PROBLEM.pencil, None)
    vehicle = carriage(pencil)
    heavy = np.linalg.inv(vehicle.M)
    force = vehicle.force(outer.direction) @ outer.constant
    contacts, h = np.array(pencil.places, float), np.diag(vehicle.H)
    J, n, r = MODES, track.mass.shape[1], len(vehicle.K)
    v = float(PROBLEM.v)

    def rate(t: float, state: Any) -> Any:
        a, b = (state[k * J * n : (k + 1) * J * n].reshape(J, n) for k in (0, 1))
        y, dy = state[2 * J * n : 2 * J * n + r], state[2 * J * n + r :]
        shape = np.sin(np.multiply.outer(contacts + start + v * t, track.wavenumbers))
        f = (vehicle.B.T @ y - shape @ a[:, track.loaded]) / h
        push = -np.einsum("jab,jb->ja", track.damping, b) - np.einsum("jab,jb->ja", track.stiffness, a)
        push[:, track.loaded] += 2 / LENGTH * (f @ shape)
        down = heavy @ (force - vehicle.C @ dy - vehicle.K @ y - vehicle.B @ f)
        return np.concatenate([b.ravel(), np.einsum("jab,jb->ja", inverse, push).ravel(), dy, down])

    zero = np.zeros(2 * J * n + 2 * r)
    found = solve_ivp(rate, (0, times[-1]), zero, "DOP853", times, rtol=tolerance, atol=tolerance * 1e-5)
    shapes = np.sin(np.multiply.outer(contacts[:, None] + start + v * times, track.wavenumbers))
    return np.einsum("ptj,tj->pt", shapes, found.y[: J * n].reshape(J, n, -1)[:, track.loaded].T)


def test_both_tracks_agree() -> None:
    times = np.array([0.01, 0.02])
    one, other = response(PROBLEM, times=times), finite_track(PROBLEM, length=LENGTH, modes=MODES, times=times)
    assert np.abs(one.rail - other.rail).max() <= one.error.rail + other.error.total


def main() -> None:
    infinite()
    finite()


if __name__ == "__main__":
    main()
