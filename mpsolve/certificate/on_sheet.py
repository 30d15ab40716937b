"""The whole sheet of the paper's beam as a spectrum in the units of what was given: rad/s for a case in SI."""

from __future__ import annotations

from time import process_time
from typing import Any

from flint import acb

from mpsolve.certificate.sheet import SheetSpectrum, certify_sheet, known_count
from mpsolve.errors import InputError
from mpsolve.model.parameters import Case, PhysicalCase
from mpsolve.numbers.balls import precision
from mpsolve.numbers.decimals import working_bits
from mpsolve.outcome import Reason
from mpsolve.problem.cases import Given
from mpsolve.progress import Progress, silent
from mpsolve.proof.effort import Effort
from mpsolve.sheet.enclose import RootBall
from mpsolve.spectrum.enclose import Symmetry
from mpsolve.spectrum.regions import Answered, HalfPlane, Sheet
from mpsolve.spectrum.solve import MORE_EFFORT
from mpsolve.spectrum.spectrum import Cost, Root, Spectrum

_PIECES = 100_000
_SPARE = 1  # a digit more, for the rounding of q √(k/m)
_MOST = 10_000


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
    spare = 0 if scale is None else _SPARE
    tell = _timed(progress or silent, budget)
    pieces = budget.evaluations or 100 * _PIECES
    found = certify_sheet(case, min(digits + spare, _MOST), region, pieces, tell, check)
    with precision(working_bits(digits + spare)):
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
        certificate=found.certificate,
        cost=Cost(process_time() - started, evaluations=found.evaluations),
        sheet=found,
    )


def sheet_of(spectrum: object) -> SheetSpectrum:
    """The answer on the paper's beam, in dimensionless terms; InputError where there is none."""
    found = spectrum.sheet if isinstance(spectrum, Spectrum) else spectrum
    if not isinstance(found, SheetSpectrum):
        given = "one of another region or track" if found is None else f"a {type(found).__name__}"
        raise InputError("spectrum", f'is {given}: pass certify(case, region="sheet") of the paper\'s beam')
    return found


def _timed(progress: Progress, budget: Effort) -> Progress:
    """The same progress, which ends the count and the search for roots when the time is over."""

    def tell(stage: str, fraction: float) -> None:
        if stage != "verifying":
            budget.spend(0)
        progress(stage, fraction)

    return tell


def _root(root: RootBall, unit: Any, given: Given) -> Root:
    symmetry = Symmetry[root.symmetry.name]
    if unit is None:
        return Root(root.q, root.multiplicity, symmetry, given)
    return Root(acb(root.q.real * unit, root.q.imag * unit), root.multiplicity, symmetry, given)


def _region(region: Any) -> Answered:
    names: dict[Any, Answered] = {"sheet": Sheet(), "unstable": HalfPlane()}
    return names.get(region, region)


def _worded(reason: Reason) -> Reason:
    """The reason with the remedy in the words of `certify`."""
    remedy = reason.remedy.replace("raise max_pieces", MORE_EFFORT)
    numbers = {"pieces" if name == "max_pieces" else name: value for name, value in reason.numbers.items()}
    return Reason(reason.code, reason.message, numbers, remedy)
