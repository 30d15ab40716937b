"""What summaries of Dimitrovová 2023 and 2025 say of tracks of two and three layers, for `mpsolve audit`.

Only the summaries are on trial, in our words. They give no numbers: the parameters are ours, and each finding names
them.
"""

from __future__ import annotations

from mpsolve.claims import Claim, Paper

from .checks import finite, missing, one_mass, two_layer_irregular, two_masses

_STIFF = {"k_pad": ("3e8",), "m_sleeper": ("250",), "k_ballast": ("1e8",)}

CLAIMS = (
    Claim(
        "missing", "2025, abstract",
        "Three layers should give three critical velocities; in many cases some of them are missing.",
        missing, {},
        {"k_ballast": ("1e8", "2e8", "1e8", "1e7"), "k_ground": ("5e7", "2e7", "1e6", "1e7"),
         "m_ballast": ("500", "800", "1500", "800"), "shear": ("0", "1e7")},
    ),
    Claim(
        "finite", "2025, abstract",
        "Where one is missing there is no resonance: deflections stay finite, even without damping.",
        finite, {}, {"v": ("150", "300", "450", "600", "750", "900"), "c": ("1000", "100", "10")},
    ),
    Claim(
        "two-layer-force", "2023, abstract",
        "On two layers some parameters give irregular critical velocities of a constant force.",
        two_layer_irregular, {},
        {"k_pad": ("3e8", "1e8", "1e9"), "m_sleeper": ("250", "500", "250"), "k_ballast": ("1e8", "1e7", "1e7")},
    ),
    Claim(
        "two-layer-mass", "2023, abstract",
        "On two layers the instability of one moving mass may be irregular.",
        one_mass, {}, _STIFF | {"M": ("500", "5000"), "c": ("1e4",), "v": ("300", "1700")},
    ),
    Claim(
        "two-layer-masses", "2023, abstract",
        "On two layers the instability of two moving masses may be irregular.",
        two_masses, {}, _STIFF | {"M": ("500",), "c": ("1e4",), "v": ("500", "900", "1100", "1600"), "gap": ("2",)},
    ),
)  # fmt: skip

PAPER = Paper(
    "Critical velocities and instability on layered tracks",
    "Dimitrovová, Appl. Sci. 13 (2023) 12356, doi:10.3390/app132212356; "
    "Dimitrovová, Infrastructures 10 (2025) 200, doi:10.3390/infrastructures10080200",
    CLAIMS,
    notation=(
        "The claims are told in our words, the parameters are ours, in SI units: a rail of EI = 6.4e6 N m², m = 60 "
        "kg/m; pads k_pad, sleepers m_sleeper, ballast k_ballast, per metre; a third layer m_ballast on k_ground, "
        "with the shear stiffness `shear` along the track. A critical velocity is one at which the undamped track "
        "has a double real wavenumber under a constant force: greatest values of the phase velocity count beside "
        "least ones, and so does the velocity of shear waves. For pseudo-critical velocities, which the summary does "
        "not define, the claim on finite deflections is tried at all velocities between the critical ones."
    ),
)
