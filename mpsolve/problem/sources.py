"""Where the numbers of an input file come from: the texts under its keys `source`."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from mpsolve.errors import InputError
from mpsolve.problem.toml import kind

SOURCE = "where the numbers come from"


def sources_of(content: Mapping[str, Any]) -> tuple[str, ...]:
    """The sources of the file, its track and its vehicles, each once; InputError for what is no text."""
    found = [*_texts(content.get("source"), "source")]
    track, placed = content.get("track"), content.get("vehicle")
    if isinstance(track, dict):
        found += [f"Track: {text}" for text in _texts(track.get("source"), "track.source")]
    for j, entry in enumerate(placed if isinstance(placed, list) else [], 1):
        if isinstance(entry, dict):
            found += [f"Vehicle: {text}" for text in _texts(entry.get("source"), f"vehicle[{j}].source")]
    return tuple(dict.fromkeys(found))


def _texts(given: Any, key: str) -> list[str]:
    each = [] if given is None else given if isinstance(given, list) else [given]
    for one in each:
        if type(one) is not str or not one.strip():
            stated = "is empty" if type(one) is str else f"is {kind(one)}, not a text"
            raise InputError(key, f'{stated}: write source = "…", a book, a paper or a measurement')
    return [" ".join(one.split()).rstrip(".") for one in each]
