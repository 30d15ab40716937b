"""Where a mass would lift off the beam: the assumption of tight contact, looked at afterwards."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from mpsolve.vehicles.load import Load

_NOISE = 1e-6  # of the largest force: what float64 leaves of a contact force that is 0


def applied(load: Load, tau: Any) -> Any:
    """The force of the load at the times τ, P_j(τ) of (2); float64."""
    constant, amplitude, omega, phase = map(float, (load.constant, load.amplitude, load.frequency, load.phase))
    return constant + amplitude * np.sin(omega * tau + phase)


def contact_loss(loads: Sequence[Load], force: Any, tau: Any) -> tuple[tuple[float | None, str], ...]:
    """For each mass the first time at which its contact force falls below zero, and what is to be said of it.

    The time is linear between the given ones; None where the force never falls, or cannot be judged.
    """
    size = sum(abs(float(load.constant)) + abs(float(load.amplitude)) for load in loads)
    order = np.argsort(tau)
    return tuple(
        _first_loss(load, row[order], tau[order], _NOISE * size) for load, row in zip(loads, force, strict=True)
    )


def _first_loss(load: Load, force: Any, tau: Any, noise: float) -> tuple[float | None, str]:
    pressing = float(load.constant) if load.frequency else float(applied(load, 0.0))
    if pressing <= 0:
        return None, "no constant force presses this mass on the beam, so its contact cannot be judged"
    lifted = np.flatnonzero(force < -noise)
    if not len(lifted):
        return None, ""
    k = int(lifted[0])
    pressed = np.flatnonzero(force[:k] > noise)
    if len(pressed):
        j = int(pressed[-1])
        return float(tau[j] + (tau[k] - tau[j]) * force[j] / (force[j] - force[k])), ""
    if tau[k] == 0:
        return 0.0, ""
    return float(
        tau[k]
    ), f"contact is lost before τ = {tau[k]:.6g}, the first given time that tells: give earlier ones"
