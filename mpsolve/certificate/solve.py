"""The verb of the general engine: all induced frequencies of a problem in a region, proved, written and checked."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from time import process_time
from typing import Any

from mpsolve.certificate.spectrum_file import RootEntry, spectrum_certificate
from mpsolve.errors import InputError
from mpsolve.numbers.model import rational, shown
from mpsolve.outcome import Reason, Status
from mpsolve.problem.problem import Problem
from mpsolve.problem.reduced import Reduced, reduce_problem
from mpsolve.proof.effort import Effort
from mpsolve.spectrum.enclose import RootBall, Symmetry
from mpsolve.spectrum.premises import require_premises
from mpsolve.spectrum.regions import Below, Box, HalfPlane, Region
from mpsolve.spectrum.solve import Found, default_height, solve, unstable_number
from mpsolve.spectrum.spectrum import Cost, Spectrum, sorted_roots
from mpsolve.tracks.at_rest import lowest_cut

MAX_DIGITS, MIN_DIGITS = 10_000, 15
Progress = Callable[[str, float], None]


def certify_problem(
    problem: Problem,
    *,
    region: object = None,
    digits: int = 30,
    effort: Effort | None = None,
    progress: Progress | None = None,
    check: bool = True,
) -> Spectrum:
    """Every root of Δ in the region: a proof, or `Status.UNDECIDED` with reason and remedy.

    region: "unstable" (Im q < 0), ("below", h) (with it Im q < h as far as the answer's region says), a Box, or None:
    below a height near the lowest cut, else "unstable". check: have the standalone verifier pass the certificate.
    Raises InputError for a track that is unstable by itself or has no damping, and for regions without meaning.
    """
    started = process_time()
    tell = progress or (lambda _stage, _fraction: None)
    budget = effort or Effort(evaluations=2_000_000)
    reduced = reduce_problem(problem)
    require_premises(reduced, HalfPlane())
    wanted, note = _region(reduced, region)
    found = solve(reduced, wanted, checked_digits(digits), budget, tell)
    if found.count is None and region is None and isinstance(wanted, Below):
        wanted, note = HalfPlane(), "roots above the real axis are left out, as the count below a height stayed open"
        found = solve(reduced, wanted, digits, budget, tell)
    return _spectrum(reduced, wanted, digits, found, note, budget, started, check)


def checked_digits(digits: object) -> int:
    """A whole number from 15 to 10,000."""
    try:
        number = int(digits.__index__())  # type: ignore[attr-defined]
    except (AttributeError, TypeError):
        number = 0
    if not MIN_DIGITS <= number <= MAX_DIGITS:
        raise InputError("digits", f"is {digits!r}: give a whole number from {MIN_DIGITS} to {MAX_DIGITS}")
    return number


def _region(reduced: Reduced, region: object) -> tuple[Region, str]:
    if region == "unstable":
        return HalfPlane(), ""
    if isinstance(region, (Box, HalfPlane)):
        return region, ""
    if region is None:
        low, _ = lowest_cut(reduced.problem.track)
        return (Below(default_height(reduced, low)), "") if low > 0 else (HalfPlane(), "")
    if isinstance(region, tuple) and len(region) == 2 and region[0] == "below":
        height = rational(region[1], "region")
        if height <= 0:
            raise InputError("region", f'is below {shown(height)}: give ("below", h) with h above 0, or "unstable"')
        return Below(height), ""
    raise InputError("region", f'is {region!r}: give "unstable", ("below", h) or a Rectangle')


def _spectrum(
    reduced: Reduced,
    wanted: Region,
    digits: int,
    found: Found,
    note: str,
    budget: Effort,
    started: float,
    check: bool,
) -> Spectrum:
    problem, count = reduced.problem, found.count
    if count is None:
        cost = Cost(process_time() - started, evaluations=budget.spent)
        return Spectrum(problem, wanted, digits, Status.UNDECIDED, found.reason, cost=cost)
    roots = sorted_roots(problem, found.balls)
    cost = Cost(process_time() - started, 0.0, budget.spent, count.pieces)
    common: dict[str, Any] = {
        "count": count.total,
        "roots": roots,
        "neutral": reduced.neutral,
        "note": note or count.why,
    }
    if found.reason is not None:
        known = {"count": count.total}
        return Spectrum(
            problem, count.region, digits, Status.UNDECIDED, found.reason, known=known, cost=cost, **common
        )
    unstable = unstable_number(found.balls)
    certificate = spectrum_certificate(reduced, count, _entries(found.balls), unstable)
    status, reason, seconds = _checked(certificate, check)
    cost = Cost(cost.seconds, seconds, cost.evaluations, cost.pieces)
    return Spectrum(
        problem, count.region, digits, status, reason, unstable=unstable, certificate=certificate, cost=cost, **common
    )


def _checked(certificate: Any, check: bool) -> tuple[Status, Reason | None, float]:
    """The verifier's word on the certificate that was just made."""
    if not check:
        return Status.UNVERIFIED, None, 0.0
    from mpsolve.certificate.verify2 import verify_content

    started = process_time()
    verdict = verify_content(certificate.content)
    seconds = process_time() - started
    if verdict.valid:
        return Status.PROVED, None, seconds
    message = f"the standalone verifier does not accept the proof: {verdict.reason}"
    return Status.UNDECIDED, Reason("verifier", message, {}, "report this as a fault, with the input"), seconds


def _entries(balls: tuple[RootBall, ...]) -> list[RootEntry]:
    """One entry for a pair q, −q̄, one for a root by itself."""
    out = []
    for ball in balls:
        if ball.symmetry is Symmetry.IMAGINARY:
            out.append(_entry(ball, False))
        elif ball.q.real > 0:
            out.append(_entry(ball, any(other.q.overlaps(ball.mirrored.q) for other in balls)))
        elif not any(other.q.overlaps(ball.mirrored.q) for other in balls):
            out.append(_entry(ball, False))
    return out


def _entry(ball: RootBall, pair: bool) -> RootEntry:
    re, im = (_on_grid(x.mid(), ball.exponent) for x in (ball.q.real, ball.q.imag))
    side = max((_fraction(x.rad()) for x in (ball.q.real, ball.q.imag)), default=Fraction(0))
    return RootEntry(re, im, ball.exponent, side * Fraction(3, 2), ball.multiplicity, pair)


def _on_grid(x: Any, exponent: int) -> int:
    mantissa, own = x.man_exp()
    return int(mantissa) << (int(own) - exponent) if mantissa else 0


def _fraction(x: Any) -> Fraction:
    mantissa, exponent = x.man_exp()
    return Fraction(int(mantissa)) * Fraction(2) ** int(exponent)
