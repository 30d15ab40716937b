"""Exact holds what was written, orders and combines without rounding, and its balls contain it."""

from __future__ import annotations

import copy
import math
import pickle
from decimal import Decimal
from fractions import Fraction
from typing import Any

import flint
import mpmath
import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from mpsolve.errors import InputError
from mpsolve.numbers.exact import Exact
from mpsolve.numbers.written import MAX_DIGITS, MAX_RADICAND_DIGITS, MAX_TEXT

fractions = st.fractions(min_value=-(10**9), max_value=10**9, max_denominator=10**9)
radicands = st.fractions(min_value=0, max_value=10**12, max_denominator=10**6)
roots = st.builds(lambda radicand, sign: Exact.root4(radicand) * sign, radicands, st.sampled_from((-1, 1)))
exacts = st.one_of(fractions.map(Exact), roots)
precisions = st.integers(20, 400)
few = settings(max_examples=50)


def signed(value: Fraction) -> Fraction:
    return value * abs(value) ** 3


def measure(x: Exact) -> Fraction:
    """Return x|x|³, which is increasing in x, from public parts only."""
    return x.sign * x.fourth_power


def reference(x: Exact, precision: int) -> Any:
    with mpmath.workprec(precision):
        return x.sign * mpmath.sqrt(mpmath.sqrt(mpmath.mpf(x.fourth_power.numerator) / x.fourth_power.denominator))


def label(value: object) -> str:
    return value if isinstance(value, str) and len(value) < 25 else type(value).__name__


def endpoints(ball: flint.arb) -> tuple[Fraction, Fraction]:
    (m, e), (r, f) = (tuple(map(int, part.man_exp())) for part in (ball.mid(), ball.rad()))
    middle, radius = m * Fraction(2) ** e, r * Fraction(2) ** f
    return middle - radius, middle + radius


@pytest.mark.parametrize(
    ("given_value", "value"),
    [
        ("0.67", Fraction(67, 100)),
        (" 67/100 ", Fraction(67, 100)),
        ("-1.5e-3", Fraction(-3, 2000)),
        ("+.5", Fraction(1, 2)),
        ("5.", 5),
        ("-6/4", Fraction(-3, 2)),
        ("1_000.5E+2", 100050),
        ("root4(16/81)", Fraction(2, 3)),
        ("-root4( 0.0016 )", Fraction(-1, 5)),
        (0.1, Fraction(1, 10)),
        (np.float64(0.1), Fraction(1, 10)),
        (np.float32(0.1), Fraction(1, 10)),
        (np.int64(-7), -7),
        (Decimal("0.10"), Fraction(1, 10)),
        (Fraction(1, 3), Fraction(1, 3)),
        (70, 70),
        (Exact("1/3"), Fraction(1, 3)),
        ("9" * MAX_DIGITS, 10**MAX_DIGITS - 1),
        ("1e-399", Fraction(1, 10**399)),
    ],
    ids=label,
)
def test_numbers_are_read_as_written(given_value: object, value: Fraction) -> None:
    assert Exact.parse(given_value).as_fraction() == value


@given(st.floats(allow_nan=False, allow_infinity=False))
def test_a_float_is_its_shortest_decimal(value: float) -> None:
    x = Exact.parse(value)
    assert x.as_fraction() == Fraction(repr(value))
    assert float(x) == value


@given(st.decimals(allow_nan=False, allow_infinity=False, min_value=-(10**30), max_value=10**30, places=40))
def test_a_decimal_is_exact(value: Decimal) -> None:
    assert Exact.parse(value).as_fraction() == Fraction(value)


