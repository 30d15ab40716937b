"""Three arithmetics, one result: float64 and mpmath agree, and balls hold the truth and stay narrow."""

from __future__ import annotations

import threading
from typing import Any

import flint
import mpmath
import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from oracle import grid, holds, point, sharp

from mpsolve.errors import PrecisionError
from mpsolve.fields import MP, Float64, ball_arithmetic, real_pairing, simple_root

few = settings(max_examples=60)
PRECISIONS = (64, 200, 2000)
complexes = st.builds(complex, grid(-3, 3), grid(-3, 3))
mp = mpmath.MPContext()
mp.prec = 4200


def true_waves(sigma: Any, delta2: Any, x: Any) -> tuple[Any, Any, Any]:
    """The definitions, at a precision that outlives every cancellation of the tests."""
    sigma, delta2, x = mp.mpmathify(sigma), mp.mpmathify(delta2), mp.mpmathify(x)
    carrier, delta = mp.expj(sigma * x), mp.sqrt(delta2)
    if not delta:
        return carrier, carrier * x, -carrier * x**3 / 6
    cos, sin = mp.cos(delta * x), mp.sin(delta * x) / delta
    return carrier * cos, carrier * sin, carrier * (x * cos - sin) / (2 * delta2)


# --- waves -------------------------------------------------------------------------------------------------

# δ²x² on both sides of each switch between series and closed form, down to 0
NEAR = [0, 1e-40, 1e-30j, 2.0**-21, -(2.0**-20), 2.0**-19 * 1j, 0.0099, 0.0101j, -0.0101, 0.249, 0.251j, -0.26]


@pytest.mark.parametrize("z", NEAR)
@pytest.mark.parametrize("bits", PRECISIONS)
def test_waves_near_a_collision_lose_nothing(z: complex, bits: int) -> None:
    sigma, x = 0.375 + 0.5j, 1.25
    truth = true_waves(sigma, complex(z), x)
    with ball_arithmetic(bits) as field:
        for ball, value in zip(field.waves(point(sigma), point(complex(z)), flint.arb(x)), truth, strict=True):
            # the argument here is δ² = z, so that δ²x² is beside the switch or beyond it
            assert holds(ball, value)
            assert sharp(ball, bits - 16)
    for value, exact in zip(MP(bits).waves(mp.mpc(sigma), mp.mpc(z), x), truth, strict=True):
        assert abs(value - exact) < abs(exact) * mp.mpf(2) ** (16 - bits)
    for value, exact in zip(Float64().waves(sigma, complex(z), x), truth, strict=True):
        assert abs(complex(value) - complex(exact)) < 1e-12 * abs(complex(exact))


@few
@given(complexes, complexes, grid(0, 5), st.sampled_from(PRECISIONS))
def test_waves_agree_in_all_arithmetics(sigma: complex, delta2: complex, x: float, bits: int) -> None:
    truth = true_waves(sigma, delta2, x)
    size = float(max(abs(mp.expj((sigma + s * mp.sqrt(delta2)) * x)) for s in (1, -1))) * (1 + x**3)
    with ball_arithmetic(bits) as field:
        balls = field.waves(point(sigma), point(delta2), flint.arb(x))
    for ball, mid, flat, exact in zip(
        balls,
        MP(bits).waves(mp.mpc(sigma), mp.mpc(delta2), x),
        Float64().waves(sigma, delta2, np.array(x)),
        truth,
        strict=True,
    ):
        assert holds(ball, exact)
        assert (ball - ball.mid()).abs_upper() < size * flint.arb(2) ** (16 - bits)
        assert abs(mid - exact) < size * mp.mpf(2) ** (24 - bits)
        assert abs(complex(flat) - complex(exact)) < 1e-12 * size


