"""The worst distance: where between lo and hi the smallest masses reach the onset of instability, proved.

With the masses t·eta_m, a crossing is a zero of F(x, t, d) = R·Δ for real x = q. Where t is least over all zeros, the
slopes F_x and F_d are parallel, Im(conj(F_x) F_d) = 0: else t could be lowered along the zeros (implicit functions).
That holds where d lies between lo and hi, not at these ends. What is proved for masses up to a ceiling above t:

    outside a hole       F has no zero, for any x and all d from lo to hi
    least inside         the hole keeps away from both ends, and in a box around it the system Re F = Im F =
                         Im(conj(F_x) F_d) = 0 has one solution: so that is where t is least
    least at an end      in a box around the hole dt/dd = −Im(conj(F_x) F_d)/Im(conj(F_x) F_t) along the zeros leads
                         upward from this end, where F has one zero in it: so that is it
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import pairwise
from typing import Any

import flint
import numpy as np

from mpsolve.discs import DiscField, Discs, DualField
from mpsolve.errors import PrecisionError
from mpsolve.fields import Float64, ball_arithmetic
from mpsolve.model.boxes import root_discs
from mpsolve.model.branch import track
from mpsolve.model.characteristic import kernel_matrix
from mpsolve.model.parameters import Case
from mpsolve.numbers.exact import Exact
from mpsolve.sheet.far import far_radius
from mpsolve.stability.curvature import NestedBalls, second_order, split_balls
from mpsolve.stability.exclude import Job, arrays, grid, local
from mpsolve.stability.family import Family
from mpsolve.stability.holes import about, inward
from mpsolve.stability.krawczyk import ball_of, contracted, contracted_all
from mpsolve.stability.together import Search
from mpsolve.stability.zero import BITS, approach, isolate, mass_level, sharpen

acb, arb = flint.acb, flint.arb
_DISTANCES, _FREQUENCIES = 96, 600  # of the float64 scan that tells where to look
_WIDEST, _NARROWEST = 2, 24  # binary exponents of the reach of the box about the solution
_BUDGET = 2_000_000  # boxes
_ROUND = 6  # decimal digits of the scale of the masses
_LEAST_ROOM = 1e-3  # of the hole along d: nearer to an end the zeros beside the hole hardly lie above the least one

Point = tuple[Any, Any, Any]


@dataclass(frozen=True)
class Worst:
    """The least mass level η over all distances, its distance d and frequency q, as balls."""

    eta: Any
    d: Any
    q: Any
    evaluations: int


def worst_search(case: Case, low: Exact, high: Exact, digits: int) -> Search[Worst]:
    """The worst distance in [low, high] for masses η·eta_m at 0, d, 2d, …. Raises `PrecisionError`."""
    x, eta, d = _guess(case, low, high)
    scale = Exact.parse(Fraction(f"{eta:.{_ROUND}g}"), "eta")
    family = Family(_scaled(case, scale), "mass", second="distance")
    point, end = _least(family, (x, 1.0, d), low, high)
    if end is None:
        hole = _between(float(point[2]), _box(family, point), low, high)
    else:
        hole = _end_box(family, point, end, 1 if end is low else -1)
    ceiling = _ceiling(family, point, hole, (-1, 1) if end is None else (1,) if end is low else (-1,))
    with ball_arithmetic(BITS) as field:
        reach = far_radius(family.at(field, None, low.ball().union(high.ball())))
    centre = map(Fraction, map(float, point))
    holes = np.array([[end for v, h in zip(centre, hole, strict=True) for end in inward(about(v, h))]])
    cover = yield Job(family, _region(reach, ceiling, low, high), holes, 0, 64, _BUDGET)
    if len(cover.open):
        raise PrecisionError(
            f"{len(cover.open)} boxes near d = {cover.open[0][4]:.4g} are open: masses nearly as small as the least "
            "cross there; give a range of distances without it, or one on either side"
        )
    with ball_arithmetic(math.ceil(digits * math.log2(10)) + 40):
        if end is None:
            q, t, distance = _sharpened(family, point, hole, digits)
        else:
            q, t, distance = *_sharpened_at(family, point, hole, end, digits), end.ball()
        if not t < arb(ceiling):
            raise PrecisionError("the least crossing mass lies above the masses looked at: change the range a little")
        return Worst(t * scale.ball(), distance, q, cover.evaluations)


def _least(family: Family, guess: tuple[float, float, float], low: Exact, high: Exact) -> tuple[Point, Exact | None]:
    """The point (x, t, d) of least t that is found near the guess, and the end of the range it is at. Heuristic."""
    x, t, d = guess
    found: list[tuple[Point, Exact | None]] = []
    try:
        inside = _solution(family, (arb(x), arb(t), arb(d)))
        if low.ball() < inside[2] < high.ball():
            found.append((inside, None))
    except PrecisionError:
        pass  # no stationary point near: the least one then is at an end
    for end in (low, high):
        crossing = _crossing_at(family, x, t, end)
        if crossing is not None:
            found.append(((arb(crossing[0]), arb(crossing[1]), arb(float(end))), end))
    if not found:
        raise PrecisionError("the least crossing mass was not found again: change the range a little")
    return min(found, key=lambda one: float(one[0][1]))


def _between(d: float, box: tuple[float, float, float], low: Exact, high: Exact) -> tuple[float, float, float]:
    """Half-widths of a box within this one that keeps away from both ends of the range."""
    room = min(box[2], 0.9 * (d - float(low)), 0.9 * (float(high) - d))
    inside = low < Fraction(d) - Fraction(room) and high > Fraction(d) + Fraction(room)  # compared exactly
    if not inside or room < min(_LEAST_ROOM, box[2]):
        raise PrecisionError(
            f"the worst distance, {d:.6g}, nearly is an end of the range: widen the range, or end it further away"
        )
    return box[0], box[1], room


def _scaled(case: Case, scale: Exact) -> Case:
    return replace(case, eta_m=tuple(ratio * scale for ratio in case.eta_m))


def _region(reach: float, ceiling: float, low: Exact, high: Exact) -> Any:
    """[0, reach] × [0, ceiling] × [low, high] in boxes."""
    flat = grid(reach, 0.0, ceiling, 1)
    ends = np.linspace(float(low) * (1 - 2.0**-50), float(high) * (1 + 2.0**-50), 7)
    return np.concatenate([np.column_stack([flat, np.full((len(flat), 2), pair)]) for pair in pairwise(ends)])


def _guess(case: Case, low: Exact, high: Exact) -> tuple[float, float, float]:
    """(x, η, d) near the least crossing mass, by float64 on a grid. Heuristic.

    Where an eigenvalue λ of [K_ij μ_j] is real and positive, η = π/(2x²λ) is a crossing mass.
    """
    best: tuple[float, float, float] | None = None
    model, x = track(case, Float64()), np.geomspace(0.02, 3, _FREQUENCIES)
    for d in np.linspace(float(low), float(high), _DISTANCES).tolist():
        rows = kernel_matrix(replace(model, positions=tuple(k * d for k in range(len(model.eta_m)))), x)
        matrices = np.array([[rows[i][j] * eta for j, eta in enumerate(model.eta_m)] for i in range(len(rows))])
        values = np.linalg.eigvals(np.moveaxis(matrices, -1, 0))
        for k in range(len(x) - 1):
            for value in values[k]:
                after = values[k + 1][np.argmin(abs(values[k + 1] - value))]
                if value.imag * after.imag < 0 < value.real:
                    eta = math.pi / (2 * x[k] ** 2 * value.real)
                    if best is None or eta < best[1]:
                        best = float(x[k]), eta, d
    if best is None:
        raise PrecisionError(
            "no crossing mass was seen at any distance of the range, which is no proof that there is none"
        )
    return best


def _system(F: Any) -> tuple[list[Any], list[list[Any]]]:
    """(Re F, Im F, Im(conj(F_x) F_d)) and their slopes along x, t, d, from F nested in the order q, d, t."""
    order = (0, 2, 1)
    (f_x, f_d, _), value = F.slopes, F.value
    along = [value.slopes[k] for k in order]
    turns = [f_x.slopes[k].conjugate() * f_d.value + f_x.value.conjugate() * f_d.slopes[k] for k in order]
    values = [value.value.real, value.value.imag, (f_x.value.conjugate() * f_d.value).imag]
    return values, [[z.real for z in along], [z.imag for z in along], [z.imag for z in turns]]


def _in_balls(family: Family, field: Any, point: Point) -> tuple[list[Any], list[list[Any]]]:
    x, t, d = point
    model = family.at(field, None, d)
    roots = split_balls(model, acb(x))
    return _system(second_order(model, NestedBalls(), roots, [acb(x), acb(d), acb(t)], acb(1)))


def _solution(family: Family, start: Point) -> Point:
    """Newton's method on midpoints. Heuristic; `PrecisionError` where it goes astray."""
    point = start
    with ball_arithmetic(BITS) as field:
        for _ in range(60):
            values, jacobian = _in_balls(family, field, point)
            step = _newton(values, jacobian)
            size = max(abs(float(s)) for s in step)
            cut = min(1.0, 0.05 / size) if size else 1.0
            point = tuple((v - s * cut).mid() for v, s in zip(point, step, strict=True))
            if not 0 < float(point[0]) < 1e3 or not 0.2 < float(point[1]) < 5 or float(point[2]) <= 0:
                break
            if size < 1e-15:
                return point
    raise PrecisionError("the least crossing mass has no smooth minimum in the range: it may lie at an end of it")


