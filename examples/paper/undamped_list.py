"""Section 4.2 and conclusions (i), (ii), (iii), (v), (vi) as printed, for `undamped`."""

from __future__ import annotations

from collections.abc import Callable

from mpsolve.claims import Claim, Finding, Printed

from .cases import DISTANCES, MASSES
from .supercritical import four_signs, one_mass_onset_at_critical, onset_at_critical
from .undamped import (
    closer_with_distance,
    cut_at_the_limit,
    embedded,
    ends_by_distance,
    ends_by_mass,
    last_velocities,
    only_one_pair,
    two_pairs_then_one,
)

_LAST = "η_M = {eta_m}: the final α with both frequency pairs is α = {alpha} for d̂ = {d}, respectively."


def _last(name: str, place: str, eta_m: str, d: str, alpha: str) -> Claim:
    return Claim(name, place, _LAST, last_velocities, {"eta_m": (eta_m,), "d": (d,), "alpha": tuple(alpha.split())})


def _claim(
    name: str,
    place: str,
    words: str,
    check: Callable[[Claim], Finding],
    at: Printed | None = None,
    **printed: tuple[str, ...],
) -> Claim:
    return Claim(name, place, words, check, printed, at or {})


_SIGNS = ("1.05", "1.2", "1.4")

CLAIMS = (
    _claim(
        "i", "Section 5 (i), Section 4.2, abstract",
        "In the undamped case, instability occurs exactly at the critical velocity.",
        onset_at_critical, at={"eta_m": MASSES, "d": DISTANCES, "alpha": ("1.4",)},
    ),
    _claim(
        "i-one-mass", "Section 5 (i), Section 3, abstract",
        "In the undamped case, one moving mass becomes unstable exactly at the critical velocity, too.",
        one_mass_onset_at_critical, at={"eta_m": ("10", "20", "40", "70", "80", "140"), "alpha": ("1.4",)},
    ),
    _claim(
        "ii", "Section 5 (ii)", "In the undamped case, the frequency lines are cut in the subcritical velocity range "
        "when the real part reaches the limiting frequency {limit}.", cut_at_the_limit, limit=("q_lm",),
    ),
    _claim(
        "iii", "Section 5 (iii)", "In the undamped case, each induced frequency appears with all four sign "
        "combinations of the real and imaginary parts in the supercritical velocity range.", four_signs,
        at={"alpha": _SIGNS, "eta_m": MASSES, "d": DISTANCES},
    ),
    _claim(
        "v-pairs-undamped", "Section 5 (v), Section 4.2", "In the subcritical velocity range, {low} pairs of "
        "frequencies exist for a lower α, and only {high} exists for a higher α (undamped).", two_pairs_then_one,
        low=("2",), high=("1",),
    ),
    _claim(
        "v-embedded-undamped", "Section 5 (v), (vi), Section 4.2", "The lower frequency pair is always {lower} the "
        "limiting cases of the single and doubled mass; the higher pair always lies {higher} this region (undamped).",
        embedded, lower=("between",), higher=("outside",),
    ),
    _claim(
        "v-distance", "Section 5 (v), Section 4.2", "A smaller distance between the masses results in the frequency "
        "line being closer to that of the doubled mass, a greater distance closer to that of the single "
        "mass.", closer_with_distance, at={"alpha": ("0.01", "0.3")},
    ),
    _claim(
        "vi-mass", "Section 5 (vi), Section 4.2", "In the absence of damping, a lower η_M results in a {way} α when "
        "the higher line is cut by q_lm.", ends_by_mass, way=("lower",),
    ),
    _claim(
        "vi-distance", "Section 5 (vi), Section 4.2", "In the absence of damping, a lower d̂ results in a lower α "
        "when the higher line is cut by q_lm.", ends_by_distance,
    ),
    _last("4.2-final-40-near", "Section 4.2, after Figure 3", "40", "0.5:0.5:1.5", "0.74 0.86 0.87"),
    _last("4.2-final-40-far", "Section 4.2, after Figure 6", "40", "2:0.5:4.5", "0.87 0.88 0.89 0.90 0.90 0.90"),
    _last("4.2-final-10", "Section 4.2, before Figure 8", "10", "0.5:0.5:1.5", "0.37 0.66 0.72"),
    _claim(
        "fig-6-constant", "Section 4.2, after Figure 6", "η_M = {eta_m}, α = {alpha}, d̂ = {d}: the first three "
        "graphs in Figure 6 (d̂ = {alone}) have constant amplitudes.", only_one_pair,
        eta_m=("40",), alpha=("0.9",), d=("2:0.5:4.5",), alone=("2", "2.5", "3"),
    ),
    _claim(
        "fig-8-variable", "Section 4.2, before Figure 8", "η_M = {eta_m}, α = {alpha}, d̂ = {d}: the final two "
        "graphs have variable amplitudes (constant only for d̂ = {alone}).", only_one_pair,
        eta_m=("10",), alpha=("0.5",), d=("0.5:0.5:1.5",), alone=("0.5",),
    ),
)  # fmt: skip
