"""What a reader of the page can do about a part that is open, in place of the remedies meant for library users."""

from __future__ import annotations

import re

_FOR_LIBRARY = re.compile(
    r"(?:shorten the range of alpha|prove it in parts, over shorter ranges|start (?:above it|from alpha = 0\.001)"
    r"|ask for (?:more|fewer) digits(?:, so that clusters come apart, or for a rectangle)?"
    r'|change a parameter a little, or ask for another region \("unstable", a Rectangle\)'
    r"|raise (?:the (?:precision|effort)|max_pieces)|certify (?:single cases|other positions one by one))"
)
_ONSET = "mpsolve onset FILE --all --from A --to B"
ADVICE = {
    "roots": "change a value of the file a little, or try mpsolve certify FILE --digits 100, or one with "
    "--region unstable, or a small --region=RE_MIN,RE_MAX,IM_MIN,IM_MAX",
    "velocity": f"try a shorter range of α with {_ONSET}",
    "mass": "try mpsolve crossings FILE --digits 60, or decide single sizes with mpsolve certify on copies of the "
    "file with other masses",
    "distance": "decide single distances with mpsolve certify on copies of the file with other positions",
    "lines": "decide single velocities with mpsolve certify on copies of the file with another velocity",
    "chart": f"try a shorter range of α with {_ONSET}, on a copy of the file with the masses times this factor",
}
ADVICE["response"] = ADVICE["roots"]


def for_reader(reason: str, part: str) -> str:
    """The reason with what helps on the command line; `part` is a key of `ADVICE`, FILE the input of the page."""
    return _FOR_LIBRARY.sub(ADVICE[part], reason).replace("alpha_C", "α_C")
