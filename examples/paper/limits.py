"""Where the cuts of the paper's beam begin, in balls: the limiting frequency q_lm, and α_C at which they join.

D(p, q) = 0 with real p exactly when q = αp + iη_b ± ½√(p⁴ − 4Np² + 4β²), so that q_lm is the minimum over p of
½√(p⁴ − 4Np² + 4β²) − αp, for any N = η_N − η_S < β = √(1 − η_b²); (33), (34) are its case η_b = N = 0.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from flint import fmpq_poly

from mpsolve.numbers.balls import precision, rational_ball
from mpsolve.numbers.realroots import as_fmpq, positive_roots
from mpsolve.problem.case import Case

_BITS = 128


def limiting_frequency(case: Case) -> Any:
    """q_lm > 0 for α < α_C; zero or negative from α_C on, where the cuts are joined."""
    alpha2, N, beta2 = case.alpha.as_fraction() ** 2, case.axial.as_fraction(), _beta2(case)
    with precision(_BITS):
        if not alpha2:
            return rational_ball(beta2 - max(N, Fraction(0)) ** 2).sqrt()
        # stationary: z (z − 2N)² = α² (z² − 4Nz + 4β²) in z = p², at the largest root
        cubic = (-4 * alpha2 * beta2, 4 * N * (N + alpha2), -(4 * N + alpha2), Fraction(1))
        z = positive_roots(fmpq_poly([as_fmpq(c) for c in cubic]))[-1][0]
        inner = z * (z - 4 * rational_ball(N)) + 4 * rational_ball(beta2)
        return inner.sqrt() / 2 - rational_ball(alpha2).sqrt() * z.sqrt()


def critical_velocity_ratio(case: Case) -> Any:
    """α_C = √(β − N), at which q_lm = 0."""
    with precision(_BITS):
        return (rational_ball(_beta2(case)).sqrt() - rational_ball(case.axial.as_fraction())).sqrt()


def _beta2(case: Case) -> Fraction:
    beta2: Fraction = 1 - case.eta_b.as_fraction() ** 2
    return beta2
