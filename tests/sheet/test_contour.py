"""Covering and turning: the winding of functions with known zeros; a zero on the path is never passed."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from typing import Any

import flint
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from oracle import grid

from mpsolve.errors import PrecisionError
from mpsolve.fields import ball_arithmetic
from mpsolve.sheet.contour import cover, in_half_plane, turning
from mpsolve.sheet.winding import unique_integer

acb, arb = flint.acb, flint.arb
few = settings(max_examples=30)
zeros = st.lists(st.builds(complex, grid(-2, 2), grid(-2, 2)), min_size=0, max_size=5)


def polynomial(zeros: list[complex]) -> Callable[[Any], Any]:
    def value(z: Any) -> Any:
        product = acb(1)
        for zero in zeros:
            product *= z - acb(zero.real, zero.imag)
        return product

    return value


def winding(function: Callable[[Any], Any], limit: int = 20_000) -> int:
    """Of the circle |z| = 1, run over 0 ≤ t ≤ 2."""

    def on_circle(t: Any) -> Any:
        return function(acb(t).exp_pi_i())

    path = cover(lambda t: (on_circle(t),), 0.0, 2.0, 0.125, limit)
    assert path.breaks[0] == 0
    assert path.breaks[-1] == 2
    assert all(a < b for a, b in zip(path.breaks, path.breaks[1:], strict=False))
    assert len(path.middles) == len(path.breaks) - 1 <= path.evaluations
    return unique_integer(turning(path, 0, on_circle(arb(0)), on_circle(arb(2))) / (2 * arb.pi()))


@few
@given(zeros, st.integers(0, 3))
def test_the_winding_counts_zeros_less_poles(drawn: list[complex], poles: int) -> None:
    assume(all(abs(abs(z) - 1) > 1e-3 for z in drawn))
    with ball_arithmetic(64):
        function = polynomial(drawn)
        expected = sum(abs(z) < 1 for z in drawn) - poles
        assert winding(lambda z: function(z) / (z - 0.25) ** poles) == expected


@pytest.mark.parametrize("gap", [1e-2, 1e-5, 1e-9])
def test_a_zero_close_to_the_path_is_counted_on_its_side(gap: float) -> None:
    with ball_arithmetic(64):
        assert winding(polynomial([1 - gap])) == 1
        assert winding(polynomial([1 + gap])) == 0


@pytest.mark.parametrize("angle", ["0", "1/3", "1", "1.9", "1/7"])
def test_a_zero_on_the_path_is_never_passed(angle: str) -> None:
    with ball_arithmetic(64):
        numerator, _, denominator = angle.partition("/")
        zero = (acb(arb(numerator)) / int(denominator or 1)).exp_pi_i()
        with pytest.raises(PrecisionError):
            winding(lambda z: z - zero)


def test_effort_is_bounded() -> None:
    with ball_arithmetic(64), pytest.raises(PrecisionError, match="more than 5 pieces"):
        winding(polynomial([0.99]), limit=5)


def test_pieces_stay_in_a_half_plane() -> None:
    assert in_half_plane(acb(arb(1, 0.2), arb(1, 0.2)))
    assert not in_half_plane(acb(arb(1, 0.9), arb(0, 0.9)))
    assert not in_half_plane(acb(arb(0, 0.1), arb(0, 0.1)))
    assert not in_half_plane(acb("nan"))


def test_an_integer_is_the_only_one_in_its_ball() -> None:
    assert unique_integer(arb(3, 0.4)) == 3
    for open_ball in (arb(3, 1.2), arb(2.5, 0.3), arb(0.5, 0.6)):
        with pytest.raises(PrecisionError, match="no single integer"):
            unique_integer(open_ball)


def test_a_piece_and_a_wider_one_are_shown_to_the_checker() -> None:
    """Enclosures are no monotone functions: a checker that is strict wants to see both."""
    seen: list[tuple[Any, Any]] = []

    def accept(piece: Any, wider: Any) -> bool:
        seen.append((piece, wider))
        return bool(piece.rad() < 0.2)

    path = cover(lambda _: (acb(1),), 1.0, 2.0, 1.0, 100, accept=accept)
    assert len(path.breaks) > 3
    assert all(b - a < 0.4 for a, b in pairwise(path.breaks))
    assert all(wider.contains_interior(piece) for piece, wider in seen)
