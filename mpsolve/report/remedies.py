"""Remedies in the names of the options of the command line, in place of those of arguments."""

from __future__ import annotations

from typing import Any

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
    ("for a Rectangle", "for --region=RE_MIN,RE_MAX,IM_MIN,IM_MAX"),
    ("give a Rectangle", "give --region=RE_MIN,RE_MAX,IM_MIN,IM_MAX"),
    ("with im_max < 0", "with IM_MAX < 0"),
    ("with re_min > 0", "with RE_MIN > 0"),
    ('for ("below", h)', "for --region below=H"),
    ('ask for region="unstable"', "try --region unstable"),
    (", or give spectrum=certify(problem)", ""),
)


def on_command_line(said: Any) -> Any:
    """A text, or the texts in lists and mappings, with the names of options in place of those of arguments."""
    if isinstance(said, dict):
        return {key: on_command_line(one) for key, one in said.items()}
    if isinstance(said, list):
        return [on_command_line(one) for one in said]
    if isinstance(said, str):
        for argument, option in _COMMAND:
            said = said.replace(argument, option)
    return said
