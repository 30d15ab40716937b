"""Every crossing of the real axis in a range of one parameter, proved complete, and the counts between."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import accumulate, pairwise
from time import process_time
from typing import Any

from mpsolve.certificate.solve import checked_digits
from mpsolve.numbers.balls import precision, rational_ball
from mpsolve.numbers.packed import exact_ends
from mpsolve.numbers.realroots import short_between
from mpsolve.outcome import Reason, Status
from mpsolve.parallel.threads import one_thread
from mpsolve.problem.cases import Given, as_problem
from mpsolve.problem.problem import Problem
from mpsolve.progress import Progress, silent
from mpsolve.proof.effort import Effort, begun
from mpsolve.proof.stopping import stoppable
from mpsolve.ranges.answer import Interval, Proof, Spent, within
from mpsolve.ranges.base import base_at, growing, uncounted
from mpsolve.ranges.certified import Base, crossings_certificate, verified, with_room
from mpsolve.ranges.crossed import Crossing, Crossings, speeds_within
from mpsolve.ranges.enclosed import Crossing as Scaled
from mpsolve.ranges.lone_mass import without_damping
from mpsolve.ranges.never import never_unstable
from mpsolve.ranges.parted import COMPLETE, parted, speeds_above
from mpsolve.ranges.scope import OpenError, Scope, checked_over, from_above_rest, one_path, scope_of
from mpsolve.ranges.search import Search
from mpsolve.ranges.undamped import no_damping
from mpsolve.ranges.without_end import endless, require_mass

_BOXES = 400_000  # that an answer may take unless effort says otherwise
_REACH, _IN_REACH = 8.0, 20_000
"""Scaled: up to which frequency crossings are listed where none bounds them, and boxes for that."""
_ROOM = Fraction(1, 1024)  # of a range: where roots are counted there is so much to the next crossing, if anywhere


def crossings(
    problem: Given,
    *,
    over: Mapping[str, Any],
    digits: int = 15,
    effort: Effort | None = None,
    progress: Progress | None = None,
    check: bool = True,
) -> Crossings:
    """Every value of one parameter in a closed range at which a root crosses the real axis, to `digits` digits.

    At these the number of growing roots changes. Nothing is said of real roots that do not cross it: all over the
    range on a beam without damping, or of motions that no contact feels through the track, as those of undamped
    bodies against each other over one place.

    over: {path: (low, high)}, in the problem's units; a factor of all masses may have the high None: without end.
    The answer is proved where the list is complete and the numbers of unstable roots between its entries are known;
    else `Status.UNDECIDED` with a reason, and what was found. Faster than short waves of the track nothing may bound
    the frequencies at which roots cross: then all crossings up to one are listed, which `known` says.
    check: have the standalone verifier pass the certificate of the whole answer; without it the answer has none.
    Raises InputError for a path that there is not and for ranges that cannot be.
    """
    given = as_problem(problem)
    ranges = checked_over(problem, over, endless=True)
    one_path(ranges)
    with one_thread():
        found = find(given, ranges, checked_digits(digits), effort, progress or silent, check)
    return replace(found, problem=problem)


def find(
    problem: Problem,
    over: Mapping[str, Interval],
    digits: int,
    effort: Effort | None,
    progress: Progress,
    check: bool,
    near: Sequence[tuple[float, float]] = (),
) -> Crossings:
    """`crossings` of checked arguments; the upper end may be None.

    near: points (q, value) at which crossings are expected: they are enclosed first, which saves boxes.
    """

    def none(ranges: Mapping[str, Interval], why: str) -> Crossings:
        return Crossings(problem, ranges, Status.UNVERIFIED, digits=digits, counts=(0,), note=why)

    def inside(ranges: Mapping[str, Interval], rest: Effort | None) -> Crossings:
        return _within(problem, ranges, digits, rest, progress, check, near)

    def left_open(why: Reason) -> Crossings:
        return Crossings(problem, over, Status.UNDECIDED, why, digits=digits)

    found: Crossings
    why = never_unstable(problem, over)
    if why is not None:
        return none(over, why)
    ((path, (_, high)),) = over.items()
    if high is None:
        require_mass(path)
    if no_damping(problem, over):
        return without_damping(problem, over, digits, effort, progress, check)
    if high is None:
        budget = begun(effort, _BOXES)
        found = endless(problem, over, lambda ranges: inside(ranges, budget), left_open, budget, progress)
        return found
    speeds = speeds_within(problem, over)
    if not speeds:
        found = inside(over, effort)
        open_ended = found.reason is not None and found.reason.code == "passivity"
        speeds = speeds_above(problem, over) if open_ended else []
        if not speeds:
            return found
    found = parted(problem, over, speeds, inside, none, effort)
    return found


@stoppable
def _within(
    problem: Problem,
    over: Mapping[str, Interval],
    digits: int,
    effort: Effort | None,
    progress: Progress,
    check: bool,
    near: Sequence[tuple[float, float]] = (),
) -> Crossings:
    started = process_time()
    budget = begun(effort, _BOXES)
    over = from_above_rest(problem, over)
    scope, unbounded = scope_of(problem, over), None
    try:
        X = scope.X
    except OpenError as error:
        X, unbounded, budget = _REACH, error.reason, budget.share(min(_IN_REACH, budget.evaluations or _IN_REACH))
        scope = replace(scope, reach=X)
    search = Search(scope, digits)
    q_unit, unit = float(scope.family.frequency_unit), float(scope.family.units[0])
    search.enclose_near([(q / q_unit, x / unit) for q, x in near])
    cover = search.cover(budget, progress, check)
    family = scope.family
    proof = Proof(over, family.units, family.frequency_unit, X, cover, tuple(search.judge.known))
    reason, inside = cover.reason, []
    zeros = [with_room(one) for one in search.found]
    for one in zeros:
        crossing = _in_units(one, scope)
        where = within(crossing.value, next(iter(over.values())))
        if where is None and reason is None:
            reason = Reason("end", "a crossing lies at an end of the range", {}, "give a range that ends elsewhere")
        if where:
            inside.append(crossing)
    inside.sort(key=lambda one: float(one.value.mid()))
    common: dict[str, Any] = {"digits": digits, "crossings": tuple(inside)}
    if unbounded is not None:
        known: dict[str, Any] = {"crossings": len(inside)}
        known |= {COMPLETE: Fraction(X) * family.frequency_unit} if reason is None else {}
        cost = Spent.since(started, boxes=budget.spent)
        return Crossings(problem, over, Status.UNDECIDED, unbounded, known, (proof,), cost, **common)
    counts, base = None, None
    if reason is None:
        progress("base", 0.9)
        counts, base, reason = _counts(problem, over, inside, budget, check)
    cost = Spent.since(started, base, boxes=budget.spent)
    proofs = (replace(proof, base=base),)
    if reason is not None:
        known = {"crossings": len(inside)}
        return Crossings(problem, over, Status.UNDECIDED, reason, known, proofs, cost, **common)
    rooms = list(zip(zeros, search.judge.known, strict=True))
    claim = {"counts": list(counts or ()), "directions": [one.direction for one in inside]}
    at = Base((_counted_at(over, inside)[0],), base)
    progress("verifying", 0.9)
    asked = budget if check else None
    found = verified(lambda: crossings_certificate(scope, cover.tree, rooms, at, claim), cover.tree.nodes, asked)
    common |= {"proofs": proofs, "cost": cost.with_check(found.seconds), "counts": counts}
    return Crossings(problem, over, found.status, certificate=found.certificate, note=found.note, **common)


def _in_units(one: Scaled, scope: Scope) -> Crossing:
    with precision(max(int(one.x.mid().bits()), 53) + 64):
        value = one.x * rational_ball(scope.family.units[0])
        q = one.q * rational_ball(scope.family.frequency_unit)
        return Crossing(value, q, one.gained)


def _counts(
    problem: Problem, over: Mapping[str, Interval], found: list[Crossing], budget: Effort, check: bool
) -> tuple[tuple[int, ...] | None, Any, Reason | None]:
    """(the numbers of unstable roots between crossings, the spectrum from which they are counted, why not)."""
    path = next(iter(over))
    for one, other in pairwise(found):
        if not one.value < other.value:
            return None, None, Reason("close", "two crossings cannot be told apart", {}, "ask for more digits")
    if any(one.direction is None for one in found):
        stated = "a root touches the real axis as far as can be told"
        return None, None, Reason("direction", stated, {}, "ask for more digits")
    at, first = _counted_at(over, found)
    base = base_at(problem.changed(path, at), budget.rest(), check)
    number_there = growing(base)
    if number_there is None:
        return None, base, uncounted(base, f"at {path} = {float(at):.6g}")
    gained = [0, *accumulate(one.direction or 0 for one in found)]
    counts = tuple(number_there + number - gained[first] for number in gained)
    if min(counts) < 0:
        stated = "the counts contradict each other"
        return None, base, Reason("counts", stated, {}, "report this as a fault, with the input")
    return counts, base, None


def _counted_at(over: Mapping[str, Interval], found: list[Crossing]) -> tuple[Fraction, int]:
    """Where the roots are counted, and behind how many crossings: before the first, if it does not lie too near."""
    ((low, high),) = over.values()
    ends = [(low, low), *(exact_ends(one.value) for one in found), (high, high)]
    gaps = [(a, b) for (_, a), (b, _) in pairwise(ends)]
    widths = [b - a for a, b in gaps]
    k = next((n for n, width in enumerate(widths) if width > (high - low) * _ROOM), widths.index(max(widths)))
    return short_between(*gaps[k]), k
