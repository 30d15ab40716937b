"""Every printed digit is proved: the decimal lies within one unit in its last place of the whole ball."""

from __future__ import annotations

import mpmath
import pytest
from flint import arb, fmpq
from hypothesis import example, given
from hypothesis import strategies as st

from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import precision
from mpsolve.numbers.decimals import decimal, fixed_digits, outward, proved_digits

EXACT = mpmath.MPContext()
EXACT.prec = 4000


def last_unit(text: str) -> mpmath.mpf:
    """One unit in the last place of a decimal text."""
    mantissa, _, exponent = text.partition("e")
    places = len(mantissa.partition(".")[2])
    return EXACT.mpf(10) ** (int(exponent or 0) - places)


def ends(ball: arb) -> list[mpmath.mpf]:
    values = []
    for x in (ball.mid(), ball.rad()):
        mantissa, exponent = x.man_exp()
        values.append(EXACT.ldexp(EXACT.mpf(int(mantissa)), int(exponent)))
    return [values[0] - values[1], values[0] + values[1]]


mantissas, powers = st.integers(-(10**40), 10**40), st.integers(-400, 300)


@given(mantissas, powers, st.integers(0, 10**9), powers, st.integers(1, 60))
@example(9999999999, 0, 1, -20, 10)
@example(0, 0, 0, 0, 5)
@example(0, 0, 3, -50, 5)
@example(-(10**40), 0, 0, 0, 3)
@example(15, -1, 4, -1, 5)
def test_one_unit_in_the_last_place(m: int, e: int, r: int, f: int, limit: int) -> None:
    with precision(300):
        ball = arb(m) * arb(2) ** e + arb(0, arb(r) * arb(2) ** f)
    text = proved_digits(ball, limit)
    assert all(abs(EXACT.mpf(text) - end) <= last_unit(text) for end in ends(ball))
    shown = decimal(ball, limit)
    assert all(abs(EXACT.mpf(text) - end) <= EXACT.mpf(shown.radius_text) for end in ends(ball))
    assert shown.radius <= fmpq(10) ** shown.place or not shown.radius
    figures = text.partition("e")[0].lstrip("-0.").replace(".", "")
    assert len(figures) <= limit or text.isdigit()


@given(st.integers(1, 10**30), st.integers(-100, 100), st.integers(2, 25))
def test_sharp_balls_fill_the_limit(m: int, e: int, limit: int) -> None:
    with precision(300):
        text = proved_digits((arb(m) * arb(2) ** e).sqrt() + arb(0, 1) * arb(2) ** -400, limit)
    assert len(text.partition("e")[0].replace(".", "").lstrip("0")) >= limit - 1


@pytest.mark.parametrize(
    ("ball", "limit", "text", "radius"),
    [
        (arb(0), 5, "0", "0"),
        (arb(1) / 4, 30, "0.25", "0"),
        (arb(100), 2, "1.0e2", "0"),
        (arb(123456.5, 3), 30, "1.2346e5", "6.51"),
        (arb(2.5, 0.0009), 10, "2.500", "0.000901"),
        (arb(-1.25, 0.0009), 10, "-1.250", "0.000901"),
        (arb(9.999999, 1e-9), 3, "10.0", "1.01e-6"),
        (arb(0, 0.4), 5, "0", "0.401"),
        (arb(0, 2.0**-40), 5, "0e-12", "9.10e-13"),
    ],
)
def test_as_it_is_written(ball: arb, limit: int, text: str, radius: str) -> None:
    assert (decimal(ball, limit).text, decimal(ball, limit).radius_text) == (text, radius)


@given(mantissas, powers, st.integers(0, 10**9), powers, st.integers(1, 60))
@example(9999999999, 0, 1, -20, 10)
@example(15, -1, 1, -20, 1)
@example(-(10**40), 0, 0, 0, 3)
def test_fixed_digits_are_those_of_every_point(m: int, e: int, r: int, f: int, limit: int) -> None:
    with precision(300):
        ball = arb(m) * arb(2) ** e + arb(0, arb(r) * arb(2) ** f)
    try:
        text = fixed_digits(ball, limit)
    except PrecisionError:
        assert ball.contains(0) or ball.rel_accuracy_bits() < 5
        return
    assert all(abs(EXACT.mpf(text) - end) <= last_unit(text) / 2 for end in ends(ball))
    figures = text.partition("e")[0].lstrip("-0.").replace(".", "")
    assert len(figures) <= limit or text.isdigit()


@pytest.mark.parametrize(
    ("ball", "limit", "text"),
    [
        (arb(0), 5, "0"),
        (arb(1) / 4, 30, "0.25"),
        (arb(1) / 4, 1, "0.3"),
        (arb(123456.5, 3), 30, "1.235e5"),
        (arb(2.5, 0.0009), 10, "2.50"),
        (arb(2.5, 0.0009), 2, "2.5"),
        (arb(2.5, 0.0009), 1, "0e1"),
        (arb(9.999999, 1e-9), 3, "10.0"),
        (arb(-0.125, 1e-9), 3, "-0.125"),
        (arb(0.0999996, 1e-9), 3, "0.100"),
    ],
)
def test_fixed_digits_as_they_are_written(ball: arb, limit: int, text: str) -> None:
    if text == "0e1":  # both 2 and 3 are roundings of its points
        with pytest.raises(PrecisionError, match="no digit"):
            fixed_digits(ball, limit)
    else:
        assert fixed_digits(ball, limit) == text


@pytest.mark.parametrize("ball", [arb(0, 1), arb(0.5, 0.4), arb(0, 2.0**-40)])
def test_no_fixed_digit(ball: arb) -> None:
    with pytest.raises(PrecisionError, match="no digit of a number"):
        fixed_digits(ball, 10)


def test_fixed_digits_of_an_unbounded_ball() -> None:
    with pytest.raises(PrecisionError, match="raise the precision"):
        fixed_digits(arb(1) / arb(0, 1), 10)


@given(st.floats(allow_nan=False, allow_infinity=False), st.integers(1, 20))
def test_outward(x: float, limit: int) -> None:
    low, high = outward(x, limit, up=False), outward(x, limit, up=True)
    assert EXACT.mpf(low) <= EXACT.mpf(x) <= EXACT.mpf(high)
    assert len(high.strip("-0.").replace(".", "").strip("0")) <= limit


def test_ten_thousand_digits() -> None:
    with precision(34_000):
        text = proved_digits(arb.pi(), 10_000)
        assert abs(arb(text) - arb.pi()) < arb(10) ** -9_999
    assert len(text) == 10_001


def test_an_unbounded_ball_is_refused() -> None:
    with pytest.raises(PrecisionError, match="raise the precision"):
        proved_digits(arb(1) / arb(0, 1), 10)
