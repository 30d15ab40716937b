"""The verb of the general engine: all induced frequencies of a problem in a region, proved, written and checked."""

from __future__ import annotations

import math
from time import process_time
from typing import Any

from mpsolve.certificate.asked import asked_region
from mpsolve.certificate.entries import root_entries
from mpsolve.certificate.format import Certificate
from mpsolve.certificate.sheet_file import sheet_certificate
from mpsolve.certificate.spectrum_file import RootEntry, spectrum_certificate
from mpsolve.certificate.whole_sheet import closing_words, sheet_halves, unstable_part
from mpsolve.errors import PrecisionError
from mpsolve.numbers.decimals import outward
from mpsolve.numbers.model import whole
from mpsolve.numbers.result import Cost
from mpsolve.outcome import Reason, Status
from mpsolve.problem.line import Line, on_line
from mpsolve.problem.problem import Problem
from mpsolve.problem.reduced import Reduced, reduce_problem
from mpsolve.progress import Progress, silent
from mpsolve.proof.effort import Effort, begun
from mpsolve.proof.in_time import in_time
from mpsolve.proof.stopping import stoppable
from mpsolve.spectrum.behind import BEHIND
from mpsolve.spectrum.count import AT_REST, Count, count_roots, line_for
from mpsolve.spectrum.lossless import PASSIVE, none_unstable, passive_everywhere
from mpsolve.spectrum.premises import require_premises
from mpsolve.spectrum.regions import Answered, Below, HalfPlane, Rectangle, Region, Sheet
from mpsolve.spectrum.sheet import SheetCount, count_sheet
from mpsolve.spectrum.solve import MOST_DIGITS, Found, solve, unstable_number
from mpsolve.spectrum.spectrum import Spectrum, sorted_roots
from mpsolve.spectrum.unfelt import unfelt_frequencies

AnyCount = Count | SheetCount
MAX_DIGITS, MIN_DIGITS = MOST_DIGITS, 15
_EVALUATIONS, _SECONDS = 200_000, 300.0  # without a stated effort; most problems take some thousands, and 0.1 s
_LONG = 8  # contacts: under a stated effort strips are counted first; fewer are counted as a whole in as much time
_ROOMS = (1.8, 2.6)  # for a verifier that refuses a piece
_CLOSED = (AT_REST, PASSIVE, BEHIND)
_PART = "ask for a Rectangle round the part that matters"
_REMEDY = "report this as a fault, with the input"


