"""The distances that a receptance is asked for: which lie ahead, and in which steps waves run through them."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import cached_property
from typing import Any

from flint import arb

from mpsolve.frozen import frozen
from mpsolve.numbers.balls import Balls, acb, bits_now

_K = Balls()


@frozen
class Side:
    """Distances of one sign (1: ξ ≥ 0), by their numbers, and from 0 on (its place, that of the leap to it)."""

    sign: int
    own: tuple[int, ...]
    exact: tuple[Fraction, ...]
    way: tuple[tuple[int, int], ...]
    leaps: tuple[Fraction, ...]

    @staticmethod
    def of(exact: Sequence[Fraction], sign: int) -> Side:
        own = [k for k, x in enumerate(exact) if (x >= 0) == (sign > 0)]
        here = [exact[k] for k in own]
        leaps: dict[Fraction, int] = {}
        way, before = [], Fraction(0)
        for k in sorted(range(len(here)), key=lambda k: abs(here[k])):
            way.append((k, leaps.setdefault(here[k] - before, len(leaps))))
            before = here[k]
        return Side(sign, tuple(own), tuple(here), tuple(way), tuple(leaps))

    def waves(self, roots: Sequence[acb], thin: bool) -> list[list[acb]]:
        """e^{zξ} of the roots at each distance: at thin roots by products, where few leaps lie between them."""
        if not thin or 2 * len(self.leaps) >= len(self.exact):
            return [_wave(x, roots) for x in self.exact]
        leaps = [_wave(x, roots) for x in self.leaps]
        out: list[list[Any]] = [[]] * len(self.exact)
        here = [acb(1)] * len(roots)
        for k, leap in self.way:
            here = [wave * one for wave, one in zip(here, leaps[leap], strict=True)]
            out[k] = here
        return out


@frozen
class Spread:
    """Exact distances, once for many frequencies."""

    exact: tuple[Fraction, ...]

    @cached_property
    def sides(self) -> tuple[Side, Side]:
        return Side.of(self.exact, 1), Side.of(self.exact, -1)

    @property
    def balls(self) -> list[arb]:
        """At the precision that is set."""
        bits = bits_now()
        if bits not in self._kept:
            self._kept.clear()
            self._kept[bits] = [_K.number(x) for x in self.exact]
        return self._kept[bits]

    @cached_property
    def _kept(self) -> dict[int, list[Any]]:
        return {}


def _wave(x: Fraction, roots: Sequence[acb]) -> list[acb]:
    ball = _K.number(x)
    return [(ball * z).exp() if x else acb(1) for z in roots]
