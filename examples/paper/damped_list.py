"""Section 4.3 and conclusions (iv), (v), (vi), (x) as printed, for `damped` and `spectra`."""

from __future__ import annotations

from mpsolve.claims import Claim, Printed
from mpsolve.claims.values import grid

from .damped import (
    damping_destabilises,
    heavier_decays_slower,
    lighter_masses_stay_stable,
    never_real,
    one_mass_is_supercritical,
    one_mass_onset_grows,
    onsets_on_the_grid,
    stable_and_unstable,
)
from .spectra import (
    always_in_pairs,
    crosses_the_limit,
    cut_at_damping,
    finite_number,
    most_pairs,
    order_with_damping,
    pairs_with_damping,
    subcritical_velocity,
)

_MODEL: Printed = {"eta_b": ("0.05",), "eta_m": ("70",)}
_FIGURE_9 = {"eta_b": ("0.05",), "eta_m": ("10",), "d": grid("1.5:1.5:4.5")}
_DAMPINGS = ("0.04", "0.05", "0.1", "0.2", "0.4", "0.7", "0.99")
_CROWDED = ("0 1.4 70 4.5", "0.05 1.4 70 4.5", "0.7 1.4 10 4.5", "0.99 1.4 10 4.5", "0.99 1.4 70 4.5")

CLAIMS = (
    Claim(
        "4.3-onset", "Section 4.3, Figure 9a",
        "The onset of instability occurs for α < α_c when η_M = {eta_m} (η_b = {eta_b}); that is, at α = {alpha} for "
        "d̂ = {d}, respectively.",
        onsets_on_the_grid, {**_MODEL, "d": ("1", "1.5"), "alpha": ("0.97", "0.67")},
    ),
    Claim(
        "4.3-lighter", "Section 4.3, Figure 9b",
        "η_M = {eta_m}, η_b = {eta_b}, d̂ = {d}: no onset below α_c, where the paper reports one for η_M = 70 only.",
        lighter_masses_stay_stable, _FIGURE_9, {"alpha": ("1",)},
    ),
    Claim(
        "x", "Section 5 (x), abstract",
        "In the damped case, damping can act in the opposite sense and shift the onset of instability into the "
        "{range} range.",
        damping_destabilises, {"range": ("subcritical",)}, {**_MODEL, "d": ("1.5",)},
    ),
    Claim(
        "4.4-one-mass", "Section 4.4, Section 1, Section 3",
        "Damping always shifts the onset of instability to {range} velocities for one moving mass.",
        one_mass_is_supercritical, {"range": ("supercritical",)}, {"eta_b": ("0.05",), "eta_m": ("10", "40", "70")},
    ),
    Claim(
        "4.3-one-mass-damping", "Section 4.3",
        "For one moving mass, a higher η_b results in a larger α for which the onset of instability occurs.",
        one_mass_onset_grows, {}, {"eta_m": ("10", "70"), "eta_b": _DAMPINGS},
    ),
    Claim(
        "iv", "Section 5 (iv), Section 3",
        "In the damped case, the frequency lines are cut when the imaginary part reaches the damping ratio {level}.",
        cut_at_damping, {"level": ("η_b",)}, {**_MODEL, "d": ("1.5",)},
    ),
    Claim(
        "v-pairs-damped", "Section 5 (v)",
        "In the subcritical velocity range, {low} pairs of frequencies exist for a lower α, and only {high} exists "
        "for a higher α (said without excluding damping).",
        pairs_with_damping, {"low": ("2",), "high": ("1",)},
        {"cases": ("0.05 0.5 70 1", "0.3 0.6 10 4.5", "0.3 0.9 10 3", "0.1 0.95 10 0.5")},
    ),
    Claim(
        "v-embedded-damped", "Section 5 (v)",
        "The {which} frequency pair is always embedded between the limiting cases of the single and doubled mass "
        "(said without excluding damping).",
        order_with_damping, {"which": ("lower",)}, {"cases": ("0.05 0.5 40 1", "0.05 0.9 10 1.5", "0.5 0.95 10 1.5")},
    ),
    Claim(
        "vi-outside-damped", "Section 5 (vi)",
        "The {which} frequency pair always lies outside the region specified in (v) (said without excluding "
        "damping).",
        order_with_damping, {"which": ("higher",)}, {"cases": ("0.05 0.5 40 1", "0.2 0.95 70 1.5", "0.5 0.8 70 1.5")},
    ),
    Claim(
        "3-most-pairs", "Section 3",
        "In all cases examined until α = 1.4, the maximum number of pairs is {pairs}.",
        most_pairs, {"pairs": ("4",)}, {"cases": _CROWDED, "searched": ("0", "0.05", "0.3"), "top": ("1.4",)},
    ),
    Claim(
        "3-pairs", "Section 3",
        "The roots always exist in pairs; if q_M1 is a root, q_M2 = (−q_M1)* is also a root.",
        always_in_pairs, {}, {**_MODEL, "alpha": ("1.4",), "d": ("1.5",)},
    ),
    Claim(
        "3-finite", "Section 3, Section 5",
        "The number of roots of det = 0 is finite.",
        finite_number, {}, {"cases": _CROWDED[:3]},
    ),
    Claim(
        "4.3-imaginary", "Section 4.3",
        "In the damped case the imaginary part of the induced frequency is always non-zero.",
        never_real, {}, {**_MODEL, "d": ("1.5",)},
    ),
    Claim(
        "4.3-crosses-q_lm", "Section 4.3",
        "In contrast to the undamped case, the first branch of the limiting frequency q_lm can be crossed by the "
        "real part of the induced frequency.",
        crosses_the_limit, {}, {**_MODEL, "d": ("1",), "alpha": ("0.5", "0.97")},
    ),
    Claim(
        "fig-11-unstable", "Section 4.3, Figure 11; Figures A.3 to A.5",
        "η_M = {eta_m}, η_b = {eta_b}, d̂ = {d}, α = {alpha}: the instability is identified in the final graphs of "
        "b) and c), that is at (α d̂) = {unstable}.",
        stable_and_unstable,
        {**_MODEL, "d": ("0.5:0.5:1.5",), "alpha": ("0.5", "0.8", "0.9"), "unstable": ("0.8 1.5", "0.9 1.5")},
    ),
    Claim(
        "fig-11-decay", "Section 4.3, after Figure 11",
        "The decrease in the amplitudes is slower for a higher η_M (η_M = {eta_m}, α = {alpha}).",
        heavier_decays_slower, {"eta_m": ("10", "70"), "alpha": ("0.5", "0.8", "0.9")},
        {"eta_b": ("0.05",), "d": ("0.5", "1", "1.5", "3", "4.5")},
    ),
    Claim(
        "4.3-subcritical", "Section 4.3, Figure 10",
        "α = {alpha} is a subcritical velocity for η_b = {eta_b}.",
        subcritical_velocity, {"alpha": ("0.99",), "eta_b": ("0.04:0.01:0.99",)},
    ),
)  # fmt: skip
