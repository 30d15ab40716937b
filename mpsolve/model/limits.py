"""Where the cuts begin: the limiting frequency q_lm and the velocity ratio α_C at which the cuts join.

D(p, q) = 0 with real p exactly when q = αp + iη_b ± ½√(p⁴ − 4Np² + 4β²), so that q_lm is the minimum over p
of ½√(p⁴ − 4Np² + 4β²) − αp, for any η_N, η_S and η_b < 1 with N < β; (33), (34) are its case η_b = N = 0.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from mpsolve.errors import InputError
from mpsolve.fields import Field
from mpsolve.model.branch import track
from mpsolve.problem.case import Case


def limiting_frequency(case: Case, field: Field) -> Any:
    """q_lm > 0 for α < α_C; zero or negative from α_C on, where the cuts are joined.

    Raises InputError when η_b ≥ 1 or N ≥ β (the cuts leave the line Im q = η_b).
    """
    require_cuts_on_line(case)
    t = track(case, field)
    if not case.alpha:
        return field.real_sqrt(t.beta2 - t.axial * t.axial) if case.axial.sign > 0 else field.real_sqrt(t.beta2)
    # stationary: z (z − 2N)² = α² (z² − 4Nz + 4β²) in z = p², at the largest root
    alpha2, axial = t.alpha * t.alpha, t.axial
    z = field.largest_real_root(-(4 * axial + alpha2), 4 * axial * (axial + alpha2), -4 * alpha2 * t.beta2)
    return field.real_sqrt(z * (z - 4 * axial) + 4 * t.beta2) / 2 - t.alpha * field.real_sqrt(z)


def critical_velocity_ratio(case: Case, field: Field) -> Any:
    """α_C = √(β − N), at which q_lm = 0. Raises InputError when η_b ≥ 1 or N ≥ β."""
    require_cuts_on_line(case)
    t = track(case, field)
    return field.real_sqrt(field.real_sqrt(t.beta2) - t.axial)


def branch_points(case: Case) -> list[float]:
    """All r ≥ 0 on the cuts where two p-roots meet, ascending, in float64: the extrema of r(p). Heuristic use."""
    alpha, axial, beta2 = float(case.alpha), float(case.axial), 1 - float(case.eta_b) ** 2
    # r' = α + (p³ − 2Np)/S = 0, squared; r = αp + S/2 with S² = p⁴ − 4Np² + 4β²
    square = np.polysub(np.polymul([1, 0, -2 * axial, 0], [1, 0, -2 * axial, 0]), [0])
    squared = np.polysub(square, alpha**2 * np.array([1, 0, -4 * axial, 0, 4 * beta2]))
    points = set()
    for p in np.roots(squared):
        x = p.real
        root = np.sqrt(max(x**4 - 4 * axial * x * x + 4 * beta2, 0.0))
        slope = alpha * root + x**3 - 2 * axial * x
        if abs(p.imag) < 1e-6 * (1 + abs(x)) and abs(slope) < 1e-6 * (1 + abs(x) ** 3):
            points.add(float(abs(alpha * x + root / 2)))
    return sorted(points)


def require_cuts_on_line(case: Case) -> None:
    if case.overdamped:
        raise InputError(
            "eta_b",
            f"is {case.eta_b.short()}, and from 1 on the branch cuts leave the line Im q = eta_b: "
            'only region="unstable", or a rectangle in Im q ≤ 0, can be certified',
        )
    if not case.cuts_on_line:
        raise InputError(
            "eta_n",
            f"gives eta_n − eta_s = {case.axial.beside(1)}, not below √(1 − eta_b²), and the branch cuts leave "
            'the line Im q = eta_b: only region="unstable", or a rectangle in Im q ≤ 0, can be certified',
        )
