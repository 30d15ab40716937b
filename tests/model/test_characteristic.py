"""Δ is the determinant (26) over π^n for any number of masses, with its derivatives and limits in the distance."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import flint
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from oracle import Truth, cases, frequencies, grid, holds, point

from mpsolve import Case
from mpsolve.errors import PrecisionError
from mpsolve.fields import MP, Float64, ball_arithmetic
from mpsolve.model.branch import Motion, pairing, track
from mpsolve.model.characteristic import characteristic, characteristic_rate, characteristic_rates
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


# --- derivatives along other motions ------------------------------------------------------------------------


def moved(truth: Truth, motion: Motion, q: complex) -> Callable[[Any], Any]:
    """h ↦ Δ of the truth with every argument moved by h along the motion."""
    start = truth.alpha, truth.eta_b, list(truth.eta_m), list(truth.x)
    masses, places = (speeds or (0,) * len(truth.x) for speeds in (motion.eta_m, motion.positions))

    def at(h: Any) -> Any:
        truth.alpha, truth.eta_b = start[0] + motion.alpha * h, start[1] + motion.eta_b * h
        truth.eta_m = [eta + speed * h for eta, speed in zip(start[2], masses, strict=True)]
        truth.x = [x + speed * h for x, speed in zip(start[3], places, strict=True)]
        return truth.delta(truth.mp.mpmathify(q) + motion.q * h)

    return at


@st.composite
def motions(draw: st.DrawFn, masses: int) -> Motion:
    speeds = st.tuples(*[grid(-1, 1)] * masses)
    return Motion(
        q=draw(grid(-1, 1)),
        alpha=draw(grid(-1, 1)),
        eta_b=draw(grid(-1, 1)),
        eta_m=draw(st.one_of(st.none(), speeds)),
        positions=draw(st.one_of(st.none(), speeds)),
    )


@numbers
@settings(max_examples=8)
@given(st.data())
def test_rates_along_any_motion(masses: int, data: st.DataObject) -> None:
    """q, α, η_b, the masses and their positions, alone and together, by differences of the truth."""
    case = data.draw(cases(masses=masses))
    q = data.draw(frequencies(case, 2**-4))
    every = Motion(q=1), Motion(alpha=1), Motion(eta_b=1), Motion(positions=tuple(range(masses)))
    chosen = (data.draw(st.sampled_from(every)), data.draw(motions(masses)))
    truth = Truth(case, 60)
    value = truth.delta(q)
    slopes = [truth.mp.diff(moved(truth, motion, q), truth.mp.zero, h=truth.mp.mpf(10) ** -20) for motion in chosen]
    size = 1 + abs(value) + max(abs(slope) for slope in slopes)
    tolerance = 1e-15 * size * (1 + 1 / abs(Truth(case, 30).resultant(q))) ** 4
    with ball_arithmetic(150) as field:
        found, rates = characteristic_rates(track(case, field), point(q), chosen)
        assert holds(found, value)
        for rate, slope in zip(rates, slopes, strict=True):
            assert abs(rate - flint.acb(slope)) < flint.arb(tolerance)
    other, rates = characteristic_rates(track(case, MP(200)), q, chosen)
    assert abs(other - value) < tolerance
    assert all(abs(rate - slope) < tolerance for rate, slope in zip(rates, slopes, strict=True))


@settings(max_examples=8)
@given(st.data(), cases(masses=2), st.sampled_from(["alpha", "eta_b", "positions"]))
def test_rates_over_wide_balls_hold_those_of_each_point(data: st.DataObject, case: Case, name: str) -> None:
    """As interval Newton needs them: the parameter is a ball, and the truth anywhere within."""
    q = data.draw(frequencies(case, 2**-3))
    reach, towards = 2.0**-12, data.draw(st.sampled_from([-1.0, 0.5, 1.0]))
    motion = Motion(positions=(0, 1)) if name == "positions" else Motion(**{name: 1})
    truth = Truth(case, 50)
    along = moved(truth, motion, q)
    slope = truth.mp.diff(along, truth.mp.mpf(reach * towards), h=truth.mp.mpf(10) ** -16)
    with ball_arithmetic(128) as field:
        model, spread = track(case, field), flint.arb(0, reach)
        wide = model.positions[0], model.positions[1] + spread
        model = replace(model, **{name: wide if name == "positions" else getattr(model, name) + spread})
        try:
            _, (rate,) = characteristic_rates(model, point(q), (motion,))
        except PrecisionError:
            return
        error = flint.arb(0, 1e-12 * (1 + float(abs(slope))))
        assert holds(rate + flint.acb(error, error), slope)


def test_a_motion_that_stands_still_has_no_rate() -> None:
    case = Case(alpha="0.6", eta_b="0.1", eta_m=(30, 12), positions=(0, "0.7"))
    value, (rate,) = characteristic_rates(track(case, MP(100)), 0.3 - 0.2j, (Motion(),))
    assert rate == 0
    assert abs(value - characteristic(track(case, MP(100)), 0.3 - 0.2j)) < 2.0**-95 * abs(value)
    assert characteristic_rates(track(case, MP(100)), 0.3 - 0.2j, ())[1] == []
