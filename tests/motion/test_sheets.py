"""The sheets above the cut line continue what is found below it; paths see the zeros that they pass."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from oracle import Truth

from mpsolve import Case
from mpsolve.fields import MP, Float64
from mpsolve.model.branch import track
from mpsolve.model.kernel import kernel_at_contact
from mpsolve.motion.paths import ellipse, graded, lift
from mpsolve.motion.quadrature import adaptive_panels
from mpsolve.motion.sheets import PHYSICAL, pairing_below, pairing_on, sections

CASES = [
    (Case(alpha="0.67", eta_b="0.05", eta_m=70), [0, 2]),
    (Case(alpha="1.2", eta_b="0.05", eta_m=70), [4, 2]),
    (Case(alpha="0.1", eta_b=0, eta_n="0.6", eta_m=70), [0, 2, 4, 2]),
]
ROOTS = {(0, 1): 0, (1, 1): 2, (0, -1): 4}


@pytest.mark.parametrize(("case", "real_roots"), CASES)
def test_each_section_continues_the_kernel_from_below(case: Case, real_roots: list[int]) -> None:
    """Against a Taylor polynomial of the paper's residue sums below the line."""
    model, truth = track(case, Float64()), Truth(case, 60)
    line = sections(case)
    assert [ROOTS[part.sheet.rank, part.sheet.sign] for part in line] == real_roots
    for part in line:
        middle = 0.0 if part.start < 0 else part.start + min(part.end - part.start, 1.0) / 2
        reach = min(part.end - middle, 0.5) / 20
        low = middle + 1j * (float(case.eta_b) - reach)
        turn = truth.mp.expjpi(truth.mp.mpf(2) / 24)
        points = [low + reach / 2 * turn**k for k in range(24)]
        values = [truth.kernel(0, q) for q in points]
        above = low + 1.5j * reach  # above the line by half of `reach`, within the disc of convergence
        coefficients = [
            sum(v * turn ** (-k * n) for k, v in enumerate(values)) / 24 / (reach / 2) ** n for n in range(24)
        ]
        expected = complex(sum(c * (1.5j * reach) ** n for n, c in enumerate(coefficients)))
        found = kernel_at_contact(model, pairing_on(model, np.array([above]), part.sheet))[0]
        assert abs(found - expected) < 1e-5 * abs(expected)
        physical = kernel_at_contact(model, pairing_on(model, np.array([above]), PHYSICAL))[0]
        assert part.gap == bool(abs(physical - expected) < 1e-5 * abs(expected))


@pytest.mark.parametrize("case", [case for case, _ in CASES])
def test_values_on_the_cut_are_limits_from_below(case: Case) -> None:
    field = MP(120)
    model, context = track(case, field), field.context
    for part in sections(case)[1:]:
        q = context.mpc(part.start + min(part.end - part.start, 1.0) / 2, float(case.eta_b))
        on = kernel_at_contact(model, pairing_below(model, q, context.mpf(2) ** -30))
        tiny = context.mpf(10) ** -9
        first, second = (
            kernel_at_contact(model, pairing_on(model, q - k * tiny * field.i, PHYSICAL)) for k in (1, 2)
        )
        assert abs(2 * first - second - on) < 1e-12 * abs(on)  # linear extrapolation


def test_a_path_finds_the_zeros_that_it_passes() -> None:
    """A zero on the continued sheet that is known from a second, lower path, and from the value there."""
    case = Case(alpha="1.2", eta_b="0.05", eta_m=(70, 70), positions=(0, "1.5"))
    model, part = track(case, Float64()), sections(case)[0]
    samples = np.linspace(1e-3, np.pi - 1e-3, 4000)

    def family(height: float) -> Any:
        return ellipse(complex(0, 0.05), part.end, height)

    high, low = (lift(model, family, height, samples, part.sheet, closed=True) for height in (0.4, 0.0005))
    assert high is not None
    assert low is not None
    assert len(high.zeros) == 3
    assert not low.zeros
    for q, s in high.zeros:
        assert q.imag > 0.05
        pair = pairing_on(model, np.array([q]), part.sheet)
        assert abs(pair.s[0] - s) < 1e-9
    found = [q for q, _ in high.zeros]
    assert all(min(abs(q + other.conjugate()) for other in found) < 1e-9 for q in found)


def test_panels_resolve_a_peak_and_a_decay() -> None:
    def place(u: Any) -> tuple[Any, Any]:
        return 1j * u, 1j + 0 * u

    def integrand(u: Any, _q: Any, _rate: Any) -> tuple[Any, Any]:
        return (1 / ((u - 0.3) ** 2 + 1e-6))[None, :], 2 * u

    panels = adaptive_panels(place, integrand, graded(1.0), 0.0, 1e-12, 10_000)
    assert np.array_equal(panels.left, 2 * panels.nodes)
    peak = 1 / ((panels.nodes - 0.3) ** 2 + 1e-6)
    exact = (np.arctan(0.7e3) + np.arctan(0.3e3)) * 1e3
    assert np.sum(panels.weights * peak) == pytest.approx(exact, rel=1e-12)
    assert np.sum(panels.weights * np.exp(-50 * panels.nodes)) == pytest.approx((1 - np.exp(-50)) / 50, rel=1e-12)
