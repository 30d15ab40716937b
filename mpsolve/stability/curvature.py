"""How a root moves with the distance: q'(d) and q''(d) on a branch of induced frequencies, in balls and in discs."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import flint
import numpy as np

from mpsolve.discs import DiscField, Discs, DualField
from mpsolve.dual import Dual
from mpsolve.errors import PrecisionError
from mpsolve.fields import Ball, laplace_det
from mpsolve.model.boxes import root_discs
from mpsolve.model.branch import Track, pairing
from mpsolve.model.scaled import SplitRoots, scaled_characteristic
from mpsolve.stability.exclude import arrays
from mpsolve.stability.family import Family

acb, arb = flint.acb, flint.arb


class NestedBalls:
    """Dual numbers of dual numbers over balls: second derivatives in q and the unit of distance."""

    i = acb(0, 1)
    det = staticmethod(laplace_det)

    def __init__(self) -> None:
        self.pi = arb.pi()

    def one_minus_exp(self, z: Any, x: Any) -> Any:
        return (1 - (z * x * self.i).exp()) / z

    def nearest_pair_first(self, z: Any) -> Any:
        return z

    def choose(self, _: Any, apart: Any, _bordered: Any) -> Any:
        return apart()


def motion_with_distance(track: Track, q: Any, d: Any) -> tuple[Any, Any]:
    """q'(d) and q''(d) of the root of Δ in the ball q, masses at 0, d, 2d, …: enclosures for every root and d there.

    By implicit differentiation of F = R·Δ, which has the same roots. Raises `PrecisionError`.
    """
    roots = split_balls(track, q)
    first, second = _implicit(second_order(track, NestedBalls(), roots, [acb(q), acb(d)], acb(1)))
    if not (first.is_finite() and second.is_finite()):
        raise PrecisionError("the slope of Δ may vanish on the ball of a root: split it")
    return first, second


def split_balls(track: Track, q: Any) -> SplitRoots:
    """The four p-roots in balls. Raises `PrecisionError`."""
    pair = pairing(track, q)
    field: Ball = track.field
    over, under = field.sqrt(pair.discriminant(1)), field.sqrt(pair.discriminant(-1))
    half = pair.s / 2
    return SplitRoots(half + over, half - over, -half + under, -half - under)


def _implicit(F: Any) -> tuple[Any, Any]:
    """q' = −F_d/F_q and q'' = −(F_dd + 2 F_qd q' + F_qq q'²)/F_q."""
    value, (f_q, f_d) = F.value, F.slopes
    first = -(value.slopes[1] / value.slopes[0])
    return first, -((f_d.slopes[1] + f_q.slopes[1] * first * 2 + f_q.slopes[0] * first * first) / value.slopes[0])


def second_order(track: Track, field: Any, z: SplitRoots, arguments: Sequence[Any], one: Any) -> Any:
    """F = R·Δ as a dual number of dual numbers in q, d and, if it is given, t, by which all masses are multiplied.

    `one` is 1 in the arithmetic.
    """
    q, d, *mass = [_variable(value, k, len(arguments), one) for k, value in enumerate(arguments)]
    r, none = arguments[0] - track.field.i * track.eta_b, one * 0
    roots = [_root(track, p, r, none, len(arguments)) for p in (z.a, z.b, z.c, z.e)]
    places = tuple(d * k for k in range(len(track.eta_m)))
    moving = Track(field, track.alpha, track.axial, track.eta_b, track.eta_m, places, track.cuts_on_line)
    kappa = q * q * 2 / field.pi
    return scaled_characteristic(moving, SplitRoots(*roots), [kappa * mass[0] if mass else kappa])[0]


def _variable(value: Any, number: int, count: int, one: Any) -> Dual:
    none, order = one * 0, range(count)
    units = [one if k == number else none for k in order]
    return Dual(Dual(value, units), [Dual(unit, [none] * count) for unit in units])


def _root(track: Track, p: Any, r: Any, none: Any, count: int) -> Dual:
    """p(q) with p_q = −D_q/D_p and p_qq = −(D_qq + 2 D_pq p_q + D_pp p_q²)/D_p."""
    slope = (p * p - track.A * 2) * p * 4 + track.alpha * r * 8
    first = (track.alpha * p - r) * -8 / slope
    second = -((track.alpha * first * 16 - 8 + (p * p * 12 - track.A * 8) * first * first) / slope)
    rest = [none] * (count - 1)
    return Dual(Dual(p, [first, *rest]), [Dual(first, [second, *rest]), *(Dual(none, [none, *rest]) for _ in rest)])


def convex_branch(family: Family, edges: Any, roots: Any) -> bool:
    """Whether one branch of roots is proved to pass next to `roots` at the distances `edges`, with Im q'' > 0.

    Between neighbouring edges a tube, a disc that holds exactly one root for every distance of the piece, is
    proved by interval Newton; the roots at the edges lie in the tubes on both sides.
    """
    d, half = (edges[1:] + edges[:-1]) / 2, np.abs(np.diff(edges)) / 2 * (1 + 2.0**-50)
    middle = (roots[1:] + roots[:-1]) / 2
    reach = 2 * np.abs(np.diff(roots)) + half / 8 + 1e-12
    pieces = _Tubes(family, Discs(d, half), middle, reach)
    ends = _Tubes(family, Discs(edges), roots, np.full(len(roots), 1e-11))
    gaps = [np.abs(ends.image.m[k:][: len(d)] - middle) + ends.image.r[k:][: len(d)] for k in (0, 1)]
    joined = np.all(gaps[0] < reach) and np.all(gaps[1] < reach)
    curvature = pieces.curvature()
    return bool(joined and pieces.proved.all() and ends.proved.all() and np.all(curvature.m.imag > curvature.r))


class _Tubes:
    """Discs of radius `reach` about `middle`; each that is `proved` holds one root for every d of its ball."""

    def __init__(self, family: Family, d: Discs, middle: Any, reach: Any) -> None:
        field = DiscField()
        self.family, self.d, self.q = family, d, Discs(middle, reach)
        self.model = arrays(family.at(field, d), len(middle))
        with np.errstate(all="ignore"):
            still, over = root_discs(self.model, Discs(middle)), root_discs(self.model, self.q)
            kappa = Discs(middle) * Discs(middle) * 2 / field.pi
            at = arrays(family.at(field, Discs(d.m)), len(middle))
            value = scaled_characteristic(at, still.roots, [kappa])[0]
            one = Discs(np.ones_like(middle))
            self.second = second_order(self.model, DualField(), over.roots, [self.q, d], one)
            along_q, along_d = self.second.value.slopes
            step = (value + along_d * Discs(np.zeros_like(middle), d.r)) / along_q
            self.image = Discs(middle) - step
            self.proved = still.known & over.apart & (step.upper < reach)

    def curvature(self) -> Discs:
        with np.errstate(all="ignore"):
            second: Discs = _implicit(self.second)[1]
            return second
