"""The number of roots in a region, with all that a certificate needs to repeat the count."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

from mpsolve.errors import EffortError, PrecisionError
from mpsolve.fields import Float64, ball_arithmetic
from mpsolve.model.branch import Track, track
from mpsolve.model.limits import critical_velocity_ratio, limiting_frequency
from mpsolve.problem.case import Case
from mpsolve.progress import Progress
from mpsolve.sheet import reasons
from mpsolve.sheet.contour import Path
from mpsolve.sheet.far import far_radius
from mpsolve.sheet.region import Region
from mpsolve.sheet.rest import resting_start
from mpsolve.sheet.winding import count_rectangle, count_sheet, count_unstable
from mpsolve.spectrum.regions import Rectangle

BITS = 64
_BESIDE = 1e-6  # a rectangle this close to the line of the cuts fails because of it


@dataclass(frozen=True)
class Count:
    """A proved number of roots. `contour` is "edge" (whole sheet), "line" (Im q < 0) or the rectangle."""

    total: int
    contour: Literal["edge", "line"] | Rectangle
    radius: float | None  # no root has |q − iη_b| ≥ radius
    start: float | None  # of the edge
    paths: tuple[Path, ...]
    bits: int = BITS

    @property
    def evaluations(self) -> int:
        return sum(path.evaluations for path in self.paths)


def count_roots(case: Case, region: Region, limit: int, tell: Progress, line: bool = False) -> Count:
    """The proved count for the region; `PrecisionError` with reason and remedy when it is undecided.

    The unstable region is counted on the whole sheet, where that is possible, since the edge of the cut takes
    fewer pieces than the real line; else, or if `line` is asked for, on the line.
    """
    tell("counting", 0.0)
    if isinstance(region, Rectangle):
        return _in_rectangle(case, region, limit)
    if region == "sheet":
        try:
            return _on_edge(case, limit, tell)
        except PrecisionError as error:
            raise type(error)(reasons.on_sheet(case, error.reason)) from None
    if case.cuts_on_line and not line:
        try:
            return _on_edge(case, limit, tell)
        except PrecisionError as error:
            if not case.eta_b:
                raise type(error)(reasons.on_sheet(case, error.reason)) from None
    with ball_arithmetic(BITS) as field:
        model = track(case, field)
        radius = far_radius(model)
        total, path = count_unstable(model, radius, limit, _meter(tell, radius))
    return Count(total, "line", radius, None, (path,))


def _in_rectangle(case: Case, box: Rectangle, limit: int) -> Count:
    with ball_arithmetic(BITS) as field:
        model = track(case, field)
        _check_reach(model, box, limit)
        try:
            total, paths = count_rectangle(model, box, limit)
        except EffortError:
            raise
        except PrecisionError as error:
            gaps = [abs(float(side - case.eta_b)) for side in (box.im_min, box.im_max)]
            if case.cuts_on_line and min(gaps) < _BESIDE * max(1.0, float(case.eta_b)):
                raise PrecisionError(reasons.beside_cut(case, box)) from error
            raise
    return Count(total, box, None, None, paths)


def _check_reach(model: Track, box: Rectangle, limit: int) -> None:
    """Raises where the rectangle goes far beyond all roots and its sides would take more pieces than allowed.

    A side runs through the phase √(2|q|)·span of the waves between the masses twice, half a turn a piece at best.
    """
    reach = max(abs(float(x)) for x in vars(box).values())
    span = float((model.positions[-1] - model.positions[0]).mid())
    if reach < 4096 or 2 * math.sqrt(2 * reach) * span < limit / 2:
        return
    try:
        radius = far_radius(model)
    except PrecisionError:
        return
    if reach > 4 * radius:
        raise EffortError(reasons.rectangle_too_large(reach, radius))


def _on_edge(case: Case, limit: int, tell: Progress) -> Count:
    joined = cuts_are_joined(case)
    last: PrecisionError | None = None
    for bits in (BITS, 4 * BITS):
        with ball_arithmetic(bits) as field:
            model = track(case, field)
            radius = far_radius(model)
            single = len(model.eta_m) == 1
            at_rest = not case.alpha and (single or not case.axial)
            from_disc = at_rest and not single
            starts = [resting_start(model)] if from_disc else [0.0] if joined else _gap_points(case)
            for start in starts:
                try:
                    total, path = count_sheet(model, start, radius, limit, _meter(tell, radius), None, at_rest)
                except EffortError:
                    raise  # more bits, or another start, would take as many pieces again
                except PrecisionError as error:
                    last = error
                else:
                    return Count(total, "edge", radius, start, (path,), bits)
    raise last or PrecisionError("the gap between the cuts is too narrow to enter: take alpha further from alpha_C")


def _meter(tell: Progress, radius: float) -> Callable[[float], None]:
    """Progress by the logarithm of the distance covered: pieces grow along the way."""
    return lambda here: tell("counting", min(1.0, math.log1p(here) / math.log1p(radius)))


def _gap_points(case: Case) -> list[float]:
    """Dyadic points of the gap, ever closer to the branch point."""
    limit = float(limiting_frequency(case, Float64()))
    return [p for k in (7, 14, 24, 36) if (p := limit * (1 - 2.0**-k)) > 0]


def cuts_are_joined(case: Case) -> bool:
    """α > α_C, decided with balls; `PrecisionError` if the two are equal, or too close to tell at 4096 bits."""
    for bits in (BITS, 512, 4096):
        with ball_arithmetic(bits) as field:
            model: Track = track(case, field)
            critical = critical_velocity_ratio(case, field)
            if model.alpha > critical:
                return True
            if model.alpha < critical:
                return False
    raise PrecisionError(
        "alpha equals alpha_C = √(√(1 − eta_b²) − N), or nearly so, and the cuts just touch: "
        "change alpha, eta_b or the axial force a little"
    )
