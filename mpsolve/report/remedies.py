"""What a reader of the page can do about a part that is open, in place of the remedies meant for library users."""

from __future__ import annotations

import re

_FOR_LIBRARY = re.compile(
    r"(?:shorten the range of alpha|prove it in parts, over shorter ranges|start (?:above it|from alpha = 0\.001)"
    r"|ask for (?:more|fewer) digits(?:, so that clusters come apart, or for a rectangle)?"
    r"|change a parameter a little, or move the side of the rectangle"
    r'|ask for the region "unstable"(?:, or (?:raise max_pieces|for more digits, so that clusters come apart))?'
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
_COMMAND = (
    ('ask for the region "unstable"', "try --region unstable"),
    ('only region="unstable", or a rectangle in Im q ≤ 0, can be certified', "try --region unstable"),
    ("allow more effort, with effort=Effort(seconds=…)", "allow more with --effort SECONDS"),
    ('give "unstable", ("below", h) or a Rectangle', "give unstable, below=H or RE_MIN,RE_MAX,IM_MIN,IM_MAX"),
    (
        'give "sheet", "unstable", ("below", h) with a number h, or a Rectangle',
        "give unstable, below=H, RE_MIN,RE_MAX,IM_MIN,IM_MAX, or sheet",
    ),
    ('ask for "unstable"', "try --region unstable"),
    ("give h up to", "give --region below=H with H up to"),
    ("or for more digits", "or more --digits"),
    ("ask for more digits", "ask for more --digits"),
    ("or for a rectangle", "or for a small --region=RE_MIN,RE_MAX,IM_MIN,IM_MAX"),
    ("ask for a rectangle", "ask for a small --region=RE_MIN,RE_MAX,IM_MIN,IM_MAX"),
)
ADVICE["response"] = ADVICE["roots"]


def on_command_line(reason: str) -> str:
    """The reason with the names of options in place of those of arguments."""
    for argument, option in _COMMAND:
        reason = reason.replace(argument, option)
    return reason
