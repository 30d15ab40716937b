"""The receptance of the beam under a moving force: tables for solvers that have their own vehicle and time steps."""

from __future__ import annotations

from typing import Any

import numpy as np

from mpsolve.errors import InputError
from mpsolve.fields import Float64
from mpsolve.model.branch import pairing, track
from mpsolve.model.kernel import AHEAD, BEHIND, kernel
from mpsolve.model.limits import limiting_frequency
from mpsolve.model.parameters import Case, PhysicalCase


def receptance(case: Case | PhysicalCase, xi: Any, q: Any) -> Any:
    """K(ξ, q) of (21) on the physical sheet, float64, complex, shape (len(xi), len(q)); the masses play no part.

    A force of 1 that moves along at ξ = 0 as e^{iqτ} deflects the beam by (4/π) K(ξ, q) e^{iqτ} in units of w_st,
    ξ ahead of it positive (13). xi: real, in units of 1/χ; q: complex, in units of χ v_cr, off the cuts.
    An obstacle Z_j(q) in place of η_Mj q² at ξ_j gives the system
    det[I − (2/π) K(ξ_i − ξ_j, q) Z_j(q)] = 0. InputError for points that are not finite, lie on a cut,
    or where float64 does not reach.

    A static unit force gives the deflection 1:

    >>> round(float(4 / np.pi * receptance(Case(alpha=0, eta_b=1, eta_m=1), 0, 0)[0, 0].real), 12)
    1.0
    """
    case = case.dimensionless if isinstance(case, PhysicalCase) else case
    places, points = np.atleast_1d(np.asarray(xi, float)), np.atleast_1d(np.asarray(q, complex))
    for name, values in (("xi", places), ("q", points)):
        if values.ndim != 1 or not np.isfinite(values).all():
            raise InputError(name, "is no list of finite numbers: give a number, or a list of numbers")
    if case.cuts_on_line:
        with np.errstate(all="ignore"):
            start, line = limiting_frequency(case, Float64()), float(case.eta_b)
        if ((points.imag == line) & (np.abs(points.real) >= start)).any():
            raise InputError(
                "q", f"lies on the cut Im q = {line}, where K has two values: give points on one side of it"
            )
    elif (points.imag > 0).any():
        raise InputError("q", "lies above the real axis, where the cuts of this case may be: give Im q ≤ 0")
    with np.errstate(all="ignore"):
        model = track(case, Float64())
        pair = pairing(model, points)
        K = np.array([kernel(model, pair, AHEAD if x >= 0 else BEHIND, abs(x)) for x in places.tolist()])
    if not np.isfinite(K).all():
        raise InputError("q", "has points where K cannot be computed in float64: give smaller ones, or a slower case")
    return K
