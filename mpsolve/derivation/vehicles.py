"""The equations of motion of every vehicle from its energies, by Lagrange's equations.

T: kinetic energy, V: energy of the springs, R: half the power that the dampers take. The contact forces λ work on the
motion of the contact points, which gives B.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import sympy as sp

from mpsolve import vehicles
from mpsolve.derivation.tracks import Expr, symbols_of, t
from mpsolve.errors import InputError
from mpsolve.vehicles.vehicle import AnyVehicle

half = sp.Rational(1, 2)


@dataclass(frozen=True)
class Energies:
    """Coordinates y(t), T, V, R, and the place and motion of each contact."""

    coordinates: tuple[Expr, ...]
    T: Expr
    V: Expr
    R: Expr
    contacts: tuple[tuple[Expr, Expr], ...]

    @property
    def matrices(self) -> tuple[Expr, Expr, Expr, Expr]:
        """M, C, K and B of d/dt ∂T/∂ẏ + ∂R/∂ẏ + ∂V/∂y = B λ."""
        y, rates = sp.Matrix(self.coordinates), sp.Matrix([one.diff(t) for one in self.coordinates])
        momenta = sp.Matrix([self.T]).jacobian(rates)
        return (
            sp.expand(momenta.jacobian(rates)),
            sp.expand(sp.Matrix([self.R]).jacobian(rates).jacobian(rates)),
            sp.expand(sp.Matrix([self.V]).jacobian(y).jacobian(y)),
            sp.Matrix([motion for _, motion in self.contacts]).jacobian(y).T,
        )

    @property
    def equations(self) -> tuple[Expr, ...]:
        """The left sides of Lagrange's equations."""
        return tuple(
            sp.expand(self.T.diff(one.diff(t)).diff(t) + self.R.diff(one.diff(t)) + self.V.diff(one))
            for one in self.coordinates
        )


@lru_cache
def energies(model: type[AnyVehicle], body: bool = False) -> Energies:
    """The energies of a vehicle of the catalogue, its parameters symbols; body: a bogie with one of its own."""
    a = symbols_of(model)
    if model not in (vehicles.Bogie, *_ENERGIES):
        stated = f"is {model.name}, whose energies are not written down"
        raise InputError("vehicle", f"{stated}: write them in mpsolve/derivation/vehicles.py")
    return _bogie(a, body) if model is vehicles.Bogie else _ENERGIES[model](a)


def _moving(*names: str) -> tuple[Expr, ...]:
    return tuple(sp.Function(name)(t) for name in names)


def _kinetic(*pairs: tuple[Expr, Expr]) -> Expr:
    return sum(half * mass * motion.diff(t) ** 2 for mass, motion in pairs)


def _link(stiffness: Expr, damping: Expr, lengthening: Expr) -> tuple[Expr, Expr]:
    """The energy of a spring, and half the power of the damper beside it."""
    return half * stiffness * lengthening**2, half * damping * lengthening.diff(t) ** 2


def _mass(a: Any) -> Energies:
    (wheel,) = _moving("y_w")
    return Energies((wheel,), _kinetic((a.M, wheel)), sp.Integer(0), sp.Integer(0), ((sp.Integer(0), wheel),))


def _oscillator(a: Any) -> Energies:
    wheel, body = _moving("y_w", "y_b")
    V, R = _link(a.k, a.c, body - wheel)
    return Energies((wheel, body), _kinetic((a.wheel, wheel), (a.body, body)), V, R, ((sp.Integer(0), wheel),))


def _running(a: Any, names: tuple[str, ...], middle: Expr) -> Energies:
    """A bogie without body, whose middle is at `middle`: the frame is rigid, y + θ x."""
    rear, front, frame, pitch = _moving(*names)
    arm = a.wheelbase / 2
    links = [_link(a.k, a.c, frame + side * arm * pitch - wheel) for side, wheel in ((-1, rear), (1, front))]
    T = _kinetic((a.wheel, rear), (a.wheel, front), (a.frame, frame), (a.inertia, pitch))
    contacts = ((middle - arm, rear), (middle + arm, front))
    return Energies((rear, front, frame, pitch), T, sum(V for V, _ in links), sum(R for _, R in links), contacts)


def _bogie(a: Any, body: bool) -> Energies:
    run = _running(a, ("y_r", "y_f", "y", "theta"), sp.Integer(0))
    if not body:
        return run
    (carried,) = _moving("y_b")
    V, R = _link(a.k2, a.c2, carried - run.coordinates[2])
    T = run.T + _kinetic((a.body, carried))
    return Energies((*run.coordinates, carried), T, run.V + V, run.R + R, run.contacts)


def _coach(a: Any) -> Energies:
    """The bogie's parameters are symbols of their own, with `inertia` of the bogie called so."""
    under = symbols_of(vehicles.Bogie)
    under.inertia = sp.Symbol("inertia_bogie", positive=True)
    rear = _running(under, ("y_1", "y_2", "y_r", "theta_r"), -a.pivots / 2)
    front = _running(under, ("y_3", "y_4", "y_f", "theta_f"), a.pivots / 2)
    bounce, pitch = _moving("y_b", "theta_b")
    arm = a.pivots / 2
    links = [
        _link(a.k2, a.c2, bounce - arm * pitch - rear.coordinates[2]),
        _link(a.k2, a.c2, bounce + arm * pitch - front.coordinates[2]),
    ]
    return Energies(
        (*rear.coordinates, *front.coordinates, bounce, pitch),
        rear.T + front.T + _kinetic((a.body, bounce), (a.inertia, pitch)),
        rear.V + front.V + sum(V for V, _ in links),
        rear.R + front.R + sum(R for _, R in links),
        (*rear.contacts, *front.contacts),
    )


_ENERGIES: dict[type[AnyVehicle], Callable[[Any], Energies]] = {
    vehicles.Mass: _mass,
    vehicles.Oscillator: _oscillator,
    vehicles.Coach: _coach,
}