def _newton(values: list[Any], jacobian: list[list[Any]]) -> list[Any]:
    matrix = flint.arb_mat(3, 3, [entry.mid() for row in jacobian for entry in row])
    try:
        step = matrix.solve(flint.arb_mat(3, 1, [value.mid() for value in values]))
    except ZeroDivisionError:
        raise PrecisionError("the least crossing mass has no curvature there") from None
    return [entry.mid() for entry in step.entries()]


def _box(family: Family, point: Point) -> tuple[float, float, float]:
    """Half-widths of the widest box about the point in which discs prove that there is one solution."""
    shape = np.array([0.2 + 2.5 * _tilt(family, point), 1.0, 2.0])  # in x, t and d: the zeros leave the box along d
    sizes = 2.0 ** -np.arange(_WIDEST, _NARROWEST, 0.5)[:, None] * shape
    count, field = len(sizes), DiscField()
    centres = [np.full(count, float(v)) for v in point]

    def nested(reaches: Any) -> tuple[Any, Any]:
        q, mass, distance = (Discs(v, h) for v, h in zip(centres, reaches.T, strict=True))
        model = arrays(family.at(field, None, distance), count)
        found = root_discs(model, q)
        one = Discs(np.ones(count))
        return second_order(model, DualField(), found.roots, [q, distance, mass], one), found.apart

    with np.errstate(all="ignore"):
        still, there = nested(0 * sizes)
        over, apart = nested(sizes)
    with ball_arithmetic(BITS):
        for k in np.flatnonzero(there & apart):
            centre, size = [arb(float(v)) for v in point], [float(h) for h in sizes[k]]
            values, jacobian = _system(_balls(still, int(k)))[0], _system(_balls(over, int(k)))[1]
            finite = all(entry.is_finite() for row in [values, *jacobian] for entry in row)
            if finite and contracted_all(values, jacobian, centre, size) is not None:
                return size[0], size[1], size[2]
    raise PrecisionError("the least crossing mass could not be isolated: two may nearly coincide")


