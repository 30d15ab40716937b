"""Figures 3 to 8, A.1 to A.5 and conclusions (vii), (ix) as printed, for `motion`."""

from __future__ import annotations

from mpsolve.claims import Claim
from mpsolve.claims.values import grid

from .motion import (
    agreement_is_excellent,
    damping_does_not_matter,
    differences_by_distance,
    differences_by_mass,
    disagreement_band,
    higher_pair_matters,
    influence_grows,
    minimum_vanishes,
    misled_by_one_velocity,
    usually_omitted,
)

_FIGURE_3 = {"eta_m": ("70",), "d": ("0.5:0.5:1.5",), "alpha": ("0.5", "0.8", "0.9")}

CLAIMS = (
    Claim(
        "vii", "Section 5 (vii)",
        "The higher frequency pair in the subcritical velocity range can significantly vary the amplitudes of the "
        "unsteady harmonic vibration.",
        higher_pair_matters, {}, {"alpha": ("0.9",), "eta_m": ("70",), "d": ("1.5",)},
    ),
    Claim(
        "fig-3", "Section 4.2, after Figure 3",
        "η_M = {eta_m}, d̂ = {d}, α = {alpha}: by increasing d̂ and α, the influence of the second induced frequency "
        "pair increases.",
        influence_grows, _FIGURE_3,
    ),
    Claim(
        "fig-7", "Section 4.2, Figure 7",
        "η_M = {eta_m}: there may exist α for which the minimum value of the envelope is practically zero.",
        minimum_vanishes, {"eta_m": ("40",)}, {"d": ("4",), "alpha": ("0.5", "0.8")},
    ),
    Claim(
        "4.2-misled", "Section 4.2",
        "At α = {alpha} (η_M = 74.1) and a small distance the higher pair is negligible; at a large one it is not.",
        misled_by_one_velocity, {"alpha": ("0.34",)},
        {"elsewhere": ("0.344",), "eta_m": ("74.1",), "d": ("0.445", "1.335", "4.45"), "limit": ("0.05",)},
    ),
    Claim(
        "ix-mass", "Section 5 (ix)",
        "The differences between the full and harmonic solutions increase with a decreasing η_M in the "
        "vicinity of α_c.",
        differences_by_mass, {},
        {"alpha": ("0.9", "0.95", "0.99"), "eta_m": ("10", "40", "70"), "d": grid("0.5:0.5:4.5")},
    ),
    Claim(
        "ix-distance", "Section 5 (ix), Section 4.1",
        "The differences increase with an increasing d̂ up to a particular limit, following which the agreement is "
        "recovered.",
        differences_by_distance, {},
        {"alpha": ("0.9",), "eta_m": ("10", "40", "70"), "d": grid("0.5:0.5:4.5")},
    ),
    Claim(
        "ix-excellent", "Section 5 (ix), Figure A.1",
        "η_M = {eta_m}, α = {alpha}, d̂ = {d}: the agreement between the full and harmonic solutions is excellent.",
        agreement_is_excellent, {"eta_m": ("40",), "alpha": ("0.5",), "d": ("0.5:0.5:4.5",)},
        {"eta_b": ("0",), "limit": ("0.01",)},
    ),
    Claim(
        "fig-A.2", "Appendix, Figure A.2",
        "η_M = {eta_m}, α = {alpha}, d̂ = {d}: a noticeable disagreement between the full and harmonic solutions "
        "starting from d̂ = {first}, recovered starting from d̂ = {last}.",
        disagreement_band,
        {"eta_m": ("40",), "alpha": ("0.9",), "d": ("0.5:0.5:4.5",), "first": ("1.5",), "last": ("3.5",)},
    ),
    Claim(
        "fig-A.3-5", "Appendix, Figures A.3 to A.5",
        "η_M = {eta_m}, η_b = {eta_b}, α = {alpha}, d̂ = {d}: all cases show excellent agreement between the full "
        "and harmonic solutions.",
        agreement_is_excellent,
        {"eta_m": ("70",), "eta_b": ("0.05",), "alpha": ("0.5", "0.8", "0.9"), "d": ("0.5:0.5:1.5",)},
        {"limit": ("0.05",)},
    ),
    Claim(
        "5-not-damping", "Section 5",
        "The importance of the truly transient vibrations can be evaluated by the difference at zero time, and it is "
        "therefore not affected by damping or other factors.",
        damping_does_not_matter, {},
        {"alpha": ("0.9",), "eta_m": ("70",), "d": ("1",), "eta_b": ("0", "0.05", "0.3")},
    ),
    Claim(
        "4.1-omitted", "Section 4.1, Section 5",
        "The truly transient vibrations can be omitted in most cases.",
        usually_omitted, {},
        {"alpha": ("0.1", "0.3", "0.5", "0.7", "0.9"), "eta_m": ("10", "40", "70"), "d": ("0.5", "1.5", "3", "4.5"),
         "eta_b": ("0",), "limit": ("0.05",)},
    ),
)  # fmt: skip