@pytest.mark.parametrize(
    ("given_value", "reason"),
    [
        (True, "type bool"),
        (np.bool_(True), "type bool"),
        (None, "type NoneType"),
        ([1], "type list"),
        (np.array(0.5), "type ndarray"),
        (1j, "type complex"),
        (b"1", "type bytes"),
        (math.nan, "not finite"),
        (-math.inf, "not finite"),
        (Decimal("sNaN"), "not finite"),
        ("-Infinity", "not finite"),
        ("", "not a number"),
        (".", "not a number"),
        ("--1", "not a number"),
        ("1e", "not a number"),
        ("1__0", "not a number"),
        ("_1", "not a number"),
        ("1e1_", "not a number"),
        ("0x10", "not a number"),
        ("１", "not a number"),
        ("1 2", "not a number"),
        ("1/2/3", "not a number"),
        ("1.5/2", "not a number"),
        ("root4(2", "not a number"),
        ("root4(-2)", "not a number"),
        ("root4(root4(2))", "not a number"),
        ("root4()", "not a number"),
        ("1/0", "divides by zero"),
        ("root4(1/0)", "divides by zero"),
        ("1e999999999", "exponent"),
        (f"1e-{MAX_DIGITS + 1}", "exponent"),
        ("-1e-999999999", "exponent"),
        (Decimal("1e999999"), "exponent"),
        ("root4(1e9999999)", "exponent"),
        ("1e" + "9" * 5000, "too many digits"),
        ("9" * 5000, "too many digits"),
        ("1/" + "9" * 5000, "too many digits"),
        ("9" * (MAX_DIGITS + 1), "more than 400 digits"),
        (f"1e{MAX_DIGITS}", "more than 400 digits"),
        (f"root4(1e{MAX_RADICAND_DIGITS})", "more than 4000 digits"),
        (10**6000, "more than 400 digits"),
        (Fraction(1, 10**6000), "more than 400 digits"),
        ("1" * (MAX_TEXT + 1), "characters"),
    ],
    ids=label,
)
def test_what_is_no_number_is_refused_by_name(given_value: object, reason: str) -> None:
    with pytest.raises(InputError, match=f"^alpha: .*{reason}") as caught:
        Exact.parse(given_value, "alpha")
    assert caught.value.key == "alpha"
    assert len(str(caught.value)) < 200


@given(exacts)
def test_text_repr_pickle_and_copy_give_the_number_back(x: Exact) -> None:
    for again in (Exact.parse(str(x)), eval(repr(x)), pickle.loads(pickle.dumps(x)), copy.deepcopy(x)):
        assert again == x
        assert hash(again) == hash(x)
        assert str(again) == str(x)


def test_canonical_texts() -> None:
    texts = {"0.67": "67/100", "70.0": "70", "root4(4/6)": "root4(2/3)", "-root4(2)": "-root4(2)", "-0": "0"}
    assert {text: str(Exact(text)) for text in texts} == texts


@given(st.fractions(min_value=0))
def test_a_perfect_fourth_power_is_rational(value: Fraction) -> None:
    assert Exact.root4(value**4).as_fraction() == value
    assert Exact.sqrt(value**2).as_fraction() == value


@given(st.integers(1, 10**200))
def test_the_neighbours_of_a_perfect_fourth_power_are_not(n: int) -> None:
    assert not Exact.root4(n**4 + 1).is_rational
    assert n == 1 or not Exact.root4(n**4 - 1).is_rational
    assert not Exact.root4(Fraction(n**4, n**4 + 1)).is_rational
    with pytest.raises(ValueError, match="irrational"):
        Exact.root4(n**4 + 1).as_fraction()


@pytest.mark.parametrize("make", [Exact.root4, Exact.sqrt])
def test_there_is_no_even_root_below_zero(make: Any) -> None:
    with pytest.raises(ValueError, match="-1 has no real"):
        make(-1)


@given(exacts, exacts)
@few
def test_the_order_is_that_of_the_real_numbers(x: Exact, y: Exact) -> None:
    a, b = reference(x, 600), reference(y, 600)
    with mpmath.workprec(600):
        assume(abs(a - b) > abs(a) * mpmath.mpf(2) ** -500)
    assert (x < y, x > y, x <= y, x >= y, x == y) == (a < b, a > b, a < b, a > b, False)


@given(st.integers(1, 10**60))
def test_the_order_is_exact_where_doubles_agree(n: int) -> None:
    below, above = Exact.root4(n**4 - 1), Exact.root4(n**4 + 1)
    assert below < n < above
    assert -above < -n < -below
    assert n in (Exact(n), Fraction(n))


@given(fractions)
def test_a_rational_equals_and_hashes_as_its_fraction(value: Fraction) -> None:
    assert Exact(value) == value
    assert value == Exact(value)
    assert hash(Exact(value)) == hash(value)
    assert bool(Exact(value)) == bool(value)
    assert Exact(value) <= value <= Exact(value)


def test_a_float_is_never_compared() -> None:
    assert Exact("0.5") != 0.5
    with pytest.raises(TypeError):
        assert Exact("0.5") < 0.6  # type: ignore[operator]


@given(exacts, exacts)
@few
def test_products_and_quotients(x: Exact, y: Exact) -> None:
    a, b = reference(x, 300), reference(y, 300)
    with mpmath.workprec(300):
        assert abs(reference(x * y, 300) - a * b) <= abs(a * b) * mpmath.mpf(2) ** -290
        assert not y or abs(reference(x / y, 300) - a / b) <= abs(a / b) * mpmath.mpf(2) ** -290
    assert -x * y == x * -y == -(x * y)
    if y:
        assert x / y * y == x
        assert 1 / y * x == x / y
    else:
        with pytest.raises(ZeroDivisionError):
            x / y


