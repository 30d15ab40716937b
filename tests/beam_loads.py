"""Times, forces and pairs of masses that tests of the finite beam share."""

from __future__ import annotations

import numpy as np

from mpsolve import Case
from mpsolve.vehicles.load import Load

TAU = np.linspace(0, 60, 121)
FORCES = (Load(1, "0.4", "0.3", "0.5"), Load("0.5", "0.3", "1.2", "-1"), Load("-0.2"))


def pair(alpha: str, eta_m: int, eta_b: str, distance: str) -> Case:
    return Case(alpha=alpha, eta_b=eta_b, eta_m=(eta_m, eta_m), positions=(0, distance))
