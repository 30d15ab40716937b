"""The factors of D on the physical sheet are the paper's p-roots, sorted by the real axis."""

from __future__ import annotations

from typing import Any

import flint
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from oracle import Truth, cases, frequencies, holds, point, sharp

from mpsolve import Case
from mpsolve.errors import PrecisionError
from mpsolve.fields import MP, Float64, ball_arithmetic
from mpsolve.model.branch import ALONG_ALPHA, ALONG_DAMPING, ALONG_Q, Motion, pairing, pairing_rate, track

few = settings(max_examples=40)


@few
@given(st.data(), cases(), st.sampled_from([64, 200, 1000]))
def test_factors_are_the_upper_and_the_lower_p_roots(data: st.DataObject, case: Case, bits: int) -> None:
    """D = (p² − s p + t)(p² + s p + t'), (18): s, t − t' and the resultant R in balls and mpmath."""
    q = data.draw(frequencies(case))
    truth = Truth(case, 2 * bits // 3)
    (a, b), (c, e) = truth.p_roots(q)
    exact = (a + b, a * b - c * e, truth.resultant(q))
    with ball_arithmetic(bits) as field:
        pair = pairing(track(case, field), point(q))
        for ball, value in zip((pair.s, pair.h, pair.R), exact, strict=True):
            assert holds(ball, value)
            assert (ball - ball.mid()).abs_upper() < flint.arb(2) ** (40 - bits)
        assert holds(pair.discriminant(1), ((a - b) / 2) ** 2)
        assert holds(pair.discriminant(-1), ((c - e) / 2) ** 2)
    other = pairing(track(case, MP(bits)), q)
    for value, expected in zip((other.s, other.h, other.R), exact, strict=True):
        assert abs(value - expected) < truth.mp.mpf(2) ** (40 - bits)


@few
@given(st.data(), cases())
def test_float64_follows(data: st.DataObject, case: Case) -> None:
    q = data.draw(frequencies(case))
    (a, b), _ = Truth(case, 30).p_roots(q)
    s = complex(pairing(track(case, Float64()), q).s)
    assert abs(s - complex(a + b)) < 1e-7 * abs(complex(a + b))


@settings(max_examples=15)
@given(st.data(), cases())
def test_rates_are_derivatives(data: st.DataObject, case: Case) -> None:
    q = data.draw(frequencies(case))
    field = MP(300)
    model, mp = track(case, field), field.context

    def rate_of(name: str) -> Any:
        return mp.diff(lambda z: getattr(pairing(model, z), name), mp.mpmathify(q), h=mp.mpf(10) ** -25)

    rate = pairing_rate(model, q, pairing(model, q))
    for name in ("s", "y", "h", "R"):
        assert abs(getattr(rate, name) - rate_of(name)) < 1e-15 * (1 + abs(rate_of(name)))
    with ball_arithmetic(150) as balls:
        ball_model = track(case, balls)
        enclosed = pairing_rate(ball_model, point(q), pairing(ball_model, point(q)))
        assert all(holds(getattr(enclosed, name), getattr(rate, name)) for name in ("s", "y", "h", "R"))


@few
@given(st.data(), cases(), st.integers(8, 30))
def test_a_wide_ball_holds_every_point_or_is_refused(data: st.DataObject, case: Case, shrink: int) -> None:
    q = data.draw(frequencies(case, 2**-5))
    towards = complex(*data.draw(st.tuples(*[st.sampled_from([-1, -0.5, 0, 0.5, 1])] * 2)))
    reach = 2.0**-shrink
    with ball_arithmetic(80) as field:
        spread = flint.arb(0, reach)
        try:
            pair = pairing(track(case, field), point(q) + flint.acb(spread, spread))
        except PrecisionError:
            return
    truth = Truth(case, 40)
    (a, b), _ = truth.p_roots(q + reach * towards)
    assert holds(pair.s, a + b)
    assert holds(pair.R, truth.resultant(q + reach * towards))


@pytest.mark.parametrize("eta_b", ["0", "0.05"])
def test_a_ball_that_meets_the_cut_is_refused(eta_b: str) -> None:
    """q_lm is below 1, so q = 2 + iη_b is on the cut."""
    with ball_arithmetic(80) as field:
        model = track(Case(alpha="0.5", eta_b=eta_b, eta_m=1), field)
        with pytest.raises(PrecisionError):
            pairing(model, flint.acb(2, model.eta_b))
        with pytest.raises(PrecisionError):
            pairing(model, flint.acb(2, flint.arb(float(model.eta_b.mid()), 0.01)))


def test_a_narrow_ball_far_from_the_cut_stays_narrow() -> None:
    with ball_arithmetic(80) as field:
        model = track(Case(alpha="0.5", eta_b="0.05", eta_m=1), field)
        spread = flint.arb(0, 2.0**-20)
        pair = pairing(model, flint.acb(1, -1) + flint.acb(spread, spread))
    assert sharp(pair.s, 16)
    assert sharp(pair.R, 14)


def test_masses_at_one_place_are_merged() -> None:
    model = track(Case(alpha=0, eta_b=0, eta_m=(1, 2, 3), positions=(0, 0, 1)), Float64())
    assert model.eta_m == (3.0, 3.0)
    assert model.positions == (0.0, 1.0)


@pytest.mark.parametrize("motion", [ALONG_Q, ALONG_ALPHA, ALONG_DAMPING, Motion(q=0.5, alpha=-1, eta_b=0.25)])
@settings(max_examples=5)
@given(st.data(), cases(most_damping=0.9))
def test_rates_along_other_motions(motion: Motion, data: st.DataObject, case: Case) -> None:
    """The factors' derivatives with α and η_b, by differences of the truth's p-roots."""
    q = data.draw(frequencies(case, 2**-4))
    truth = Truth(case, 60)
    mp, alpha, eta_b = truth.mp, truth.alpha, truth.eta_b

    def factors_at(h: Any) -> dict[str, Any]:
        truth.alpha, truth.eta_b = alpha + motion.alpha * h, eta_b + motion.eta_b * h
        (a, b), (c, e) = truth.p_roots(mp.mpmathify(q) + motion.q * h)
        names = {"s": a + b, "y": (a + b) ** 2, "h": a * b - c * e, "c2": -4 * (truth.axial + truth.alpha**2)}
        return names | {"R": truth.resultant(mp.mpmathify(q) + motion.q * h)}

    with ball_arithmetic(200) as field:
        model = track(case, field)
        pair = pairing(model, point(q))
        rate = pairing_rate(model, point(q), pair, motion)
    step = mp.mpf(10) ** -20
    after, before = factors_at(step), factors_at(-step)
    for name in ("s", "y", "h", "c2", "R"):
        slope = (after[name] - before[name]) / (2 * step)
        assert abs(flint.acb(getattr(rate, name)) - flint.acb(slope)) < 1e-12 * (1 + abs(flint.acb(slope)))


@settings(max_examples=8)
@given(st.data(), cases(most_damping=0.9), st.sampled_from([1, -1]))
def test_rates_of_the_discriminants(data: st.DataObject, case: Case, side: int) -> None:
    q = data.draw(frequencies(case, 2**-4))
    truth = Truth(case, 60)
    mp, alpha = truth.mp, truth.alpha

    def discriminant(h: Any) -> Any:
        truth.alpha = alpha + h
        first, second = truth.p_roots(q)[0 if side == 1 else 1]
        return ((first - second) / 2) ** 2

    model = track(case, MP(200))
    rate = pairing_rate(model, q, pairing(model, q), ALONG_ALPHA).discriminant(side)
    assert abs(rate - mp.diff(discriminant, mp.zero, h=mp.mpf(10) ** -20)) < 1e-12 * (1 + abs(rate))
