"""What is proved before a count is closed: a rectangle that holds all growth, and counts of strips of it.

A count is closed last of all, so that without this an effort that ends a little earlier leaves nothing. Where the
effort is stated, strips are counted one after the other, each by the turn of Δ̂ round it, before the whole is.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import dataclass, field, replace
from fractions import Fraction
from itertools import pairwise
from typing import Any, TypeVar

import numpy as np
from flint import arb

from mpsolve.characteristic.paths import Paths
from mpsolve.errors import EffortError, PrecisionError
from mpsolve.numbers.balls import precision
from mpsolve.passivity.beyond import Beyond
from mpsolve.proof.effort import Effort
from mpsolve.spectrum.regions import Rectangle
from mpsolve.spectrum.sides import along_sides, side, whole_turn, zeros

_HALF_STRIPS, _BOX_STRIPS = 4, 3
"""Of the right half of a rectangle that lies evenly about the imaginary axis, and of any other rectangle."""

_HELD = 4000  # evaluations for what is known of a count that stays open
Counted = TypeVar("Counted")


@dataclass
class Partial:
    """Filled while a count is under way; all in it is proved.

    in_strips: whether strips are counted before the whole, which costs about as much once more. growth: no root has
    Im q ≤ −growth. outside: a rectangle outside which no root has Im q < 0. strips: open rectangles with their
    numbers of roots, which leave out no root. open: the rest of what holds all roots of the region.
    """

    in_strips: bool = False
    growth: Fraction | None = None
    outside: Rectangle | None = None
    strips: list[tuple[Rectangle, int]] = field(default_factory=list)
    open: list[Rectangle] = field(default_factory=list)

    @property
    def known(self) -> dict[str, Any]:
        """For an answer that stays undecided: with `count` where no strip is open."""
        bounds = {"growth": self.growth, "outside": self.outside}
        out: dict[str, Any] = {name: value for name, value in bounds.items() if value is not None}
        if self.strips and not self.open:
            out["count"] = sum(number for _, number in self.strips)
        if self.strips or self.outside is not None:
            out |= {"strips": tuple(self.strips), "open": tuple(self.open)}
        return out


def holding_growth(
    partial: Partial, paths: Paths, beyond: Beyond, height: Fraction, effort: Effort, count: Callable[[], Counted]
) -> Counted:
    """What `count` gives. Where that stays open, or strips are wanted, what holds all growth is proved, too."""
    if partial.in_strips:
        hold_growth(partial, paths, beyond, height, effort)
    try:
        return count()
    except PrecisionError:
        if not partial.in_strips:
            with suppress(EffortError):
                hold_growth(partial, paths, beyond, height, Effort(evaluations=_HELD))
        raise


def hold_growth(partial: Partial, paths: Paths, beyond: Beyond, height: Fraction, effort: Effort) -> None:
    """Prove the theorem of `beyond` by itself, then count strips of its rectangle where these are wanted.

    `plan_beyond` has planned walls and axis. Here they are linked to the start: along the imaginary axis to the floor
    of the rectangle, from there along the floor and up the wall to the real axis, and on to the tail.
    """
    unit = paths.arrays.reduced.frequency_unit
    down = side(complex(0, -paths.start.depth), complex(0, -beyond.depth), 6)
    walls = replace(beyond.walls, points=beyond.walls.points[::-1])
    try:
        paths.prove((paths.plan("link", down, effort), walls, beyond.axis), effort)
    except EffortError:
        raise
    except PrecisionError:
        return  # the whole count comes to the walls another way
    rho, depth = (Fraction(x) * unit for x in (beyond.rho, beyond.depth))
    partial.outside = Rectangle(-rho, rho, -depth, 0)
    count_strips(partial, paths, Rectangle(-rho, rho, -depth, height), effort)


def count_strips(partial: Partial, paths: Paths, whole: Rectangle, effort: Effort) -> None:
    """Count strips of `whole`, the outermost first; a strip with a root on a side, or next to it, stays open."""
    partial.open = [whole]
    if not partial.in_strips:
        return
    unit = paths.arrays.reduced.frequency_unit
    groups = list(_strips(whole, unit))
    partial.open = [strip for group in groups for strip in group]
    for group in groups:
        try:
            number = _number(paths, group[0], unit, effort)
        except EffortError:
            raise
        except PrecisionError:
            continue
        partial.strips += [(strip, number) for strip in group]
        partial.open = [strip for strip in partial.open if strip not in group]


def _strips(whole: Rectangle, unit: Fraction) -> Iterator[tuple[Rectangle, ...]]:
    """Strips between floats (scaled), with each its mirror image, which holds as many roots."""
    even = _is_even(whole)
    low, high = Fraction(0) if even else whole.re_min, whole.re_max
    cuts = np.linspace(float(low / unit), float(high / unit), (_HALF_STRIPS if even else _BOX_STRIPS) + 1)[1:-1]
    between = [x for x in sorted({Fraction(cut) * unit for cut in cuts.tolist()}) if low < x < high]
    ends = [-between[0] if even and between else whole.re_min, *between, high]
    for a, b in reversed(list(pairwise(ends))):
        strip, mirror = (Rectangle(*ends, whole.im_min, whole.im_max) for ends in ((a, b), (-b, -a)))
        yield (strip, mirror) if even and strip != mirror else (strip,)


def _is_even(box: Rectangle) -> bool:
    return box.re_min == -box.re_max


def _number(paths: Paths, strip: Rectangle, unit: Fraction, effort: Effort) -> int:
    """How many roots a strip holds: as q ↦ −q̄ maps roots to roots, half the way round tells it of an even one."""
    a, b, c, d = (float(x / unit) for x in strip.bounds)
    around = [complex(a, c), complex(b, c), complex(b, d), complex(a, d), complex(a, c)]
    half = [complex(0, c), complex(b, c), complex(b, d), complex(0, d)]
    even = _is_even(strip)
    proved = along_sides(paths, half if even else around, effort)
    with precision(64):
        return zeros(whole_turn(proved) / (arb.pi() * (1 if even else 2)))
