"""The public verb: every induced frequency of a problem in a region, with proof, whatever the track and vehicles."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

from mpsolve.errors import InputError
from mpsolve.problem.case import Case
from mpsolve.problem.cases import Given, as_problem
from mpsolve.problem.physical import PhysicalCase
from mpsolve.problem.problem import Problem
from mpsolve.progress import Progress
from mpsolve.proof.effort import Effort
from mpsolve.spectrum.regions import Sheet, checked_region

if TYPE_CHECKING:
    from mpsolve.spectrum.spectrum import Spectrum


def certify(
    problem: Given,
    *,
    region: object = None,
    digits: int = 30,
    effort: Effort | None = None,
    progress: Progress | None = None,
    check: bool = True,
) -> Spectrum:
    """Every induced frequency of the problem in the region: a proof, or `Status.UNDECIDED` with reason and remedy.

    problem: a Problem, or a Case or PhysicalCase of the paper; q, rectangles and h are in its units (rad/s in
    SI, where h and the bounds of a rectangle may be texts with a unit).
    region: "unstable" (Im q < 0), ("below", h) (Im q < h, h below the branch cuts), a `Rectangle`, or "sheet" (the
    whole physical sheet, of masses on the paper's beam while its cuts lie on one line). Left out, it is "sheet" for
    the paper's beam with few masses, else ("below", h) for an h near the lowest cut, else "unstable"; the answer's
    `region` says which.
    digits: certified digits of each root relative to |q|, 15 to 10,000. effort bounds the work. progress is called
    with a stage and a fraction from 0 to 1. check: run the standalone verifier on the certificate before "proved" is
    returned; without it the status is "proved, not verified".
    Raises InputError for a track that is unstable by itself, and for a region that has no meaning.

    >>> from mpsolve import Case, certify
    >>> certify(Case(alpha="0.67", eta_b="0.05", eta_m=("70", "70"), positions=("0", "1.5"))).unstable
    2
    """
    if not isinstance(problem, (Problem, Case, PhysicalCase)):
        raise InputError("problem", f"is of type {type(problem).__name__}: give a Problem, a Case or a PhysicalCase")
    if effort is not None and not isinstance(effort, Effort):
        raise InputError("effort", f"is of type {type(effort).__name__}: give Effort(seconds=…, evaluations=…)")
    from mpsolve.certificate.asked import default_region, has_whole_sheet, is_damped
    from mpsolve.certificate.solve import certify_problem, checked_digits  # what computes is loaded when it is needed
    from mpsolve.certificate.whole_sheet import unstable_part

    meant, digits = as_problem(problem), checked_digits(digits)
    options: dict[str, Any] = {"digits": digits, "progress": progress, "check": check}
    asked = default_region(problem, meant) if region is None else checked_region(region, problem)
    if effort is not None and region is None:
        effort = effort.half()  # the rest is for the regions that are asked for instead

    def answered(wanted: object) -> Spectrum:
        return _about(problem, certify_problem(meant, region=wanted, effort=effort, **options))

    first = answered(asked)
    if first.proved or _interrupted(first):
        return first
    if region is not None:
        if asked != "unstable" or not _next_to_the_line(first) or not (is_damped(meant) and has_whole_sheet(meant)):
            return first
        whole = answered("sheet")  # a root is too close to the real axis: this count goes another way
        return unstable_part(whole) if whole.proved else first
    narrower = _NARROWER if isinstance(first.region, Sheet) else _NARROWER[1:]
    effort = effort.half() if effort is not None and len(narrower) > 1 else effort
    for wanted, note in narrower:
        if wanted or is_damped(meant):  # without damping there is nothing below a height
            found = answered(wanted)
            if found.proved:
                return replace(found, note=found.note or note)
            if _interrupted(found):
                break
    return first


def _interrupted(found: Spectrum) -> bool:
    return found.reason is not None and found.reason.code == "interrupted"


def _next_to_the_line(found: Spectrum) -> bool:
    return found.reason is not None and found.reason.code in ("root-on-line", "line")


_NARROWER = (
    (None, "roots above the cuts, or next to them, are left out, as the count on the whole sheet stayed open"),
    ("unstable", "roots above the real axis are left out, as the count of more than the half-plane stayed open"),
)
"""What is asked for instead where the default region stays open, and what is said then."""


def _about(given: Given, found: Spectrum) -> Spectrum:
    """The answer, which speaks of what was given: a Case keeps its units."""
    if given is found.problem:
        return found
    return replace(found, problem=given, roots=tuple(replace(root, problem=given) for root in found.roots))
