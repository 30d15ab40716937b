"""The rearranged equations (52) marched in time for any vehicle: one linear contact force a contact and step.

Over a step every contact force is linear in time. Modes and vehicle answer it exactly (`exponentials`,
`carriage`). The forces are such that rail and vehicle move alike, in the mean over the step and against P₁, or, where
the contact has a compliance H, that the compression e of Bᵀy − w, of which e_θ is so tested, obeys e = H f in the
mean and against P₁. Contacts and springs add no energy and take none, at any step. A step costs O(contacts · modes).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.finite.carriage import Carriage, VehicleTables, rough_rates, vehicle_tables
from mpsolve.finite.exponentials import Exponentials, wave_tables
from mpsolve.numbers.arrays import Complexes, Reals
from mpsolve.proof.effort import Effort
from mpsolve.vehicles.loads import Outer
from mpsolve.vibration.forcing import Irregularity

_TESTED = np.array([[1 / 2, -1 / 2], [1 / 6, 0]])
"""∫φ_a of the integral of the linear function whose tests with φ_b are given."""
_MEAN = np.array([1, 1 / 3])
"""∫ P_l²."""


@dataclass(frozen=True)
class Setting:
    """A track in exponentials of this length, a vehicle with its outer forces, and where everything starts.

    contacts (n,): places in the moving frame; points (p,): the places watched; origin: of the moving frame at t = 0,
    from the left support; velocity, duration. steady: constant loads have acted for ever. unilateral: contacts, which
    all have a compliance, push only. rough: irregularities, none or one for each contact.
    """

    track: Exponentials
    length: float
    vehicle: Carriage
    outer: Outer
    contacts: Reals
    points: Reals
    origin: float
    velocity: float
    duration: float
    steady: bool = False
    unilateral: bool = False
    rough: tuple[Irregularity, ...] = ()


@dataclass(frozen=True)
class Motion:
    """At the ends of the steps, times (s + 1,): the rail (p, s + 1) under the points that move along.

    state (r, s + 1) and state_rate: of the kept coordinates. force (n, 2, s): the contact forces f₀P₀ + f₁P₁.
    """

    times: Any
    rail: Reals
    state: Any
    state_rate: Any
    force: Reals


def march(setting: Setting, steps: int, effort: Effort | None = None) -> Motion:
    """The motion in equal steps, each one evaluation; LinAlgError where the contact forces are not determined."""
    h = setting.duration / steps
    rail, vehicle = _Rail(setting, h), vehicle_tables(setting.vehicle, setting.outer, h)
    n, r = len(setting.contacts), len(setting.vehicle.K)
    contacts = _Contacts(setting, vehicle)
    X = vehicle.start
    states, forces = np.empty((steps + 1, len(X))), np.empty((steps, n, 2))
    deflection = np.zeros((steps + 1, len(setting.points)))
    if setting.steady:
        held = _steady(setting, rail)
        X = np.concatenate([held.kept, X[r:]])
        contacts.compression = setting.vehicle.H @ held.force
        deflection[0] = rail.read()
    states[0] = X
    rough = rough_rates(setting.rough, n, h, steps)
    for step in range(steps):
        if effort is not None:
            effort.spend(1)
        f = contacts.forces(rail.history() - rough[step], rail.gain(), X)
        X = vehicle.advance @ X + np.einsum("nlj,jl->n", vehicle.entry, f)
        rail.advance(f)
        states[step + 1], forces[step] = X, f
        deflection[step + 1] = rail.read()
    slope = _slope(vehicle, states, forces) / h
    return Motion(h * np.arange(steps + 1), deflection.T, states[:, :r].T, slope, np.moveaxis(forces, 0, -1))


class _Contacts:
    """The contact forces of each step, and how far each contact is compressed; one that is open carries none.

    A contact opens where the mean of its force over a step would pull, and closes where rail and wheel overlap.
    """

    def __init__(self, setting: Setting, vehicle: VehicleTables) -> None:
        n = len(setting.contacts)
        self._H, self._vehicle, self._unilateral = setting.vehicle.H, vehicle, setting.unilateral
        self._spring = np.linalg.inv(_TESTED)
        self._matrix = vehicle.gain - np.einsum("ac,c,ij->iacj", self._spring, _MEAN, setting.vehicle.H)
        self._soft = bool(setting.vehicle.H.any())
        self._closed = np.ones(n, bool)
        self.compression = np.zeros(n)

    def forces(self, history: Reals, gain: Reals, X: Reals) -> Any:
        """(n, l), from what the rail and the vehicle bring along."""
        own = np.einsum("ain,n->ia", self._vehicle.history, X)
        past = history - own
        if self._soft:
            past -= self.compression[:, None] * self._spring[:, 0]
        f = self._solved(self._matrix - gain, past)
        if self._unilateral:
            while (self._closed & (f[:, 0] < 0)).any():
                self._closed &= f[:, 0] >= 0
                f = self._solved(self._matrix - gain, past)
        if self._soft:
            moved = np.einsum("ij,jc->ic", self._H, f * _MEAN) - self.compression[:, None] * [1, 0]
            after = self.compression + moved @ self._spring[0]
            if not self._closed.all():
                rate = own - history + np.einsum("iacj,jc->ia", self._vehicle.gain - gain, f)
                after = np.where(self._closed, after, self.compression + rate[:, 0])
                self._closed |= after > 0
            self.compression = after
        return f

    def _solved(self, matrix: Reals, past: Reals) -> Any:
        n = len(past)
        if self._closed.all():
            return np.linalg.solve(matrix.reshape(2 * n, 2 * n), past.ravel()).reshape(2, n).T
        open_ = np.repeat(~self._closed, 2)
        matrix = np.where(open_[:, None], 0.0, matrix.reshape(2 * n, 2 * n))
        for i in np.flatnonzero(~self._closed):  # f = 0 in place of its two equations; columns are (force, contact)
            matrix[2 * i, i] = matrix[2 * i + 1, n + i] = 1.0
        return np.linalg.solve(matrix, np.where(open_, 0.0, past.ravel())).reshape(2, n).T


@dataclass(frozen=True)
class _Held:
    """The kept coordinates and the contact forces under constant loads that have moved for ever."""

    kept: Reals
    force: Reals


def _steady(setting: Setting, rail: _Rail) -> _Held:
    """The steady motion at t = 0, which the rail then carries: K y = g − B f, Bᵀy − W f = H f."""
    n, r = len(setting.contacts), len(setting.vehicle.K)
    W = np.array([rail.under(rail.steady_waves(unit)) for unit in np.eye(n)]).T
    vehicle = setting.vehicle
    matrix = np.block([[vehicle.K, vehicle.B], [vehicle.B.T, -W - vehicle.H]])
    push = vehicle.force(setting.outer.direction) @ setting.outer.constant
    found = np.linalg.solve(matrix, np.concatenate([push, np.zeros(n)]))
    rail.carry(rail.steady_waves(found[r:]))
    return _Held(found[:r], found[r:])


def _slope(vehicle: VehicleTables, states: Reals, forces: Reals) -> Any:
    """dy/dθ of the kept coordinates at the ends of the steps, (r, s + 1)."""
    ends = np.concatenate([forces[:1, :, 0] - forces[:1, :, 1], forces[..., 0] + forces[..., 1]])
    return vehicle.rate @ states.T + vehicle.rate_force @ ends.T


class _Rail:
    """The modes of the track as they are moved from step to step."""

    def __init__(self, setting: Setting, h: float) -> None:
        track = setting.track
        gaps = setting.contacts - setting.contacts[0]
        table = wave_tables(track.waves(setting.length, setting.velocity), gaps, h)
        shape = track.rate.shape
        self._h, self._weight, self._direct = h, track.weight, h * table.direct
        self._decay = table.decay.reshape(shape)
        self._entry = np.stack(table.entry).reshape(2, 2, *shape)  # (sign, l, R, J)
        self._history = h * np.stack(table.history).reshape(2, 2, *shape)  # (sign, a, R, J)
        self._image = h * table.image.reshape(4, *shape).sum(1).T.copy()  # (J, a l)
        self._turn = np.exp(1j * setting.velocity * h * track.k)
        self._shift = np.exp(1j * np.multiply.outer(gaps, track.k))
        places = np.multiply.outer(setting.points - setting.contacts[0], track.k)
        self._sine, self._cosine = np.sin(places), np.cos(places)
        self._carrier = track.turn * np.exp(1j * (setting.origin + setting.contacts[0]) * track.k)
        self._phase = self._shift * self._carrier
        self._z = np.zeros(shape, complex)

    def steady_waves(self, f: Any) -> Any:
        """What constant forces f (n,) leave in the modes when they have moved for ever, at the start."""
        along = f @ self._phase
        ahead, behind = self._entry[:, 0]
        return along * ahead / (self._turn - self._decay) + along.conj() * behind / (self._turn.conj() - self._decay)

    def carry(self, waves: Complexes) -> None:
        self._z = waves

    def under(self, waves: Complexes) -> Any:
        """The deflection under the contacts, (n,)."""
        return self._phase.imag @ (self._weight * waves).real.sum(0)

    def history(self) -> Any:
        """∫φ_a of the rail's rate in θ under the contacts, as far as it comes from the past, (n, a)."""
        ahead, behind = (self._history * self._z).sum(2)  # each (a, J)
        return (self._phase @ (ahead + behind.conj()).T).real

    def gain(self) -> Any:
        """The same per contact force of this step, (contact, test, force, contact)."""
        n = len(self._phase)
        products = (self._phase[:, None] * self._phase).reshape(n * n, -1)
        whole = self._direct + (products @ self._image).real.reshape(n, n, 2, 2)
        return whole.transpose(0, 2, 3, 1)

    def advance(self, f: Any) -> None:
        """To the end of the step under the forces f (n, l)."""
        along = f.T @ self._phase  # (l, J)
        self._z *= self._decay
        for waves, entry in ((along, self._entry[0]), (along.conj(), self._entry[1])):
            self._z += waves[0] * entry[0]
            self._z += waves[1] * entry[1]
        self._carrier = self._carrier * self._turn
        self._phase = self._shift * self._carrier

    def read(self) -> Any:
        """The deflection of the points, (p,)."""
        amplitude = (self._weight * self._z).real.sum(0)
        return self._cosine @ (self._carrier.imag * amplitude) + self._sine @ (self._carrier.real * amplitude)
