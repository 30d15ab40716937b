"""The presets: each is a TOML file in `tracks` or `vehicles` beside this one, found by its name."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from difflib import get_close_matches
from functools import lru_cache
from pathlib import Path
from typing import Any, Literal

from mpsolve import tracks, vehicles
from mpsolve.errors import InputError
from mpsolve.problem.toml import parsed

_HERE = Path(__file__).parent
Kind = Literal["track", "vehicle"]


@dataclass(frozen=True)
class Preset:
    """One track or vehicle.

    on: what its values are for: "rail" (one rail), "track" (both rails, the whole vehicle), "wire", "ice".
    sources: where its numbers come from, and what is assumed. model: the section of the input file, with units.
    notes: where single values come from, by their key. v, vehicle: what a track is tried with. count, spacing: of a
    row of vehicles.
    """

    name: str
    kind: Kind
    title: str
    on: str
    sources: tuple[str, ...]
    model: Mapping[str, Any]
    notes: Mapping[str, str] = field(default_factory=dict)
    v: str = ""
    vehicle: str = ""
    count: int = 1
    spacing: str = ""


def names(kind: Kind) -> tuple[str, ...]:
    """The names of all presets of a kind, in alphabetical order."""
    return tuple(sorted(file.stem for file in (_HERE / f"{kind}s").glob("*.toml")))


def preset(kind: Kind, name: str) -> Preset:
    """The preset of that name; InputError names the nearest one."""
    known = names(kind)
    if name not in known:
        models = {model.name for model in (tracks if kind == "track" else vehicles).CATALOGUE}
        if name.lower() in models:
            stated = f"is {name!r}, which is a model, not a preset: see mpsolve models {name.lower()}"
            raise InputError(kind, f"{stated}, or take one of the presets {', '.join(known)}")
        near = get_close_matches(name.lower(), known, n=1, cutoff=0.5)
        advice = f"did you mean {near[0]}?" if near else f"there are {', '.join(known)}"
        raise InputError(kind, f"is {name[:40]!r}, which is unknown: {advice}")
    return _read(kind, name)


@lru_cache
def _read(kind: Kind, name: str) -> Preset:
    file = _HERE / f"{kind}s" / f"{name}.toml"
    content = parsed(file.read_text("utf-8"), file.name)
    model, sources = content.pop(kind), tuple(content.pop("sources"))
    return Preset(name=name, kind=kind, sources=sources, model=model, **content)
