"""No zero in a region [x] × [t] outside of given holes: subdivision in rigorous float64, many boxes at once."""

from __future__ import annotations

import itertools
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from mpsolve.discs import DiscField, Discs, DualField
from mpsolve.dual import Dual
from mpsolve.model.boxes import part, root_discs, root_slopes
from mpsolve.model.branch import ALONG_Q, Track
from mpsolve.model.scaled import SplitRoots, scaled_characteristic
from mpsolve.stability.family import Family

_CHUNK = 8192
_SMALL = 2.0**-9  # boxes of this width in t are looked at one by one
_OUT = 1 + 2.0**-50  # half-widths of boxes are rounded outward

Region = Any  # float64 array of shape (n, 4): x from, x to, t from, t to


@dataclass(frozen=True)
class Cover:
    """What subdivision left over, as boxes, and the number of boxes that were looked at."""

    open: Region
    evaluations: int


def exclude(
    family: Family, region: Region, holes: Region, few: int = 160, levels: int = 64, budget: int = 3_000_000
) -> Cover:
    """Subdivides `region` until each box is proved to hold no zero or lies in a hole, or `few` boxes are left.

    The few are those that surround a zero, or a point where the formulas lose their grip: balls deal with them.
    Stops with what is open after so many levels, or when the budget of boxes is spent.
    """
    arithmetic, evaluations = DiscField(), 0
    boxes = np.asarray(region, dtype=float).reshape(-1, 4)
    for level in range(levels):
        if evaluations > budget or len(boxes) <= (few if level else 0) or (few and _small(boxes)):
            break
        evaluations += len(boxes)
        halves = []
        for start in range(0, len(boxes), _CHUNK):
            chunk = boxes[start : start + _CHUNK]
            free, across = _tested(family, arithmetic, chunk)
            keep = ~(free | inside(chunk, holes))
            halves.append(_halved(chunk[keep], across[keep]))
        boxes = np.concatenate(halves)
    return Cover(boxes, evaluations)


def _small(boxes: Region) -> bool:
    return bool(np.max(boxes[:, 3] - boxes[:, 2], initial=0) < _SMALL)


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
    for x0, x1, t0, t1 in holes:
        found |= (boxes[:, 0] >= x0) & (boxes[:, 1] <= x1) & (boxes[:, 2] >= t0) & (boxes[:, 3] <= t1)
    return found


def _halved(boxes: Region, across: Any) -> Region:
    """Both halves of each box, along x where `across`, else along t."""
    x0, x1, t0, t1 = boxes.T
    with np.errstate(all="ignore"):
        x = np.where(x0 > 1, np.sqrt(x0 * x1), np.where(x1 > 4, 2.0, (x0 + x1) / 2))
    t = (t0 + t1) / 2
    first = np.stack([x0, np.where(across, x, x1), t0, np.where(across, t1, t)], axis=1)
    second = np.stack([np.where(across, x, x0), x1, np.where(across, t0, t), t1], axis=1)
    return np.concatenate([first, second])


def _tested(family: Family, field: DiscField, boxes: Region) -> tuple[Any, Any]:
    """(proved to hold no zero, whether to halve along x) of each box."""
    x0, x1, t0, t1 = boxes.T
    x, t = (x0 + x1) / 2, (t0 + t1) / 2
    dx, dt = np.maximum(x1 - x, x - x0) * _OUT, np.maximum(t1 - t, t - t0) * _OUT
    across = (x1 - x0) / (1 + x0) > t1 - t0
    height = field.number(family.height)
    q = Discs(x + 1j * height.m, dx + height.r)
    model = arrays(family.at(field, Discs(t, dt)), len(boxes))
    with np.errstate(all="ignore"):
        found = root_discs(model, q)
        value = _value(family, field, model, found.roots, q, Discs(t, dt))
        free = found.known & value.nonzero()
        if len(model.eta_m) == 2 and not family.height:
            free |= found.apart & _outweighed(model, found.roots)
        more = found.apart & ~free
        if more.any():
            free[more], across[more] = _by_slopes(family, field, boxes[more], part(model, more), found.roots, more, q)
    return free, across


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


