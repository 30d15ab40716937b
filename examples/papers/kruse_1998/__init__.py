"""What the summary of Kruse, Metrikine and Popp 1998 says of a two-mass oscillator on a string, for `mpsolve audit`.

The full text was not at hand: the parameters are ours, and each finding names them.
"""

from __future__ import annotations

from mpsolve.claims import Claim, Paper

from .checks import not_unique, one_or_two

CLAIMS = (
    Claim(
        "one-or-two", "Summary",
        "On an elastic foundation the oscillator has one or two real positive eigenfrequencies, by its parameters.",
        one_or_two, {}, {"wheel": ("0.1", "1", "5", "5"), "k": ("0.2", "1", "0.2", "5"), "v": ("0.2", "0.7")},
    ),
    Claim(
        "not-unique", "Summary",
        "With viscosity the eigenfrequencies of attenuating vibrations are not uniquely determined.",
        not_unique, {}, {"wheel": ("1",), "k": ("1",), "c": ("0.56",), "v": ("0.6",)},
    ),
)  # fmt: skip

PAPER = Paper(
    "A two-mass oscillator on a string",
    "Kruse, Metrikine and Popp, J. Sound Vib. 218 (1998) 103–116",
    CLAIMS,
    notation=(
        "The claims are told in our words. Units in which the string has T = m = 1 and its foundation k = 1; c is "
        "its viscosity, v the velocity (waves: 1), and the oscillator a wheel under a body of mass 1 on a spring k. "
        "The string answers a force under it with the stiffness 2 √(b² − (q − ic/2)²), b² = (1 − v²)(1 − c²/4)."
    ),
)
