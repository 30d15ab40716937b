"""Values with units are exact, and of the dimension that is asked for; each refusal quotes the text."""

from __future__ import annotations

from contextlib import suppress
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from mpsolve.errors import InputError
from mpsolve.numbers.model import quantities
from mpsolve.numbers.unit_names import unit_of
from mpsolve.numbers.units import factor, in_unit, measured, split
from mpsolve.tracks import CATALOGUE
from mpsolve.vehicles import CATALOGUE as VEHICLES


@pytest.mark.parametrize(
    ("text", "unit", "value"),
    [
        ("360 km/h", "m/s", 100),
        ("12.5 t", "kg", 12500),
        ("60 kg/m", "kg/m", 60),
        ("35 kN/mm", "N/m", 35_000_000),
        ("2 s", "s", 2),
        ("770 N s/m²", "N s/m²", 770),
        ("770 N*s/m^2", "N s/m²", 770),
        ("770 N·s·m⁻²", "N s/m²", 770),
        ("0.77 kNs/m**2", "N s/m²", 770),
        ("6.4MNm²", "N m²", 6_400_000),
        ("210 GPa", "N/m²", 210 * 10**9),
        ("1/3 m", "m", Fraction(1, 3)),
        ("5 %", "", Fraction(1, 20)),
        ("−3 kN", "N", -3000),
        ("60 mph", "m/s", Fraction("26.8224")),
        ("136 lb", "kg", Fraction("61.68856232")),
        ("1 kip/in", "N/m", Fraction("453.59237") * Fraction("9.80665") / Fraction("0.0254")),
        ("12 N/(m s)", "kg/s³", 12),
        ("1000 ms", "s", 1),
        ("3 1/min", "1/s", Fraction(1, 20)),
        ("50 mrad/s", "rad/s", None),
        ("0.1", "m/s", Fraction(1, 10)),
        (" 7 ", "kg", 7),
        ("145 kg/(0.6 m)", "kg/m", Fraction(725, 3)),
        ("120 kN/mm/(0.6 m)", "N/m²", 200_000_000),
        ("145 kg/(600mm)", "kg/m", Fraction(725, 3)),
        ("3 N s/(.5 m s)", "N/m", 6),
    ],
)
def test_values_are_exact(text: str, unit: str, value: Fraction | int | None) -> None:
    if value is None:
        with pytest.raises(InputError, match="no unit"):
            in_unit(text, unit, "x")
    else:
        assert in_unit(text, unit, "x") == value


@pytest.mark.parametrize(
    ("text", "unit", "said"),
    [
        ("6.4 MN m", "N m²", "'6.4 MN m', whose unit is N m, but the bending stiffness is in N m²"),
        ("5 kg", "", "'5 kg', but the bending stiffness has no unit: leave the unit out"),
        ("5 %", "m", "whose unit is a bare number"),
        ("3 Hz", "rad/s", "which is no rational number: write 18.84955592 rad/s, with as many digits as wanted"),
        ("25 kN/mm", "N/m²", "give it in N/m² or its like"),
        ("-90 °", "rad", "write -1.570796327 rad,"),
        ("1_500 rpm", "1/s", "write 157.0796327 rad/s,"),
        ("3 Hz", "m/s", "whose unit has no exact ratio to rad/s"),
        ("3 m Hz", "m/s", "whose unit has no exact ratio to rad/s"),
        ("35 KN/mm", "N/m", "'35 KN/mm', but 'KN' is no unit: did you mean kN/mm\\?"),
        ("5 Kg", "kg", "did you mean kg"),
        ("300 Km/h", "m/s", "'Km' is no unit: did you mean km/h\\?"),
        ("83 m/sec", "m/s", "did you mean m/s\\?"),
        ("10 tons", "kg", "did you mean t\\?"),
        ("100 kmh", "m/s", "did you mean km/h"),
        ("100 KMH", "m/s", "did you mean km/h"),
        ("5 foo", "m", "'foo' is no unit: units are km/h"),
        ("5 N/m s", "N s/m", "leaves open what stands under the stroke: write /\\(m s\\)"),
        ("5 N/", "N/m", "stroke with nothing"),
        ("290 kg / 0.6 m", "kg/m", r"write /\(0.6 m\)"),
        ("145/0.6 kg/m", "kg/m", r"but a ratio has two whole numbers: .* as 145 kg/\(0.6 m\)"),
        ("145/0.6", "kg/m", "but a ratio has two whole numbers"),
        ("145 kg/0.6", "kg/m", "divides by 0.6, a number alone"),
        ("145 kg/(0 m)", "kg/m", "divides by zero"),
        ("145 kg/(1.5)", "kg", "'1.5' is no unit"),
        ("145 kg/(0.6 m 2)", "kg/m", "'2' is no unit"),
        ("5 m^99", "m", "exponent 99"),
        ("12,5 t", "kg", "comma"),
        ("12,500", "kg", "comma"),
        ("12 500 kg", "kg", "1_000"),
        ("5 1", "", "'1' is no unit"),
        ("5 1 kg", "kg", "'1' is no unit"),
        ("heavy", "kg", "'heavy' is not a number"),
        ("nan kg", "kg", "not a number|not finite"),
    ],
)
def test_refusals_quote_the_text(text: str, unit: str, said: str) -> None:
    with pytest.raises(InputError, match=said) as caught:
        in_unit(text, unit, "track.EI", "bending stiffness")
    assert caught.value.key == "track.EI"
    assert text in str(caught.value)


