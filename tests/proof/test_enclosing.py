"""Enclosures of a cubic whose roots are known exactly: on a line, off it, beside it, and to many digits."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import pytest
from flint import acb, arb

from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import precision
from mpsolve.numbers.rootball import Symmetry
from mpsolve.proof.enclosing import Line, enclosed, root_ball

REAL = Line(Symmetry.REAL, lambda z: acb(z.real))


@dataclass(frozen=True)
class Cubic:
    """(z − a)((z − b)² + c²): the roots a, b ± ci."""

    a: Any
    b: Any
    c: Any

    def value(self, z: Any) -> Any:
        return (z - self.a) * ((z - self.b) ** 2 + self.c**2)

    def slope(self, z: Any) -> Any:
        return (z - self.b) ** 2 + self.c**2 + 2 * (z - self.a) * (z - self.b)

    def both(self, z: Any) -> tuple[Any, Any]:
        return self.value(z), self.slope(z)


FAR = Cubic(acb(3) / 2, acb(5), acb(2))


def test_a_root_on_the_line_is_known_to_be_there() -> None:
    with precision(100):
        root = enclosed(FAR, acb(1.5, 2**-40), 2, (REAL,))
        assert root.symmetry is Symmetry.REAL
        assert root.found.image.imag == 0
        ball = root_ball(FAR, root, 50)
    assert (ball.symmetry, ball.q.imag) == (Symmetry.REAL, 0)
    assert ball.q.contains(acb(3) / 2)
    with precision(300):
        assert ball.q.real.rad() < arb(10) ** -50 * 1.5


def test_off_the_line_there_is_no_symmetry() -> None:
    with precision(100):
        root = enclosed(FAR, acb(5, 2 + 2**-40), 2, (REAL,))
        assert (root.line, root.symmetry) == (None, Symmetry.NONE)
        assert root_ball(FAR, root, 20).q.contains(acb(5, 2))


def test_two_roots_that_are_mirrors_are_not_taken_for_one_on_the_line() -> None:
    """b ± ci with c = 2⁻⁴⁰: next to the real axis, where one box of both proves nothing."""
    close = Cubic(acb(3), acb(1), acb(2) ** -40)
    with precision(200):
        root = enclosed(close, acb(1, 2**-40), 1, (REAL,))
        assert root.symmetry is Symmetry.NONE
        ball = root_ball(close, root, 20)
    assert ball.q.imag > 0


def test_where_nothing_is_proved() -> None:
    double = Cubic(acb(3), acb(1), acb(0))
    with precision(100), pytest.raises(PrecisionError, match="no box"):
        enclosed(double, acb(1 + 2**-30), 1, (REAL,))


def test_units_and_a_least_size() -> None:
    """Digits of a root that is smaller than `least` count from there: its box need not be sharpened further."""
    small = Cubic(acb(2) ** -200, acb(5), acb(2))
    with precision(300):
        root = enclosed(small, acb(0), 1, (REAL,))
        rough, turned = (root_ball(small, root, 15, lambda z, k=k: acb(k) * z, least=2.0**-60) for k in (1, 4))
    assert turned.q.contains(acb(2) ** -198)
    assert -200 < rough.exponent <= turned.exponent + 2
    with precision(300):
        assert root_ball(small, root, 15).exponent < -200
