"""No zero in a region [x] × [t] outside of given holes: subdivision in rigorous float64, many boxes at once.

A region may have two parameters, [x] × [t] × [s]. Many regions of families that are alike share one sweep, since a
sweep over few boxes costs as much as one over a thousand.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from mpsolve.discs import DiscField, Discs, DualField
from mpsolve.dual import Dual
from mpsolve.model.boxes import part, root_discs, root_slopes
from mpsolve.model.branch import ALONG_Q, Track
from mpsolve.model.scaled import SplitRoots, scaled_characteristic
from mpsolve.stability.family import Family, moved

_CHUNK = 8192
_SMALL = 2.0**-9  # boxes of this width in t are looked at one by one
_OUT = 1 + 2.0**-50  # half-widths of boxes are rounded outward

Region = Any  # float64 array of shape (n, 4): x from, x to, t from, t to; (n, 6) with a second parameter


@dataclass(frozen=True)
class Job:
    """Subdivide `boxes` until each is proved to hold no zero or lies in a hole, or `few` boxes are left.

    The few are those that surround a zero, or a point where the formulas lose their grip: balls deal with them.
    It ends with what is open after so many levels, or when the budget of boxes is spent.
    """

    family: Family
    boxes: Region
    holes: Region
    few: int = 160
    levels: int = 64
    budget: int = 3_000_000


@dataclass(frozen=True)
class Cover:
    """What subdivision left over, as boxes, and the number of boxes that were looked at."""

    open: Region
    evaluations: int


def exclude(job: Job) -> Cover:
    """One job alone."""
    return exclude_all([job])[0]


def exclude_all(jobs: Sequence[Job]) -> list[Cover]:
    """The jobs' covers. The families must be alike: same parameters, same number of masses."""
    families, field = [job.family for job in jobs], DiscField()
    width = 2 + 2 * len(families[0].parameters)
    boxes = np.concatenate([np.asarray(job.boxes, dtype=float).reshape(-1, width) for job in jobs])
    owner = np.repeat(np.arange(len(jobs)), [len(np.asarray(job.boxes).reshape(-1, width)) for job in jobs])
    spent = np.zeros(len(jobs), dtype=int)
    done: list[Any] = [None] * len(jobs)
    for level in itertools.count():
        for k, job in enumerate(jobs):
            if done[k] is None and _ended(job, boxes, owner == k, level, spent[k]):
                done[k] = boxes[owner == k]
        active = np.array([left is None for left in done])
        if not active.any():
            return [Cover(left, int(number)) for left, number in zip(done, spent, strict=True)]
        boxes, owner = boxes[active[owner]], owner[active[owner]]
        spent += np.bincount(owner, minlength=len(jobs))
        halves, owners = [], []
        for start in range(0, len(boxes), _CHUNK):
            chunk, whose = boxes[start : start + _CHUNK], owner[start : start + _CHUNK]
            free, axis = _tested(families, whose, field, chunk)
            keep = ~free
            for k in np.unique(whose):
                keep &= ~((whose == k) & inside(chunk, jobs[k].holes))
            halves.append(_halved(chunk[keep], axis[keep]))
            owners.append(np.concatenate([whose[keep], whose[keep]]))
        boxes, owner = np.concatenate(halves), np.concatenate(owners)
    raise AssertionError("unreachable")


def _ended(job: Job, boxes: Region, mine: Any, level: int, spent: int) -> bool:
    number = int(np.count_nonzero(mine))
    if level >= job.levels or spent > job.budget or number <= (job.few if level else 0):
        return True
    return bool(job.few) and bool(np.max(boxes[mine, 3] - boxes[mine, 2], initial=0) < _SMALL)


def grid(x1: float, t0: float, t1: float, rows: int = 12) -> Region:
    """[0, x1] × [t0, t1] in boxes that are finer where the zeros are: a start for `exclude`."""
    near = np.linspace(0, min(x1, 2.0), 25)
    far = np.geomspace(2.0, x1, max(2, int(3 * np.log2(x1 / 2)) + 2))[1:] if x1 > 2 else np.empty(0)
    x, t = np.concatenate([near, far]), np.linspace(t0, t1, rows + 1)
    x[-1], t[0], t[-1] = x1, t0, t1
    corners = [(a, b, c, d) for a, b in itertools.pairwise(x) for c, d in itertools.pairwise(t)]
    return np.array(corners)


def inside(boxes: Region, holes: Region) -> Any:
    """Whether each box lies in a hole."""
    found = np.zeros(len(boxes), dtype=bool)
    for hole in holes:
        within = np.ones(len(boxes), dtype=bool)
        for k in range(0, len(hole), 2):
            within &= (boxes[:, k] >= hole[k]) & (boxes[:, k + 1] <= hole[k + 1])
        found |= within
    return found


