"""Where a key stands in the text of an input file."""

from __future__ import annotations

import re

_HEAD = re.compile(r"\s*(\[\[?)\s*([^\[\]#]+?)\s*\]")
_KEY = re.compile(r'\s*(?:"([^"]+)"|([\w-]+))\s*=')


def line_of(text: str, key: str) -> int | None:
    """The number of the line of a key such as "track.EI", "vehicle[2].bogie.wheel" or "mass[1]", from 1.

    Of a key that is missing it is the line of its section; None where that is nowhere, or is the whole file.
    """
    lines, place = _lines(text), key
    while place:
        for known in (place, f"{place}[1]"):
            if known in lines:
                return lines[known]
        bare = re.sub(r"\[\d+\]$", "", place)
        place = bare if bare != place else place.rpartition(".")[0]
    return None


def _lines(text: str) -> dict[str, int]:
    """The lines by their keys; the sections of a list are numbered from 1."""
    found: dict[str, int] = {}
    section, seen = "", {}  # type: ignore[var-annotated]
    for number, line in enumerate(text.splitlines(), 1):
        head, key = _HEAD.match(line), _KEY.match(line)
        if head:
            name = head[2]
            if head[1] == "[[":
                seen[name] = seen.get(name, 0) + 1
            first, dot, rest = name.partition(".")
            section = f"{first}[{seen[first]}]{dot}{rest}" if first in seen else name
            found.setdefault(section, number)
        elif key:
            found.setdefault(f"{section}.{key[1] or key[2]}".lstrip("."), number)
    return found
