"""The public verb: every induced frequency of a problem in a region, with proof, whatever the track and vehicles."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

from mpsolve.errors import InputError
from mpsolve.model.parameters import Case, PhysicalCase
from mpsolve.problem.cases import Given, as_paper, as_problem
from mpsolve.problem.problem import Problem
from mpsolve.progress import Progress
from mpsolve.proof.effort import Effort
from mpsolve.spectrum.regions import checked_region

if TYPE_CHECKING:
    from mpsolve.spectrum.spectrum import Spectrum

FEW = 2
"""Up to so many masses the whole sheet of the paper's beam is what is asked for by default."""


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

    problem: a Problem, or a Case or PhysicalCase of the paper; q, rectangles and h are in its units (rad/s in SI).
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
    from mpsolve.certificate.solve import certify_problem, checked_digits  # what computes is loaded when it is needed

    digits = checked_digits(digits)
    paper = as_paper(problem)
    wanted = _default(paper) if region is None else checked_region(region)
    options: dict[str, Any] = {"digits": digits, "effort": effort, "progress": progress, "check": check}
    if isinstance(paper, Case) and wanted in ("sheet", "unstable") and not _rational(paper):
        return _on_sheet(problem, paper, wanted, options)
    found = _about(problem, certify_problem(as_problem(problem), region=wanted, **options))
    if region is None and wanted == "sheet" and not found.proved and not _lossless(paper):
        other = _about(problem, certify_problem(as_problem(problem), region=None, **options))
        return replace(other, note=other.note or _SHEET) if other.proved else found
    if paper is not None and _lossless(paper) and not found.proved and wanted in ("sheet", "unstable"):
        other = _on_sheet(problem, paper, wanted, options)  # next to the critical velocity
        return other if other.proved else found
    if wanted is None and not found.proved:
        other = certify(problem, region="unstable", **options)
        return replace(other, note=other.note or _ABOVE) if other.proved else found
    return found


def _lossless(paper: Case | PhysicalCase | None) -> bool:
    """Whether nothing damps: then there is no other region than the sheet."""
    return paper is not None and not (paper.eta_b if isinstance(paper, Case) else paper.c)


_SHEET = "roots above the cuts, or next to them, are left out, as the count on the whole sheet stayed open"
_ABOVE = "roots above the real axis are left out, as the count below a height stayed open"


def _on_sheet(given: Given, paper: Case | PhysicalCase, region: Any, options: dict[str, Any]) -> Spectrum:
    from mpsolve.certificate.on_sheet import certify_on_sheet

    return certify_on_sheet(given, paper, region, **options)


def _about(given: Given, found: Spectrum) -> Spectrum:
    """The answer, which speaks of what was given: a Case keeps its units."""
    if given is found.problem:
        return found
    return replace(found, problem=given, roots=tuple(replace(root, problem=given) for root in found.roots))


def _default(paper: Case | PhysicalCase | None) -> str | None:
    """ "sheet" or None, where the general engine chooses."""
    if paper is None:
        return None
    case = paper if isinstance(paper, Case) else paper.dimensionless
    if not case.cuts_on_line:
        return None if _rational(case) or isinstance(paper, PhysicalCase) else "unstable"
    few = len(set(case.positions)) <= FEW or not case.eta_b
    return "sheet" if few or isinstance(paper, Case) else None


def _rational(case: Case) -> bool:
    ratios = (case.alpha, case.eta_b, case.eta_n, case.eta_s, *case.eta_m, *case.positions)
    return all(x.is_rational for x in ratios)
