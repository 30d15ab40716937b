"""Interval Newton on plain functions: exact roots inside, as sharp as asked, and no box where there is no proof."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import pytest

from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, acb_poly, arb, bits_now, precision
from mpsolve.proof.newton import isolated, polished, sharpened


@dataclass
class Sine:
    """sin z, with the precisions at which it was asked."""

    asked: list[int] = field(default_factory=list)

    def value(self, z: Any) -> Any:
        self.asked.append(bits_now())
        return acb(z).sin()

    def slope(self, z: Any) -> Any:
        return acb(z).cos()

    def both(self, z: Any) -> tuple[Any, Any]:
        return self.value(z), self.slope(z)


@dataclass
class Polynomial:
    coefficients: tuple[int, ...]

    def value(self, z: Any) -> Any:
        return acb_poly(list(self.coefficients))(z)

    def slope(self, z: Any) -> Any:
        return acb_poly(list(self.coefficients)).derivative()(z)

    def both(self, z: Any) -> tuple[Any, Any]:
        return self.value(z), self.slope(z)


@pytest.mark.parametrize("goal", [60, 100, 333, 1000, 33220])
def test_pi_to_any_number_of_bits(goal: int) -> None:
    sine = Sine()
    with precision(80):
        found = isolated(sine, polished(sine, acb(3)), arb(3))
    sine.asked.clear()
    image = sharpened(sine, found.image, goal)
    with precision(goal + 100):
        assert image.contains(acb(arb.pi()))
        assert image.rad() <= abs(image).upper() * arb((1, -goal))
    assert len(sine.asked) < 15
    assert sum(sine.asked[:-1]) < 1.6 * goal + 500
    assert max([80, *sine.asked]) < goal + 200


def test_the_box_holds_one_root() -> None:
    f = Polynomial((-2, 0, 1))
    with precision(64):
        found = isolated(f, polished(f, acb(1.4)), arb(1))
        assert found.box.contains(acb(arb(2).sqrt()))
        assert found.box.contains_interior(found.image)
        assert not found.box.contains(-acb(arb(2).sqrt()))


def test_a_real_root_stays_real() -> None:
    f = Polynomial((-2, 0, 1))
    with precision(64):
        found = isolated(f, polished(f, acb(1.4)), arb(1))
    image = sharpened(f, found.image, 500, lambda z: acb(z.real))
    assert image.imag == 0
    with precision(600):
        assert image.real.contains(arb(2).sqrt())


def test_a_double_root_is_refused() -> None:
    """(z − 1)²: the slope vanishes with the value."""
    f = Polynomial((1, -2, 1))
    with precision(128), pytest.raises(PrecisionError):
        isolated(f, acb(1), arb(1))


def test_two_near_roots_are_not_taken_for_one() -> None:
    """Roots 2⁻³⁰ apart: only a box much smaller than that is proved."""
    f = Polynomial((2**60 - 1, -(2**61), 2**60))
    with precision(160):
        found = isolated(f, polished(f, acb(1 + 2.0**-30)), arb(1))
        assert found.box.contains(acb(1 + 2.0**-30))
        assert not found.box.contains(acb(1 - 2.0**-30))


def test_no_root_no_box() -> None:
    """e^z has none, wherever Newton's method goes."""

    class Exponential:
        def value(self, z: Any) -> Any:
            return acb(z).exp()

        slope = value

        def both(self, z: Any) -> tuple[Any, Any]:
            return self.value(z), self.slope(z)

    with precision(64), pytest.raises(PrecisionError):
        isolated(Exponential(), polished(Exponential(), acb(1)), arb(1))


def test_a_slope_that_cannot_be_told_is_a_smaller_box() -> None:
    """A function that refuses wide balls is asked on narrower ones."""

    class Shy(Polynomial):
        def slope(self, z: Any) -> Any:
            if z.rad() > 1e-9:
                raise PrecisionError("too wide")
            return super().slope(z)

    f = Shy((-2, 0, 1))
    with precision(100):
        found = isolated(f, polished(f, acb(1.4)), arb(1))
        assert found.box.rad() < 1e-8
        assert found.box.contains(acb(arb(2).sqrt()))


@dataclass
class Demanding(Sine):
    """The same, which is not known at less than 200 bits."""

    def value(self, z: Any) -> Any:
        if bits_now() < 200:
            raise PrecisionError("too few bits")
        return super().value(z)


def test_more_precision_is_tried_where_the_function_itself_asks_for_it() -> None:
    with precision(300):
        pi = sharpened(Demanding(), acb(arb(3.14159, 0.001), 0), 60)
        assert pi.real.contains(arb.pi())
        assert pi.real.rad() < 1e-17


def test_a_step_that_comes_out_wider_is_taken_again_with_more_bits() -> None:
    """√z − 2⁻¹⁰⁰, whose value loses 400 bits: a ball that such a step widens holds the branch point 0, for ever."""

    class Lossy:
        def value(self, z: Any) -> Any:
            return acb(z).sqrt() - arb(2) ** -100 + acb(arb(0, arb(2) ** (400 - bits_now())))

        def slope(self, z: Any) -> Any:
            return 1 / (2 * acb(z).sqrt())

    with precision(600):
        start = acb(arb(2) ** -200 * (1 + arb(2) ** -50), 0) + acb(arb(0, arb(2) ** -240), arb(0, arb(2) ** -240))
        root = sharpened(Lossy(), start, 150)
        assert root.contains(acb(arb(2) ** -200, 0))
        assert root.rad() < arb(2) ** -349


def test_a_function_that_is_never_known_is_given_up() -> None:
    class Unknown(Sine):
        def value(self, z: Any) -> Any:
            raise PrecisionError(f"never at {z}")

    with pytest.raises(PrecisionError, match="never"):
        sharpened(Unknown(), acb(arb(3.14159, 0.001), 0), 60)
