"""q_lm and α_C: against the definition by brute force, and against (33) where it holds."""

from __future__ import annotations

import flint
import numpy as np
import pytest
from hypothesis import given, settings
from oracle import Truth, cases, holds, sharp

from mpsolve import Case, InputError
from mpsolve.fields import MP, Float64, ball_arithmetic
from mpsolve.model.limits import branch_points, critical_velocity_ratio, limiting_frequency

few = settings(max_examples=60)


def brute_force(case: Case) -> float:
    """min over p of ½√(p⁴ − 4Np² + 4β²) − αp, on ever finer grids."""
    alpha, axial, beta2 = float(case.alpha), float(case.axial), 1 - float(case.eta_b) ** 2
    low, high = 0.0, 20.0
    for _ in range(8):
        p = np.linspace(low, high, 4001)
        values = np.sqrt(p**4 - 4 * axial * p**2 + 4 * beta2) / 2 - alpha * p
        best, step = p[np.argmin(values)], p[1] - p[0]
        low, high = max(best - 2 * step, 0.0), best + 2 * step
    return float(values.min())


@few
@given(cases())
def test_limiting_frequency_is_the_minimum(case: Case) -> None:
    expected = brute_force(case)
    precise = limiting_frequency(case, MP(200))
    assert abs(precise - expected) < 1e-12
    assert abs(limiting_frequency(case, Float64()) - expected) < 1e-9
    with ball_arithmetic(128) as field:
        ball = limiting_frequency(case, field)
        assert abs(ball - ball.mid()) < 1e-25
        assert ball.overlaps(flint.arb(precise) + flint.arb(0, 1e-50))


@pytest.mark.parametrize("eta_n", ["-1", "0", "0.3", "0.9"])
def test_limiting_frequency_of_a_standing_load(eta_n: str) -> None:
    """α = 0: √(β² − N²) for N > 0, where the minimum is at p² = 2N, else β, at p = 0."""
    case = Case(alpha=0, eta_b="0.3", eta_n=eta_n, eta_m=1)
    expected = (0.91 - max(float(eta_n), 0) ** 2) ** 0.5
    assert abs(limiting_frequency(case, MP(100)) - expected) < 1e-15
    assert abs(brute_force(case) - expected) < 1e-12


@pytest.mark.parametrize("alpha", ["0.01", "0.1", "0.5", "0.9", "0.999", "1.2"])
def test_equation_33_inverts_it(alpha: str) -> None:
    """(33) holds for η_b = 0 and η_N = η_S only; with q_lm < 0 it continues to α > α_C."""
    for pasternak in ("0", "0.4"):
        case = Case(alpha=alpha, eta_b=0, eta_n=pasternak, eta_s=pasternak, eta_m=1)
        field = MP(300)
        q, mp = limiting_frequency(case, field), field.context
        fourth = (8 + 20 * q**2 - q**4 - q * (q**2 + 8) ** mp.mpf("1.5")) / 8
        assert abs(fourth - mp.mpf(alpha) ** 4) < mp.mpf(10) ** -80


@few
@given(cases())
def test_q_lm_is_zero_at_alpha_c(case: Case) -> None:
    """α_C² = β − N; with damping it is not the paper's α_cr,ex = √(1 − N)."""
    field = MP(200)
    critical = critical_velocity_ratio(case, field)
    truth = Truth(case, 50)
    assert abs(critical**2 - (truth.mp.sqrt(1 - truth.eta_b**2) - truth.axial)) < 1e-45
    with ball_arithmetic(128) as balls:
        ball = critical_velocity_ratio(case, balls)
        assert holds(ball, critical)
        assert sharp(ball, 100)
    sign = float(limiting_frequency(case, Float64()))
    if abs(sign) > 1e-9:
        assert (sign > 0) == (float(case.alpha) < critical)


@few
@given(cases())
def test_branch_points_are_double_p_roots(case: Case) -> None:
    """At each of them D of (18) has two equal real p-roots, and |q_lm| is one of them."""
    truth = Truth(case, 30)
    points = branch_points(case)
    assert any(abs(r - abs(limiting_frequency(case, Float64()))) < 1e-6 for r in points)
    for r in points:
        roots = np.roots([complex(c) for c in truth.quartic(r + truth.mp.j * truth.eta_b)])
        gaps = [abs(a - b) for k, a in enumerate(roots) for b in roots[:k]]
        assert min(gaps) < 1e-3  # a double root to half the digits, a fourfold one (α = N = 0) to a quarter


@pytest.mark.parametrize(
    "changes", [{"eta_b": 1}, {"eta_b": 2}, {"eta_b": "0.6", "eta_n": "0.8"}, {"eta_n": "0.95", "eta_b": "0.5"}]
)
def test_cuts_off_the_line_are_refused(changes: dict[str, str]) -> None:
    """η_b ≥ 1, or N ≥ β."""
    case = Case(**({"alpha": "0.5", "eta_b": 0, "eta_m": 1} | changes))
    for function in (limiting_frequency, critical_velocity_ratio):
        with pytest.raises(InputError, match='region="unstable"'):
            function(case, Float64())
