"""The sentences that are tried, word for word as the paper prints them, where a claim states them in its own words.

"…" marks what is left out between them. Symbols stand for the paper's typesetting, everything else is its text.
"""

from __future__ import annotations

_UNDAMPED_PAIRS = "two pairs of frequencies exist for a lower α, and only one exists for a higher α."
_EMBEDDED = "The lower frequency pair is always embedded between the limiting cases of the single and doubled mass."
_OUTSIDE = "The higher frequency pair always lies outside the region specified in (v)."
_CUT = "the corresponding frequency line is cut by the first branch of the limiting frequency q_lm."
_SMOOTH = (
    "The critical distance between moving masses, defined as the distance for which the imaginary part of one of the "
    "induced frequencies is the lowest, is practically constant and only smoothly dependent on the damping: the "
    "dimensionless value changes smoothly from 1.25 to 1.05 within the damping range of η_b = 0.04 : 0.01 : 0.99."
)
_LAST = "is α = {} for d̂ = 0.5:0.5:1.5, respectively"
_TWELVE = (
    "In Figure 12, the damped case with η_b = 0.05 one moving mass is compared to two moving masses separated by "
    "d̂ = 1:0.25:2."
)
_CAPTION_12 = (
    "Velocity at onset of instability for one and two moving masses as function of η_M for η_b = 0.05 and "
    "d̂ = 0.5:0.5:1.5."
)
_CROSS = "All presented curves cross the limit of α = 1."
_CAPTION_2 = (
    "Induced frequencies: a) η_M = 70, d̂ = 0.5:0.5:1.5; b) η_M = 40, d̂ = 0.5:0.5:1.5; c) η_M = 40, d̂ = 2:0.5:4.5; "
    "d) η_M = 40, d̂ = 2:0.5:4.5; e) η_M = 10, d̂ = 0.5:0.5:1.5"
)
_CAPTION_3 = (
    "Unsteady harmonic part of vibrations for η_M = 70 and d̂ = 0.5:0.5:1.5: a) α = 0.5; b) α = 0.8; c) α = 0.9"
)
_CAPTION_7 = "Maximum and minimum of function envelopes for η_M = 40 and d̂ = 0.5:0.5:4.5."
_CAPTION_8 = "Unsteady harmonic part of vibrations for η_M = 10, d̂ = 0.5:0.5:1.5, and α = 0.5."
_CAPTION_9 = (
    "Induced frequencies in damped case for η_b = 0.05: a) η_M = 70, d̂ = 0.5:0.5:1.5; b) η_M = 10, d̂ = 1.5:1.5:4.5"
)
_CAPTION_11 = (
    "Unsteady harmonic part of vibrations for η_M = 70, η_b = 0.05, and d̂ = 0.5:0.5:1.5: a) α = 0.5; b) α = 0.8; "
    "c) α = 0.9"
)
_SELECTED = "Three velocity ratios are selected: α = 0.5; 0.8; 0.9."
_FURTHER = "η_M = 40 is tested further for larger distances, as reported in Figures 4 to 6."
_FAR = (
    "The final α with both frequency pairs are α = 0.87; 0.88; 0.89; 0.90; 0.90; 0.90 for d̂ = 2:0.5:4.5, respectively"
)
_TEN = "For η_M = 10 and d̂ = 0.5:0.5:1.5, the final α values with both frequency pairs are only α = 0.37; 0.66; 0.72"
_CASES_11 = (
    "Only certain cases are selected for a fixed η_b = 0.05, namely η_M = 70 with d̂ = 0.5:0.5:1.5 (Figure 11), "
    "because for η_M = 10 with d̂ = 1.5:1.5:4.5, the unsteady part of the vibrations is rapidly damped."
)
_UNDAMPED_A = "Only cases with η_M = 40, α = 0.5 or α = 0.9, and d̂ = 0.5 : 0.5 : 4.5 are shown for illustration."
_UNSTABLE_A = "Unstable cases are clearly identified and validated in last graphs of Figures A.4–5."
_EXCELLENT_A = (
    "It can be concluded from Figure A.1 that the agreement between the full and harmonic solutions is excellent"
)
_BAND_A = (
    "it is shown in Figure A.2 that there is a noticeable disagreement between the full and harmonic solutions "
    "starting from d̂ = 1.5, however, the agreement is recovered starting from d̂ = 3.5."
)
_DIFFERENCES = (
    "The differences increase with a decreasing η_M in the vicinity of α_c and with an increasing d̂ up to a "
    "particular limit, following which the agreement is recovered."
)


def _appendix(alpha: str, rest: str) -> str:
    return f"{_UNDAMPED_A} … Vibration comparison for η_M = 40, α = {alpha} and d̂ = {rest}"


def _far(alpha: str) -> str:
    return (
        f"{_FURTHER} … Unsteady harmonic part of vibrations for η_M = 40, α = {alpha}, and d̂ = 2:0.5:4.5 (black "
        f"dotted lines indicate function envelopes). … {_FAR}"
    )


