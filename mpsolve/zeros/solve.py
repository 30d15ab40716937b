"""Count, find, sort: the zeros of a function in a region, or what is known and why the rest is open."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from flint import acb, arb

from mpsolve.errors import EffortError, InputError, PrecisionError
from mpsolve.numbers.rootball import RootBall
from mpsolve.outcome import Reason
from mpsolve.progress import Progress
from mpsolve.proof.effort import MORE_EFFORT, Effort
from mpsolve.zeros.analytic import NotAnalyticError
from mpsolve.zeros.count import Count, ZeroOnPathError, count_zeros
from mpsolve.zeros.evaluate import PoleError
from mpsolve.zeros.find import corners_of, find_zeros
from mpsolve.zeros.function import Function
from mpsolve.zeros.geometry import Vertices, box_of, grown
from mpsolve.zeros.read import Given
from mpsolve.zeros.regions import Cut, Disc, Polygon, Rectangle, Region, place_in

_MOVES = (Fraction(1, 1 << 12), Fraction(-1, 1 << 12), Fraction(3, 1 << 9), Fraction(-3, 1 << 9))
"""How far the boundary is moved, relative to the region's size, where the count does not pass it."""


@dataclass(frozen=True)
class Solved:
    """The count (None where it stayed open), all its balls, those in `region`, and why that is not all."""

    count: Count | None
    balls: tuple[RootBall, ...]
    inside: tuple[RootBall, ...]
    region: Region
    note: str
    reason: Reason | None


def solve(given: Given, region: Region, cuts: Sequence[Cut], digits: int, effort: Effort, tell: Progress) -> Solved:
    """The zeros in the region; never raises for what stays undecided."""
    tell("boundary", 0.0)
    try:
        count, part = _counted(given.function, region, cuts, effort)
    except (EffortError, PrecisionError) as error:
        return Solved(None, (), (), region, "", reason_of(error))
    tell("zeros", 0.0)
    try:
        balls = tuple(find_zeros(given.function, count, digits, effort, tell))
    except EffortError as error:
        return Solved(count, (), (), region, "", error.reason)
    number = sum(ball.multiplicity for ball in balls)
    if number != count.total or _overlap(balls):
        message = f"{count.total} zeros are counted, but {number} could be enclosed"
        numbers = {"counted": str(count.total), "enclosed": str(number)}
        reason = Reason("zeros", message, numbers, "ask for more digits, so that close zeros come apart")
        return Solved(count, balls, balls, region, "", reason)
    return _sorted(count, balls, region, part, _common(given.denominator, balls))


def _counted(f: Function, region: Region, cuts: Sequence[Cut], effort: Effort) -> tuple[Count, Fraction]:
    """The count in the region's polygon, or in one moved a little; and by how much."""
    failure: PrecisionError | None = None
    for part in (Fraction(0), *_MOVES):
        vertices = grown(region.polygon, part) if part else region.polygon
        if vertices is None:
            break
        try:
            return count_zeros(f, vertices, cuts, effort), part
        except EffortError:
            raise
        except InputError:
            if not part:
                raise
        except PrecisionError as error:
            failure = failure or error
            if isinstance(error, NotAnalyticError) and not _near_boundary(error.place, region.polygon):
                break
    raise failure or PrecisionError("f is not counted")


def _near_boundary(place: complex, vertices: Vertices) -> bool:
    left, right, low, high = map(float, box_of(vertices))
    width = max(right - left, high - low) * float(max(_MOVES))
    inside = (left + width < place.real < right - width) and (low + width < place.imag < high - width)
    return len(vertices) > 4 or not inside


def _overlap(balls: Sequence[RootBall]) -> bool:
    order = sorted(balls, key=lambda ball: corners_of(ball)[0][0])  # by their left ends, whatever their sizes
    for k, ball in enumerate(order):
        for other in order[k + 1 :]:
            if other.q.real > ball.q.real:
                break
            if ball.q.overlaps(other.q):
                return True
    return False


def _common(denominator: Function | None, balls: Sequence[RootBall]) -> Reason | None:
    """A zero of the numerator at which the denominator may vanish too."""
    for ball in balls if denominator is not None else ():
        low, high = corners_of(ball)
        side = max(high[0] - low[0], high[1] - low[1])
        wide = ball.q + acb(arb(0, float(side)), arb(0, float(side)))
        try:
            if denominator is not None and denominator.value(wide).abs_lower() > 0:
                continue
        except PrecisionError:
            pass
        near = complex(ball.q)
        message = f"numerator and denominator may vanish together near z = {near:.8g}"
        remedy = "divide both by what they have in common, or ask for a region without this place"
        return Reason("common-zero", message, {"re": repr(near.real), "im": repr(near.imag)}, remedy)
    return None


def _sorted(
    count: Count, balls: tuple[RootBall, ...], region: Region, part: Fraction, reason: Reason | None
) -> Solved:
    """The balls inside what was asked for, or inside what was counted where the boundary cannot be told."""
    places = [place_in(region, *corners_of(ball)) for ball in balls]
    if part >= 0 and None not in places:
        inside = tuple(ball for ball, place in zip(balls, places, strict=True) if place)
        return Solved(count, balls, inside, region, "", reason)
    moved = Polygon(count.vertices)
    box = box_of(count.vertices)
    a, b, c, d = box
    kept: Region = Rectangle(*box) if set(count.vertices) == {(a, c), (b, c), (b, d), (a, d)} else moved
    if part > 0 or isinstance(region, Disc):
        note = "a zero lies on the boundary, or too near to be told: the region is a little larger than was asked for"
    else:
        note = (
            "f may vanish, or have a branch point, on the boundary: the region is a little smaller than was asked for"
        )
    return Solved(count, balls, balls, kept, note, reason)


def reason_of(error: EffortError | PrecisionError) -> Reason:
    """The error as a reason with a remedy that fits it."""
    if isinstance(error, EffortError):
        return error.reason if error.reason.code == "effort" else Reason("effort", str(error), {}, MORE_EFFORT)
    if isinstance(error, ZeroOnPathError):
        return Reason(
            "zero-on-boundary", str(error), _at(error.place), "move that side of the region, or turn the cut"
        )
    if isinstance(error, NotAnalyticError):
        if isinstance(error.cause, PoleError):
            message = f"f may have a pole near z = {error.place:.6g}"
            remedy = "give f as (numerator, denominator), or a region without this place"
            return Reason("pole", message, _at(error.place), remedy)
        remedy = "declare the branch cuts, as in cuts=[Cut.ray(origin, direction)], or give a region without them"
        return Reason("not-analytic", str(error), _at(error.place), remedy)
    return Reason("count", str(error), {}, "give a region with simpler sides, or f with fewer cancellations")


def _at(place: complex) -> dict[str, str]:
    return {"re": f"{place.real:.10g}", "im": f"{place.imag:.10g}"}
