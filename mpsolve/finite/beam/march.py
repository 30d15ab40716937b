"""The rearranged equations (49)–(55) marched in time: exact modes, one unknown acceleration a mass and step.

Over a step every mass has an acceleration linear in time, u = u₀ + u₁P₁, so its contact force is known up to two
numbers, and every mode answers that force exactly, since (polynomial) · (sine of the moving position) integrates
in closed form. The two numbers make beam and mass move alike, in the mean over the step and against P₁:

    ∫ φ(θ) [ d/dτ w(x_j + ατ, τ) − v_j − ∫ u_j ] dθ = 0,   φ = 1, P₁.

The force does the same work on the mass as on the beam: the march adds no energy and takes none, at any step. The
modes enter by the sums over all of them of products of sines, which depend on the difference of two positions
(found once) and on their sum (the image in the support, at each step). A step costs O(masses · modes).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.finite.beam.modes import Beam
from mpsolve.numbers.wave_tables import Waves, gauss, legendre_powers, mirrored, moments, nested, wave_tables

UNKNOWN = 1
"""Degree of the acceleration in a step."""


@dataclass(frozen=True)
class Loading:
    """Masses in float64: `eta_m` (n,), `places` (n,) at τ = 0 from the left support, `force`(τ) (n,) as in f_j.

    `degree`: the polynomial degree in a step by which the force is replaced; 1 is exact for a constant one.
    """

    eta_m: Any
    places: Any
    force: Callable[[float], Any]
    degree: int = UNKNOWN


@dataclass(frozen=True)
class Motion:
    """At the ends of the steps, `times` (s + 1,): w and dw/dτ of points that move with the masses, (points, s + 1).

    The masses are the first points. `acceleration` (masses, s): the mean of w0_j,ττ in each step. `state` (E,): the
    exponentials of the beam at the last time, without their weights.
    """

    times: Any
    deflection: Any
    velocity: Any
    acceleration: Any
    state: Any


@dataclass(frozen=True)
class _Tables:
    """What does not change from step to step. E exponentials, n masses, unknowns a, force polynomials l."""

    decay: Any  # e^{rate h}, (E,)
    entry: tuple[Any, Any]  # what P_l e^{±ikx} adds to z, two of (l, E)
    history: tuple[Any, Any]  # ∫φ_a of the velocity under e^{±ikx} per unit z, two of (a, E)
    direct: Any  # ∫φ_a of the velocity at mass i per force P_l at mass j, (n, n, a, l)
    image: Any  # the same per e^{ik(x_i + x_j)}, (a l, E)
    inertia: Any  # ∫φ_a ∫ P_l of the mass itself, (a, a)
    tail_decay: complex
    tail_entry: Any  # (l,)
    tail_history: Any  # (a,)


def march(beam: Beam, loading: Loading, duration: float, steps: int, offsets: Any = ()) -> Motion:
    """The motion of masses that are at rest, on a beam at rest, at τ = 0, in `steps` equal steps to `duration`.

    offsets (m,): more points to watch, as distances from the first mass. Float64.
    """
    k, _, weight = beam.exponentials
    h, eta, n, degree = duration / steps, loading.eta_m, len(loading.eta_m), loading.degree
    table = _tables(beam, loading, h)
    gaps = loading.places - loading.places[0]
    points = np.concatenate([gaps, np.asarray(offsets, float)])
    shift = np.exp(1j * np.multiply.outer(points, k))
    flexibility = beam.tail_flexibility(np.abs(points[:, None] - gaps))
    nodes, projection = _projection(degree)
    tail_weight, tail_stiffness = 1 / (1j * beam.tail_rate.imag), abs(beam.tail_rate) ** 2

    z, y, velocity = np.zeros(len(k), complex), np.zeros(n, complex), np.zeros(n)
    deflections, velocities = np.zeros((2, steps + 1, len(points)))
    accelerations = np.zeros((steps, n))
    carrier = np.exp(1j * loading.places[0] * k)
    for step in range(steps):
        start = step * h
        phase = shift[:n] * carrier
        products = (phase[:, None] * phase).reshape(n * n, -1)
        gain = table.direct + (products @ table.image.T).real.reshape(table.direct.shape)
        applied = np.array([loading.force(start + h * node) for node in nodes]).T @ projection
        past = (phase @ (table.history[0] * z).T + phase.conj() @ (table.history[1] * z).T).real
        past += (flexibility[:n] @ (y[:, None] * table.tail_history)).real
        u = _accelerations(gain, table.inertia, eta, past, applied, velocity)
        applied[:, : UNKNOWN + 1] -= eta[:, None] * u
        z = table.decay * z
        for waves, entry in ((phase, table.entry[0]), (phase.conj(), table.entry[1])):
            z += np.sum(waves * (applied @ entry), axis=0)
        y = table.tail_decay * y + tail_stiffness * (applied @ table.tail_entry)
        velocity = velocity + h * u[:, 0]
        accelerations[step] = u[:, 0]

        carrier = np.exp(1j * (loading.places[0] + beam.alpha * (start + h)) * k)
        deflections[step + 1], velocities[step + 1] = _motion_of_points(beam, shift * carrier, z * weight)
        deflections[step + 1] += flexibility @ (tail_weight * y).real
        velocities[step + 1] += flexibility @ (tail_weight * beam.tail_rate * y).real
        velocities[step + 1, :n] = velocity
    return Motion(h * np.arange(steps + 1), deflections.T, velocities.T, accelerations.T, z)


def _motion_of_points(beam: Beam, phase: Any, amplitude: Any) -> tuple[Any, Any]:
    """w and its rate at moving points, from e^{ikx} (points, E) and weight · z (E,)."""
    k, rate, _ = beam.exponentials
    value, slope = amplitude.real, beam.alpha * k * amplitude.real
    return phase.imag @ value, phase.imag @ (rate * amplitude).real + phase.real @ slope


def _accelerations(gain: Any, inertia: Any, eta: Any, past: Any, applied: Any, velocity: Any) -> Any:
    """The u (n, a) of all masses together."""
    n, size = past.shape
    rest = past + np.einsum("ijal,jl->ia", gain, applied)
    rest[:, 0] -= velocity
    matrix = np.einsum("ijab,j->iajb", gain[..., :size], eta)
    for j in range(n):
        matrix[j, :, j, :] += inertia
    return np.linalg.solve(matrix.reshape(n * size, n * size), rest.ravel()).reshape(n, size)


def _projection(degree: int) -> tuple[Any, Any]:
    """Nodes in [0, 1], and the matrix from values there to the coefficients of P_l; exact for that degree."""
    nodes, weight = gauss(degree + 1)
    values = np.vander(nodes, degree + 1, increasing=True) @ legendre_powers(degree).T
    return nodes, weight[:, None] * values * (2 * np.arange(degree + 1) + 1)


def _tables(beam: Beam, loading: Loading, h: float) -> _Tables:
    degree = loading.degree
    waves = Waves(*beam.exponentials, beam.length, beam.alpha)
    table = wave_tables(waves, loading.places, h, UNKNOWN, degree)
    tests, forces = legendre_powers(UNKNOWN), legendre_powers(degree)
    lone = np.array([beam.tail_rate])
    tail_weight, stiffness = 1 / (1j * beam.tail_rate.imag), abs(beam.tail_rate) ** 2
    tail = (stiffness * tail_weight * lone * nested(lone, -lone, h, UNKNOWN, degree)).real[..., 0]
    gap = loading.places[:, None] - loading.places
    still = np.zeros(1)
    return _Tables(
        decay=table.decay,
        entry=table.entry,
        history=table.history,
        direct=table.direct + beam.tail_flexibility(np.abs(gap))[..., None, None] * tail,
        image=table.image.reshape(-1, len(waves.k)),
        inertia=nested(still, still, h, UNKNOWN, degree)
        .real[..., : UNKNOWN + 1, 0]
        .reshape(UNKNOWN + 1, UNKNOWN + 1),
        tail_decay=complex(np.exp(beam.tail_rate * h)),
        tail_entry=h * (mirrored(degree) * (forces @ moments(lone * h, degree)))[:, 0],
        tail_history=tail_weight * beam.tail_rate * (tests @ moments(lone * h, UNKNOWN))[:, 0],
    )
