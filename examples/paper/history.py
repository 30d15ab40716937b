"""The full solution against the harmonic one in time, in float64: what the truly transient part adds.

These results are computed, not proved; the response estimates its errors, by rest before τ = 0 among others.
"""

from __future__ import annotations

from functools import lru_cache
from itertools import pairwise
from typing import Any

import numpy as np

from mpsolve import Case, Load, Vibration, response
from mpsolve.claims import Claim, Finding, Verdict
from mpsolve.problem.cases import as_problem

from .cases import DISTANCES, pair, spectrum

_END, _STEPS, _WINDOW = 100.0, 201, 61


@lru_cache(maxsize=64)
def largest_parts(eta_b: str, eta_m: str, alpha: str, d: str) -> tuple[float, float]:
    """At ξ = 0 and τ = 0 to 100: the largest |transient|, and the largest |harmonic|."""
    found = _moved(pair(alpha, eta_b, eta_m, d), np.linspace(0.0, _END, _STEPS))
    transient, harmonic = np.abs(found.transient[0]), np.abs(found.harmonic[0])
    return float(transient.max()), float(harmonic.max())


def _moved(case: Case, times: Any) -> Vibration:
    """The motion of the rear contact under unit forces, in w_st = 1/2, over the certified roots of the sheet."""
    asked: dict[str, Any] = {"times": times, "places": [0], "spectrum": spectrum(case)}
    found: Vibration = response(as_problem(case), [Load(2)] * case.count, **asked)
    return found


def _tables(claim: Claim) -> dict[str, tuple[float, float]]:
    model = claim.numbers("eta_b", "eta_m", "alpha")
    eta_b, eta_m, alpha = model
    return {d: largest_parts(eta_b, eta_m, alpha, d) for d in claim.values("d")}


def excellent(claim: Claim) -> Finding:
    """The full and the harmonic solution differ by a small part of the amplitude at all times."""
    limit, parts = float(claim.number("limit")), _tables(claim)
    numbers = tuple(
        (f"d = {d}: largest difference over the amplitude", f"{a / h:.2g}") for d, (a, h) in parts.items()
    )
    worst = max(a / h for a, h in parts.values())
    sentence = (
        f"At the rear contact and for τ ≤ {_END:g} the difference is at most {100 * worst:.2g} % of the amplitude."
    )
    return Finding(Verdict.AGREES if worst < limit else Verdict.DISAGREES, sentence, numbers)


def band(claim: Claim) -> Finding:
    """The distances with a noticeable disagreement."""
    first, last, parts = float(claim.number("first")), float(claim.number("last")), _tables(claim)
    numbers = tuple(
        (f"d = {d}: largest difference (static displacement 1)", f"{a:.3g}") for d, (a, _) in parts.items()
    )
    inside = [a for d, (a, _) in parts.items() if first <= float(d) < last]
    outside = [a for d, (a, _) in parts.items() if not first <= float(d) < last]
    if min(inside) > max(outside):
        sentence = (
            f"The largest difference is {min(inside):.2g} or more in that band, {max(outside):.2g} or less outside."
        )
        return Finding(Verdict.AGREES, sentence, numbers)
    return Finding(Verdict.DISAGREES, "The largest differences do not separate these distances.", numbers)


def late_parts(eta_b: str, eta_m: str, alpha: str, d: str, starts: tuple[str, ...]) -> list[float]:
    """At ξ = 0: the largest |transient| from rest on, and over windows of τ that begin at `starts`, a quarter "
    "long."""
    first = [np.linspace(0.0, float(starts[0]), _STEPS)]
    times = np.concatenate(first + [np.linspace(float(a), 1.25 * float(a), _WINDOW) for a in starts])
    sizes = np.abs(_moved(pair(alpha, eta_b, eta_m, d), times).transient[0])
    return [float(sizes[:_STEPS].max()), *map(float, sizes[_STEPS:].reshape(len(starts), _WINDOW).max(axis=1))]


def temporary(claim: Claim) -> Finding:
    """The truly transient part dies out: it falls from each late window to the next, to a small part of its "
    "largest."""
    eta_b, eta_m, alpha = claim.numbers("eta_b", "eta_m", "alpha")
    starts, limit = claim.values("tau"), float(claim.number("limit"))
    parts = {d: late_parts(eta_b, eta_m, alpha, d, starts) for d in claim.values("d")}
    windows = ", ".join(starts)
    numbers = tuple(
        (f"d = {d}: largest, and from τ = {windows}", ", ".join(f"{x:.3g}" for x in found))
        for d, found in parts.items()
    )
    left = max(found[-1] / found[0] for found in parts.values())
    falls = all(before > after for found in parts.values() for before, after in pairwise(found[1:]))
    sentence = (
        f"Undamped at α = {alpha}, η_M = {eta_m}, over τ = {windows} and a quarter longer, the largest value "
        f"{'falls each time' if falls else 'does not always fall'}; from τ = {starts[-1]} on at most "
        f"{100 * left:.2g} % of the largest is left."
    )
    return Finding(Verdict.AGREES if falls and left < limit else Verdict.DISAGREES, sentence, numbers)


_UNDAMPED = {"eta_b": ("0",), "eta_m": ("40",)}

CLAIMS = (
    Claim(
        "fig-A.1-history",
        "Appendix, Figure A.1",
        "η_M = {eta_m}, α = {alpha}: the agreement between the full and harmonic solutions is excellent.",
        excellent,
        {"eta_m": ("40",), "alpha": ("0.5",)},
        {"eta_b": ("0",), "d": ("0.5", "1.5", "3"), "limit": ("0.01",)},
    ),
    Claim(
        "fig-A.2-history",
        "Appendix, Figure A.2",
        "η_M = {eta_m}, α = {alpha}: a noticeable disagreement between the full and harmonic solutions starting from "
        "d̂ = {first}, recovered starting from d̂ = {last}.",
        band,
        {"eta_m": ("40",), "alpha": ("0.9",), "first": ("1.5",), "last": ("3.5",)},
        {"eta_b": ("0",), "d": ("0.5", "1", "1.5", "3", "3.5")},
    ),
    Claim(
        "5-temporary",
        "Section 5",
        "The purpose of the truly transient vibrations is to adjust the initial conditions; their importance "
        "is temporary.",
        temporary,
        {},
        {**_UNDAMPED, "alpha": ("0.9",), "d": DISTANCES, "tau": ("100", "300", "1000", "3000"), "limit": ("0.05",)},
    ),
)
