"""A small paper: what right, wrong, computed and stuck claims come to, in the time of one spectrum."""

from mpsolve.claims import Claim, Paper

from .checks import count, guess, stuck

_AT = {"eta_m": ("10",)}

PAPER = Paper(
    "One mass & its <roots>",
    "Nobody, one mass",
    [
        Claim("i-a", "Section 1", "There are {roots} roots.", count, {"roots": ("2",)}, _AT),
        Claim("i-b", "Section 1", "There are {roots} roots.", count, {"roots": ("3",)}, _AT),
        Claim("ii", "Section 2", "About {roots}.", guess, {"roots": ("2", "3")}),
        Claim("iii", "Section 3", "Nobody knows.", stuck),
    ],
    quotes={"i-a": "Two roots were found."},
    notation="A root is a root.",
    slow=("ii",),
)
