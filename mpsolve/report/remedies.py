"""Remedies in the names of the options of the command line, in place of those of arguments."""

from __future__ import annotations

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
    (
        "declare the branch cuts, as in cuts=[Cut.ray(origin, direction)]",
        "declare the branch cuts, each with --cut RE IM DRE DIM",
    ),
    ('or for ("below", h) give h up to', "or give --region below=H with H up to"),
    ("give h up to", "give --region below=H with H up to"),
    ("or for more digits", "or more --digits"),
    ("ask for more digits", "ask for more --digits"),
    ("or for a rectangle", "or for a small --region=RE_MIN,RE_MAX,IM_MIN,IM_MAX"),
    ("ask for a rectangle", "ask for a small --region=RE_MIN,RE_MAX,IM_MIN,IM_MAX"),
)


def on_command_line(reason: str) -> str:
    """The reason with the names of options in place of those of arguments."""
    for argument, option in _COMMAND:
        reason = reason.replace(argument, option)
    return reason
