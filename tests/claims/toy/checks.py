"""The checks of the small paper."""

from __future__ import annotations

from mpsolve import Case
from mpsolve.certificate.certify import certify
from mpsolve.claims import Claim, Finding, Verdict
from mpsolve.errors import PrecisionError


def count(claim: Claim) -> Finding:
    found = certify(Case(alpha="0.5", eta_b="0.1", eta_m=claim.number("eta_m")), digits=15)
    right = str(found.count) == claim.number("roots")
    certificates = [(f"{claim.id}_spectrum", found.certificate), ("none", None)]
    numbers = [("roots", str(found.count))]
    verdict = Verdict.PROVED if right else Verdict.REFUTED
    return Finding(verdict, f"There are {found.count}.", numbers, certificates=certificates)


def guess(claim: Claim) -> Finding:
    return Finding(Verdict.AGREES, f"One of {len(claim.values('roots'))}.", search=["2 & more"])


def stuck(claim: Claim) -> Finding:
    raise PrecisionError(f"{claim.id} needs more digits")
