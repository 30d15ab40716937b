"""The certified induced frequencies that a motion starts from."""

from __future__ import annotations

from mpsolve.certificate.on_sheet import AnySpectrum, sheet_of
from mpsolve.certificate.sheet import SheetSpectrum, certify_sheet
from mpsolve.errors import InputError, PrecisionError
from mpsolve.problem.case import Case


def proved_spectrum(case: Case, spectrum: AnySpectrum | None, digits: int = 30) -> SheetSpectrum:
    """The given spectrum of the case, or a new one with these digits; PrecisionError if it is undecided."""
    found = certify_sheet(case, digits) if spectrum is None else sheet_of(spectrum)
    if found.case != case or found.region != "sheet":
        raise InputError(
            "spectrum", 'is not that of this case on the whole sheet: pass certify(case, region="sheet")'
        )
    if not found.proved:
        raise PrecisionError(f"the induced frequencies are undecided: {found.reason}")
    return found
