"""A bogie on two layers: infinite track, finite track, and scipy's solve_ivp on the same modal equations."""

from __future__ import annotations

from typing import Any

import numpy as np
from measure import median, seconds
from scipy import sparse
from scipy.integrate import solve_ivp

from mpsolve import certify, critical_velocities, finite_track, read_problem, response
from mpsolve.finite.carriage import carriage
from mpsolve.finite.discretization import discretized
from mpsolve.vehicles.loads import outer_forces

PROBLEM = read_problem("examples/two_layer_bogie.toml").problem
MANY, SOME = np.linspace(0, 2, 2000), np.linspace(0, 2, 200)
PLACES = [0, "1.28", 2, -2]
LENGTH, MODES = 60.0, 1000


def infinite() -> None:
    spectrum = certify(PROBLEM, check=False)
    whole = median(lambda: response(PROBLEM, times=MANY, places=PLACES, spectrum=spectrum), 5)
    one = median(lambda: response(PROBLEM, times=SOME, places=[0], spectrum=spectrum), 9)
    bare = median(lambda: response(PROBLEM, times=SOME, places=[0]), 9)
    print(f"2,000 times × 4 places {seconds(whole)} with the roots (goal: 1 s)")
    print(f"200 times × 1 place {seconds(one)} with the roots (goal: 100 ms), {seconds(bare)} with kept ones")
    print(f"critical velocities {seconds(median(lambda: critical_velocities(PROBLEM.track), 5))} (goal: 0.2 s)")


def finite() -> None:
    whole = median(lambda: finite_track(PROBLEM, length=400, modes=MODES, times=MANY, places=PLACES), 1)
    print(f"finite track, {MODES} modes, 2,000 times × 4 places to 2 s {seconds(whole)} (goal: 5 s)")
    beside_scipy(0.02, "DOP853", 1e-2, 1e-7)
    beside_scipy(0.4, "Radau", 1e-2, 1e-6)


def beside_scipy(last: float, method: str, theirs: float, ours: float) -> None:
    """Both to the same equations on the same length: processor times, and errors against much finer steps."""
    times = np.linspace(last / 4, last, 4)
    figures: dict[str, Any] = {"length": LENGTH, "modes": MODES, "times": times}
    known = finite_track(PROBLEM, **figures, steps=8192)
    found: dict[str, Any] = {}

    def march() -> None:
        found["ours"] = finite_track(PROBLEM, **figures, tolerance=ours).rail

    def scipy() -> None:
        found["theirs"] = Modal(known.start).rail(times, method, theirs)

    mine, other = median(march, 3), median(scipy, 1)
    off = {key: np.abs(rail - known.rail).max() / np.abs(known.rail).max() for key, rail in found.items()}
    print(f"to {last} s: finite track {seconds(mine)} (error {off['ours']:.1e}), solve_ivp by {method} "
          f"{seconds(other)} (error {off['theirs']:.1e}): {other / mine:.1f} times (goal: 3)")  # fmt: skip


class Modal:
    """The same equations, M a″ + C a′ + K a = forces of the contact springs, for scipy.

    Radau is given a sparse Jacobian without the contacts, with which its iterations converge: about ten times quicker
    than DOP853, which the fastest mode holds to tiny steps.
    """

    def __init__(self, start: float) -> None:
        track, pencil = discretized(PROBLEM.track.waveguide, LENGTH, MODES), PROBLEM.pencil
        outer = outer_forces(pencil, None)
        inverse = np.linalg.inv(track.mass)
        parts = [-np.einsum("jab,jbc->acj", inverse, part) for part in (track.stiffness, track.damping)]
        self.inner, self.fields = np.concatenate(parts, 1), len(track.kinds)  # (fields, 2 fields, J)
        self.push = inverse[:, :, track.loaded].T * (2 / LENGTH)
        self.k, self.loaded, self.start, self.v = track.wavenumbers, track.loaded, start, float(PROBLEM.v)
        self.vehicle = carriage(pencil)
        self.heavy = np.linalg.inv(self.vehicle.M)
        self.force = self.vehicle.force(outer.direction) @ outer.constant
        self.places, self.h = np.array(pencil.places, float), np.diag(self.vehicle.H)

    def shapes(self, t: Any) -> Any:
        return np.sin(np.multiply.outer(np.add.outer(self.places + self.start, self.v * t), self.k))

    def rate(self, t: float, state: Any) -> Any:
        n, car = self.fields, self.vehicle
        a = state[: 2 * n * MODES].reshape(2 * n, MODES)
        y, dy = state[a.size :].reshape(2, -1)
        shape = self.shapes(t)
        f = (car.B.T @ y - shape @ a[self.loaded]) / self.h
        down = self.heavy @ (self.force - car.C @ dy - car.K @ y - car.B @ f)
        faster = np.einsum("abj,bj->aj", self.inner, a) + (f @ shape) * self.push
        return np.concatenate([a[n:].ravel(), faster.ravel(), dy, down])

    @property
    def jacobian(self) -> Any:
        n, car = self.fields, self.vehicle
        rows = [[sparse.eye(MODES) if b == a + n else None for b in range(2 * n)] for a in range(n)]
        rows += [[sparse.diags(entry) for entry in row] for row in self.inner]
        springs = car.K + car.B @ np.diag(1 / self.h) @ car.B.T
        moved = np.block([[0 * springs, np.eye(len(springs))], [-self.heavy @ springs, -self.heavy @ car.C]])
        return sparse.block_diag([sparse.bmat(rows), moved]).tocsc()

    def rail(self, times: Any, method: str, tolerance: float) -> Any:
        options = {"jac": self.jacobian} if method == "Radau" else {}
        rest = np.zeros(2 * self.fields * MODES + 2 * len(self.vehicle.K))
        limits = {"rtol": tolerance, "atol": 1e-6 * tolerance}
        found = solve_ivp(self.rate, (0, times[-1]), rest, method, times, **limits, **options)
        loaded = found.y[self.loaded * MODES : (self.loaded + 1) * MODES]
        return np.einsum("ptj,jt->pt", self.shapes(times), loaded)


def test_both_tracks_agree() -> None:
    times = np.array([0.01, 0.02])
    one, other = response(PROBLEM, times=times), finite_track(PROBLEM, length=LENGTH, modes=MODES, times=times)
    assert np.abs(one.rail - other.rail).max() <= one.error.rail + other.error.total


def main() -> None:
    infinite()
    finite()


if __name__ == "__main__":
    main()
