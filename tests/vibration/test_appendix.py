"""Every case of Figures A.1–A.5: the response against the inverse transform, and the finite beam against both."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from infinite import inverted
from laplace import Inversion, Line

from mpsolve import Case, certify, finite_beam, response
from mpsolve.vehicles.load import Load

SLOW = pytest.mark.slow
GROWTH = 0.05  # more than in Figures A.4 and A.5
SECOND = Line(periods=2.4, drop=36.0, fall=37.0, least=13.0)


def pair(alpha: str, eta_m: int, eta_b: str, distance: float) -> Case:
    return Case(alpha=alpha, eta_b=eta_b, eta_m=(eta_m, eta_m), positions=(0, distance))


APPENDIX = [
    *(pair(alpha, 40, "0", k / 2) for alpha in ("0.5", "0.9") for k in range(1, 10)),
    *(pair(alpha, 70, "0.05", k / 2) for alpha in ("0.5", "0.8", "0.9") for k in range(1, 4)),
]
UNEQUAL = Case(alpha="0.7", eta_b="0.02", eta_m=(70, 25), positions=(0, "1.3"))
THREE = Case(alpha="0.6", eta_b="0.05", eta_m=(70, 40, 30), positions=(0, 1, "2.5"), eta_n="0.2")
HARMONIC = (Load(1, "0.5", "0.3", "0.2"), Load("0.6", "0.8", "1.7", 2))
FORCED = [(UNEQUAL, HARMONIC), (THREE, (*HARMONIC, Load(2, 1, "0.3")))]
TRIALS = [*((case, (Load(), Load())) for case in APPENDIX), *FORCED]
SAMPLE = [TRIALS[k] for k in (*np.random.default_rng(5).choice(len(APPENDIX), 2, replace=False), -2, -1)]


def agree_with_the_inverse_transform(case: Case, loads: Any, times: tuple[float, ...]) -> None:
    """At contact points, between, behind and ahead of them; inversion along a second line tells its own error."""
    last = float(case.positions[-1])
    xi = (0.0, last, 0.25, -2.5, last + 2)
    found = response(case, loads, xi, times, certify(case, digits=20))
    for w, tau in zip(found.w.T, times, strict=True):
        truth = Inversion(case, loads, GROWTH)(xi, tau)
        again = Inversion(case, loads, 2 * GROWTH, 20, SECOND)(xi, tau)
        assert np.abs(again - truth).max() < 1e-11
        assert np.abs(w - truth).max() < min(found.error, 1e-8)
        assert np.abs(truth).max() > 1e-3


@pytest.mark.parametrize(("case", "loads"), SAMPLE)
def test_the_response_is_the_inverse_transform(case: Case, loads: Any) -> None:
    agree_with_the_inverse_transform(case, loads, (3.0, 30.0))


@SLOW
@pytest.mark.parametrize(("case", "loads"), TRIALS)
def test_the_response_is_the_inverse_transform_in_every_case(case: Case, loads: Any) -> None:
    """All together take about ten minutes on one core."""
    agree_with_the_inverse_transform(case, loads, (0.5, 3.0, 12.0, 40.0))


def test_the_transforms_in_float64_and_mpmath_agree() -> None:
    case, loads = SAMPLE[-1]
    xi = (0.0, 2.5, -1.0)
    assert np.abs(inverted(case, loads, xi, 1.0) - Inversion(case, loads)(xi, 1.0)).max() < 1e-12


def beam_agrees(case: Case, loads: Any) -> None:
    """To its own error, and to 1e-3 of the static deflection, which is 1."""
    tau, n, xi = np.linspace(0, 60, 61), case.count, (0.25, -2.5)
    beam = finite_beam(case, loads, tau, xi=xi)
    w = response(case, loads, (*(float(x) for x in case.positions), *xi), tau).w
    error = np.abs(np.concatenate([beam.displacement, beam.shape]) - w).max()
    assert error < min(beam.error.total, 1e-3)
    assert beam.error.total < 1e-3 * max(1.0, np.abs(w[:n]).max())


@pytest.mark.parametrize(("case", "loads"), SAMPLE[:1])
def test_the_finite_beam_agrees(case: Case, loads: Any) -> None:
    beam_agrees(case, loads)


@SLOW
@pytest.mark.parametrize(("case", "loads"), TRIALS)
def test_the_finite_beam_agrees_in_every_case(case: Case, loads: Any) -> None:
    """All together take about two minutes on one core."""
    beam_agrees(case, loads)
