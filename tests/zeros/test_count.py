"""Counts against numbers known by algebra; nothing is counted past a zero on the path, a pole or an unseen cut."""

from __future__ import annotations

import math
import random

import pytest
from functions import function

from mpsolve.errors import EffortError, PrecisionError
from mpsolve.proof.effort import Effort
from mpsolve.zeros.count import count_zeros
from mpsolve.zeros.regions import Cut, Disc, Polygon, Rectangle, Region


def count(text: str, region: Region, *cuts: Cut) -> int:
    return count_zeros(function(text), region.polygon, cuts, Effort(evaluations=50_000)).total


@pytest.mark.parametrize("seed", range(12))
def test_products_times_entire_functions_without_zeros(seed: int) -> None:
    """The text is expanded, so that no factor shows."""
    rng = random.Random(seed)
    roots = [complex(rng.randint(-40, 40) / 16, rng.randint(-40, 40) / 16) for _ in range(rng.randint(1, 7))]
    coefficients = [complex(1)]
    for root in roots:
        shifted = [0j, *coefficients]
        coefficients = [a - root * b for a, b in zip(shifted, [*coefficients, 0j], strict=True)]
    text = " + ".join(f"({c.real!r} + ({c.imag!r})*i)*z**{k}" for k, c in enumerate(coefficients))
    box = Rectangle("-1.51", "1.49", "-1.53", "1.47")
    inside = sum(-1.51 < z.real < 1.49 and -1.53 < z.imag < 1.47 for z in roots)
    disc = sum(abs(z) < 1.7003 for z in roots)
    for factor in ("1", "exp(z/2)", "rgamma(z + 9)"):
        assert count(f"({text})*{factor} + 0*z", box) == inside
    if all(abs(abs(z) - 1.7003) > 0.02 for z in roots):
        assert count(text, Disc(0, "1.7003")) == disc


@pytest.mark.parametrize(
    ("text", "region", "number"),
    [
        ("sin(z)", Rectangle("-10.1", "10.2", -3, 4), 7),
        ("exp(z) - 1", Rectangle(-1, 1, -20, 20), 2 * math.floor(20 / (2 * math.pi)) + 1),
        ("z**50 + z**12 - 5*sin(20*z)*cos(12*z) - 1", Disc(0, "0.5"), None),
        ("sqrt(z) - 1/2", Rectangle("0.01", 2, -1, 1), 1),
        ("sin(z)", Polygon([-1 - 1j, 7 - 1j, 7 + 1j, 2 + 1j, 2 + 3j, -1 + 3j]), 3),
    ],
)
def test_numbers_known_otherwise(text: str, region: Region, number: int | None) -> None:
    found = count(text, region)
    if number is None:  # by numerical integration of f′/f in floats
        import numpy as np

        z = 0.5 * np.exp(2j * np.pi * np.arange(20_000) / 20_000)
        f = z**50 + z**12 - 5 * np.sin(20 * z) * np.cos(12 * z) - 1
        number = round(float(np.angle(np.roll(f, -1) / f).sum() / (2 * np.pi)))
        # the polygon is a little larger than the disc: it may hold more
        assert found >= number
    else:
        assert found == number


def test_a_region_along_a_cut_and_round_its_tip() -> None:
    region, ray = Rectangle(-1, 2, -1, 1), Cut.ray(0, -1)
    assert count("sqrt(z) - 1/2", region, ray) == 1
    assert count("sqrt(z) + 1/2", region, ray) == 0  # its zero lies on the other sheet
    assert count("sqrt(z) - i/2 + 1/100", region, ray) == 0  # z = (i/2 − 1/100)²: Re √z < 0
    assert count("sqrt(z) - i/2 - 1/100", region, ray) == 1
    assert (
        count("log(z) - i*3", Rectangle(-2, "-0.5", 0, 2), ray) == 1
    )  # the lower side lies on the cut, seen from above
    assert count("log(z) - i*3", Rectangle(-2, "-0.5", -2, 0), ray) == 0  # and from below


def test_a_branch_point_at_which_f_is_not_finite_is_refused() -> None:
    region, cut = Rectangle(-3, 3, -2, 2), Cut.segment(-1, 1)
    for text in ("z*sqrt(1 - 1/z**2) - i", "sqrt((z - 1)/(z + 1)) - 2", "log((z - 1)/(z + 1)) - 2"):
        with pytest.raises(PrecisionError):
            count(text, region, cut)


def test_undeclared_cuts_poles_and_zeros_on_the_path_are_never_counted_past() -> None:
    box = Rectangle(-1, 1, -1, 1)
    for text, region, cuts in (
        ("sqrt(z)", box, ()),
        ("log(z + 2) * sqrt(z)", box, ()),
        ("sqrt(z) - 1/2", box, (Cut.ray("-0.25", -1),)),  # shorter than the true cut
        ("sqrt(z) - 1/2", box, (Cut.ray(0, 1j),)),  # another ray
        ("sqrt(z**2)", box, ()),
        ("sin(1/z)", box, ()),
        ("sin(z)", Rectangle(0, 1, -1, 1), ()),
        ("sin(z)", Rectangle(-1, 1, 0, 1), ()),
        ("z - 1 - i", box, ()),
        ("sqrt(z) - 1/2*i", box, (Cut.ray(0, -1),)),  # a zero on the upper lip
    ):
        with pytest.raises(PrecisionError):
            count(text, region, *cuts)


def test_effort_ends_it() -> None:
    with pytest.raises(EffortError):
        count_zeros(function("sin(z)"), Rectangle(-9, 9, -1, 1).polygon, (), Effort(evaluations=10))
