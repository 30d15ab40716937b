"""The public verb `real_roots`: every real zero of a function on an interval, proved, written and checked."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise
from time import process_time
from typing import Any

from flint import acb

from mpsolve.certificate.roots_check import budget_of, checked
from mpsolve.certificate.roots_file import interval_certificate
from mpsolve.certificate.solve import checked_digits
from mpsolve.errors import EffortError, InputError, PrecisionError
from mpsolve.numbers.balls import precision
from mpsolve.numbers.model import rational, shown
from mpsolve.numbers.result import Cost
from mpsolve.numbers.rootball import Symmetry
from mpsolve.outcome import Reason, Status
from mpsolve.progress import Progress, silent
from mpsolve.proof.effort import Effort
from mpsolve.zeros.analytic import hull
from mpsolve.zeros.answer import Zero, Zeros
from mpsolve.zeros.enclose import Zeros as Near
from mpsolve.zeros.function import Function
from mpsolve.zeros.read import Given, read_function
from mpsolve.zeros.reals import OpenTileError, Tiling, bracket, tile
from mpsolve.zeros.solve import reason_of


def real_roots(
    f: object,
    a: object,
    b: object,
    *,
    digits: int = 15,
    effort: Effort | None = None,
    progress: Progress | None = None,
    check: bool = True,
) -> Zeros:
    """Every real zero of f on the closed interval [a, b] with its multiplicity: a proof, or undecided with a reason.

    f: as for `roots`, but it must be an expression that is real on the interval. A multiplicity is the power of the
    factor of f whose simple zero it is: a multiple zero must show in the form of f, as in (z - 1)**3. Zeros of one
    factor that meet are refused by name. The balls are flint.arb. Other arguments and errors as for `roots`.

    >>> from mpsolve import real_roots
    >>> [zero.multiplicity for zero in real_roots("(z - 1)**3*(z**2 - 2*z - 24.11)", -10, 10).roots]
    [1, 3, 1]
    """
    started = process_time()
    digits, budget, tell = checked_digits(digits), budget_of(effort), progress or silent
    low, high = rational(a, "a"), rational(b, "b")
    if not low < high:
        raise InputError("b", f"is {shown(high)}, not above a = {shown(low)}: give the ends in order")
    given = read_function(f, None, False)
    if given.expression is None or not given.function.real:
        remedy = "give an expression without i, and √ and log only of numbers above 0"
        raise InputError("f", f"is not known to be real on the real axis: {remedy}")
    common: dict[str, Any] = {"function": given.words, "digits": digits, "region": (low, high)}
    try:
        tilings = [tile(part, power, low, high, budget) for part, power in given.function.parts]
        zeros, brackets, reason = _real_zeros(given, tilings, digits, float(max(abs(low), abs(high))))
    except (EffortError, PrecisionError) as error:
        cost = Cost(process_time() - started, 0.0, budget.spent)
        return Zeros(status=Status.UNDECIDED, reason=_real_reason(error), cost=cost, **common)
    pieces = sum(len(tiling.kinds) for tiling in tilings)
    cost = Cost(process_time() - started, 0.0, budget.spent, pieces)
    if reason is not None:
        return Zeros(status=Status.UNDECIDED, reason=reason, roots=zeros, cost=cost, **common)
    total = sum(zero.multiplicity for zero in zeros)
    answer = Zeros(status=Status.UNVERIFIED, count=total, roots=zeros, cost=cost, **common)
    rows = [(tiling, _sharp_bits(digits), row) for tiling, row in zip(tilings, brackets, strict=True)]
    certificate = interval_certificate(given.expression, low, high, rows)
    return checked(answer, certificate, budget if check else None, tell)


def _sharp_bits(digits: int) -> int:
    """At which the signs beside a zero are told: twice its digits, as f may be flat there, and some more."""
    return int(7 * digits) + 256


def _real_reason(error: EffortError | PrecisionError) -> Reason:
    if isinstance(error, OpenTileError):
        remedy = "write a multiple zero as a power of a factor, or give an interval without this place"
        return Reason("open-tile", str(error), {"re": f"{error.place:.10g}"}, remedy)
    return reason_of(error)


def _real_zeros(
    given: Given, tilings: list[Tiling], digits: int, size: float
) -> tuple[tuple[Zero, ...], list[list[tuple[Fraction, Fraction]]], Reason | None]:
    """The zeros in their order; the brackets of each factor's zeros; and why they are not all told apart."""
    found, brackets = [], []
    for tiling in tilings:
        near, row = Near(tiling.function, size, tiling.power), []
        for low, high in tiling.with_zeros:
            ball = _sharp(near, low, high, digits)
            with precision(_sharp_bits(digits)):
                row.append(bracket(tiling.function, low, high, ball))
            found.append((*row[-1], ball, tiling.power))
        brackets.append(row)
    found.sort(key=lambda one: one[0])
    zeros = tuple(Zero(ball, power, True) for _, _, ball, power in found)
    for one, two in pairwise(found):
        if one[1] >= two[0]:
            place = float((two[0] + two[1]) / 2)
            message = f"zeros of two factors of f near z = {place:.8g} are not told apart"
            remedy = "take the common factor out of both, or ask for more digits"
            return zeros, brackets, Reason("open-tile", message, {"re": f"{place:.10g}"}, remedy)
    for low, high, _, _ in found:
        if given.denominator is not None and not _nonzero(given.denominator, low, high):
            message = f"numerator and denominator may vanish together near z = {float(low):.8g}"
            remedy = "divide both by what they have in common"
            return zeros, brackets, Reason("common-zero", message, {"re": f"{float(low):.10g}"}, remedy)
    return zeros, brackets, None


def _nonzero(f: Function, low: Fraction, high: Fraction) -> bool:
    try:
        return bool(f.value(acb(hull((low, low), (high, high)).real)).abs_lower() > 0)
    except PrecisionError:
        return False


def _sharp(near: Near, low: Fraction, high: Fraction, digits: int) -> Any:
    """The one zero of a tile as a real ball: interval Newton from its middle, which must end in the tile."""
    tile_ball = hull((low, low), (high, high)).real
    seeds = [(low + high) / 2, low, high, *(low + (high - low) * k / 8 for k in range(1, 8))]
    for seed in seeds:
        try:
            ball = near.single(acb(hull((seed, seed)).real), 80, digits)
        except PrecisionError:
            continue
        if ball.symmetry is Symmetry.REAL and tile_ball.overlaps(ball.q.real):
            return ball.q.real
    return tile_ball
