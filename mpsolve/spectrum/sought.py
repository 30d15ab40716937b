"""Where counted roots are sought: rectangles that hold them, points near which they may be. Nothing is proved."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np

from mpsolve.numbers.float64 import distinct
from mpsolve.problem.line import on_line
from mpsolve.problem.reduced import Reduced
from mpsolve.spectrum.candidates import Area, Weight, both
from mpsolve.spectrum.count import Count, scaled_height
from mpsolve.spectrum.regions import Answered, Below, Rectangle
from mpsolve.spectrum.sheet import SheetCount

_SLOW = np.concatenate([np.arange(1, 13) / 12, np.outer([0.3, 0.6, 0.9], np.exp([-0.4j, -0.8j, -1.2j])).ravel()])
"""Where vibrations are looked for that run slower than waves, in parts of the frequency at which those begin."""


def areas_of(reduced: Reduced, count: Count | SheetCount) -> tuple[Area, ...]:
    """Scaled rectangles that hold the right half of all counted roots, small ones first."""
    if isinstance(count, SheetCount):
        return _on_sheet(count)
    region, unit = count.region, reduced.frequency_unit
    if isinstance(region, Rectangle):
        ends = [abs(float(x / unit)) for x in (region.re_min, region.re_max)]
        least = 0.0 if region.re_min < 0 < region.re_max else min(ends)
        return (Area(least, max(ends), float(region.im_min / unit), float(region.im_max / unit)),)
    if count.beyond is not None:
        width, depth = count.beyond.rho, count.beyond.depth
    else:
        depth = float((region.radius or Fraction(0)) / unit)
        reach = region.reach if isinstance(region, Below) else region.radius
        width = float((reach or Fraction(0)) / unit)  # at rest there is a reach without a radius
    areas = [Area(0.0, width, -depth, 0.0)]
    if isinstance(region, Below):
        areas.insert(0, Area(0.0, width, 0.0, scaled_height(reduced, region.height)))
    return tuple(areas)


def _on_sheet(count: SheetCount) -> tuple[Area, ...]:
    """Both sides of the line of the cuts, and what is below it in sizes that grow."""
    h, small = float(count.line.height), max(2 * count.end, 1.5)
    first = Area(0.0, small, h - small, h if _none_above(count) else h + small, h)
    if count.far is None:
        return (first,)
    # roots of masses close to each other lie as far out as waves are short beside the gap
    sizes = [x * small for x in (4, 32, 256) if x * small < count.far.reach]
    return first, *(Area(0.0, size, h - size, h, h) for size in (*sizes, max(4 * small, count.far.reach)))


def _none_above(count: SheetCount) -> bool:
    """Whether track and vehicle are passive on the whole half above the cuts."""
    return count.far is not None and not count.upper.paths


def hints_of(reduced: Reduced, count: Count | SheetCount) -> Any:
    """Points at which Δ̂ turns fast, and slow frequencies; none twice."""
    if isinstance(count, SheetCount):
        halves = (count.lower, count.upper)
        rings = [loop.places for half in halves for loop in half.loops]
        turns = [path.points for half in halves for path in half.paths if path.kind == "turn"]
        slow = count.first * _SLOW
        points = np.concatenate([*turns, *rings, slow])
        near = points[np.abs(points) < max(16.0, 4 * count.end)]
        both_halves = near if _none_above(count) else np.concatenate([near, near.conj()])
        return distinct(both_halves) + 1j * float(count.line.height)
    points = np.concatenate([path.points for path in count.paths if path.kind == "turn"])
    if not count.half:
        return points
    line = on_line(reduced)
    height = float(line.height) if line is not None else 0.0
    return (points.conj() if count.half == "upper" else points) + 1j * height


def weight_of(reduced: Reduced, region: Answered) -> Weight:
    """How many roots of the region a point of its right half stands for, in floats."""
    if not isinstance(region, Rectangle):
        return both
    unit = float(reduced.frequency_unit)
    low, high = float(region.re_min) / unit, float(region.re_max) / unit
    return lambda q: sum(low < x < high for x in {q.real, -q.real}) if both(q) > 1 else 1