QUOTES = {
    "i-one-mass": "In the undamped case, instability occurs exactly at the critical velocity, as for that of one "
    "moving mass.",
    "v-pairs-undamped": f"In the subcritical velocity range, {_UNDAMPED_PAIRS}",
    "v-pairs-damped": f"In the subcritical velocity range, {_UNDAMPED_PAIRS}",
    "v-embedded-undamped": f"{_EMBEDDED} … {_OUTSIDE}",
    "v-embedded-damped": _EMBEDDED,
    "vi-outside-damped": _OUTSIDE,
    "v-distance": "A smaller distance between the masses results in the frequency line being closer to that of the "
    "doubled mass. A greater distance between the masses results in the frequency line being closer to that of the "
    "single mass.",
    "vi-mass": f"In the absence of damping, {_CUT} A lower η_M or d̂ results in a lower α when this occurs.",
    "vi-distance": f"In the absence of damping, {_CUT} A lower η_M or d̂ results in a lower α when this occurs.",
    "4.2-final-40-near": "This occurs for η_M = 40, where the higher frequency line is cut for a lower α; that is, "
    f"the final α with both frequency pairs {_LAST.format('0.74; 0.86; 0.87')}.",
    "4.2-final-40-far": f"{_FAR}",
    "4.2-final-10": f"{_TEN} for d̂ = 0.5:0.5:1.5, respectively",
    "fig-6-constant": f"{_FAR}, and thus, the first three graphs in Figure 6 have constant amplitudes.",
    "fig-8-variable": "thus, only the case of α = 0.5 is presented in Figure 8, with the final two graphs of "
    "variable amplitudes.",
    "4.3-onset": "The difference is that the onset of instability occurs for α < α_c when η_M = 70; that is, at "
    "α = 0.97 and α = 0.67 for d̂ = 1 and d̂ = 1.5, respectively.",
    "4.3-lighter": f"{_CAPTION_9} … The difference is that the onset of instability occurs for α < α_c when η_M = 70",
    "3-most-pairs": "Nevertheless, in all cases examined until α = 1.4, the maximum number of pairs is four.",
    "3-pairs": "As with one moving mass, the roots always exist in pairs; that is, if q_M1 is a root, "
    "q_M2 = (-q_M1)* is also a root",
    "3-finite": "The number of roots of det = 0 is not known a priori, but it is carefully verified by the argument "
    "principle in all tested examples until α = 1.4 that this number is finite.",
    "4.3-imaginary": "In contrast to the undamped case, the first branch of the limiting frequency q_lm can be "
    "crossed by the real part of the induced frequency because the imaginary part is always non-zero.",
    "fig-11-unstable": "The instability is clearly identified in the final graphs Figures 11b) and c). … "
    f"{_UNSTABLE_A}",
    "fig-11-decay": "It can be concluded that the decrease in the amplitudes is slower for a higher η_M.",
    "4.3-subcritical": "By analyzing one particular subcritical velocity α = 0.99 with η_M = 70 as a function of "
    "η_b = 0.04:0.01:0.99",
    "xi": _SMOOTH,
    "xi-smooth-low": _SMOOTH,
    "xi-smooth-high": _SMOOTH,
    "xi-window": _SMOOTH,
    "4.3-limit": "if the moving masses are at the critical distance, instability occurs in the subcritical velocity "
    "range even for a relatively low η_M and typical η_b; e.g., η_M = 21.9 and η_b = 0.1.",
    "fig-12-text": f"{_TWELVE} … {_CROSS}",
    "fig-12-caption": f"{_CAPTION_12} … {_CROSS}",
    "fig-12-order": "With proximate masses, damping can act oppositely and shift the onset of instability "
    f"significantly into the subcritical range. … {_TWELVE}",
    "4.4-method": "it suffices to assume that there exists an induced frequency with a very low but negative "
    "imaginary part. Subsequently, it is possible to repeat the analysis for the same but positive value to "
    "confirm that the results obtained are practically unchanged, and therefore, the crossing of the imaginary "
    "axis has been detected correctly.",
    "fig-3": f"{_CAPTION_3} … It can be concluded from Figure 3 that by increasing d̂ and α, the influence of the "
    "second induced frequency pair increases",
    "fig-7": "the maximum and minimum of the function envelopes are plotted as a function of α for η_M = 40 and "
    "d̂ = 0.5:0.5:4.5. … It can be concluded that there may exist α for which the minimum value is practically "
    "zero, but no general trend is observed.",
    "4.2-misled": "the masses can be replaced by one doubled mass. However, it is demonstrated that this is not "
    "generally true. The previous conclusion was misled by the constant relatively low α = 0.34 and low time "
    "interval analyzed, and therefore, the additional changes in amplitudes that were imposed by the higher "
    "frequency were negligible.",
    "ix-mass": _DIFFERENCES,
    "ix-distance": _DIFFERENCES,
    "ix-excellent": _EXCELLENT_A,
    "fig-A.1-history": _EXCELLENT_A,
    "fig-A.2": _BAND_A,
    "fig-A.2-history": _BAND_A,
    "fig-A.3-5": "All cases show excellent agreement between the full and harmonic solutions, as it is usual for "
    "higher η_M.",
    "5-temporary": "the purpose is to adjust the initial conditions to the harmonic solution; their importance is "
    "temporary.",
    "fig-2": _CAPTION_2,
    "fig-3-list": f"{_SELECTED} … {_CAPTION_3}",
    "fig-4-list": _far("0.5"),
    "fig-5-list": _far("0.8"),
    "fig-6-list": _far("0.9"),
    "fig-8-list": f"{_TEN} for d̂ = 0.5:0.5:1.5, respectively, and thus, only the case of α = 0.5 is presented in "
    f"Figure 8 … {_CAPTION_8}",
    "fig-12": f"{_TWELVE} … {_CAPTION_12}",
    "fig-9a": f"{_CAPTION_9} … {_CASES_11}",
    "fig-9b": f"{_CAPTION_9} … {_CASES_11}",
    "fig-11": f"{_CASES_11} … {_CAPTION_11}",
    "fig-7-list": f"{_CAPTION_7} … are plotted as a function of α for η_M = 40 and d̂ = 0.5:0.5:4.5.",
    "fig-10a": "as a function of η_b = 0.04:0.01:0.99 … within the damping range of η_b = 0.04 : 0.01 : 0.99.",
    "fig-A.1-list": _appendix("0.5", "0.5:0.5:4.5"),
    "fig-A.2-list": _appendix("0.9", "0.5 : 0.5 : 4.5"),
    "fig-A.3-5-list": f"{_CAPTION_11} … Vibration comparison for η_M = 70, α = 0.5, η_b = 0.05, d̂ = 0.5:0.5:1.5 … "
    "Vibration comparison for η_M = 70, α = 0.8, η_b = 0.05, d̂ = 0.5:0.5:1.5 … Vibration comparison for η_M = 70, "
    f"α = 0.9, η_b = 0.05, d̂ = 0.5:0.5:1.5 … {_UNSTABLE_A}",
    "fig-A-doubled": "In addition, solutions related to one doubled mass are included, but only when the distance "
    "between masses is low. … dashed – doubled mass, omitted for d̂ = 1.5 and larger due to large discrepancies … For "
    "distances between masses below d̂ = 1.5, also solution for doubled mass is added.",
    "4.1-distances": "the case analyzed in [39] is described by χ = 0.445m⁻¹, α = 0.344, and η_M = 74.1. The tested "
    "distances range from d̂ = 1χ = 0.455 to d̂ = 10χ = 4.45.",
    "4.1-velocity": "the case analyzed in [39] is described by χ = 0.445m⁻¹, α = 0.344, and η_M = 74.1. … The "
    "previous conclusion was misled by the constant relatively low α = 0.34 … restricted to one velocity ratio α = "
    "0.344.",
    "4.1-reference": "Although very high values of η_b are obviously not realistic in practical applications, these "
    "values are important for the instability analysis, as explained later in Section 4.2.",
    "3-frequency": "the frequency of the specified infinite beam, independently of the Pasternak modulus and axial "
    "force, is ω_inf = √(k/m)",
    "3-buckling": "where N_cr represents the buckling critical force",
    "3-doubled": "because all roots of D(p, q) are duplicated.",
    "3-alpha_C": "It should be noted that in the undamped case, α_cr,ex = α_C.",
    "3-static": "is the maximum static displacement caused by the constant force P_C1 that is applied to the beam on "
    "Winkler's foundation k",
    "4.1-symmetry": "It should be noted that matrices C(t) and K(t) are not symmetrical",
    "5-more-frequencies": "the characteristic equation is more complicated, and the number of induced frequencies is "
    "higher than the one moving mass case.",
    "1-interval": "Instability velocities are not single velocities but constitute an interval, and the lowest one "
    "can be identified as the velocity at which the onset of instability occurs.",
    "4.3-no-duplication": "In the damped case, there is no duplication, and each frequency that is plotted "
    "represents only one frequency pair.",
    "4.3-rapidly": _CASES_11,
    "vi-cut-damped": "In the damped case, the corresponding frequency line is also usually cut when the imaginary "
    "part reaches η_b, but no general conclusions can be drawn in such a case.",
    "viii-superposition": "In general, result superposition is not possible unless the masses are far apart, with a "
    "distance of at least d̂ = 4.5, which is the highest value considered in this study.",
    "4.2-superposition": "even for d̂ = 4.5, the dynamic interaction between the two masses is not negligible, and "
    "result superposition cannot be used.",
    "ix-superposition": "For a large distance between masses, superposition would be possible",
    "eq-31": "where a is a convenient positive number that ensures that all singularities are located to the right "
    "from the integration line",
    "eq-26-one-place": "which is reduced to the characteristic equation of η_M = η_M1 + η_M2 for d̂ = 0, as expected.",
    "eq-33-damped": "It is determined that, for η_b < 1, there is a limiting velocity α_c … in the special case of "
    "η_N = η_S, which also includes the case when both parameters are null, a simple relation exists between q_lm "
    "and α for both branches",
}  # fmt: skip
