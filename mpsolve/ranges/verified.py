"""Whether the standalone verifier passes the certificate of an answer over ranges, within a bounded work."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from mpsolve.certificate.format import Certificate
from mpsolve.errors import CertificateError, PrecisionError
from mpsolve.outcome import Status
from mpsolve.proof.effort import Effort
from mpsolve.proof.in_time import in_time

_A_NODE, _PIECES = 1, 3000
"""Boxes that the verifier may look at: so many for each node of the tree, and so many more."""


@dataclass(frozen=True)
class Verified:
    """status: PROVED if the certificate passed, else UNVERIFIED; note: why there is none; seconds: of the check."""

    status: Status
    certificate: Certificate | None = None
    note: str = ""
    seconds: float = 0.0


def verified(make: Callable[[], Certificate], nodes: int, budget: Effort | None) -> Verified:
    """Make a certificate and have it checked within the effort; None: neither."""
    if budget is None:
        return Verified(Status.UNVERIFIED, note="the verifier was not asked")
    from mpsolve.certificate.verify_ranges import verify_bytes

    def made_and_checked() -> tuple[Certificate | None, str]:
        try:
            certificate = make()
            verdict = verify_bytes(certificate.text.encode("ascii"), _A_NODE * nodes + _PIECES)
        except (CertificateError, PrecisionError) as error:
            return None, str(error)
        return (certificate, "") if verdict.valid else (None, f"the verifier does not pass one: {verdict.reason}")

    found, late, seconds = in_time(made_and_checked, budget)
    certificate, why = found or (None, late)
    status = Status.UNVERIFIED if certificate is None else Status.PROVED
    return Verified(status, certificate, why, seconds)
