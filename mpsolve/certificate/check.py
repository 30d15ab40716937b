"""Certificates of every kind, each by the standalone verifier that knows it."""

from __future__ import annotations

import re
from typing import Any

from mpsolve.certificate.verify2 import Verdict
from mpsolve.certificate.verify2 import verify_bytes as of_spectra

_MOST = 64_000_001
_ZEROS = re.compile(rb'"format"\s*:\s*"mpsolve zeros"')
_RANGES = re.compile(rb'"kind"\s*:\s*"(?:crossings|stable|chart)"')
_VERSION_1 = re.compile(rb'"version"\s*:\s*1\b')
_VERSION_2 = re.compile(rb'"version"\s*:\s*2\b')

OLD = (
    "the file is a certificate of version 1, which is no longer read: make it anew from its case, "
    "with `mpsolve certify` for induced frequencies and `mpsolve crossings` for a range"
)


def verify(path: Any) -> Verdict:
    """The verdict on the certificate in the file `path`. Never raises for what the file holds."""
    try:
        with open(path, "rb") as file:
            raw = file.read(_MOST)
    except (OSError, ValueError) as error:
        return Verdict(False, f"the file cannot be read: {getattr(error, 'strerror', None) or error}")
    return verify_bytes(raw)


def verify_bytes(raw: bytes) -> Verdict:
    """The verdict on a certificate's bytes. Never raises for what they hold."""
    if _ZEROS.search(raw):
        from mpsolve.certificate.verify_roots import verify_bytes as of_zeros

        return of_zeros(raw)
    if _VERSION_1.search(raw) and not _VERSION_2.search(raw):
        return Verdict(False, OLD)
    if _RANGES.search(raw):
        from mpsolve.certificate.verify_ranges import verify_bytes as of_ranges

        return of_ranges(raw)
    return of_spectra(raw)
