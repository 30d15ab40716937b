"""The search about a branch point: it finds what Newton's method in balls enclosed, and nothing on other sheets."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from mpmath import mp

from mpsolve import Case, certify
from mpsolve.characteristic.proved import Proved
from mpsolve.problem.cases import as_problem
from mpsolve.problem.line import on_line
from mpsolve.problem.reduced import reduce_problem
from mpsolve.proof.effort import Effort
from mpsolve.spectrum.enclose import enclose
from mpsolve.spectrum.near_roots import beside_branch_points, near_branch_points
from mpsolve.spectrum.sheet import count_sheet


@pytest.mark.parametrize(
    ("alpha", "eta", "mass", "number"), [("0.5", "0.01", "1e-5", 1), ("0.5", 0, "1e-6", 1), ("0.67", "0.05", "70", 0)]
)
def test_each_is_next_to_a_root(alpha: str, eta: object, mass: str, number: int) -> None:
    reduced = reduce_problem(as_problem(Case(alpha=alpha, eta_b=eta, eta_m=[mass], positions=[0])))
    line = on_line(reduced)
    assert line is not None
    count = count_sheet(line, Effort(evaluations=100_000))
    found = near_branch_points(count)
    assert len(found) == number
    for sigma in found:
        ball = enclose(Proved(reduced), sigma, 20)
        away = abs(complex(ball.q.mid()) * 1j / float(reduced.frequency_unit) - complex(sigma))
        assert away < 1e-15


def test_on_both_sides_of_a_joined_cut_with_little_damping() -> None:
    """Above the speed of waves each root has a mirror beyond the cut, 5·10⁻⁵ away from it; both are enclosed."""
    given = Case(
        alpha="1.984", eta_b="0.001299", eta_m=("0.02044", "0.05313", "0.002817"), positions=(0, "0.05789", "0.84038")
    )
    line = on_line(reduce_problem(as_problem(given)))
    assert line is not None
    count = count_sheet(line, Effort(evaluations=100_000))
    found = sorted(beside_branch_points(count) * float(line.lower.frequency_unit), key=lambda q: q.imag)
    assert found[:2] == pytest.approx([1.74821676430 + 0.00125057975j, 1.74821630877 + 0.00135262266j], rel=1e-9)
    whole = certify(given, region="sheet", digits=15)
    assert (whole.proved, whole.count) == (True, 4)
    assert abs(_delta(found[1])) < 1e-6 * abs(_delta(found[1] + 1e-3j))


def _delta(q: complex) -> complex:
    """Δ of that case, from the roots of D in p and their residues."""
    shift = np.array([-1.984, q])  # Ω over p
    D = np.polyadd(np.polyadd([0.25, 0, 0, 0, 1], -np.polymul(shift, shift)), 0.002598j * shift)
    p, x, M = np.roots(D), [0, 0.05789, 0.84038], np.array([0.02044, 0.05313, 0.002817])
    ahead, weight = p.imag > 0, 1j / np.polyval(np.polyder(D), p)

    def kernel(y: float) -> complex:
        waves = weight * np.exp(1j * p * y)
        return complex(waves[ahead].sum() if y >= 0 else -waves[~ahead].sum())

    G = np.array([[kernel(a - b) for b in x] for a in x])
    return complex(np.linalg.det(np.eye(3) - q * q * G * M))


@pytest.mark.parametrize(("eta", "gap"), [("0.05", "0.0005"), ("0", "0.001")])
def test_two_masses_that_all_but_touch_at_rest(eta: str, gap: str) -> None:
    """They swing against each other 10⁻²⁰ below the branch point. By hand, with z = q − iη and κ⁴ = 1 − η² − z²:

    1 = M q² (G(0) − G(d)), and G(x) = e^{−κx} (cos κx + sin κx)/2κ³ is Winkler's beam.
    """
    whole = certify(Case(alpha=0, eta_b=eta, eta_m=["70", "70"], positions=[0, gap]), region="sheet", digits=30)
    assert (whole.proved, whole.count) == (True, 4)
    with mp.workdps(80):
        d, damping = mp.mpf(gap), mp.mpf(eta)

        def frequency(k: Any) -> Any:
            return mp.sqrt(1 - damping**2 - k**4) + 1j * damping

        def against(k: Any) -> Any:
            return 2 * k**3 - 70 * frequency(k) ** 2 * (1 - mp.exp(-k * d) * (mp.cos(k * d) + mp.sin(k * d)))

        truth = frequency(mp.findroot(against, 35 * d**2 * frequency(0) ** 2))
        assert 1e-23 < abs(truth - frequency(0)) < 1e-17
        errors = [abs(mp.mpmathify(complex(root.q.mid())) - truth) for root in whole.roots]
        (near,) = [root for root, error in zip(whole.roots, errors, strict=True) if error < 1e-10]
        middle = mp.mpc(near.q.real.mid().str(60, radius=False), near.q.imag.mid().str(60, radius=False))
        assert abs(middle - truth) < 1e-29