@few
@given(complexes, st.integers(8, 40), complexes)
def test_waves_of_a_wide_ball_hold_every_point(middle: complex, shrink: int, towards: complex) -> None:
    """A ball of δ² around 0, or around either side of the switch at |z| = 1/4."""
    middle, reach = middle * 2.0 ** (-shrink // 4), 2.0**-shrink
    inside = middle + reach * complex(towards.real, towards.imag) / 3
    with ball_arithmetic(100) as field:
        spread = flint.arb(0, reach)
        try:
            balls = field.waves(point(1j), point(middle) + flint.acb(spread, spread), flint.arb(1))
        except PrecisionError:
            return  # the closed form needs δ ≠ 0
        for ball, exact in zip(balls, true_waves(1j, mp.mpmathify(inside), 1), strict=True):
            assert holds(ball, exact)
        assert all((b - b.mid()).abs_upper() < 300 * reach + 1e-25 for b in balls)


# --- cubic roots -------------------------------------------------------------------------------------------


@few
@given(st.tuples(*[st.builds(complex, grid(-2, 2), grid(0.1, 2))] * 3), st.sampled_from(PRECISIONS))
def test_dominant_sum_is_the_sum_of_the_upper_roots(drawn: tuple[complex, ...], bits: int) -> None:
    """Of a quartic with two roots above the real axis, two below, and no cubic term."""
    a, b, c = drawn[0], drawn[1], drawn[2].conjugate()
    e = -(a + b + c)
    assume(e.imag < -0.1 and abs(a - b) > 0.05 and abs(c - e) > 0.05)
    ys = [mp.mpmathify(s) ** 2 for s in (a + b, a + c, a + e)]
    gaps = [abs(ys[0] - y) for y in ys[1:]]
    assume(min(gaps) > 0.05 * abs(ys[0]))
    coefficients = [-(ys[0] + ys[1] + ys[2]), ys[0] * ys[1] + ys[0] * ys[2] + ys[1] * ys[2], -ys[0] * ys[1] * ys[2]]
    with ball_arithmetic(bits) as field:
        ball = field.dominant_sum(*(flint.acb(v) for v in coefficients))
    assert holds(ball, mp.mpmathify(a + b))
    assert sharp(ball, bits - 24)
    with mp.workprec(bits):
        rounded = [+v for v in coefficients]
    assert abs(MP(bits).dominant_sum(*rounded) - (a + b)) < abs(a + b) * mp.mpf(2) ** (32 - bits)
    flat = Float64().dominant_sum(*(np.array([complex(v)]) for v in coefficients))
    assert abs(complex(flat[0]) - (a + b)) < 1e-10 * abs(a + b)


@pytest.mark.parametrize("bits", PRECISIONS)
@pytest.mark.parametrize(("total", "other"), [(2j, 1), (206j / 1024, 1j / 1024)])
def test_dominant_sum_where_the_other_two_are_equal(total: complex, other: complex, bits: int) -> None:
    """Two p-roots on one side of the real axis meet: no singularity."""
    y, z = mp.mpmathify(total) ** 2, mp.mpmathify(other) ** 2
    coefficients = [-(y + 2 * z), 2 * y * z + z * z, -y * z * z]
    with ball_arithmetic(bits) as field:
        ball = field.dominant_sum(*(flint.acb(v) for v in coefficients))
        assert holds(ball, mp.mpmathify(total))
        assert sharp(ball, bits - 24)
    assert abs(Float64().dominant_sum(*(complex(v) for v in coefficients)) - total) < 1e-10 * abs(total)
    assert abs(MP(bits).dominant_sum(*coefficients) - total) < mp.mpf(2) ** (24 - bits)


@few
@given(grid(-3, 3), grid(-3, 3), grid(-3, 3), st.booleans(), st.sampled_from(PRECISIONS))
def test_largest_real_root(a: float, b: float, c: float, pair: bool, bits: int) -> None:
    """Of (y − a)(y − b)(y − c), or of (y − a)(y² − 2by + b² + c²) with one real root."""
    assume(min(abs(a - b), abs(b - c), abs(c - a), abs(a), abs(b), abs(c)) > 0.05)
    x = [mp.mpf(v) for v in (a, b, c)]
    low, product = (2 * x[1], x[1] ** 2 + x[2] ** 2) if pair else (x[1] + x[2], x[1] * x[2])
    coefficients = [-(x[0] + low), x[0] * low + product, -x[0] * product]
    truth = x[0] if pair else max(x)
    with ball_arithmetic(bits) as field:
        ball = field.largest_real_root(*(flint.arb(v) for v in coefficients))
    assert holds(ball, truth)
    assert (ball - ball.mid()).abs_upper() < flint.arb(2) ** (24 - bits)
    assert abs(MP(bits).largest_real_root(*coefficients) - truth) < mp.mpf(2) ** (40 - bits)
    assert abs(float(Float64().largest_real_root(*(float(v) for v in coefficients))) - float(truth)) < 1e-9


def test_simple_root_holds_the_root_for_every_coefficient_in_the_balls() -> None:
    with ball_arithmetic(100):
        wide = [flint.acb(flint.arb(v, 1e-6)) for v in (-6, 11, -6)]  # (y − 1)(y − 2)(y − 3)
        ball = simple_root(wide, 1.9, 100)
        assert ball.contains(flint.acb(2))
        for signs in np.ndindex(2, 2, 2):
            polynomial = [v + (2 * s - 1) * 9e-7 for v, s in zip((-6, 11, -6), signs, strict=True)]
            nearest = min(np.roots([1, *polynomial[::-1]]), key=lambda y: abs(y - 2))
            assert ball.contains(flint.acb(nearest.real))
        assert sharp(ball, 17)


@pytest.mark.parametrize(
    ("coefficients", "seed"),
    [
        ((-3, 7, -5), 1.0001),  # (y − 1)²(y − 3)
        ((-1, 3, -3), 0.9),  # (y − 1)³
        (([-6, 0.3], [11, 0.3], [-6, 0.3]), 2.0),  # balls in which roots meet
    ],
)
def test_simple_root_refuses_what_may_be_multiple(coefficients: tuple[Any, ...], seed: float) -> None:
    balls = [flint.acb(flint.arb(*v)) if isinstance(v, list) else flint.acb(v) for v in coefficients]
    with ball_arithmetic(100), pytest.raises(PrecisionError, match="split the piece"):
        simple_root(balls, seed, 100)


@few
@given(grid(-3, 3), grid(0.1, 3), grid(-3, 3), st.sampled_from(PRECISIONS))
def test_real_pairing_factors_a_real_quartic(c2: float, c1: float, c0: float, bits: int) -> None:
    """(p² − s p + t)(p² + s p + t') has t + t' = s² + c2, s h = c1 and t t' = c0."""
    with ball_arithmetic(bits):
        try:
            s, h = real_pairing(flint.arb(c2), flint.arb(c1), flint.arb(c0), bits)
        except PrecisionError:
            assume(False)
        total = s * s + c2
        assert (s * h).contains(flint.arb(c1))
        assert ((total * total - h * h) / 4).contains(flint.arb(c0))
        assert sharp(s, bits - 30)


# --- det and roots -----------------------------------------------------------------------------------------


def leibniz(rows: list[list[complex]]) -> Any:
    if not rows:
        return mp.one
    minors = [[row[:k] + row[k + 1 :] for row in rows[1:]] for k in range(len(rows))]
    return sum((-1) ** k * mp.mpc(rows[0][k]) * leibniz(minor) for k, minor in enumerate(minors))


@few
@given(st.integers(1, 4), st.lists(complexes, min_size=16, max_size=16))
def test_det_agrees_in_all_arithmetics(n: int, drawn: list[complex]) -> None:
    rows = [[20 * (i == k) + drawn[4 * i + k] for k in range(n)] for i in range(n)]
    truth = leibniz(rows)
    with ball_arithmetic(100) as field:
        ball = field.det([[point(v) for v in row] for row in rows])
        assert holds(ball, truth)
        assert (ball - ball.mid()).abs_upper() < 1e-22
    assert abs(MP(100).det(rows) - truth) < 1e-22
    stacked = Float64().det([[np.array([v, 2 * v]) for v in row] for row in rows])
    assert np.allclose(stacked, [complex(truth), 2 ** len(rows) * complex(truth)], rtol=1e-11, atol=1e-11)


@few
@given(complexes, st.integers(4, 60))
def test_a_balls_square_root_is_one_continuous_branch(middle: complex, shrink: int) -> None:
    """Also across the negative real axis, where the principal branch jumps."""
    reach = flint.arb(0, 2.0**-shrink)
    with ball_arithmetic(100) as field:
        z = point(middle) + flint.acb(reach, reach)
        if z.contains(0):
            with pytest.raises(PrecisionError):
                field.sqrt(z)
        else:
            root = field.sqrt(z)
            assert (root * root).contains(z)
            assert (root - root.mid()).abs_upper() < 8 * reach.rad() / z.abs_lower().sqrt()


# --- precision ---------------------------------------------------------------------------------------------


def test_ball_precision_is_put_back() -> None:
    before = flint.ctx.prec
    with ball_arithmetic(777):
        assert flint.ctx.prec == 777
        with ball_arithmetic(99):
            assert flint.ctx.prec == 99
        assert flint.ctx.prec == 777
    assert flint.ctx.prec == before
    with pytest.raises(ZeroDivisionError), ball_arithmetic(777):
        raise ZeroDivisionError
    assert flint.ctx.prec == before
    with pytest.raises(PrecisionError), ball_arithmetic(500):
        simple_root([flint.acb(0), flint.acb(0), flint.acb(0)], 0, 500)
    assert flint.ctx.prec == before


def test_threads_wait_for_each_others_precision() -> None:
    before, seen = flint.ctx.prec, []

    def work(bits: int) -> None:
        for _ in range(200):
            with ball_arithmetic(bits):
                third = flint.arb(1) / 3
                seen.append(
                    flint.ctx.prec == bits and -2 - bits < float(third.rad().log() / flint.arb(2).log()) < 2 - bits
                )

    threads = [threading.Thread(target=work, args=(bits,)) for bits in (70, 900, 130)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(seen) == 600
    assert all(seen)
    assert flint.ctx.prec == before


@pytest.mark.parametrize("bits", [52, 1, 0, -5])
def test_mpmath_below_float64_is_refused(bits: int) -> None:
    with pytest.raises(ValueError, match="at least 53"):
        MP(bits)


def test_mpmaths_global_precision_is_left_alone() -> None:
    before = mpmath.mp.prec
    assert abs(MP(400).sqrt(2) ** 2 - 2) < mpmath.mpf(2) ** -390
    assert mpmath.mp.prec == before
