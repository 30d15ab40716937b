"""The Laplace image of the forces and the positions ξ − x_j in balls and in discs, for the proved contour."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import flint

from mpsolve.discs import DiscField, Discs
from mpsolve.fields import Ball
from mpsolve.motion.forcing import Tone, image, tones
from mpsolve.numbers.exact import Exact
from mpsolve.problem.case import Case
from mpsolve.vehicles.load import Load

acb, arb = flint.acb, flint.arb


@dataclass(frozen=True)
class Setting:
    """Forces F_j(q) and gaps (sign, ξ − x_j) in both arithmetics."""

    tones: tuple[Tone, ...]
    balls: Callable[[Any], list[Any]]
    discs: Callable[[Any], list[Any]]
    gaps: list[list[tuple[int, Any]]]
    disc_gaps: list[list[tuple[int, Any]]]


def setting(case: Case, loads: Sequence[Load], xi: Sequence[Exact], field: Ball) -> Setting:
    parts = tuple(Tone(p.frequency, tuple(acb(a) for a in p.amplitudes), p.exact) for p in tones(case, loads, field))
    places = case.merged.positions
    signs = [[(x > place) - (x < place) for place in places] for x in xi]
    gaps = [
        [(sign, x.ball() - place.ball()) for sign, place in zip(row, places, strict=True)]
        for row, x in zip(signs, xi, strict=True)
    ]
    disc_gaps = [[(sign, to_disc(gap)) for sign, gap in row] for row in gaps]
    discs = tuple(Tone(to_disc(p.frequency), tuple(_Phasor(a) for a in p.amplitudes), p.exact) for p in parts)
    plane: Any = DiscField()
    return Setting(parts, lambda q: image(parts, field, q), lambda q: image(discs, plane, q), gaps, disc_gaps)


def to_disc(ball: Any) -> Discs:
    """A disc that holds the ball."""
    ball = acb(ball)
    middle = complex(ball.mid())
    return Discs(middle, float(abs(ball - acb(middle.real, middle.imag)).upper()) * (1 + 2.0**-40))


class _Phasor(Discs):
    """A constant amplitude in a disc, with its conjugate."""

    __slots__ = ()

    def __init__(self, ball: Any) -> None:
        disc = to_disc(ball)
        super().__init__(disc.m, disc.r)

    def conjugate(self) -> Discs:
        return Discs(self.m.conj(), self.r)
