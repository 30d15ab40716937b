"""Enclosures: one zero, a cluster with its number, none where there is none; powers count."""

from __future__ import annotations

import pytest
from flint import acb
from functions import function

from mpsolve.errors import PrecisionError
from mpsolve.zeros.enclose import BITS, Zeros, enclose


@pytest.mark.parametrize(
    ("text", "seed", "m"), [("sin(z)", 3.1, 1), ("(exp(z) - 1)**2 + 0*z", 0.01, 1), ("1 - cos(z)", 0.01, 2)]
)
def test_enclosures(text: str, seed: complex, m: int) -> None:
    (ball,) = enclose(function(text).parts[0][0], seed, 10.0, 20)
    assert ball.multiplicity == m
    assert enclose(function("exp(z) + 0*z"), 1.0, 10.0, 20) == []


def test_a_zero_at_0_has_an_absolute_size_and_a_power_its_number() -> None:
    ball = Zeros(function("sin(z) + 0*z"), 10.0, 3).single(0.01, BITS, 30)
    assert ball.multiplicity == 3
    assert ball.q.contains(acb(0))
    assert float(ball.q.rad()) < 1e-40


def test_where_newton_finds_nothing_there_is_no_ball() -> None:
    with pytest.raises(PrecisionError):
        Zeros(function("exp(z) + 0*z"), 10.0).single(1.0, BITS, 20)
