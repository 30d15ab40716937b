"""One mass, faster than the waves of an undamped beam: as many roots grow at all such velocities and masses.

EI, m, k > 0, T = kp − N, W(p) = (EI p⁴ + T p² + k)/m > 0, w = √W. Supposed for all p ≠ 0:

    2 W W″ > W′²,    W″ > 0,    W″² W > v² W′²,

so that w is strictly convex. Let h(p) = v p + w(p): it falls to its least value −b and rises from there, and b > 0
where the cuts have joined. As a limit from Im q < 0, 1/(x − i0) having the imaginary part π δ(x), D = m(W − Ω²) gives

    −Im G(0, q) = ½ Σ sgn Ω/|D_p| = ½ (S(q) − S(−q)),    S(x) = Σ_{h(p) = x} 1/(2 m w |h′|),

the first sum over the real p-roots: those with Ω = w have h(p) = q, those with Ω = −w have h(−p) = −q. As w h′ =
v w + W′/2 has the slope v W′/2w + W″/2 > 0, w |h′| grows with h on either side of the least point. So S falls all the
way from x = −b, before which it is 0. **Hence −Im G(0, q) < 0 for 0 < q < b, and > 0 for q > b.**

Let the vehicle be one mass M > 0 with one contact, of compliance 1/k ≥ 0: Δ̃ = 1 − q²M(G + 1/k), up to a factor.
Where the parameters change within these premises, no root comes to the real axis from Im q < 0. To q = 0: there the
p-roots are real and apart, G is bounded and Δ̃ → 1. To another q ≠ ±b: G is continuous and Im Δ̃ ≠ 0 (q < 0 is the
mirror). To ±b: there two p-roots meet, one of U and one of L (beyond b they are conjugates), twice only since h is
strictly convex, and apart from the others: |G| → ∞, and Δ̃ with it. Nor does one come from infinity: all have |q|² ≤
e² (SPEC2, 8.2), continuous in the parameters. By Hurwitz's theorem their number is the same for all velocities above
that at which the cuts join (b > 0), all M > 0 and all contact springs. It tells the crossings of a range over which a
beam has no damping; else they stay open.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from itertools import product
from time import process_time
from typing import TYPE_CHECKING, Any

from flint import fmpq_poly

from mpsolve.errors import InputError
from mpsolve.numbers.balls import arb, precision
from mpsolve.numbers.decimals import working_bits
from mpsolve.numbers.realroots import as_fmpq, end_of, is_positive, negative_point, short_between
from mpsolve.outcome import Status
from mpsolve.problem.problem import Problem
from mpsolve.progress import Progress
from mpsolve.proof.effort import Effort
from mpsolve.ranges import undamped
from mpsolve.ranges.answer import Interval, Spent
from mpsolve.ranges.base import base_at, growing, uncounted
from mpsolve.ranges.crossed import Crossing, Crossings
from mpsolve.ranges.undamped import SPEEDS, at_corner, cuts_join, no_damping, of_vehicles, passive_at

if TYPE_CHECKING:
    from mpsolve.tracks.euler_bernoulli import EulerBernoulli

NOTE = (
    "under one mass that is faster than the waves of an undamped beam no root comes to the real axis: no boxes are "
    "needed, and as many grow as at a certified point"
)


@dataclass(frozen=True)
class Faster:
    """A part of a range over which the number of growing roots is the same.

    joins: the velocity at which the part begins, a ball, where it begins inside the range, which is stable up to
    there; None where the part is all of the range. low, high: ends of the part, as exact numbers inside of it.
    """

    joins: arb | None
    low: Fraction
    high: Fraction


def faster(problem: Problem, over: Mapping[str, Interval]) -> Faster | None:
    """The part of a range of velocities, or of something of the vehicle, of which the theorem tells; else None.

    The range is one that goes beyond the velocity at which the cuts join, by `undamped.never_unstable`.
    """
    ((path, (low, high)),) = over.items()
    top = max(2 * low, Fraction(1)) if high is None else high
    if not no_damping(problem, over) or not _of_one_mass(problem, {path: (low, top)}):
        return None
    if _joined(problem.track, problem.changed(path, low).v):
        return Faster(None, low, top)
    if path not in SPEEDS or high is None or not passive_at(problem, {path: low}):
        return None
    joins = cuts_join(problem, path)
    above = end_of(joins, 1)
    return Faster(joins, above, high) if end_of(joins, -1) > low and above < high else None


def alike(problem: Problem, over: Mapping[str, Interval]) -> bool:
    """Whether the theorem tells that the same number of roots grows at all points of the ranges."""
    if not (no_damping(problem, over) and _of_one_mass(problem, over)):
        return False
    slowest = at_corner(problem, {path: low for path, (low, _) in over.items()})
    return _joined(slowest.track, slowest.v)


def _of_one_mass(problem: Problem, over: Mapping[str, Interval]) -> bool:
    """The premises but for b > 0: one mass throughout, as masses are linear in each parameter."""
    if not all((path in SPEEDS or of_vehicles(path)) and ends[0] >= 0 for path, ends in over.items()):
        return False
    corners = [dict(zip(over, corner, strict=True)) for corner in product(*over.values())]
    fastest = at_corner(problem, {path: high for path, (_, high) in over.items()})
    return all(_one_mass(problem, point) for point in corners) and _convex(fastest.track, fastest.v)


def _one_mass(problem: Problem, point: Mapping[str, Fraction]) -> bool:
    try:
        each = [placed.vehicle.pencil for placed in at_corner(problem, point).vehicles]
    except InputError:
        return False
    if len(each) != 1 or each[0].size != 1 or each[0].contacts != 1:
        return False
    (one,) = each
    return one.M[0][0] > 0 and not one.C[0][0] and not one.K[0][0] and one.B[0][0] != 0


def _polynomials(beam: EulerBernoulli) -> tuple[fmpq_poly, fmpq_poly, fmpq_poly]:
    """m times W, W″ and dW/dy, in y = p²; W′² = 4 y (dW/dy)²."""
    EI, T, k = (as_fmpq(x) for x in (beam.EI, beam.kp - beam.N, beam.k))
    return fmpq_poly([k, T, EI]), fmpq_poly([2 * T, 12 * EI]), fmpq_poly([T, 2 * EI])


def _convex(beam: Any, v: Fraction) -> bool:
    """The premises, for all velocities up to v."""
    W, bend, slope = _polynomials(beam)
    square = 4 * fmpq_poly([0, 1]) * slope**2
    return all(map(_positive, (2 * W * bend - square, bend, bend**2 * W - as_fmpq(v * v * beam.m) * square)))


def _positive(f: fmpq_poly) -> bool:
    """f > 0 for all y > 0."""
    lowest = next((n for n, c in enumerate(f.coeffs()) if c != 0), None)
    return lowest is not None and is_positive(fmpq_poly(f.coeffs()[lowest:]))


def _joined(beam: Any, v: Fraction) -> bool:
    """Whether W < v² y for some y: b > 0."""
    W, _, _ = _polynomials(beam)
    return negative_point(W - fmpq_poly([0, as_fmpq(v * v * beam.m)])) is not None


def without_damping(
    problem: Problem,
    over: Mapping[str, Interval],
    digits: int,
    effort: Effort | None,
    progress: Progress,
    check: bool,
) -> Crossings:
    """`crossings` of checked arguments, where `undamped.no_damping` and something may grow."""
    started = process_time()
    part = faster(problem, over)
    if part is None:
        return Crossings(problem, over, Status.UNDECIDED, *undamped.left_open(problem, over), digits=digits)
    progress("base", 0.0)
    path, at = next(iter(over)), short_between(part.low, part.high)
    base = base_at(problem.changed(path, at), effort, check)
    number = growing(base)
    cost = Spent.since(started, base)
    if number is None:
        why = uncounted(base, f"at {path} = {float(at):.6g}")
        return Crossings(problem, over, Status.UNDECIDED, why, digits=digits, cost=cost)
    if part.joins is None or not number:
        return Crossings(problem, over, Status.UNVERIFIED, digits=digits, counts=(number,), note=NOTE, cost=cost)
    with precision(working_bits(digits)):
        first = Crossing(undamped.cuts_join(problem, path), arb(0), number)
    known: dict[str, Any] = {"crossings": (first,), "counts": (0, number), "note": NOTE}
    return Crossings(problem, over, Status.UNVERIFIED, digits=digits, cost=cost, **known)
