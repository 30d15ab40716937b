"""The paper's cases and what several claims ask of them, each computed once a process."""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache
from typing import Any

import flint

from mpsolve import CutPoint, CutPoints, Spectrum, certify, cut_points
from mpsolve.certificate.format import Certificate
from mpsolve.claims import Claim
from mpsolve.errors import PrecisionError
from mpsolve.problem.case import Case

MASSES = ("10", "40", "70")  # η_M = 10:30:70, Section 4.1
DISTANCES = tuple(str(Fraction(k, 2).limit_denominator()) if k % 2 == 0 else f"{k / 2}" for k in range(1, 10))
DIGITS = 18
_GRID_END = "0.999"


def pair(alpha: str, eta_b: str, eta_m: str, d: str) -> Case:
    """Two equal masses at the distance d."""
    return Case(alpha=alpha, eta_b=eta_b, eta_m=(eta_m, eta_m), positions=("0", d))


def single(alpha: str, eta_b: str, eta_m: str) -> Case:
    return Case(alpha=alpha, eta_b=eta_b, eta_m=eta_m)


@lru_cache(maxsize=512)
def spectrum(case: Case) -> Spectrum:
    """All induced frequencies, proved. PrecisionError if they cannot be."""
    found = certify(case, region="sheet", digits=DIGITS)
    if not found.proved:
        raise PrecisionError(str(found.reason))
    return found


def certificate(case: Case) -> Certificate | None:
    """The certificate of `spectrum`, None where the count and the roots cannot be proved."""
    try:
        found: Certificate | None = spectrum(case).certificate
    except PrecisionError:
        return None
    return found


def lowest(case: Case) -> Any:
    """The least Im q of all roots."""
    return min((root.q.imag for root in spectrum(case).roots), key=float)


def listed(claim: Claim) -> list[tuple[str, str, Case]]:
    """The `cases` of a claim, η_b α η_M d of two equal masses: in words, the name of a certificate, the case."""
    found = []
    for text in claim.values("cases"):
        eta_b, alpha, eta_m, d = text.split()
        words = f"η_b = {eta_b}, α = {alpha}, η_M = {eta_m}, d = {d}"
        found.append((words, f"{claim.id}_eta_b{eta_b}_alpha{alpha}_eta{eta_m}_d{d}", pair(alpha, eta_b, eta_m, d)))
    return found


def ahead(case: Case) -> list[Any]:
    """The roots with Re q > 0, by ascending Re q: one of each pair ±."""
    return sorted((r.q for r in spectrum(case).roots if r.q.real > 0), key=lambda q: float(q.real.mid()))


@lru_cache(maxsize=128)
def gap_ends(eta_m: str, d: str) -> tuple[CutPoint, ...]:
    """Undamped, α = 0.01 to 0.999: all velocity ratios at which a frequency line ends at q_lm."""
    return cuts(pair("0.5", "0", eta_m, d), "0.01", _GRID_END, DIGITS).points


def cuts(case: Case, low: str, high: str, digits: int = 15) -> CutPoints:
    """All cut points of a range of velocity ratios. PrecisionError if the list is not proved."""
    found = cut_points(case, over={"v": (low, high)}, digits=digits)
    if not found.proved:
        raise PrecisionError(str(found.reason))
    return found


def higher_end(eta_m: str, d: str) -> Any:
    """The one velocity ratio (a ball) at which the higher line ends. PrecisionError if there are more or fewer."""
    ends = gap_ends(eta_m, d)
    if len(ends) != 1 or ends[0].appears:
        raise PrecisionError(f"the higher line has {len(ends)} ends for eta_M = {eta_m}, d = {d}")
    return ends[0].value


def ball(text: str) -> Any:
    """A printed number as a ball, at the present precision."""
    value = Fraction(text)
    return flint.arb(value.numerator) / value.denominator
