"""A turn is a number of zeros only where its ball leaves one choice."""

from __future__ import annotations

import pytest
from flint import arb

from mpsolve.errors import PrecisionError
from mpsolve.proof.winding import number_of_zeros


def test_one_whole_number_in_the_ball() -> None:
    assert number_of_zeros(arb(3, 0.4), "f") == 3
    assert number_of_zeros(arb(0), "f") == 0


@pytest.mark.parametrize("ball", [arb(3, 1.1), arb(2.5, 0.4), arb(-1, 0.1), arb("nan")])
def test_none_or_many_or_below_zero(ball: arb) -> None:
    with pytest.raises(PrecisionError, match="turn of f"):
        number_of_zeros(ball, "f")