def _tilt(family: Family, point: Point) -> float:
    """|dx/dd| along the zeros at the solution, where F_x and F_d are parallel."""
    with ball_arithmetic(BITS) as field:
        along = _in_balls(family, field, point)[1]
        f_x, f_d = (complex(float(along[0][k].mid()), float(along[1][k].mid())) for k in (0, 2))
    return float(abs(f_d / f_x))


def _balls(value: Any, k: int) -> Any:
    """The same nested dual number, of the disc number k, in balls."""
    if isinstance(value, Discs):
        m, r = np.atleast_1d(value.m), np.atleast_1d(value.r)
        return ball_of(Discs(np.broadcast_to(m, (k + 1,)) if len(m) == 1 else m, np.broadcast_to(r, m.shape)), k)
    return type(value)(_balls(value.value, k), [_balls(slope, k) for slope in value.slopes])


def _end_box(family: Family, point: Point, end: Exact, into: int) -> tuple[float, float, float]:
    """Half-widths of a box about a crossing at an end of the range: the only one at that end, t rising from there.

    In the box dt/dd along the zeros has the sign of `into`, so that t is least at no zero away from this end.
    """
    reaches = 2.0 ** -np.arange(_WIDEST, _NARROWEST, 0.5)
    value, (f_x, f_t, f_d), good = local(family, [float(v) for v in point], reaches)
    with ball_arithmetic(BITS):
        for k in np.flatnonzero(good):
            f, along_x, along_t, along_d = (ball_of(z, int(k)) for z in (value, f_x, f_t, f_d))
            size = float(reaches[k])
            off = end.ball() - arb(float(point[2]))  # the values were taken at a float next to the end
            if not abs(off) < arb(size):
                continue
            f = f + along_d * off
            alone = (
                contracted(f, along_x, along_t, arb(float(point[0])), arb(float(point[1])), size, size) is not None
            )
            rise = -into * (along_x.conjugate() * along_d).imag / (along_x.conjugate() * along_t).imag
            if alone and rise > 0:
                return size, size, size
    raise PrecisionError(
        "the least crossing mass is nearly stationary at an end of the range: change the range a little"
    )


