"""From candidates to root balls: isolate each, drop repetitions and what lies outside, sharpen, mirror, sort."""

from __future__ import annotations

from contextlib import suppress
from typing import Any

import flint

from mpsolve.errors import PrecisionError
from mpsolve.fields import ball_arithmetic
from mpsolve.numbers.balls import rational_ball
from mpsolve.numbers.rootball import RootBall, Symmetry
from mpsolve.problem.case import Case
from mpsolve.progress import Progress
from mpsolve.sheet.cluster import separate
from mpsolve.sheet.count import BITS, Count
from mpsolve.sheet.enclose import BASE_BITS, Box, isolate, refine
from mpsolve.sheet.seek import seek
from mpsolve.spectrum.regions import Rectangle

_RECTANGLE_RADIUS = 200.0


def collect(case: Case, count: Count, digits: int, effort: int, tell: Progress) -> tuple[RootBall, ...]:
    """Disjoint root balls of the region that `count` is for, sorted by (Re q, Im q). Proved one by one."""
    tell("seeking", 0.0)
    boxes, doubtful = _isolated(case, count, effort)
    balls: list[RootBall] = []
    for k, box in enumerate(boxes):
        tell("sharpening", k / len(boxes))
        balls.append(refine(case, box, digits))
    missing = count.total - sum(weight(ball, count) for ball in balls)
    for seed in [*doubtful, *(complex(box.image.mid()) for box in boxes)]:
        if missing > 0:  # a root's near neighbour looks like the root itself in float64
            new = [b for b in separate(case, seed, digits) if not any(b.q.overlaps(a.q) for a in balls)]
            balls += new
            missing -= sum(weight(ball, count) for ball in new)
    return _sorted([b for ball in balls for b in _images(ball) if inside(b, count)])


def _isolated(case: Case, count: Count, effort: int) -> tuple[list[Box], list[complex]]:
    """Proved boxes with Re q ≥ 0, and seeds that could not be isolated (clusters, or nothing at all)."""
    radius = count.radius or _RECTANGLE_RADIUS
    boxes: list[Box] = []
    doubtful: list[complex] = []
    seeds = [candidate.q for candidate in seek(case, radius, effort)]
    if not case.eta_b:  # with q, q̄ is a root, and next to the cut float64 takes the two for one
        seeds = [seed for q in seeds for seed in (q, q.conjugate())]
    for seed in seeds:
        if any(_holds(box, seed) for box in boxes):
            continue
        box = _isolated_at(case, seed, effort)
        if box is None:
            doubtful.append(seed)
            continue
        if not any(box.image.overlaps(other.image) for other in boxes):
            boxes.append(box)
    return boxes, doubtful


def _isolated_at(case: Case, seed: complex, effort: int) -> Box | None:
    """The box about the seed, at more bits with more effort: next to a branch point a few digits are lost."""
    for bits in sorted({BASE_BITS, min(4, effort) * BASE_BITS}):
        with suppress(PrecisionError):
            return isolate(case, seed, bits)
    return None


def _holds(box: Box, q: complex) -> bool:
    return bool(box.q.contains(flint.acb(q.real, q.imag)))


def _images(ball: RootBall) -> list[RootBall]:
    """The ball and its mirror image under q → −q̄, once if they are the same root."""
    if ball.symmetry is Symmetry.IMAGINARY:
        return [ball]
    if ball.q.real > 0 or ball.q.real < 0:
        return [ball, ball.mirrored]
    raise PrecisionError("a cluster of roots meets the imaginary axis off its symmetry: ask for more digits")


def weight(ball: RootBall, count: Count) -> int:
    """How many roots of the region this ball and its mirror image stand for."""
    return sum(b.multiplicity for b in _images(ball) if inside(b, count))


def inside(ball: RootBall, count: Count) -> bool:
    """True or False as proved; `PrecisionError` when the ball meets the border of the counted region."""
    q = ball.q
    if count.contour == "edge":
        return True
    with ball_arithmetic(max(BITS, 4 * q.bits() + BITS)):
        if isinstance(count.contour, Rectangle):
            box = count.contour
            tests: list[Any] = [
                q.real - rational_ball(box.re_min),
                rational_ball(box.re_max) - q.real,
                q.imag - rational_ball(box.im_min),
                rational_ball(box.im_max) - q.imag,
            ]
        else:
            tests = [-q.imag]
        if all(t > 0 for t in tests):
            return True
        if any(t < 0 for t in tests):
            return False
    raise PrecisionError(f"a root near {q.str(6)} lies on the border of the region, or too close to it")


def _sorted(balls: list[RootBall]) -> tuple[RootBall, ...]:
    """Disjoint balls by the midpoints of (Re q, Im q); equal real parts are equal exactly, as mirror images."""
    for k, ball in enumerate(balls):
        if any(ball.q.overlaps(other.q) for other in balls[:k]):
            raise PrecisionError(f"two root balls meet near {ball.q.str(6)}: ask for more digits")
    with ball_arithmetic(64):
        keys = {id(b): (b.q.real.mid(), b.q.imag.mid()) for b in balls}
    return tuple(sorted(balls, key=lambda b: [flint.fmpq(*_ratio(x)) for x in keys[id(b)]]))


def _ratio(x: Any) -> tuple[Any, Any]:
    """An exact dyadic ball as numerator and denominator."""
    mantissa, exponent = x.man_exp()
    shift = int(exponent)
    return (mantissa << shift, 1) if shift >= 0 else (mantissa, flint.fmpz(1) << -shift)
