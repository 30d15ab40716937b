"""All vehicles as one system under contact forces; coordinates that have no mass are taken out exactly.

M ÿ + C ẏ + K y = g(t) − B f, with f the compressions. In a basis [T₂, T₁, T₀], T₀ spanning the kernel of M and C and
T₁ the rest of that of M, the coordinates of T₀ follow at once (they are eliminated and leave a compliance in the
contacts), those of T₁ have one derivative in time, the others two. So Bᵀy − w = H f with
H = diag(h) + B₀ᵀK₀₀⁻¹B₀.

What a step does to the vehicle is exact: its state under contact forces linear in time and its outer forces. In the
time θ = t/h of a step the state X = (kept coordinates, dy/dθ of those with mass, 1, and sin, cos of every outer
force) obeys X_θ = A X + E f, and the rate of Bᵀy is G X + F f. One exponential of a matrix that holds the state, the
force and two integrals of the rate gives all tables.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np

from mpsolve.errors import InputError
from mpsolve.numbers.arrays import Reals
from mpsolve.numbers.float64 import Float64
from mpsolve.numbers.linear import completed, congruent, image, kernel, units
from mpsolve.vehicles.loads import Outer
from mpsolve.vehicles.vehicle import Pencil
from mpsolve.vibration.forcing import Irregularity


@dataclass(frozen=True)
class Carriage:
    """M₂₂ and C₁₁ are regular; the first `second` of the kept coordinates have mass. Float64 of exact numbers.

    M, C, K (r, r), B (r, n), H (n, n). motion (size, r) and give (size, n): y = motion · kept − give · f.
    fixed (size, …): the directions of the coordinates that were eliminated.
    """

    M: Reals
    C: Reals
    K: Reals
    B: Any
    H: Reals
    second: int
    motion: Reals
    give: Reals
    fixed: Reals

    @property
    def first(self) -> int:
        """How many coordinates have no mass but damping."""
        return len(self.M) - self.second

    def force(self, g: Reals) -> Reals:
        """The force g on y as one on the kept coordinates; InputError where it meets neither mass nor damper."""
        if np.any(self.fixed.T @ g):
            stated = "act on a coordinate without mass and damping, which would jump"
            raise InputError("loads", f"{stated}: give the coordinate a mass, or load another one")
        return self.motion.T @ g


def carriage(pencil: Pencil) -> Carriage:
    """The vehicle's equations, reduced; every step of the reduction is exact."""
    size = pencil.size
    massless = kernel(pencil.M, size)
    at_once = kernel((*pencil.M, *pencil.C), size) if massless else []
    damped = completed(at_once, massless)
    heavy = completed([*at_once, *damped], units(size)) if massless else units(size)
    kept = [*heavy, *damped]
    M, C, K = (congruent(rows, kept, kept) for rows in (pencil.M, pencil.C, pencil.K))
    columns = list(zip(*pencil.B, strict=True))
    B = [image(columns, vector) for vector in kept]
    T = np.array(kept, float).reshape(-1, size).T
    fixed = np.array(at_once, float).reshape(-1, size).T
    H = np.diag(np.array(pencil.h, float))
    Kf, Bf = np.array(K, float), np.array(B, float)
    motion, give = T, np.zeros((size, pencil.contacts))
    if at_once:
        inner = np.linalg.inv(np.array(congruent(pencil.K, at_once, at_once), float))
        across, touch = (
            np.array(congruent(pencil.K, at_once, kept), float),
            np.array([image(columns, vector) for vector in at_once], float),
        )
        Kf = Kf - across.T @ inner @ across
        Bf = Bf - across.T @ inner @ touch
        H = H + touch.T @ inner @ touch
        motion, give = T - fixed @ inner @ across, fixed @ inner @ touch
    return Carriage(np.array(M, float), np.array(C, float), Kf, Bf, H, len(heavy), motion, give, fixed)


@dataclass(frozen=True)
class VehicleTables:
    """N entries of the state, n contacts; forces f₀P₀ + f₁P₁, tests P₀, P₁.

    start (N,): the state at rest. advance (N, N), entry (N, 2, n): the state after the step. history (2, n, N) and
    gain (n, 2, 2, n) as (contact, test, force, contact): ∫φ_a of d(Bᵀy)/dθ. rate (r, N) and rate_force (r, n): dy/dθ
    of the kept coordinates.
    """

    start: Any
    advance: Reals
    entry: Reals
    history: Reals
    gain: Reals
    rate: Reals
    rate_force: Reals


