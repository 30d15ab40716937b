"""How many roots a region holds: the turn of Δ̂ along half of a contour, closed by passivity, an arc or a box."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np

from mpsolve.characteristic.disc_matrix import Arrays
from mpsolve.characteristic.origin import origin, waves_meet_at_zero
from mpsolve.characteristic.path import Path, Proved
from mpsolve.characteristic.paths import ROOM, Paths
from mpsolve.characteristic.start import Start, start
from mpsolve.errors import PrecisionError
from mpsolve.frozen import frozen
from mpsolve.numbers.balls import arb, precision
from mpsolve.numbers.float64 import short
from mpsolve.numbers.jets import UP, Jet, U
from mpsolve.passivity.beyond import Beyond, plan_beyond
from mpsolve.passivity.growth import fastest_growth
from mpsolve.problem.line import Line, on_line
from mpsolve.problem.reduced import Reduced
from mpsolve.proof.cover import OpenPieceError
from mpsolve.proof.definite import positive
from mpsolve.proof.effort import Effort
from mpsolve.spectrum.behind import BEHIND, all_behind
from mpsolve.spectrum.closing import closing_argument
from mpsolve.spectrum.on_frozen_track import on_rigid_rail
from mpsolve.spectrum.partial import Partial, count_strips, holding_growth
from mpsolve.spectrum.premises import open_at_rest, require_off_cuts, require_premises
from mpsolve.spectrum.reasons import WavesMeetError
from mpsolve.spectrum.regions import Below, HalfPlane, Rectangle, Region
from mpsolve.spectrum.sides import along_sides, descent, down_at, whole_turn, zeros
from mpsolve.tracks.at_rest import lowest_cut

AT_REST = "nothing moves: a passive vehicle on a passive track has no root with Im q < 0"
_LEAST_REACH, _AT_REST_REACH = 2.0, 8.0  # scaled: how far at least a count above the real axis goes; if nothing moves
_MOST_REACH = 256.0  # scaled: how far a vehicle can make it go, or a disc whose radius is not given
_BEYOND = 1.25  # times the vehicle's own highest frequency
Tell = Callable[[str, float], None]


@frozen
class Count:
    """The proved number of roots in `region`, with all that the proof rests on (points are scaled, q̂).

    beyond: the theorem that closes a half-plane; None for a disc or a rectangle, with `why` it is not there.
    half: which half of the sheet of a beam with its cuts on one line the points of a rectangle belong to, "lower" or
    "upper"; they are then z = q − iη, in the upper half z̄. "" for points q; "behind" or "passive" where that theorem
    leaves no root in Im q < 0, so that paths, if any, are those of a disc.
    """

    region: Region
    total: int
    start: Start
    paths: tuple[Path, ...]
    beyond: Beyond | None
    why: str
    evaluations: int
    half: str = ""

    @property
    def pieces(self) -> int:
        return sum(path.pieces for path in self.paths)


def count_roots(
    reduced: Reduced, region: Region, effort: Effort, tell: Tell, room: float = ROOM, partial: Partial | None = None
) -> Count:
    """The number of roots of Δ̂ in the region; PrecisionError or EffortError with the reason where it stays open.

    A half-plane whose theorem fails comes back as the half-disc that was counted. InputError where a premise fails.
    partial: takes what is proved on the way.
    """
    if isinstance(region, Rectangle) and (line := line_for(reduced, region)) is not None:
        return _box_on_line(reduced, line, region, effort, room)
    require_premises(reduced, region)
    arrays = Arrays(reduced)
    first = start(reduced.guide)
    if isinstance(region, Rectangle):
        paths = Paths(arrays, first, room)
        if partial is not None:
            count_strips(partial, paths, region, effort)
        return _box(paths, region, effort)
    meeting = origin(reduced.guide) if waves_meet_at_zero(reduced.guide) else None
    lost = waves_meet_at_zero(reduced.guide) and meeting is None
    if lost and (not _at_rest(reduced, region) or open_at_rest(reduced)):
        raise WavesMeetError
    paths = Paths(arrays, first, room, meeting)
    height = region.height if isinstance(region, Below) else Fraction(0)
    if region.radius is not None:
        return _disc(paths, first, region, height, "", effort)
    if all_behind(reduced, first):
        if height:
            return _disc(paths, first, region, height, BEHIND, effort, "behind")
        return Count(HalfPlane(), 0, first, (), None, BEHIND, effort.spent, "behind")
    if partial is not None and (rate := fastest_growth(reduced.guide)) is not None:
        partial.growth = rate * reduced.frequency_unit
    tell("passivity", 0.0)
    closed = open_at_rest(reduced) or (
        plan_beyond(paths, effort, _least_reach(reduced, _LEAST_REACH) if height else 0.0)
        if reduced.guide.v
        else None
    )
    tell("contour", 0.3)
    if isinstance(closed, str):
        return _disc(paths, first, region, height, closed, effort)
    if closed is None and not height:
        return Count(HalfPlane(), 0, first, (), None, AT_REST, effort.spent)
    if closed is None or partial is None:
        return _half_plane(paths, first, height, closed, effort)
    beyond = closed
    count = lambda: _half_plane(paths, first, height, beyond, effort)  # noqa: E731
    return holding_growth(partial, paths, beyond, height, effort, count)


def _at_rest(reduced: Reduced, region: Region) -> bool:
    return not reduced.guide.v and isinstance(region, HalfPlane) and region.radius is None


def _half_plane(paths: Paths, first: Start, height: Fraction, beyond: Beyond | None, effort: Effort) -> Count:
    """The count that passivity closes: beyond a rectangle, or at rest (None) everywhere in Im q < 0."""
    reduced = paths.arrays.reduced
    h = scaled_height(reduced, height)
    rho = short(_least_reach(reduced, _AT_REST_REACH)) if beyond is None else beyond.rho
    chain = (
        paths.plan("link", descent(first.depth, h), effort),
        paths.plan("turn", down_at(rho, h), effort),
        *((beyond.walls, beyond.axis) if beyond is not None else ()),
    )
    proved = paths.prove(chain, effort)
    with precision(64):
        middle, radius = proved.corners[1]
        _require_passive(rho, middle, radius)
        closing = closing_argument(reduced, rho, middle, radius)
        order = reduced.bodies - reduced.contacts - reduced.neutral
        total = zeros((closing + order * arb.pi() / 2 - whole_turn(proved)) / arb.pi())
    exact = _unscaled(reduced, rho)
    held = Below(height, reach=exact) if height else HalfPlane()
    return Count(held, total, first, proved.paths, beyond, "", effort.spent)


def _require_passive(rho: float, middle: Any, radius: Any) -> None:
    """V + V* is positive definite for every G in middle ± radius: PrecisionError where that is not proved."""
    a = 1j * rho * middle
    e = (rho * radius + 8 * U * np.abs(a)) * UP
    V = Jet(a[None], np.zeros_like(a[None]), e[None], np.zeros(1))
    if not positive(V, np.array([1j]), np.zeros(1))[0]:
        raise PrecisionError("the mobility at the corner of the contour is not passive to within its error")


def _disc(
    paths: Paths, first: Start, region: Region, height: Fraction, why: str, effort: Effort, half: str = ""
) -> Count:
    """Δ̂ ≠ 0 in the discs of the arc's pieces, so the half-disc holds as many roots as the polygon that goes round."""
    reduced = paths.arrays.reduced
    h, radius = scaled_height(reduced, height), _radius(reduced, region)
    arc = radius * np.exp(-1j * np.linspace(0, np.pi / 2, 33)[1:-1])
    turn = np.concatenate([down_at(radius, h), arc, [complex(0, -radius)]])
    chain = (paths.plan("link", descent(first.depth, h), effort), paths.plan("turn", turn, effort, arc=radius))
    proved = paths.prove(chain, effort)
    with precision(64):
        total = zeros(-whole_turn(proved) / arb.pi())
    asked = getattr(region, "radius", None)
    exact = asked if asked is not None else _unscaled(reduced, radius)
    held = Below(height, exact, None if half else exact) if height else HalfPlane(exact)
    return Count(held, total, first, proved.paths, None, why, effort.spent, half)


