"""Python functions on balls: their Taylor coefficients hold the truth, by series, by f′, or by values alone."""

from __future__ import annotations

import pytest
from flint import acb, acb_series, arb

from mpsolve.errors import InputError, PrecisionError
from mpsolve.numbers.balls import precision
from mpsolve.zeros.function import CallableFunction


def only_balls(z: acb) -> acb:
    if isinstance(z, acb_series):
        raise TypeError("balls only")
    return z.exp() * z.sin()


@pytest.mark.parametrize(
    "f", [CallableFunction(lambda z: z.exp() * z.sin()), CallableFunction(only_balls)], ids=["series", "values"]
)
@pytest.mark.parametrize("radius", [0, 1e-30, 1e-9, 1e-4])
def test_coefficients_hold_the_truth(f: CallableFunction, radius: float) -> None:
    with precision(120):
        z = acb(arb(0.75, radius), arb(-0.25, radius))
        for point in (acb(0.75, -0.25), acb(0.75 + radius / 2, -0.25 - radius / 2)):
            truth = acb_series([point, 1], prec=3)
            truth = truth.exp() * truth.sin()
            row = f.series(z, 3)
            assert all(a.overlaps(truth[k]) for k, a in enumerate(row))
            if radius == 0:
                assert all(float(a.rad()) < 1e-20 for a in row)


def test_a_derivative_is_used_where_it_is_given() -> None:
    f = CallableFunction(only_balls, lambda z: z.exp() * (z.sin() + z.cos()))
    z = acb(arb(0, 0.5), 1)
    _, slope = f.series(z, 2)
    assert slope.is_finite()
    assert slope.contains((acb(0.25, 1)).exp() * (acb(0.25, 1).sin() + acb(0.25, 1).cos()))


def test_what_a_function_raises_or_leaves_open_is_a_precision_error() -> None:
    for bad in (lambda z: z / 0, lambda _: acb("nan"), lambda _: acb(arb(0, float("inf")))):
        with pytest.raises(PrecisionError):
            CallableFunction(bad).value(acb(1))
    with pytest.raises(InputError):
        CallableFunction(lambda _: "text").value(acb(1))
