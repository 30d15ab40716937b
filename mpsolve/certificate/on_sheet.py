"""The whole sheet of the paper's beam as a spectrum in the units of what was given: rad/s for a case in SI."""

from __future__ import annotations

from time import process_time
from typing import Any, TypeAlias

from flint import acb

from mpsolve.certificate.sheet import SheetSpectrum, certify_sheet, known_count
from mpsolve.errors import InputError
from mpsolve.model.parameters import Case, PhysicalCase
from mpsolve.numbers.balls import precision
from mpsolve.numbers.decimals import working_bits
from mpsolve.numbers.rootball import RootBall
from mpsolve.outcome import Reason
from mpsolve.problem.cases import Given, as_paper
from mpsolve.progress import Progress, silent
from mpsolve.proof.effort import MORE_EFFORT, Effort
from mpsolve.spectrum.regions import Answered, HalfPlane, Rectangle, Sheet
from mpsolve.spectrum.spectrum import Cost, Root, Spectrum

AnySpectrum: TypeAlias = Spectrum | SheetSpectrum
"""What may be handed to a question about the paper's beam; `sheet_of` makes one thing of it."""

_PIECES = 100_000


def certify_on_sheet(
    given: Given,
    paper: Case | PhysicalCase,
    region: Any,
    digits: int,
    effort: Effort | None = None,
    progress: Progress | None = None,
    check: bool = True,
) -> Spectrum:
    """The answer of `certify_sheet` about `paper`, which is `given` as a case of the paper.

    region: "sheet", "unstable" or, for a Case, a Rectangle. effort: its evaluations bound the pieces of the contour.
    """
    started = process_time()
    case, scale = (paper, None) if isinstance(paper, Case) else (paper.dimensionless, paper.time_scale)
    budget = (effort or Effort(evaluations=_PIECES)).anew()
    tell = _timed(progress or silent, budget)
    pieces = budget.evaluations or 100 * _PIECES
    found = certify_sheet(case, digits, region, pieces, tell, check)
    with precision(working_bits(digits)):
        unit = None if scale is None else scale.ball()
        roots = tuple(_root(root, unit, given) for root in found.roots)
    count = known_count(found)
    return Spectrum(
        problem=given,
        region=_region(region),
        digits=digits,
        status=found.status,
        reason=None if found.why is None else _worded(found.why),
        count=count,
        unstable=found.unstable,
        roots=roots,
        known={} if found.proved or count is None else {"count": count},
        closing=_closing(found),
        verified=found.verified,
        certificate=found.certificate,
        cost=Cost(process_time() - started, evaluations=found.evaluations),
        sheet=found,
    )


def sheet_of(spectrum: AnySpectrum) -> SheetSpectrum:
    """The answer on the paper's beam, in dimensionless terms; InputError where there is none."""
    found = (spectrum.sheet or _as_sheet(spectrum)) if isinstance(spectrum, Spectrum) else spectrum
    if not isinstance(found, SheetSpectrum):
        given = "one of another region or track" if found is None else f"of type {type(found).__name__}"
        raise InputError("spectrum", f'is {given}: pass certify(case, region="sheet") of the paper\'s beam')
    return found


def _as_sheet(spectrum: Spectrum) -> SheetSpectrum | None:
    """The answer of the general engine about the whole sheet, in dimensionless terms; None where it is another."""
    paper = as_paper(spectrum.problem)
    if paper is None or not isinstance(spectrum.region, Sheet):
        return None
    case = paper if isinstance(paper, Case) else paper.dimensionless
    with precision(working_bits(spectrum.digits)):
        unit = None if isinstance(paper, Case) else paper.time_scale.ball()
        roots = tuple(_dimensionless(root, unit) for root in spectrum.roots)
    reason = spectrum.reason
    return SheetSpectrum(
        case,
        "sheet",
        spectrum.digits,
        spectrum.status,
        "" if reason is None else str(reason),
        spectrum.count,
        spectrum.unstable,
        roots,
        certificate=spectrum.certificate,
        evaluations=spectrum.cost.evaluations,
        why=reason,
        verified=spectrum.verified,
    )


def _dimensionless(root: Root, unit: Any) -> RootBall:
    q = root.q if unit is None else acb(root.q.real / unit, root.q.imag / unit)
    _, exponent = q.abs_lower().man_exp()
    return RootBall(q, int(exponent), root.multiplicity, root.symmetry)


def _timed(progress: Progress, budget: Effort) -> Progress:
    """The same progress, which ends the count and the search for roots when the time is over."""

    def tell(stage: str, fraction: float) -> None:
        if stage != "verifying":
            budget.spend(0)
        progress(stage, fraction)

    return tell


def _root(root: RootBall, unit: Any, given: Given) -> Root:
    q = root.q if unit is None else acb(root.q.real * unit, root.q.imag * unit)
    return Root(q, root.multiplicity, root.symmetry, given)


def _region(region: Any) -> Answered:
    named: dict[str, Answered] = {"sheet": Sheet(), "unstable": HalfPlane()}
    return region if isinstance(region, Rectangle) else named[region]


def _closing(found: SheetSpectrum) -> str:
    """What proves that no root is missed."""
    if found.radius is None:
        return "" if found.count is None else "the argument of Δ turns along the sides of the rectangle"
    return f"a bound of Δ for large q: no root has |q − iη_b| ≥ {found.radius:.10g} in units of √(k/m)"


def _worded(reason: Reason) -> Reason:
    """The reason with the remedy in the words of `certify`."""
    remedy = reason.remedy.replace("raise max_pieces", MORE_EFFORT)
    numbers = {"pieces" if name == "max_pieces" else name: value for name, value in reason.numbers.items()}
    return Reason(reason.code, reason.message, numbers, remedy)
