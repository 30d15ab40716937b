"""Δ and Δ_q are the determinant (26) over π^n for any number of masses, with its limits in the distance."""

from __future__ import annotations

import flint
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from oracle import Truth, cases, frequencies, holds, point

from mpsolve import Case
from mpsolve.fields import MP, Float64, ball_arithmetic
from mpsolve.model.branch import pairing, track
from mpsolve.model.characteristic import characteristic, characteristic_rate
from mpsolve.model.kernel import AHEAD, BEHIND, kernel, kernel_at_contact

few = settings(max_examples=12)
numbers = pytest.mark.parametrize("masses", [1, 2, 3, 4])


@numbers
@few
@given(st.data())
def test_delta_is_the_determinant_26(masses: int, data: st.DataObject) -> None:
    case = data.draw(cases(masses=masses))
    q = data.draw(frequencies(case))
    bits = data.draw(st.sampled_from([64, 200, 1000]))
    truth = Truth(case, 2 * bits * 3 // 10)
    mp, exact = truth.mp, truth.delta(q)
    slope = mp.diff(truth.delta, q, h=mp.mpf(2) ** (-bits // 2)) if bits == 200 else None
    size = 1 + abs(exact) + abs(complex(q)) ** (2 * masses) * 100**masses
    with ball_arithmetic(bits) as field:
        model = track(case, field)
        value, rate = characteristic_rate(model, point(q))
        assert holds(value, exact)
        assert holds(characteristic(model, point(q)), exact)
        assert (value - value.mid()).abs_upper() < flint.arb(mp.mpf(2) ** (40 - bits) * size)
    other = track(case, MP(bits))
    assert abs(characteristic(other, q) - exact) < mp.mpf(2) ** (40 - bits) * size
    if slope is not None:
        assert abs(characteristic_rate(other, q)[1] - slope) < mp.mpf(2) ** -80 * size * 100
        assert abs(flint.acb(slope) - rate) < flint.arb(2) ** -80 * flint.arb(size * 100)


@numbers
@few
@given(st.data())
def test_float64_arrays_follow(masses: int, data: st.DataObject) -> None:
    case = data.draw(cases(masses=masses))
    qs = np.array([data.draw(frequencies(case, 0.125)) for _ in range(3)])
    values, slopes = characteristic_rate(track(case, Float64()), qs)
    assert np.allclose(characteristic(track(case, Float64()), qs), values, rtol=1e-12)
    precise = track(case, MP(150))
    truth = Truth(case, 30)
    for q, value, slope in zip(qs, values, slopes, strict=True):
        loss = (1 + 1 / abs(complex(truth.resultant(complex(q))))) ** (masses + 2)
        size = (1 + abs(q) ** 2 * 100) ** masses * loss * 1e-12
        exact, exact_slope = characteristic_rate(precise, complex(q))
        assert abs(value - complex(exact)) < size
        assert abs(slope - complex(exact_slope)) < size * 100


def test_distance_zero_merges_masses() -> None:
    """Of (26) the paper says that it is reduced to the equation of η_M1 + η_M2 for d = 0."""
    pair = Case(alpha="0.6", eta_b="0.1", eta_m=(30, 12), positions=(0, 0))
    single = Case(alpha="0.6", eta_b="0.1", eta_m=42)
    near = Case(alpha="0.6", eta_b="0.1", eta_m=(30, 12), positions=(0, "1e-12"))
    field, q = MP(200), 0.3 - 0.2j
    value = characteristic(track(single, field), q)
    assert characteristic(track(pair, field), q) == value
    assert 0 < abs(characteristic(track(near, field), q) - value) < 1e-8


def test_a_large_distance_decouples_masses() -> None:
    """(26): Δ → Δ₁ Δ₂, the error as K(d) K(−d)."""
    field, q = MP(200), 0.3 - 0.5j
    model = track(Case(alpha="0.6", eta_b="0.1", eta_m=(30, 12), positions=(0, 60)), field)
    singles = [characteristic(track(Case(alpha="0.6", eta_b="0.1", eta_m=m), field), q) for m in (30, 12)]
    upper, lower = Truth(Case(alpha="0.6", eta_b="0.1", eta_m=1), 30).p_roots(q)
    decay = float(np.exp(-60 * float(min(p.imag for p in upper) - max(p.imag for p in lower))))
    assert decay < 1e-12
    assert 0 < abs(characteristic(model, q) - singles[0] * singles[1]) < 1e6 * decay


@few
@given(st.data(), cases(masses=2))
def test_equal_masses_factor(data: st.DataObject, case: Case) -> None:
    """[1 − a(K(0) + κ)][1 − a(K(0) − κ)] with κ² = K(d) K(−d) and a = 2 η_M q²/π."""
    q = data.draw(frequencies(case))
    case = Case(alpha=case.alpha, eta_b=case.eta_b, eta_n=case.axial, eta_m=(7, 7), positions=case.positions)
    model = track(case, MP(200))
    pair, d = pairing(model, q), model.positions[1]
    mean = kernel_at_contact(model, pair)
    skew = model.field.sqrt(kernel(model, pair, AHEAD, d) * kernel(model, pair, BEHIND, d))
    a = 14 * q**2 / model.field.pi
    product = (1 - a * (mean + skew)) * (1 - a * (mean - skew))
    assert abs(characteristic(model, q) - product) < 1e-45 * (1 + abs(product))
