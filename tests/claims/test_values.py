"""Comparisons of balls are proved either way, or refused."""

from __future__ import annotations

import flint
import pytest

from mpsolve.claims.values import below
from mpsolve.errors import PrecisionError

arb = flint.arb


def test_an_order_is_proved_or_refused() -> None:
    assert below(arb(1, 0.1), arb(2, 0.1))
    assert not below(arb(2, 0.1), arb(1, 0.1))
    assert not below(arb(1), arb(1))
    assert below(arb(1, 0.1), 2)
    for other in (arb(1.05, 0.1), arb(1, 0.1)):
        with pytest.raises(PrecisionError, match="overlap"):
            below(arb(1, 0.1), other)
