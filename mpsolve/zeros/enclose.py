"""Enclosures of zeros: a simple one by interval Newton to any number of digits, a cluster by Pellet's test."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from flint import acb, arb

from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import precision
from mpsolve.numbers.rootball import RootBall, Symmetry, on_grid, radius_of
from mpsolve.numbers.taylor import SAMPLES, Taylor, pellet
from mpsolve.proof import clusters
from mpsolve.proof.enclosing import Enclosed, Line, enclosed, root_ball
from mpsolve.proof.ladder import climb
from mpsolve.proof.newton import polished, real_part
from mpsolve.zeros.function import Function

BITS, _MOST = 80, 640
_AXIS = Line(Symmetry.REAL, real_part)
_SMALL = 2.0**-64
_OUTER = 2.0**-10


@dataclass(frozen=True)
class Zeros:
    """The zeros of f near seeds; `size` is that of the region, in which digits of a zero near 0 count from 2^−64.

    power: how often f is a factor of what is asked: so often its zeros count.
    """

    f: Function
    size: float
    power: int = 1
    most: int = SAMPLES - 2

    @property
    def least(self) -> float:
        return self.size * _SMALL

    def single(self, seed: Any, bits: int, digits: int) -> RootBall:
        """The simple zero that Newton's method reaches from the seed; PrecisionError where none is proved."""
        root = climb(lambda _: self._enclosed(acb(seed)), bits, max(bits, _MOST))
        return root_ball(self.f, root, digits, multiplicity=self.power, least=self.least)

    def _enclosed(self, seed: acb) -> Enclosed:
        start = self._polished(seed)
        size = start.abs_upper()
        size = size if size > self.size / 1024 else arb(self.size / 1024)
        return enclosed(self.f, start, size, (_AXIS,) if self.f.real else ())

    def _polished(self, seed: acb) -> acb:
        """Where Newton's method stands still; a zero at 0 is met by its absolute size."""
        start = polished(self.f, seed)
        if start.abs_upper() < self.least * _SMALL:
            return acb(0) if self._vanishes(acb(0)) else start
        near = complex(start)
        short = acb(round(near.real), round(near.imag))  # zeros that users know are often whole numbers
        if abs(short - start) < self.least and self._vanishes(short):
            return short
        return start

    def _vanishes(self, z: acb) -> bool:
        try:
            return bool(self.f.value(z).contains(0))
        except PrecisionError:
            return False

    def nearer(self, seed: complex) -> acb:
        """Newton's steps towards zeros that meet halve the distance, or nearly so."""
        z = acb(seed)
        with precision(4 * BITS):
            for _ in range(3):
                try:
                    z = polished(self.f, z)
                except PrecisionError:
                    break
        return z

    def series(self, centre: acb, shrink: int) -> Taylor:
        outer = centre.abs_upper() * _OUTER
        least = arb(self.size) * _OUTER
        last: PrecisionError | None = None
        for _ in range(12):
            try:
                found = self.f.taylor(centre, outer if outer > least else least, 8 * shrink)
                if found.bound.is_finite():
                    return found
            except PrecisionError as error:
                last = error
            outer, least = outer / 4, least / 4
        raise last or PrecisionError("f is not bounded round zeros that meet")

    def cluster(self, series: Taylor, m: int, target: int) -> list[RootBall]:
        """At least m zeros in the inner disc of a square ball, at most m around it."""
        if m == 1:
            return []
        ball = on_grid(series.centre, target, m * self.power, Symmetry.NONE, self.least)
        shift = abs(ball.q.mid() - series.centre)
        radius = radius_of(ball.exponent, m)
        inner, outer = radius - shift, radius * arb(2).sqrt() + shift
        return [ball] if pellet(series, m, inner) and pellet(series, m, outer) else []


def enclose(f: Function, seed: complex, size: float, digits: int, power: int = 1) -> list[RootBall]:
    """The zero near the seed, or those that meet there; none where nothing is proved."""
    zeros = Zeros(f, size, power)
    try:
        return [zeros.single(seed, BITS, digits)]
    except PrecisionError:
        return clusters.separate(zeros, zeros.nearer(seed), digits)
