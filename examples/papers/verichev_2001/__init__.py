"""What is said of an oscillator (2001) and a bogie (2002) on a Timoshenko beam, for `mpsolve audit`.

The full texts were not at hand: the claims are told in our words, the parameters are ours, a 60E1 rail on a soft
foundation. The last claim stands in neither summary; it is the converse that a reader may take from them.
"""

from __future__ import annotations

from mpsolve.claims import Claim, Paper

from .checks import bogie_below, bogie_grows, domains, grows

CLAIMS = (
    Claim(
        "2001-growth", "2001, summary",
        "The characteristic equation may have a root with a positive real part, and then the vibrations grow.",
        grows, {}, {"v": ("350",), "wheel": ("5000",)},
    ),
    Claim(
        "2001-domains", "2001, summary",
        "The parameters of the oscillator have domains of instability.",
        domains, {},
        {"v": ("320",), "wheel": ("100", "20000"), "k": ("1000", "1e7"), "c": ("100", "1e6")},
    ),
    Claim(
        "2002-growth", "2002, title",
        "A bogie may be unstable, too.",
        bogie_grows, {}, {"v": ("350",), "wheel": ("1000",)},
    ),
    Claim(
        "2002-below", "in neither summary",
        "A bogie is unstable only beyond the least velocity at which a wave of the track can run with it.",
        bogie_below, {}, {"v": ("240", "270"), "wheel": ("10000",)},
    ),
)  # fmt: skip

PAPER = Paper(
    "An oscillator and a bogie on a Timoshenko beam",
    "Metrikine and Verichev, Arch. Appl. Mech. 71 (2001) 613–624, doi:10.1007/s004190100177; Verichev and Metrikine, "
    "J. Sound Vib. 253 (2002) 653–668, doi:10.1006/jsvi.2001.4069",
    CLAIMS,
    notation=(
        "The claims are told in our words, the parameters are ours, in SI units. Rail: EI = 6.4e6 N m², m = 60 kg/m, "
        "shear stiffness 2.5e8 N, rotary inertia 0.24 kg m; foundation k = 1e6 N/m², c = 770 N s/m², a twentieth of "
        "the critical 2√(k m). Oscillator: wheel, and a body of 10 t on k = 1e6 N/m, c = 1e4 N s/m. Bogie: two "
        "wheels 3.4 m apart, each on such a suspension under a frame of 3 t and 3000 kg m²."
    ),
)
