"""Count, find, enclose: every root of a problem in a region, or what is known and why the rest is open."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from contextlib import nullcontext
from dataclasses import field
from fractions import Fraction
from functools import partial
from typing import Any

import numpy as np

from mpsolve.characteristic.proved import Proved
from mpsolve.errors import EffortError, PrecisionError
from mpsolve.frozen import frozen
from mpsolve.numbers.balls import rational_ball
from mpsolve.numbers.rootball import RootBall, Symmetry
from mpsolve.outcome import Reason
from mpsolve.parallel.threads import one_thread
from mpsolve.problem.line import Line
from mpsolve.problem.reduced import Reduced
from mpsolve.proof.effort import Effort
from mpsolve.spectrum.candidates import find_roots
from mpsolve.spectrum.count import Count, count_roots
from mpsolve.spectrum.enclose import enclose
from mpsolve.spectrum.multiple import separate
from mpsolve.spectrum.near_roots import beside_branch_points, near_branch_points
from mpsolve.spectrum.partial import Partial
from mpsolve.spectrum.reasons import reason_of, sheet_reason
from mpsolve.spectrum.regions import Answered, HalfPlane, Rectangle, Region, Sheet
from mpsolve.spectrum.sheet import SheetCount, count_sheet
from mpsolve.spectrum.sought import areas_of, hints_of, weight_of
from mpsolve.spectrum.spectrum import disjoint

MOST_DIGITS = 10_000
Tell = Callable[[str, float], None]


@frozen
class Found:
    """A count, or None and what is `known`; the balls that explain it, and the reason where they do not."""

    count: Count | SheetCount | None
    balls: tuple[RootBall, ...]
    reason: Reason | None
    known: Mapping[str, Any] = field(default_factory=dict)


def solve(
    reduced: Reduced, region: Region | Line, digits: int, effort: Effort, tell: Tell, in_strips: bool = False
) -> Found:
    """All roots of Δ̂ in the region, or on the whole sheet of a beam with its cuts on one line.

    Never raises for what stays undecided. Matrices are multiplied in one thread. in_strips: count parts first.
    """
    with one_thread() if reduced.contacts > _FEW else nullcontext():  # small products start no threads
        return _solve(reduced, region, digits, effort, tell, Partial(in_strips))


def _solve(
    reduced: Reduced, region: Region | Line, digits: int, effort: Effort, tell: Tell, partial: Partial
) -> Found:
    try:
        if isinstance(region, Line):
            tell("contour", 0.0)
            count: Count | SheetCount = count_sheet(region, effort)
        else:
            count = count_roots(reduced, region, effort, tell, partial=partial)
    except (EffortError, PrecisionError) as error:
        line = region if isinstance(region, Line) else None
        reason = sheet_reason(line, reduced, error) if line else reason_of(reduced, error)
        return Found(None, (), reason, partial.known)
    if not count.total:
        return Found(count, (), None)
    so_far: list[RootBall] = []
    try:
        tell("roots", 0.5)
        balls = _enclosed(reduced, count, digits, tell, so_far)
        number = _number(balls)
        if number != count.total or not disjoint(balls):
            message = f"{count.total} roots are counted, but {number} could be enclosed"
            numbers = {"counted": str(count.total), "enclosed": str(number)}
            return Found(count, balls, Reason("roots", message, numbers, _FEWER))
        signed = _signed(reduced, count, balls, digits, tell)
    except EffortError as error:
        return Found(count, tuple(so_far), error.reason)
    if signed is None:
        return Found(count, balls, _open_sign(balls))
    return Found(count, signed, None)


_FEWER = "ask for a Rectangle round those that matter: where fewer are counted, all are found"
_SHARPER = (2, 4)
"""Times the digits that were asked for, where a sign of Im q is open."""
_CLOSER = (1, 2, 3, 4)
"""The same, of roots next to a branch point."""
_FEW = 4
_NEAR = 15 / 16  # of the height of the lowest cut: most vibrations that decay slowly lie below it


def _open_sign(balls: tuple[RootBall, ...]) -> Reason:
    at = next(f"{float(ball.q.real.mid()):.10g}" for ball in balls if _sign(ball) is None)
    message = f"a root at q = {at} lies on the real axis, or closer to it than its digits tell"
    return Reason("sign", message, {"re": at}, "ask for a Rectangle with im_max < 0 below it, or for more digits")


def unstable_number(balls: tuple[RootBall, ...]) -> int:
    """How many roots of balls that do not meet the real axis have Im q < 0."""
    return sum(ball.multiplicity for ball in balls if _sign(ball))


def _sign(ball: RootBall) -> bool | None:
    """True if Im q < 0, False if Im q ≥ 0, None if the ball does not tell."""
    if ball.symmetry is Symmetry.REAL or ball.q.imag >= 0:
        return False
    return True if ball.q.imag < 0 else None


def _signed(
    reduced: Reduced, count: Count | SheetCount, balls: tuple[RootBall, ...], digits: int, tell: Tell
) -> tuple[RootBall, ...] | None:
    """The balls, with more digits where a sign of Im q takes them; None where it stays open."""
    for more in _SHARPER:
        if all(_sign(ball) is not None for ball in balls):
            break
        if more * digits > MOST_DIGITS:
            return None
        balls = _enclosed(reduced, count, more * digits, tell, [])
        if _number(balls) != count.total or not disjoint(balls):
            return None
    return balls if all(_sign(ball) is not None for ball in balls) else None


def _enclosed(
    reduced: Reduced, count: Count | SheetCount, digits: int, tell: Tell, balls: list[RootBall]
) -> tuple[RootBall, ...]:
    """The roots; `balls` holds those that are enclosed on the way."""
    hints, weight = hints_of(reduced, count), weight_of(reduced, count.region)
    proved = Proved(reduced)
    for sigma in near_branch_points(count) if isinstance(count, SheetCount) else []:
        tell("roots", 0.5)
        # a ball of so many digits of |q| may meet the cut, where the root is next to it
        found = (_balls(proved, sigma, more * digits) for more in _CLOSER)
        for ball in next(filter(None, found), []):
            _add(balls, ball, count.region, proved.lossless)
    unit = float(reduced.frequency_unit)
    later = partial(beside_branch_points, count) if isinstance(count, SheetCount) else None
    areas, left, before = areas_of(reduced, count), count.total - _number(balls), count.total + 1
    while 0 < left < before:  # what floats took for several roots in one place may be one, and others elsewhere
        known = [q for q in (complex(ball.q.mid()) / unit for ball in balls) if q.real >= 0]
        seeds = find_roots(reduced, areas, left, hints, weight, lambda: tell("roots", 0.5), known, later)
        for k, q in enumerate(seeds.tolist()):
            for ball in _balls(proved, 1j * q, digits):
                _add(balls, ball, count.region, proved.lossless)
            tell("roots", 0.5 + 0.5 * (k + 1) / len(seeds))
        for q in seeds.tolist():  # floats may take roots for one that are closer than they can tell
            if _number(balls) >= count.total:
                break
            for ball in _separated(proved, 1j * q, digits):
                _add(balls, ball, count.region, proved.lossless)
        before, left = left, count.total - _number(balls)
    return tuple(balls)


def _number(balls: Iterable[RootBall]) -> int:
    """With multiplicity."""
    return sum(ball.multiplicity for ball in balls)


def _add(balls: list[RootBall], ball: RootBall, region: Answered, lossless: bool) -> None:
    """Add a ball and its mirrors where they lie in the region and hold more roots than those that they meet."""
    images = [ball] if ball.symmetry is Symmetry.IMAGINARY else [ball, ball.mirrored]
    if lossless and ball.symmetry is not Symmetry.REAL:
        images += [one.conjugated for one in images]
    for one in images:
        met = [other for other in balls if one.q.overlaps(other.q)]
        if _inside(region, one) and one.multiplicity > sum(other.multiplicity for other in met):
            balls[:] = [other for other in balls if not one.q.overlaps(other.q)] + [one]


def _balls(proved: Proved, sigma: Any, digits: int) -> list[RootBall]:
    try:
        return [enclose(proved, sigma, digits)]
    except PrecisionError:
        return _separated(proved, sigma, digits)


def _separated(proved: Proved, sigma: Any, digits: int) -> list[RootBall]:
    try:
        return separate(proved, sigma, digits)
    except PrecisionError:
        return []


def _inside(region: Answered, ball: RootBall) -> bool:
    """Whether the ball is proved to lie in the region; that a ball meets no cut, its isolation shows."""
    if isinstance(region, Sheet):
        return True
    re, im = ball.q.real, ball.q.imag
    if isinstance(region, Rectangle):
        bounds = ((re, region.re_min, region.re_max), (im, region.im_min, region.im_max))
        return all(x > rational_ball(low) and x < rational_ball(high) for x, low, high in bounds)
    near = region.radius is None or bool(abs(ball.q) < rational_ball(region.radius))
    below = bool(im < 0) and near
    if isinstance(region, HalfPlane):
        return below
    strip = bool(im < rational_ball(region.height) and abs(re) < rational_ball(region.reach or Fraction(0)))
    return below or (strip and (near or bool(im >= 0)))


def default_height(reduced: Reduced, lowest: Fraction) -> Fraction:
    """A height below the lowest cut, short in scaled units."""
    return Fraction(float(np.float32(_NEAR * float(lowest / reduced.frequency_unit)))) * reduced.frequency_unit