def _sharpened_at(family: Family, point: Point, box: Any, end: Exact, digits: int) -> tuple[Any, Any]:
    """(x, t) of the crossing at an end, proved to lie in the box."""
    level = Family(_with_distance(family.case, end), "level")
    found = approach(level, float(point[0]), _level_of(float(point[0]), float(point[1])))
    if found is None:
        raise PrecisionError("the crossing at an end of the range was lost: ask for fewer digits")
    zero = sharpen(level, isolate(level, *found), digits + 6)
    t = mass_level(zero)
    x0, t0 = (arb(float(v)) for v in point[:2])
    if not (abs(zero.x - x0) < arb(box[0]) and abs(t - t0) < arb(box[1])):
        raise PrecisionError("the crossing at an end of the range lies elsewhere: change the range a little")
    return zero.x, t


def _ceiling(family: Family, point: Point, hole: Any, sides: tuple[int, ...]) -> float:
    """A mass t above the least one, up to which the zeros near the solution stay in the hole. Heuristic."""
    x, t, d = map(float, point)
    for share in (0.8, 0.5, 0.3, 0.15):
        places = [Exact.parse(Fraction(d + sign * share * hole[2]).limit_denominator(10**9)) for sign in sides]
        ends = [_crossing_at(family, x, t, place) for place in places]
        rises = [end[1] / t - 1 for end in ends if end is not None and abs(end[0] - x) < 0.8 * hole[0]]
        if len(rises) == len(sides) and min(rises) > 0:
            return float(t * (1 + min(*rises, hole[1]) / 2))
    raise PrecisionError("the least crossing mass hardly depends on the distance")


def _crossing_at(family: Family, x: float, t: float, d: Exact) -> tuple[float, float] | None:
    """The crossing (x, mass) near (x, t) at the distance d. Heuristic."""
    found = approach(Family(_with_distance(family.case, d), "level"), x, _level_of(x, t))
    if found is None:
        return None
    with ball_arithmetic(BITS):
        return float(found[0]), float(mass_level(_Place(*found)).mid())


def _level_of(x: float, t: float) -> float:
    kappa = 2 * t * x * x / math.pi / (1 + x * x)
    return kappa / (1 + kappa)


@dataclass(frozen=True)
class _Place:
    x: Any
    t: Any


def _with_distance(case: Case, d: Exact) -> Case:
    return replace(case, positions=tuple(d * k for k in range(case.count)))


def _sharpened(family: Family, point: Point, box: Any, digits: int) -> Point:
    """The solution in balls of relative radius below 10^−digits, proved to lie in the box."""
    centre = [arb(float(v)) for v in point]
    goal, here = math.ceil(digits * math.log2(10)) + 8, point
    bits = 80
    while True:
        with ball_arithmetic(bits + 32) as field:
            step = _newton(*_in_balls(family, field, here))
            here = tuple((v - s).mid() for v, s in zip(here, step, strict=True))
        if bits >= goal + 16:
            break
        bits = min(2 * bits - 16, goal + 16)
    with ball_arithmetic(goal + 64) as field:
        for slack in (0, 8, 16):
            sizes = [(abs(v) * arb((1, slack - goal))).upper() for v in here]
            wide = tuple(v + arb(0, s) for v, s in zip(here, sizes, strict=True))
            values, jacobian = _in_balls(family, field, here)[0], _in_balls(family, field, wide)[1]
            image = contracted_all(values, jacobian, list(here), sizes)
            if image is not None and all(
                abs(v - p) < h for v, p, h in zip(image, centre, map(arb, box), strict=True)
            ):
                return image[0], image[1], image[2]
    raise PrecisionError(f"the worst distance could not be sharpened to {digits} digits: ask for fewer")