def _value(family: Family, field: Any, model: Track, roots: SplitRoots, q: Any, t: Any) -> Any:
    if family.parameter == "level":
        return scaled_characteristic(model, roots, [t * (q * q + 1)], 1 - t)[0]
    return scaled_characteristic(model, roots, [q * q * 2 / field.pi])[0]


def _by_slopes(
    family: Family, field: DiscField, boxes: Region, model: Track, roots: SplitRoots, keep: Any, q: Discs
) -> tuple[Any, Any]:
    """The mean value theorem: the value at the middle, and the slopes over the box."""
    z = SplitRoots(*(p[keep] for p in (roots.a, roots.b, roots.c, roots.e)))
    x0, x1, t0, t1 = boxes.T
    x, t = (x0 + x1) / 2, (t0 + t1) / 2
    dx, dt = np.maximum(x1 - x, x - x0) * _OUT, np.maximum(t1 - t, t - t0) * _OUT
    value, known = _at_middle(family, field, x, t)
    slopes = _slopes(family, model, z, q[keep], Discs(t, dt))
    spans = [slope * Discs(np.zeros(len(boxes)), h) for slope, h in zip(slopes, (dx, dt), strict=True)]
    free = known & (value + spans[0] + spans[1]).nonzero()
    if family.parameter == "level":
        # the function is real at q = 0: its imaginary part is q times the slope's, which must not vanish for q > 0
        free |= (x0 == 0) & (np.abs(slopes[0].m.imag) > slopes[0].r)
    with np.errstate(invalid="ignore"):
        ratio = dx / (1 + x0) / dt  # slopes of wide boxes mislead: no box becomes a sliver
        across = np.where(ratio > 8, True, np.where(ratio < 1 / 8, False, spans[0].r > spans[1].r))
    return free, across


def _at_middle(family: Family, field: DiscField, x: Any, t: Any) -> tuple[Discs, Any]:
    """The value at points, and where it is known."""
    height = field.number(family.height)
    q = Discs(x + 1j * height.m, height.r + 0 * x)
    model = arrays(family.at(field, Discs(t)), len(x))
    found = root_discs(model, q)
    return _value(family, field, model, found.roots, q, Discs(t)), found.known


def _slopes(family: Family, model: Track, z: SplitRoots, q: Discs, t: Discs) -> tuple[Discs, Discs]:
    """The derivatives along x and t over boxes whose p-roots z are apart."""
    motion = family.motion(len(model.eta_m))
    rates = root_slopes(model, z, q, (ALONG_Q, motion))
    dual = SplitRoots(*(Dual(p, s) for p, s in zip((z.a, z.b, z.c, z.e), rates, strict=True)))
    steps = motion.positions or (0,) * len(model.eta_m)
    positions = tuple(Dual(p, [0, step]) for p, step in zip(model.positions, steps, strict=True))
    field = DualField()
    moving = replace(model, field=field, positions=positions)
    along_x, along_t = _value(family, field, moving, dual, Dual(q, [1, 0]), Dual(t, [0, 1])).slopes
    return along_x, along_t


def local(family: Family, x: float, t: float, reaches: Any) -> tuple[Any, Any, Any, Any]:
    """For the boxes x ± reach, t ± reach: value at the middle, slopes along x and t over the box, and where valid.

    Of the family's function times R, which has the same zeros.
    """
    field, count = DiscField(), len(reaches)
    xs, ts, reaches = np.full(count, x), np.full(count, t), np.asarray(reaches) * _OUT
    height = field.number(family.height)
    q, over = Discs(xs + 1j * height.m, reaches + height.r), Discs(ts, reaches)
    model = arrays(family.at(field, over), count)
    with np.errstate(all="ignore"):
        found = root_discs(model, q)
        value, known = _at_middle(family, field, xs, ts)
        along_x, along_t = _slopes(family, model, found.roots, q, over)
    good = found.apart & known & np.isfinite(along_x.r) & np.isfinite(along_t.r)
    return value, along_x, along_t, good