def test_what_a_rail_seat_has_is_divided_by_the_distance() -> None:
    with pytest.raises(InputError, match=r"divided by the distance of the sleepers, as 120 kN/mm/\(0.6 m\)"):
        in_unit("120 kN/mm", "N/m²", "track.k_pad", "stiffness of the pads")
    with pytest.raises(InputError, match=r"give it in kg/m or its like$"):
        in_unit("60 kg", "kg/m", "track.m", "mass of the rail")


def test_every_declared_unit_is_known() -> None:
    for model in (*CATALOGUE, *VEHICLES):
        for name, quantity in quantities(model).items():
            size, dimension = factor(quantity.unit)
            assert size == 1, (model, name)
            assert factor(unit_of(dimension)) == (1, dimension)


@given(st.fractions(-1000, 1000, max_denominator=97), st.sampled_from(["km/h", "kN s/mm²", "t", "in", "µm", "GPa"]))
def test_there_and_back(x: Fraction, unit: str) -> None:
    size, dimension = factor(unit)
    text = f"{x.numerator}/{x.denominator} {unit}" if x >= 0 else f"-{-x.numerator}/{x.denominator} {unit}"
    assert in_unit(text, unit_of(dimension), "x") == x * size
    assert in_unit(text, unit, "x") == x


def test_what_has_no_unit_stays() -> None:
    assert measured("root4(1/4)", "m", "x") == "root4(1/4)"
    assert measured(0.5, "m", "x") == 0.5
    assert split("1e3 N/m") == ("1e3", "N/m")
    assert split("100m") == ("100", "m")


@given(st.text(" 0123456789.,/eE+-_()^*·²⁻kMmsNgth%°", max_size=14), st.sampled_from(["m", "N s/m²", ""]))
def test_any_text_is_a_number_or_refused(text: str, unit: str) -> None:
    with suppress(InputError):
        assert isinstance(in_unit(text, unit, "x", "length"), Fraction)


@pytest.mark.parametrize(
    ("text", "unit", "value"),
    [
        ("210 GPa * 3038 cm^4", "N m²", "6379800"),
        ("210e9 Pa·3038.3e-8 m^4", "N m²", "6380430"),
        ("2 * 3.4 m", "m", "6.8"),
        ("3 m**2", "m²", "3"),
    ],
)
def test_products_of_numbers_with_units(text: str, unit: str, value: str) -> None:
    assert measured(text, unit, "x") == Fraction(value)


@pytest.mark.parametrize("text", ["3**2 m", "5 m 30", "40 kN/mm * 2", "2 * m"])
def test_what_is_no_such_product(text: str) -> None:
    with pytest.raises(InputError):
        measured(text, "kg", "x")
