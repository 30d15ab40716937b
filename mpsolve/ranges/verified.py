"""Whether the standalone verifier passes the certificate of an answer over ranges, within a bounded work."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from time import process_time

from mpsolve.certificate.format import Certificate
from mpsolve.errors import CertificateError, PrecisionError
from mpsolve.outcome import Status

_A_NODE, _PIECES = 1, 3000
"""Boxes that the verifier may look at: so many for each node of the tree, and so many more."""


@dataclass(frozen=True)
class Verified:
    """status: PROVED if the certificate passed, else UNVERIFIED; note: why there is none; seconds: of the check."""

    status: Status
    certificate: Certificate | None = None
    note: str = ""
    seconds: float = 0.0


def verified(make: Callable[[], Certificate], nodes: int, check: bool) -> Verified:
    """Make a certificate and have it checked; without `check` neither."""
    if not check:
        return Verified(Status.UNVERIFIED, note="the verifier was not asked")
    from mpsolve.certificate.verify_ranges import verify_bytes

    started = process_time()
    try:
        certificate = make()
        verdict = verify_bytes(certificate.text.encode("ascii"), _A_NODE * nodes + _PIECES)
    except (CertificateError, PrecisionError) as error:
        return Verified(Status.UNVERIFIED, note=str(error), seconds=process_time() - started)
    seconds = process_time() - started
    if not verdict.valid:
        return Verified(Status.UNVERIFIED, note=verdict.reason, seconds=seconds)
    return Verified(Status.PROVED, certificate, "", seconds)
