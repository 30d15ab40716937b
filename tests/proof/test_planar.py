"""Interval Newton in the plane: zeros that are known, to many digits; nothing where there is none, or a tangency."""

from typing import Any

import pytest

from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, arb, precision
from mpsolve.proof.planar import isolated, polished, sharpened


class Known:
    """y + i x² − 1 − 2i: the zero is (1, √2)."""

    def value(self, y: Any, x: Any) -> Any:
        return acb(y - 1, x * x - 2)

    def slopes(self, y: Any, x: Any) -> tuple[Any, Any]:
        return acb(1) + 0 * y, acb(0, 2 * x)


class Tangent(Known):
    """y + i (x² + 10⁻¹²): no zero."""

    def value(self, y: Any, x: Any) -> Any:
        return acb(y, x * x + arb("1e-12"))


def test_the_zero_is_isolated_and_sharpened() -> None:
    with precision(80):
        at = polished(Known(), (0.7, 1.2))
        zero = isolated(Known(), at, (arb(1), arb(1)))
        y, x = sharpened(Known(), zero, 400)
    with precision(600):
        assert x.contains(arb(2).sqrt())
        assert y.contains(1)
        assert x.rad() < arb(2) ** -398


def test_no_zero_is_proved_where_there_is_none() -> None:
    with precision(80), pytest.raises(PrecisionError):
        isolated(Tangent(), (arb(0), arb("1e-3")), (arb(1), arb(1)))


class Two:
    """(a − 1 + i (x² − 2), b − x + i (y − a x)): the zero is a = 1, b = x = y = √2."""

    def value(self, a: Any, b: Any, x: Any, y: Any) -> tuple[Any, ...]:
        return acb(a - 1, x * x - 2), acb(b - x, y - a * x)

    def slopes(self, *at: Any) -> tuple[Any, ...]:
        a, _, x, _ = at
        return (acb(1), acb(0), acb(0, 2 * x), acb(0)), (acb(0, -x), acb(1), acb(-1, -a), acb(0, 1))


def test_two_equations_in_four_unknowns() -> None:
    with precision(80):
        at = polished(Two(), (0.8, 1.3, 1.5, 1.2))
        a, *rest = sharpened(Two(), isolated(Two(), at, tuple(map(arb, (1, 1, 1, 1)))), 200)
    with precision(400):
        assert a.contains(1)
        assert all(ball.contains(arb(2).sqrt()) and ball.rad() < arb(2) ** -198 for ball in rest)
