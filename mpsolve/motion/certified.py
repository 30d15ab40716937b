"""The certified induced frequencies that a motion starts from."""

from __future__ import annotations

from mpsolve.certificate.certify import Spectrum, certify
from mpsolve.errors import InputError, PrecisionError
from mpsolve.model.parameters import Case


def proved_spectrum(case: Case, spectrum: Spectrum | None, digits: int = 30) -> Spectrum:
    """The given spectrum of the case, or a new one with these digits; PrecisionError if it is undecided."""
    if spectrum is None:
        spectrum = certify(case, digits)
    elif not isinstance(spectrum, Spectrum):
        raise InputError("spectrum", f"is {type(spectrum).__name__}: pass certify(case), or leave it out")
    elif spectrum.case != case or spectrum.region != "sheet":
        raise InputError(
            "spectrum", 'is not that of this case on the whole sheet: pass certify(case, region="sheet")'
        )
    if not spectrum.proved:
        raise PrecisionError(f"the induced frequencies are undecided: {spectrum.reason}")
    return spectrum