@given(exacts, fractions, fractions)
@few
def test_sums_of_rational_multiples(x: Exact, a: Fraction, b: Fraction) -> None:
    assert a * x + b * x == x * (a + b)
    assert a * x - b * x == x * (a - b)
    assert a * x + 0 == 0 + a * x == a * x
    assert abs(a * x) == abs(a) * abs(x)
    assert Exact(a) + b == a + Exact(b) == a + b
    assert Exact(a) - b == a - Exact(b) == a - b


def test_a_sum_that_is_no_fourth_root_names_both_terms() -> None:
    with pytest.raises(ValueError, match=r"root4\(2\) and -root4\(3\)"):
        Exact("root4(2)") - Exact("root4(3)")


@given(exacts, precisions)
@few
def test_the_ball_contains_the_number_and_is_narrow(x: Exact, precision: int) -> None:
    with flint.ctx.workprec(precision):
        ball = x.ball()
        assert flint.ctx.prec == precision
    low, high = endpoints(ball)
    assert signed(low) <= measure(x) <= signed(high)
    assert high - low <= abs(high) * Fraction(2) ** (5 - precision)
    fine = reference(x, 2 * precision + 10)
    slack = abs(fine) * mpmath.mpf(2) ** (-2 * precision)
    with mpmath.workprec(3 * precision):
        bounds = [mpmath.mpf(end.numerator) / end.denominator for end in (low, high)]
        assert bounds[0] - slack <= fine <= bounds[1] + slack


@given(exacts, precisions)
@few
def test_mpf_is_within_one_unit_in_the_last_place(x: Exact, precision: int) -> None:
    with mpmath.workprec(precision):
        negative, mantissa, exponent, bits = x.mpf(mpmath.mp)._mpf_
    assert bits <= precision
    exact = (-1) ** negative * int(mantissa) * Fraction(2) ** exponent
    unit = abs(exact) * Fraction(2) ** (1 - precision)
    assert signed(exact - unit) <= measure(x) <= signed(exact + unit)


@given(exacts)
def test_the_double_is_within_its_unit(x: Exact) -> None:
    value = Fraction(float(x))
    error = abs(value) * Fraction("1.2e-16")
    assert signed(value - error) <= measure(x) <= signed(value + error)


def test_a_double_that_cannot_be_overflows() -> None:
    for text in ("1e399", "root4(1e3999)"):
        with pytest.raises(OverflowError):
            float(Exact(text))
    assert float(Exact("root4(2e-3999)")) == 0


def test_short_is_for_people() -> None:
    texts = {"2/3": "0.666667", "-70": "-70", "0": "0", "root4(2)": "1.18921", "1e300": "1e+300"}
    texts |= {"root4(1e3996)": "1e+999"}
    assert {text: Exact(text).short() for text in texts} == texts


def test_a_number_cannot_be_changed() -> None:
    x = Exact("0.5")
    for name in ("_signed", "fourth_power", "other"):
        with pytest.raises(AttributeError):
            setattr(x, name, 1)
    with pytest.raises(AttributeError):
        del x._signed
    assert x == Fraction(1, 2)


def test_a_number_beside_a_bound_is_not_shown_as_the_bound() -> None:
    assert Exact("0.999999999").beside(1) == "0.999999999"
    assert Exact("1").beside(1) == "1"
    assert Exact("0.5").beside(1) == "0.5"
    tiny = Exact(1 - Fraction(1, 10**60))
    assert tiny.beside(1) == str(tiny)


@given(st.fractions(-(10**9), 10**9, max_denominator=10**6), st.integers(-30, 30), st.integers(1, 40), st.booleans())
def test_short_texts_are_those_of_mpmath(x: Fraction, power: int, digits: int, root: bool) -> None:
    """The second way: mpmath's own conversion, at many more digits."""
    scaled = x * Fraction(10) ** power
    exact = Exact.root4(abs(scaled)) if root else Exact.parse(scaled)
    with mpmath.workdps(4 * digits + 100):
        value = mpmath.mpf(scaled.numerator) / scaled.denominator
        value = mpmath.root(abs(value), 4) if root else value
        text = mpmath.nstr(value, digits, strip_zeros=True)
    assert exact.short(digits) == text.removesuffix(".0").replace(".0e", "e")
    assert float(exact) == pytest.approx(float(value), rel=3e-16)
