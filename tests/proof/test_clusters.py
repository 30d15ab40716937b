"""Roots that meet: apart where balls tell them, else one cluster; a plain polynomial stands for any function."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import pytest
from flint import acb, acb_poly, arb

from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import precision, square
from mpsolve.numbers.rootball import RootBall, Symmetry, on_grid
from mpsolve.numbers.taylor import SAMPLES, Taylor
from mpsolve.proof.clusters import separate
from mpsolve.proof.newton import isolated, polished, sharpened


@dataclass
class Polynomial:
    """Π (z − root) with exact roots."""

    roots: tuple[str, ...]
    most: int = 6

    @property
    def f(self) -> Any:
        out = acb_poly([1])
        for root in self.roots:
            out *= acb_poly([-acb(arb(root)), 1])
        return out

    def value(self, z: Any) -> Any:
        return self.f(z)

    def slope(self, z: Any) -> Any:
        return self.f.derivative()(z)

    def both(self, z: Any) -> tuple[Any, Any]:
        return self.value(z), self.slope(z)

    def series(self, centre: Any, shrink: int) -> Taylor:
        assert shrink > 0
        outer = arb(1) / 64
        shifted = self.f(acb_poly([centre, 1]))
        row = [shifted[k] for k in range(SAMPLES)]
        return Taylor(centre, tuple(row), arb(abs(self.f(centre + square(outer))).upper()), outer)

    def single(self, seed: Any, bits: int, digits: int) -> RootBall:
        with precision(bits):
            image = isolated(self, polished(self, acb(seed)), arb(1)).image
        goal = int(digits * 3.33) + 2
        image = sharpened(self, image, goal + 20)
        with precision(goal + 80):
            return on_grid(image, goal, 1, Symmetry.NONE)

    def cluster(self, series: Taylor, m: int, target: int) -> list[RootBall]:
        return [on_grid(series.centre, target, m, Symmetry.NONE)]


def test_roots_that_are_close_come_apart() -> None:
    balls = separate(Polynomial(("1", "1.00000000000001", "9")), acb(1.0001), 20)
    assert sorted(ball.multiplicity for ball in balls) == [1, 1]
    assert not balls[0].q.overlaps(balls[1].q)


@pytest.mark.parametrize("m", [2, 3, 5])
def test_a_multiple_root_is_a_cluster_with_its_number(m: int) -> None:
    (ball,) = separate(Polynomial(("1",) * m + ("9",)), acb(1.0001), 15)
    assert ball.multiplicity == m
    assert ball.q.contains(acb(1))


def test_no_root_and_too_many_are_none() -> None:
    assert separate(Polynomial(("5", "9")), acb(1), 15) == []
    assert separate(Polynomial(("1",) * 7), acb(1), 15) == []
    assert issubclass(PrecisionError, ArithmeticError)
