"""The first effect of damping: against the paper's residue sums in mpmath, and against certified roots."""

from __future__ import annotations

import flint
import pytest
from oracle import Truth

from mpsolve import Case, InputError
from mpsolve.certificate.sheet import certify_sheet as certify
from mpsolve.stability.sensitivity import damping_sensitivity

CASES = [("0.5", "1", ("40", "40"), 0), ("0.8", "1.5", ("70", "70"), 0), ("0.6", "2", ("30", "10"), "0.2")]


def _case(alpha: str, distance: str, eta_m: tuple[str, ...], eta_n: object, eta_b: object = 0) -> Case:
    return Case(alpha=alpha, eta_b=eta_b, eta_m=eta_m, positions=(0, distance), eta_n=eta_n)


@pytest.mark.parametrize("values", CASES)
def test_rates_are_those_of_the_residue_sums(values):
    """Δ_{η_b} and Δ_q by differences of the truth, whose damping is complex here."""
    case = _case(*values)
    found = damping_sensitivity(case, digits=20)
    assert found.proved
    truth = Truth(case, 50)
    mp = truth.mp
    for item in found:
        q, step = truth.middle(flint.acb(item.q)), mp.mpf(10) ** -12

        def damped(eta_b, q=q):
            truth.eta_b = eta_b
            return truth.delta(q)

        along_damping = (damped(step) - damped(-step)) / (2 * step)
        truth.eta_b = mp.mpf(0)
        along_q = (truth.delta(q + step) - truth.delta(q - step)) / (2 * step)
        assert abs(mp.im(-along_damping / along_q) - mp.mpf(item.rate.mid().str(30, radius=False))) < 1e-15


@pytest.mark.parametrize("values", CASES)
def test_a_little_damping_moves_the_roots_by_the_rate(values):
    found = damping_sensitivity(_case(*values))
    damped = [root for root in certify(_case(*values, eta_b="1e-8")).roots if root.q.real > 0]
    assert len(damped) == len(found) > 0
    for item, root in zip(found, damped, strict=True):
        assert abs(root.q.imag * 10**8 - item.rate) < 1e-6
        assert item.destabilised is bool(item.rate < 0)


def test_signs():
    assert [item.destabilised for item in damping_sensitivity(_case(*CASES[1]))] == [False, True]


def test_digits_are_proved():
    for item in damping_sensitivity(_case(*CASES[0]), digits=60):
        assert item.rate.rad() < abs(item.rate) * flint.arb(10) ** -60


@pytest.mark.parametrize(("alpha", "eta_b", "key"), [("0.5", "0.1", "eta_b"), ("1", 0, "alpha"), ("1.2", 0, "alpha")])
def test_what_has_no_real_roots_in_a_gap_is_refused(alpha, eta_b, key):
    with pytest.raises(InputError, match=key):
        damping_sensitivity(Case(alpha=alpha, eta_b=eta_b, eta_m=40))
