"""What the summary of Metrikine and Dieterman 1997 says of one mass on a compressed beam, for `mpsolve audit`.

The full text was not at hand: the parameters are ours, and each finding names them.
"""

from __future__ import annotations

from mpsolve.claims import Claim, Paper

from .checks import falls, falls_between, grows, no_resonance, overcritical, starts

_MASS = {"M": ("10",)}
_LIGHT = {"c": ("0.2",)}  # a tenth of the critical viscosity 2√(k m) = 2
_HEAVY = {"c": ("2", "3")}  # the critical one, and one and a half times as much

CLAIMS = (
    Claim(
        "onset", "Summary",
        "There is a velocity from which on the vibrations are unstable.",
        starts, {}, _MASS | _LIGHT | {"v": ("0", "3")},
    ),
    Claim(
        "growth", "Summary",
        "Unstable means that the amplitude of the mass grows exponentially.",
        grows, {}, _MASS | _LIGHT | {"v": ("1.5",)},
    ),
    Claim(
        "compression", "Summary",
        "Instability starts at lower velocities as the compression grows.",
        falls, {}, _MASS | _LIGHT | {"v": ("0", "2"), "N": ("0", "0.25", "0.5", "0.75")},
    ),
    Claim(
        "compression-all", "Summary",
        "At a velocity at which compression makes the mass unstable, more of it never makes it stable again.",
        falls_between, {}, _MASS | _LIGHT | {"v": ("0.8", "1", "1.2"), "N": ("0", "0.9")},
    ),
    Claim(
        "overcritical", "Summary",
        "Instability occurs even where the foundation is overcritically viscous.",
        overcritical, {}, _MASS | _HEAVY | {"v": ("0", "3")},
    ),
    Claim(
        "overcritical-amplification", "Summary",
        "With such a viscosity a steady load is not amplified at any velocity.",
        no_resonance, {}, _HEAVY | {"c_light": ("0.2",), "v": ("0:0.05:3",)},
    ),
)  # fmt: skip

PAPER = Paper(
    "One mass on an axially compressed beam",
    "Metrikine and Dieterman, J. Sound Vib. 201 (1997) 567–576, doi:10.1006/jsvi.1996.0783",
    CLAIMS,
    notation=(
        "The claims are told in our words. Units in which the beam has EI = 1/4 and m = 1, its foundation k = 1: "
        "v = 1 is then the critical velocity of a constant force without compression, N = 1 the force that buckles "
        "the beam, c = 2 the critical viscosity 2√(k m); M is the mass over m times the unit of length, "
        "(4 EI/k)^(1/4)."
    ),
)
