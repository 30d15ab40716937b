"""Strings on which nothing grows, whatever passive vehicles run there, at all velocities but that of the waves.

With s = σ − vP the p-roots of T P² = m s² + c s + k part by the root of

    (T − m v²)P² + v(2mσ + c)P − (mσ² + cσ + k),    G(0) = 1/√disc,
    disc = 4T(mσ² + cσ + k) + v²(c² − 4mk) = 4Tm (σ + a)(σ + b),    a + b = c/m,  ab = (k/m)(1 − w) + w(c/2m)²,

w = mv²/T. *Slower than the waves* (w < 1) a and b are conjugates or real, with Re a, Re b ≥ 0. For Re σ > 0, Im σ ≥ 0
the argument of √((σ + a)(σ + b)) lies between 0 and that of σ: Im (σ + a)(σ + b) = (Im σ)(2 Re σ + c/m) ≥ 0, and
(σ + a)(σ + b)/σ² = 1 + (c/m)/σ + ab/σ² has an argument between −2 arg σ and 0. So Re σG(0) > 0 in Re σ > 0, and no
passive vehicle with one contact has a root there (SPEC2, section 5).

*Faster* (w > 1) both p-roots belong to the waves behind: G(ξ) = 0 for ξ ≥ 0. Where each vehicle touches the string at
one place and no two are joined, the forces of the rear contacts do not reach those ahead: Δ̃ is the product of the
vehicles' own determinants on a rail that does not move, and passive vehicles have no root in Re σ > 0. (Those without
dampers vibrate on there: real q, at all velocities.)

*Several contacts, slower.* Let σ = iq, q > 0, β = c/2m, z = (σ + a)(σ + b), φ = arg σ/√z, so that 0 ≤ φ < π/2. With
g = (q − ab/q)/2β, which grows with q, tan φ = √(1 + g²) − g. And σG = e^{iφ}|σ/√disc| (1 + A + B): on one side of the
diagonal A has the entries e^{Pξ}, ξ = x_i − x_j, of waves ahead, of modulus < 1, on the other B those behind, with

    P = (√(Tm)·2√z − 2mvσ − vc)/2(T − mv²),    Re P ≥ κ := c/(2√m(√T + v√m)),  if 4km ≥ c²,  else the less of that
                                                                                 and k√m/(√T c).

Indeed let ρ = Re √z > 0: 2ρ Im √z = 2βq and (Im √z)² = q² − ab + ρ², so ρ² ≥ ab or Im √z < q, ρ > β. If ρ ≥ β then
2(T − mv²) Re P ≥ 2β√m(√T − v√m). Else ρ² ≥ ab = (k/m)(1 − w) + wβ², ab < β², so k/m < β², and √(Tm)√w = mv gives
(T − mv²) Re P ≥ √(Tm)(√(ab) − √w β) = √(Tm)(k/m)(1 − w)/(√(ab) + √w β), over T(1 − w) at least k√m/(√T c). ∎

Let b = e^{−κδ}, δ the least gap. For two contacts the Hermitian part of e^{iφ}(1 + A + B) is > 0 if 1 + b ≤ 2 cos φ.
For N it is (cos φ/2)(1 + A + A* + 1 + B + B*) + (i sin φ/2)(A − A* + B − B*). The first two are covariances of waves
that decay, 1 + A + A* > 0 and 1 + B + B* ≥ (1 − b)/(1 + b), as rows of its tridiagonal inverse add up to at most
(1 + b)/(1 − b); and ‖A − A*‖, ‖B − B*‖ ≤ N − 1, by rows. So 2(N − 1) tan φ ≤ (1 − b)/(1 + b) suffices. All is passive
from some frequency on, the same up to the very speed of the waves; and φ → 0 in Re σ ≥ 0 as |σ| → ∞, so that roots
there are bounded.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from itertools import pairwise, product

from mpsolve.numbers.balls import arb, greatest, least, precision, rational_ball
from mpsolve.numbers.jets import UP
from mpsolve.problem.family import Family, Interval
from mpsolve.problem.problem import Problem
from mpsolve.tracks.string import String

SLOWER = "slower than its waves a string takes up power from one contact at all frequencies: no boxes are needed"
FASTER = (
    "faster than its waves a string carries none ahead, so that single contacts do not feel it: no boxes are needed"
)


def quiet(problem: Problem, over: Mapping[str, Interval], side: int | None = None) -> str | None:
    """Why nothing grows at any point of the ranges; None where the theorem does not tell.

    side: −1 where all velocities are known to be slower than the waves, 1 where faster; None: they are compared.
    """
    track = problem.track
    if not isinstance(track, String) or not _ends(problem, over, "track.c")[0] > 0:
        return None
    if side is None:
        T, m, v = (_ends(problem, over, path) for path in ("track.T", "track.m", "v"))
        if None in (*T, *m, *v):  # without an upper end
            return None
        side = -1 if v[1] ** 2 * m[1] < T[0] else 1 if v[0] ** 2 * m[0] > T[1] and v[0] > 0 else 0
    contacts = [placed.vehicle.pencil.contacts for placed in problem.vehicles]
    if side < 0 and sum(contacts) == 1:
        return SLOWER
    return FASTER if side > 0 and max(contacts) == 1 else None


def passive_beyond(family: Family, up_to_waves: bool = False) -> float | None:
    """A scaled frequency beyond which several contacts are passive for all parameters, all slower than the waves.

    up_to_waves: the range may go on beyond their speed, and nothing is said of what is faster.
    """
    told = [*family.D_rest.values(), family.v]
    few = all(len(one.terms) <= 1 for one in told) and all(max(e) <= 1 for x in family.places for e, _ in x)
    count = len(family.places)
    if not isinstance(family.problem.track, String) or count < 2 or not few:
        return None
    with precision(64):
        each = [_at_corner(family, x, up_to_waves) for x in product(*family.box)]
        known = [one for one in each if one is not None]
        if len(known) < len(each):
            return None
        beta, ab, decay = zip(*known, strict=True)
        less = 1 - (-least(decay)).exp()  # 1 − b
        cos = 1 - less / 2
        t = (1 - cos * cos).sqrt() / cos if count == 2 else less / (2 - less) / (2 * (count - 1))
        if not t > 0:
            return None
        g = (1 / t - t) / 2
        first, last = greatest(beta) * arb.max(g, arb(0)), greatest(ab)
        q = first + (first * first + last).sqrt()
        return float(q.upper()) * UP


def _at_corner(family: Family, x: tuple[Fraction, ...], up_to_waves: bool) -> tuple[arb, arb, arb] | None:
    """(c/2m, what ab is at most, what κδ is at least) at a corner; None if it is faster, or waves may not decay."""
    T, m, c, k = (
        abs(family.D_rest[key].at(x)) if key in family.D_rest else Fraction(0)
        for key in ((2, 0), (0, 2), (0, 1), (0, 0))
    )
    v, places = abs(family.v.at(x)), [one.at(x) for one in family.places]
    gap = min(b - a for a, b in pairwise(places))
    slower, light = m * v * v < T, c * c <= 4 * k * m
    if not (c > 0 and gap > 0 and (slower or up_to_waves) and (light or k > 0)):
        return None
    root_T, root_m = rational_ball(T).sqrt(), rational_ball(m).sqrt()
    decay = rational_ball(c) / (2 * root_m * (root_T + (rational_ball(v) * root_m if slower else root_T)))
    if not light:
        decay = least([decay, rational_ball(k / c) * root_m / root_T])
    beta = c / (2 * m)
    return rational_ball(beta), rational_ball(k / m + beta * beta), decay * rational_ball(gap)


def _ends(problem: Problem, over: Mapping[str, Interval], path: str) -> tuple[Fraction, Fraction]:
    own = problem.parameters[path]
    return over.get(path, (own, own))