def _halved(boxes: Region, axis: Any) -> Region:
    """Both halves of each box, along x where `axis` is 0, else along the parameter of that number."""
    first, second = boxes.copy(), boxes.copy()
    for k in range(boxes.shape[1] // 2):
        low, high = boxes[:, 2 * k], boxes[:, 2 * k + 1]
        middle = (low + high) / 2
        if not k:
            with np.errstate(all="ignore"):
                middle = np.where(low > 1, np.sqrt(low * high), np.where(high > 4, 2.0, middle))
        first[:, 2 * k + 1] = np.where(axis == k, middle, high)
        second[:, 2 * k] = np.where(axis == k, middle, low)
    return np.concatenate([first, second])


def _middles(boxes: Region) -> tuple[list[Any], list[Any]]:
    """The middles of x and of the parameters, and the half-widths, rounded outward."""
    sides = [(boxes[:, k], boxes[:, k + 1]) for k in range(0, boxes.shape[1], 2)]
    middles = [(low + high) / 2 for low, high in sides]
    reaches = [np.maximum(b - m, m - a) * _OUT for (a, b), m in zip(sides, middles, strict=True)]
    return middles, reaches


def _models(families: Sequence[Family], owner: Any, field: Any, values: Sequence[Any]) -> Track:
    """The numbers of each box's own family at `values`, as arrays of one disc a box."""
    fixed = [family.fixed(field) for family in families]
    model = fixed[0]
    if len(fixed) > 1:
        model = replace(
            model,
            alpha=_gathered([one.alpha for one in fixed], owner),
            axial=_gathered([one.axial for one in fixed], owner),
            eta_b=_gathered([one.eta_b for one in fixed], owner),
            eta_m=tuple(_gathered(column, owner) for column in zip(*(one.eta_m for one in fixed), strict=True)),
            positions=tuple(
                _gathered(column, owner) for column in zip(*(one.positions for one in fixed), strict=True)
            ),
        )
    for name, value in zip(families[0].parameters, values, strict=True):
        model = moved(model, name, value)
    return arrays(model, len(owner))


def _gathered(discs: Sequence[Discs], owner: Any) -> Discs:
    return Discs(np.array([disc.m for disc in discs])[owner], np.array([disc.r for disc in discs])[owner])


def _frequencies(families: Sequence[Family], owner: Any, field: Any, x: Any, reach: Any) -> Discs:
    heights = [field.number(family.height) for family in families]
    height = heights[0] if len(heights) == 1 else _gathered(heights, owner)
    return Discs(x + 1j * height.m, reach + height.r)


def _tested(families: Sequence[Family], owner: Any, field: DiscField, boxes: Region) -> tuple[Any, Any]:
    """(proved to hold no zero, the axis along which to halve) of each box."""
    family = families[0]
    (x, *middles), (dx, *reaches) = _middles(boxes)
    values = [Discs(t, dt) for t, dt in zip(middles, reaches, strict=True)]
    widths = np.stack([2 * dx / (1 + boxes[:, 0]), *(2 * dt for dt in reaches)])
    axis = np.argmax(widths, axis=0)
    q = _frequencies(families, owner, field, x, dx)
    model = _models(families, owner, field, values)
    with np.errstate(all="ignore"):
        found = root_discs(model, q)
        value = _value(family, field, model, found.roots, q, values)
        free = found.known & value.nonzero()
        if len(model.eta_m) == 2 and not any(one.height for one in families):
            free |= found.apart & _outweighed(model, found.roots)
        more = found.apart & ~free
        if more.any():
            roots = SplitRoots(*(p[more] for p in (found.roots.a, found.roots.b, found.roots.c, found.roots.e)))
            over = part(model, more), roots, q[more], [value[more] for value in values]
            free[more], axis[more] = _by_slopes(families, owner[more], field, boxes[more], over)
    return free, axis


def _outweighed(model: Track, z: SplitRoots) -> Any:
    """Two masses of any size and a real q: Re K(0) < 0 and |K(d) K(−d)| < |K(0)|² leave no zero.

    Then |1 − κη K(0)| > κη |K(0)| for both, so that (1 − κη₁K(0))(1 − κη₂K(0)) outweighs κ²η₁η₂ K(d)K(−d). Needs
    no phase of the waves: far out they turn too fast for enclosures. On its side |e^{ipξ}| = e^{−|Im p ξ|} ≤ 1.
    """
    a, b, c, e = z.a, z.b, z.c, z.e
    distance = model.positions[1] - model.positions[0]
    residues = [1 / ((a - b) * (a - c) * (a - e)), 1 / ((b - a) * (b - c) * (b - e))]
    behind = [1 / ((c - a) * (c - b) * (c - e)), 1 / ((e - a) * (e - b) * (e - c))]
    contact = (residues[0] + residues[1]) * 1j  # K(0)/2π
    waves = [
        sum(w.upper * _decay(p, distance) for p, w in zip(roots, weights, strict=True))
        for roots, weights in (((a, b), residues), ((c, e), behind))
    ]
    leads = waves[0] * waves[1] * (1 + 2.0**-40) < contact.lower * contact.lower
    return leads & (contact.m.real < -contact.r)


def _decay(p: Discs, distance: Discs) -> Any:
    """An upper bound of e^{−|Im p|·distance}: the reciprocal of its series' first terms."""
    y = np.maximum(np.abs(p.m.imag) - p.r, 0.0) * distance.lower * (1 - 2.0**-40)
    return (1 + 2.0**-40) / (1 + y * (1 + y / 2 * (1 + y / 3 * (1 + y / 4))))


def arrays(model: Track, count: int) -> Track:
    """α and η_b as arrays of one disc a box."""
    alpha, eta_b = (Discs(np.broadcast_to(z.m, (count,)), z.r) for z in (model.alpha, model.eta_b))
    return replace(model, alpha=alpha, eta_b=eta_b)


def _value(family: Family, field: Any, model: Track, roots: SplitRoots, q: Any, values: Sequence[Any]) -> Any:
    if "level" in family.parameters:
        u = values[family.parameters.index("level")]
        return scaled_characteristic(model, roots, [u * (q * q + 1)], 1 - u)[0]
    kappa = q * q * 2 / field.pi
    if "mass" in family.parameters:
        kappa = kappa * values[family.parameters.index("mass")]
    return scaled_characteristic(model, roots, [kappa])[0]


def _by_slopes(
    families: Sequence[Family], owner: Any, field: DiscField, boxes: Region, over: tuple[Any, Any, Any, Any]
) -> tuple[Any, Any]:
    """The mean value theorem: the value at the middle, and the slopes over the box."""
    middles, reaches = _middles(boxes)
    value, known = _at_middle(families, owner, field, middles)
    slopes = _slopes(families[0], *over)
    nought = np.zeros(len(boxes))
    spans = [slope * Discs(nought, h) for slope, h in zip(slopes, reaches, strict=True)]
    free = known & sum(spans, value).nonzero()
    if "level" in families[0].parameters:
        # the function is real at q = 0: its imaginary part is q times the slope's, which must not vanish for q > 0
        free |= (boxes[:, 0] == 0) & (np.abs(slopes[0].m.imag) > slopes[0].r)
    # slopes of wide boxes mislead: no box becomes a sliver, more than 8 times as wide along one axis as another
    widths = np.stack([reaches[0] / (1 + boxes[:, 0]), *reaches[1:]])
    gains = np.stack([span.r for span in spans])
    with np.errstate(invalid="ignore"):
        slim = widths * 8 < widths.max(axis=0)
        axis = np.argmax(np.where(slim, -1.0, gains), axis=0)
    return free, axis


def _at_middle(families: Sequence[Family], owner: Any, field: DiscField, middles: list[Any]) -> tuple[Discs, Any]:
    """The value at points, and where it is known."""
    x, values = middles[0], [Discs(t) for t in middles[1:]]
    q = _frequencies(families, owner, field, x, 0 * x)
    model = _models(families, owner, field, values)
    found = root_discs(model, q)
    return _value(families[0], field, model, found.roots, q, values), found.known


def _slopes(family: Family, model: Track, z: SplitRoots, q: Discs, values: Sequence[Discs]) -> list[Discs]:
    """The derivatives along x and the parameters over boxes whose p-roots z are apart."""
    motions = [ALONG_Q, *family.motions(len(model.eta_m))]
    order = range(len(motions))
    rates = root_slopes(model, z, q, motions)
    dual = SplitRoots(*(Dual(p, s) for p, s in zip((z.a, z.b, z.c, z.e), rates, strict=True)))
    still = (0,) * len(model.eta_m)
    steps = zip(*(motion.positions or still for motion in motions), strict=True)
    positions = tuple(Dual(p, step) for p, step in zip(model.positions, steps, strict=True))
    field = DualField()
    moving = replace(model, field=field, positions=positions)
    arguments = [Dual(v, [int(j == k) for j in order]) for k, v in enumerate([q, *values])]
    slopes: list[Discs] = _value(family, field, moving, dual, arguments[0], arguments[1:]).slopes
    return slopes


def local(family: Family, centre: Sequence[float], reaches: Any) -> tuple[Any, list[Any], Any]:
    """For the boxes centre ± reach (x, then the parameters): value at the middle, slopes over the box, where valid.

    Of the family's function times R, which has the same zeros.
    """
    field, count, owner = DiscField(), len(reaches), np.zeros(len(reaches), dtype=int)
    middles, reaches = [np.full(count, v) for v in centre], np.asarray(reaches) * _OUT
    values = [Discs(t, reaches) for t in middles[1:]]
    q = _frequencies([family], owner, field, middles[0], reaches)
    model = _models([family], owner, field, values)
    with np.errstate(all="ignore"):
        found = root_discs(model, q)
        value, known = _at_middle([family], owner, field, middles)
        slopes = _slopes(family, model, found.roots, q, values)
    good = found.apart & known & np.logical_and.reduce([np.isfinite(slope.r) for slope in slopes])
    return value, slopes, good