def vehicle_tables(vehicle: Carriage, outer: Outer, h: float) -> VehicleTables:
    """The tables for steps h."""
    A, E, G, F = _system(vehicle, outer, h)
    N, n = E.shape
    r = len(vehicle.K)
    whole = np.zeros((N + 4 * n, N + 4 * n))
    x, f, slope, first, second = (slice(a, b) for a, b in _slices(N, n))
    whole[x, x], whole[x, f], whole[first, x], whole[first, f] = A, E, G, F
    whole[f, slope] = whole[second, first] = np.eye(n)
    flow = Float64().exp(whole).real
    from_f = [flow[:, f], 2 * flow[:, slope] - flow[:, f]]  # P₀ = 1 and P₁ = 2θ − 1
    gain = np.empty((n, 2, 2, n))
    for force, column in enumerate(from_f):
        gain[:, 0, force], gain[:, 1, force] = column[first], column[first] - 2 * column[second]
    return VehicleTables(
        start=_rest(vehicle, outer),
        advance=flow[x, x],
        entry=np.stack([column[x] for column in from_f], 1),
        history=np.stack([flow[first, x], flow[first, x] - 2 * flow[second, x]]),
        gain=gain,
        rate=A[:r],
        rate_force=E[:r],
    )


def _slices(N: int, n: int) -> list[tuple[int, int]]:
    ends = [0, N, N + n, N + 2 * n, N + 3 * n, N + 4 * n]
    return list(pairwise(ends))


def _rest(vehicle: Carriage, outer: Outer) -> Reals:
    still = np.zeros(len(vehicle.K) + vehicle.second)
    return np.concatenate([still, [1.0], np.sin(outer.phase), np.cos(outer.phase)])


def _system(vehicle: Carriage, outer: Outer, h: float) -> tuple[Reals, Reals, Reals, Reals]:
    """A, E, G, F of the state."""
    r, a, n, terms = len(vehicle.K), vehicle.second, vehicle.H.shape[0], len(outer.constant)
    N = r + a + 1 + 2 * terms
    y, speed, one = slice(0, r), slice(r, r + a), r + a
    sine, cosine = slice(one + 1, one + 1 + terms), slice(one + 1 + terms, N)
    force = vehicle.force(outer.direction)
    # what acts on the kept coordinates but inertia and dampers: − K y + g − B f, over X and over f
    push = np.zeros((r, N))
    push[:, y], push[:, one], push[:, sine] = -vehicle.K, force @ outer.constant, force * outer.amplitude
    pull = -vehicle.B

    A, E = np.zeros((N, N)), np.zeros((N, n))
    A[:a, speed] = np.eye(a)
    if vehicle.first:  # C₁₁ y₁' = − C₁₂ y₂' + …
        inner = np.linalg.inv(vehicle.C[a:, a:])
        rest = h * push[a:]
        rest[:, speed] -= vehicle.C[a:, :a]
        A[a:r], E[a:r] = inner @ rest, h * inner @ pull[a:]
    heavy = np.linalg.inv(vehicle.M[:a, :a])
    A[speed] = heavy @ (h * h * push[:a] - h * vehicle.C[:a] @ A[:r])
    E[speed] = heavy @ (h * h * pull[:a] - h * vehicle.C[:a] @ E[:r])
    turn = np.diag(h * outer.frequency)
    A[sine, cosine], A[cosine, sine] = turn, -turn
    return A, E, vehicle.B.T @ A[:r], vehicle.B.T @ E[:r]


def rough_rates(rough: Sequence[Irregularity], contacts: int, h: float, steps: int) -> Reals:
    """∫φ_a dr/dθ over each step of length h, (steps, contacts, a), φ_0 = 1, φ_1 = P₁; r compresses where positive.

    In parts: r(1) − r(0), and r(1) + r(0) − 2 ∫r, which is in closed form for r = A sin(ωt + φ).
    """
    if not rough:
        return np.zeros((steps, contacts, 2))
    size, omega, phase = (
        np.array([getattr(one, key) for one in rough]) for key in ("amplitude", "frequency", "phase")
    )
    turn = np.multiply.outer(np.arange(steps + 1) * h, omega) + phase
    r = size * np.sin(turn)
    middle = (turn[1:] + turn[:-1]) / 2
    mean = size * np.sin(middle) * np.sinc(omega * h / (2 * np.pi))
    return np.stack([r[1:] - r[:-1], r[1:] + r[:-1] - 2 * mean], axis=-1)
