"""Precisions double up to a bound, and only what more bits can help is tried again."""

from __future__ import annotations

import pytest

from mpsolve.errors import EffortError, PrecisionError
from mpsolve.numbers.balls import bits_now
from mpsolve.proof.ladder import climb


def test_it_stops_where_the_attempt_succeeds() -> None:
    tried = []

    def attempt(bits: int) -> str:
        tried.append((bits, bits_now()))
        if bits < 200:
            raise PrecisionError("more")
        return "done"

    assert climb(attempt, 64) == "done"
    assert tried == [(64, 64), (128, 128), (256, 256)]


def test_it_ends_at_the_bound_with_the_last_error() -> None:
    tried = []

    def attempt(bits: int) -> None:
        tried.append(bits)
        raise PrecisionError(f"open at {bits}")

    with pytest.raises(PrecisionError, match="open at 300"):
        climb(attempt, 64, 300)
    assert tried == [64, 128, 256, 300]


@pytest.mark.parametrize("error", [EffortError("spent"), ValueError("a slip"), ZeroDivisionError()])
def test_other_errors_come_out_at_once(error: Exception) -> None:
    tried = []

    def attempt(bits: int) -> None:
        tried.append(bits)
        raise error

    with pytest.raises(type(error)):
        climb(attempt, 64)
    assert tried == [64]
