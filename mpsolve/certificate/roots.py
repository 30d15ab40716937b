"""The public verb `roots`: every zero of an analytic function in a region, proved, written and checked."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from time import process_time
from typing import Any

from mpsolve.certificate.roots_check import budget_of, checked
from mpsolve.certificate.roots_file import region_certificate
from mpsolve.certificate.solve import checked_digits
from mpsolve.errors import InputError
from mpsolve.numbers.balls import rational_ball
from mpsolve.numbers.result import Cost
from mpsolve.numbers.rootball import Symmetry
from mpsolve.outcome import Reason, Status
from mpsolve.progress import Progress, silent
from mpsolve.proof.effort import Effort
from mpsolve.zeros.answer import Zero, Zeros
from mpsolve.zeros.read import Given, of_expression, read_function
from mpsolve.zeros.regions import Cut, Disc, HalfPlane, Polygon, Rectangle, Region, bound_words
from mpsolve.zeros.solve import Solved, solve
from mpsolve.zeros.turned import complex_words, composed, slant, turned_back, turned_cut, turned_region

_UNCHECKED = "proved, without a certificate that others can check: f is a Python function"


def roots(
    f: object,
    region: Region,
    *,
    cuts: Iterable[Cut] = (),
    derivative: Callable[[Any], Any] | None = None,
    assume_analytic: bool = False,
    digits: int = 15,
    effort: Effort | None = None,
    progress: Progress | None = None,
    check: bool = True,
) -> Zeros:
    """Every zero of an analytic f in the open region: a proof, or `Status.UNDECIDED` with reason and remedy.

    f: a text ("sin(z) - z/2"), an expression of sympy in one symbol, a Python function of flint.acb, or two of these
    as (numerator, denominator). A Python function is called once on a symbol; where it uses only operators and z's
    own methods it is an expression like the others. Where it cannot be read so, it must take (z, analytic), as
    acb.integral has it, or be vouched for with assume_analytic=True: its balls must not be finite where it may not be
    analytic. derivative: f′, for such a function. Sums and quotients are made one fraction: its zeros are those of
    the numerator where the denominator is not 0.
    region: Rectangle, Disc, Polygon, or HalfPlane (with the user's bound). cuts: branch cuts that reach into it, in
    any direction d; where they slant, the zeros are counted in w = z/d, and the certificate is one of f(d w).
    digits: certified digits of each zero relative to its modulus, 15 to 10,000. effort bounds the work. check: run
    the standalone verifier on the certificate before "proved" is returned.
    Raises InputError for what is no function or not analytic by its form, and for cuts that divide the region.

    >>> from mpsolve import Rectangle, roots
    >>> roots("sin(z) - z/2", Rectangle(-10, 10, -5, 5)).count
    7
    """
    if not isinstance(region, (Rectangle, Disc, Polygon, HalfPlane)):
        raise InputError("region", f"is of type {type(region).__name__}: give Rectangle, Disc, Polygon or HalfPlane")
    if isinstance(region, Rectangle) and region.has_units:
        raise InputError("region", "has bounds with units, but z is a bare number: leave them out")
    digits, budget = checked_digits(digits), budget_of(effort)
    declared = _checked_cuts(cuts)
    given = read_function(f, derivative, assume_analytic)
    tell = progress or silent
    turn = slant(declared)
    if turn is None:
        return _within_bound(_answered(given, region, declared, digits, budget, tell, check), region)
    if given.expression is None:
        raise InputError(
            "cuts", "slant, and f cannot be read as an expression: turn z, so that they lie along an axis"
        )
    there, along = turned_region(region, turn), [turned_cut(cut, turn) for cut in declared]
    turned = of_expression(composed(given.expression, turn))
    try:
        answer = _answered(turned, there, along, digits, budget, tell, check)
    except InputError as error:
        stated = str(error).removeprefix(f"{error.key}: ")
        raise InputError(error.key, f"{stated}, in the plane of w = z/({complex_words(turn)})") from None
    return _within_bound(turned_back(answer, given.words, region, there, turn), region)


def _within_bound(answer: Zeros, region: Region) -> Zeros:
    """Undecided where a zero of a half-plane is as far off as no zero is to be, by the user's word."""
    if not isinstance(region, HalfPlane) or answer.count is None:
        return answer
    beyond = next((zero for zero in answer.roots if not abs(zero.q) < rational_ball(region.bound)), None)
    if beyond is None:
        return answer
    near = complex(beyond.q)
    message = f"a zero lies near z = {near:.8g}, where |z| is not below the bound: {bound_words(region)}"
    place = {"re": repr(near.real), "im": repr(near.imag)}
    reason = Reason("bound", message, place, "give a bound that holds, or ask for a rectangle")
    known = {"counted": answer.count}
    return replace(answer, status=Status.UNDECIDED, reason=reason, known=known, count=None, certificate=None)


def _answered(
    given: Given, region: Region, cuts: Sequence[Cut], digits: int, budget: Effort, tell: Progress, check: bool
) -> Zeros:
    """The answer where all cuts lie along the axes."""
    started = process_time()
    found = solve(given, region, cuts, digits, budget, tell)
    assumed = given.assumed
    if isinstance(region, HalfPlane):
        assumed += (bound_words(region),)
    common: dict[str, Any] = {"function": given.words, "digits": digits, "assumed": assumed, "note": found.note}
    zeros = _zeros(found)
    if found.count is None or found.reason is not None:
        known = {} if found.count is None else {"counted": found.count.total}
        cost = Cost(process_time() - started, 0.0, budget.spent, found.count.pieces if found.count else 0)
        return Zeros(
            region=found.region,
            status=Status.UNDECIDED,
            reason=found.reason,
            roots=zeros,
            known=known,
            cost=cost,
            **common,
        )
    total = sum(zero.multiplicity for zero in zeros)
    cost = Cost(process_time() - started, 0.0, budget.spent, found.count.pieces)
    answer = Zeros(region=found.region, status=Status.UNVERIFIED, count=total, roots=zeros, cost=cost, **common)
    if given.expression is None:
        return replace(answer, note=f"{answer.note}; {_UNCHECKED}" if answer.note else _UNCHECKED)
    certificate = region_certificate(given.expression, found.count, found.region, found.balls, total)
    return checked(answer, certificate, budget if check else None, tell)


def _zeros(found: Solved) -> tuple[Zero, ...]:
    zeros = [Zero(ball.q, ball.multiplicity, ball.symmetry is Symmetry.REAL) for ball in found.inside]
    return tuple(sorted(zeros, key=lambda zero: (float(zero.q.real.mid()), float(zero.q.imag.mid()))))


def _checked_cuts(cuts: Iterable[Cut]) -> tuple[Cut, ...]:
    declared = tuple(cuts)
    for cut in declared:
        if not isinstance(cut, Cut):
            raise InputError("cuts", f"has an entry of type {type(cut).__name__}: give Cut.ray or Cut.segment")
    return declared
