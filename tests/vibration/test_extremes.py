"""Far positions, close masses, narrow gaps and light masses: right, as the inverse transform has it, or refused."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from infinite import inverted

from mpsolve import Case, certify, response
from mpsolve.errors import MpsolveError
from mpsolve.vehicles.load import Load


def agrees(case: Case, loads: Any, xi: Any, times: Any) -> None:
    spectrum = certify(case, digits=20)
    found = response(case, loads, xi, times, spectrum)
    growth = max((-float(root.q.imag.mid()) for root in spectrum.roots), default=0.0)
    for k, tau in enumerate(times):
        truth = inverted(case, loads, xi, tau, 1.02 * max(growth, 0.0))
        size = max(1.0, np.abs(found.steady).max(), np.abs(found.harmonic[:, k]).max())
        assert np.abs(found.w[:, k] - truth).max() < 1e-8 * size


@pytest.mark.parametrize(
    ("case", "loads", "xi"),
    [
        # supercritical, where waves grow away from the masses on the lifted part between the branch points
        (Case(alpha="1.43", eta_b="0.03", eta_m=70), [Load("-0.5", "1.6", "-1.74", 2)], (0, -2.4, -50)),
        (Case(alpha="2.2", eta_b=0, eta_n="-1.38", eta_m=(100, 100), positions=(0, "6.2")), None, (0, 6.2, -74)),
        # at rest with axial force: both pairs of p-roots meet at once, and rounding is large near the branch point
        (Case(alpha=0, eta_b="0.87", eta_n="0.263", eta_m=(4.5, 4.5), positions=(0, "0.222")), None, (0, 0.222, 1.1)),
    ],
)
def test_what_had_been_refused_is_right(case: Case, loads: Any, xi: Any) -> None:
    agrees(case, loads or [Load()] * case.count, xi, (0.3, 4.0, 30.0))


def test_a_seeded_sample_is_right_or_refused_with_a_reason() -> None:
    random, reasons = np.random.default_rng(11), []
    for _ in range(10):
        eta_b = random.choice([0, 1e-6, 0.05, round(random.uniform(0, 0.95), 3)])
        alpha, eta_m = round(random.uniform(0, 1.4), 4), np.round(random.uniform(1, 300, 2), 2)
        gap, far = round(random.uniform(0.2, 4.5), 2), round(random.uniform(-40, 40), 1)
        case = Case(alpha=alpha, eta_b=float(eta_b), eta_m=eta_m.tolist(), positions=(0, gap))
        loads = [Load(1, 0.5, round(random.uniform(0, 2), 3)), Load()]
        try:
            agrees(case, loads, (0, gap, far), (0.5, 6.0, 25.0))
        except MpsolveError as error:
            reasons.append(str(error))
    assert len(reasons) <= 2
    assert all(any(word in reason for word in ("change", "ask for", "take", "give")) for reason in reasons)