def _box(paths: Paths, box: Rectangle, effort: Effort) -> Count:
    total, proved = _round(paths, box, effort)
    return Count(box, total, paths.start, proved.paths, None, "", effort.spent)


def _round(paths: Paths, box: Rectangle, effort: Effort) -> tuple[int, Proved]:
    """The number of zeros inside, by the turn along the sides."""
    unit = paths.arrays.reduced.frequency_unit
    a, b, c, d = (float(x / unit) for x in (box.re_min, box.re_max, box.im_min, box.im_max))
    corners = [complex(a, c), complex(b, c), complex(b, d), complex(a, d), complex(a, c)]
    proved = along_sides(paths, corners, effort)
    with precision(64):
        return zeros(whole_turn(proved) / (2 * arb.pi())), proved


def line_for(reduced: Reduced, box: Rectangle) -> Line | None:
    """The beam undamped on the line of its cuts, where a rectangle needs it: above the lowest cut, or undamped."""
    line = on_line(reduced)
    if line is None or reduced.neutral or (line.height and box.im_max <= lowest_cut(reduced.problem.track)[0]):
        return None
    return line


def _box_on_line(reduced: Reduced, line: Line, box: Rectangle, effort: Effort, room: float) -> Count:
    """A rectangle below the line of the cuts, above it, or across it in the gap."""
    unit = reduced.frequency_unit
    require_off_cuts(line, box)
    above = box.im_min > line.height * unit
    half = line.upper if above else line.lower
    first = start(half.guide)
    paths = Paths(Arrays(half), first, room)
    try:
        total, proved = _round(paths, on_its_half(line, box), effort)
    except OpenPieceError as error:
        at = error.place.conjugate() if above else error.place
        raise OpenPieceError(at + 1j * float(line.height), error.length) from None
    return Count(box, total, first, proved.paths, None, "", effort.spent, "upper" if above else "lower")