@stoppable
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

    region: "unstable" (Im q < 0), Below(h) (with it Im q < h as far as the answer's region says), a Rectangle,
    "sheet" (the whole physical sheet, of masses on a beam whose cuts lie on one line), or None: below a height near
    the lowest cut, else "unstable". Of an undamped beam "unstable" is answered by its whole sheet, and None is it.
    Heights and sides are kept exactly. check: have the standalone verifier pass the certificate. Raises InputError
    for a track that is unstable by itself or, but for such a beam, has no damping, and for regions without meaning.
    """
    started = process_time()
    budget = begun(Effort(_SECONDS, _EVALUATIONS) if effort is None else effort)
    tell = _timed(progress or silent, budget)
    reduced = reduce_problem(problem)
    line = on_line(reduced)
    digits = checked_digits(digits)
    rest: tuple[Any, ...] = (budget, started, check, tell)
    if line is not None and region == "unstable" and passive_everywhere(line):
        return _spectrum(reduced, HalfPlane(), HalfPlane(), digits, Found(none_unstable(line), (), None), *rest)
    lossless = line is not None and not line.height and region in ("unstable", None)
    if region == "sheet" or lossless:
        wanted: Answered = Sheet()
        asked: Region | Line = sheet_halves(reduced, line)
    elif isinstance(region, Rectangle) and line_for(reduced, region) is not None:
        wanted = asked = region
    else:
        require_premises(reduced, HalfPlane())
        wanted = asked = asked_region(reduced, region)
    in_strips = effort is not None and reduced.contacts >= _LONG
    found = solve(reduced, asked, digits, budget, tell, in_strips)
    answer = _spectrum(reduced, wanted, asked, digits, found, *rest)
    return unstable_part(answer) if lossless and region == "unstable" else answer


def checked_digits(digits: object) -> int:
    """A whole number from 15 to 10,000."""
    return whole(digits, "digits", MIN_DIGITS, MAX_DIGITS)


def _timed(progress: Progress, budget: Effort) -> Progress:
    """The same progress, which ends the work when its time is over."""

    def tell(stage: str, fraction: float) -> None:
        if stage != "verifying":
            budget.spend(0)
        progress(stage, fraction)

    return tell


def _spectrum(
    reduced: Reduced,
    wanted: Answered,
    asked: Region | Line,
    digits: int,
    found: Found,
    budget: Effort,
    started: float,
    check: bool,
    tell: Progress,
) -> Spectrum:
    problem, count = reduced.problem, found.count
    if count is None:
        cost = Cost(process_time() - started, evaluations=budget.spent)
        return Spectrum(problem, wanted, digits, Status.UNDECIDED, found.reason, known=found.known, cost=cost)
    roots = sorted_roots(problem, found.balls)
    cost = Cost(process_time() - started, 0.0, budget.spent, count.pieces)
    common: dict[str, Any] = {
        "count": count.total,
        "roots": roots,
        "neutral": reduced.neutral,
        "unfelt": unfelt_frequencies(reduced.parts),
        "note": "" if count.why in _CLOSED else count.why,
        "closing": _closing(reduced, count),
    }
    if found.reason is not None:
        return Spectrum(
            problem, count.region, digits, Status.UNDECIDED, found.reason, known=_known(count), cost=cost, **common
        )
    unstable = unstable_number(found.balls)
    certificate = _certificate(reduced, count, root_entries(found.balls), unstable)
    if check:
        tell("verifying", 0.0)
    status, reason, verified, seconds = _checked(certificate, count, budget if check else None)
    pieces = count.pieces
    for room in _ROOMS if reason is not None and reason.code == "verifier" and "piece" in reason.message else ():
        # the verifier's bounds are wider on some piece: the same proof again, in shorter pieces
        again = _recounted(reduced, asked, budget, room)
        if again is None or (again.total, again.region) != (count.total, count.region):
            break
        certificate = _certificate(reduced, again, root_entries(found.balls), unstable)
        status, reason, verified, more = _checked(certificate, again, budget)
        pieces, seconds = again.pieces, seconds + more
        if reason is None:
            break
    cost = Cost(process_time() - started - seconds, seconds, budget.spent, pieces)
    if reason is not None:  # of what the verifier refuses nothing is known
        return Spectrum(problem, count.region, digits, status, reason, certificate=certificate, cost=cost)
    return Spectrum(
        problem,
        count.region,
        digits,
        status,
        unstable=unstable,
        certificate=certificate,
        cost=cost,
        verified=verified,
        **common,
    )


def _certificate(reduced: Reduced, count: AnyCount, roots: list[RootEntry], unstable: int) -> Certificate:
    if isinstance(count, SheetCount):
        return sheet_certificate(reduced, count, roots, unstable)
    return spectrum_certificate(reduced, count, roots, unstable)


def _recounted(reduced: Reduced, wanted: Region | Line, budget: Effort, room: float) -> AnyCount | None:
    """The count with pieces that are planned on discs larger by `room`; None where it stays open."""
    try:
        if isinstance(wanted, Line):
            return count_sheet(wanted, budget, room)
        return count_roots(reduced, wanted, budget, silent, room)
    except PrecisionError:
        return None


def _closing(reduced: Reduced, count: AnyCount) -> str:
    """What proves that no root is missed."""
    if isinstance(count, SheetCount):
        return closing_words(reduced, count)
    if count.why in (PASSIVE, BEHIND):
        return count.why
    at_rest = count.beyond is None and isinstance(count.region, (HalfPlane, Below)) and count.region.radius is None
    if at_rest:
        return AT_REST
    if isinstance(count.region, Rectangle):
        return "the argument of the characteristic function turns along the sides of the rectangle"
    if count.beyond is None:
        return "the argument of the characteristic function turns along the border of the half-disc"
    # the theorem holds outside a rectangle: this is the distance of its corners, rounded up
    corner = math.hypot(count.beyond.rho, count.beyond.depth) * (1 + 2.0**-50)
    far = outward(float(reduced.frequency_unit) * corner, 6, up=True)
    return f"the track takes up power at all frequencies with |q| ≥ {far}, so that none with Im q < 0 is there"


def _known(count: AnyCount) -> dict[str, Any]:
    """What is proved where not every root could be enclosed."""
    return {"count": count.total}


def _checked(certificate: Any, count: AnyCount, budget: Effort | None) -> tuple[Status, Reason | None, str, float]:
    """The verifier's word on the certificate that was just made, or why it was not heard; None: it is not asked."""
    if budget is None:
        return Status.UNVERIFIED, None, "", 0.0
    from mpsolve.certificate.verify2 import MAX_PIECES, verify_bytes

    other = 'ask for "unstable"' if isinstance(count, SheetCount) else ""
    if count.pieces > MAX_PIECES:
        message = f"the proof has {count.pieces} pieces, more than the {MAX_PIECES} that a verifier reads"
        return Status.UNDECIDED, Reason("pieces", message, {"pieces": str(count.pieces)}, other or _PART), "", 0.0
    verdict, why, seconds = in_time(lambda: verify_bytes(certificate.text.encode("ascii")), budget)
    if verdict is None:  # what the prover has proved is kept
        return Status.UNVERIFIED, None, why, seconds
    if verdict.valid:
        return Status.PROVED, None, verdict.claim, seconds
    message = f"the standalone verifier does not accept the proof: {verdict.reason}"
    return Status.UNDECIDED, Reason("verifier", message, {}, f"{other}; {_REMEDY}" if other else _REMEDY), "", seconds
