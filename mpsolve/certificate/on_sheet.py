"""The answer of `certify` about the whole sheet of the paper's beam, in the dimensionless terms of the motion."""

from __future__ import annotations

from typing import Any, TypeAlias

from flint import acb

from mpsolve.certificate.sheet import SheetSpectrum
from mpsolve.errors import InputError
from mpsolve.numbers.balls import precision
from mpsolve.numbers.decimals import working_bits
from mpsolve.numbers.rootball import RootBall
from mpsolve.problem.case import Case
from mpsolve.problem.cases import as_paper
from mpsolve.spectrum.regions import Sheet
from mpsolve.spectrum.spectrum import Root, Spectrum

AnySpectrum: TypeAlias = Spectrum | SheetSpectrum
"""What may be handed to a question about the paper's beam; `sheet_of` makes one thing of it."""


def sheet_of(spectrum: AnySpectrum) -> SheetSpectrum:
    """The answer on the paper's beam, in dimensionless terms; InputError where there is none."""
    found = _as_sheet(spectrum) if isinstance(spectrum, Spectrum) else spectrum
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