def on_its_half(line: Line, box: Rectangle) -> Rectangle:
    """The rectangle of z, or of z̄ above the line of the cuts."""
    height = line.height * line.lower.frequency_unit
    low, high = box.im_min - height, box.im_max - height
    return Rectangle(box.re_min, box.re_max, -high, -low) if low > 0 else Rectangle(box.re_min, box.re_max, low, high)


def scaled_height(reduced: Reduced, height: Fraction) -> float:
    """The float nearest to the height in scaled units: the discs of the pieces hold the exact line too."""
    return float(height / reduced.frequency_unit)


def _unscaled(reduced: Reduced, x: float) -> Fraction:
    return Fraction(x) * reduced.frequency_unit


def _radius(reduced: Reduced, region: Region) -> float:
    """The radius of the half-disc in scaled units: the asked one to the nearest float, or one of some size."""
    asked = getattr(region, "radius", None)
    if asked is not None:
        return float(asked / reduced.frequency_unit)
    own = np.abs(on_rigid_rail(reduced)).max(initial=0.0)
    return float(min(max(8.0, 2.0 ** np.ceil(np.log2(1.5 * own + 1e-9))), _MOST_REACH))


def _least_reach(reduced: Reduced, least: float) -> float:
    """How far a count above the real axis goes at least: beyond what the vehicle does by itself."""
    return min(max(least, _BEYOND * float(np.abs(on_rigid_rail(reduced).imag).max(initial=0.0))), _MOST_REACH)
