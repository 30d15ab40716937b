"""The input file of a track and a vehicle from the presets, with a comment on every line, and the problem in it."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from difflib import get_close_matches
from fractions import Fraction
from functools import lru_cache
from pathlib import Path
from typing import Any, Literal

from mpsolve import tracks, vehicles
from mpsolve.errors import InputError
from mpsolve.numbers.exact import Exact
from mpsolve.numbers.model import Part, Quantity, defaults, quantities
from mpsolve.numbers.spoken import decimal
from mpsolve.numbers.units import in_unit, split
from mpsolve.problem import inputfile
from mpsolve.problem.inputfile import ProblemFile, read_problem
from mpsolve.problem.problem import Problem
from mpsolve.problem.toml import parsed

_HERE = Path(__file__).parent
Kind = Literal["track", "vehicle"]
_WIDTH, _COLUMN = 118, 28
_SHARED = ("kg", "kg m²", "N/m", "N s/m")
"""Units of what a rail takes half of."""
_OF_ONE_RAIL = re.compile(r" (?:on|under) one rail")
"""What the models say of their values; here they may be for something else."""
_OF = {"rail": "one rail", "track": "both rails and the whole vehicle", "wire": "one wire", "ice": "a strip of ice"}
FIRST = "ballasted"
"""The preset that stands there without a file."""


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


def input_file(
    track: str, vehicle: str | None = None, v: str | None = None, count: int | None = None, spacing: str | None = None
) -> str:
    """The text of an input file: the preset `track` under the preset `vehicle`, or the track's usual one.

    A vehicle given as a whole is halved for one rail, a half one doubled for both. v, count, spacing: instead of the
    presets' own, with or without units. InputError where the vehicle does not run on such a track.
    """
    below, above = preset("track", track), preset("vehicle", vehicle or preset("track", track).vehicle)
    share = _share(below, above)
    velocity = below.v if v is None else v
    if in_unit(velocity, "m/s", "v", "velocity") < 0:
        raise InputError("v", f"is {velocity}: give a velocity from 0 on, x runs ahead")
    number = above.count if count is None else count
    if number < 1:
        raise InputError("count", f"is {number}: give a whole number from 1")
    gap = above.spacing if spacing is None else spacing
    if in_unit(gap, "m", "spacing", "distance of the vehicles") <= 0:
        raise InputError("spacing", f"is {gap}: give a distance above 0")
    lines = [
        *_comment("Values are exact. They may have other units of the same kind, or none: then they are in SI. "
                  f"Everything is for {_OF[below.on]}."),
        f'title = "{below.title}; {above.title}"',
        "",
        _line("v", velocity, "velocity of the vehicles"),
        "",
        *_comment(_sentence(below.title)),
        "[track]",
        *_source(below),
        *_model(below.model, tracks.CATALOGUE, below.notes, Fraction(1)),
        "",
        *_comment(_sentence(above.title)),
        "[[vehicle]]",
        *_source(above),
        *_row(number, gap),
        *_model(above.model, vehicles.CATALOGUE, above.notes, share, "vehicle"),
    ]  # fmt: skip
    text = "\n".join(lines) + "\n"
    return text if below.on == "rail" else _OF_ONE_RAIL.sub("", text)


def _share(track: Preset, vehicle: Preset) -> Fraction:
    """What part of the vehicle's values the track takes."""
    shares = {("rail", "track"): Fraction(1, 2), ("track", "rail"): Fraction(2)}
    if track.on == vehicle.on:
        return Fraction(1)
    if (track.on, vehicle.on) not in shares:
        stated = f"is {vehicle.name!r}, which is for {_OF[vehicle.on]}, but {track.name} is {_OF[track.on]}"
        raise InputError("vehicle", f"{stated}: take another, such as {track.vehicle}")
    return shares[track.on, vehicle.on]


def _row(count: int, spacing: str) -> Iterator[str]:
    if count > 1:
        yield _line("count", count, "how many of them run in a row")
        yield _line("spacing", spacing, "from the middle of one to that of the next")
    else:
        yield _line("position", "0 m", "where its middle is")
        yield f'# count = 4, spacing = "{spacing}" instead of position: four of them in a row'


def _model(
    section: Mapping[str, Any], catalogue: Any, notes: Mapping[str, str], share: Fraction, key: str = ""
) -> Iterator[str]:
    model = next(model for model in catalogue if model.name == section["model"])
    yield _line("model", section["model"], "mpsolve models explains it")
    yield from _values(section, model, notes, share, key, "")


def _values(
    section: Mapping[str, Any], model: Any, notes: Mapping[str, str], share: Fraction, key: str, inside: str
) -> Iterator[str]:
    described = quantities(model)
    parts = {name for name, quantity in described.items() if isinstance(quantity, Part)}
    for name, value in section.items():
        if name != "model" and name not in parts:
            yield _line(name, *_shared(value, share, described[name], notes.get(inside + name, "")))
    left = [name for name in defaults(model) if name not in section]
    if left:
        told = ", ".join(f"{name} ({described[name].told})" for name in left)
        yield from _comment(f"May be given too: {told}.")
    for name in parts:
        yield f"\n[{key}.{name}]"
        yield from _values(section[name], described[name].kind, notes, share, key, f"{name}.")  # type: ignore[attr-defined]


def _shared(value: Any, share: Fraction, quantity: Quantity, note: str) -> tuple[Any, str]:
    """The value for the rail or the track, and what is said of it."""
    said = f"{quantity.meaning}: {note}" if note else quantity.meaning
    if share == 1 or quantity.unit not in _SHARED or isinstance(value, list):
        return value, said
    number, unit = split(value)
    part = Exact.parse(number).as_fraction() * share
    whole = "half of" if share < 1 else "twice"
    return f"{decimal(part)} {unit}", f"{quantity.meaning}, {whole} {value}" + (f": {note}" if note else "")


def _line(key: str, value: Any, comment: str) -> str:
    return f"{f'{key} = {_toml(value)}'.ljust(_COLUMN)}  # {comment}"


def _toml(value: Any) -> str:
    if isinstance(value, list):
        return f"[{', '.join(map(_toml, value))}]"
    return f'"{value}"' if isinstance(value, str) else str(value)


def _sentence(title: str) -> str:
    return f"{title[0].upper()}{title[1:]}."


def _source(one: Preset) -> Iterator[str]:
    """Where the numbers come from, as a text over several lines."""
    text = "; ".join(one.sources).replace("\\", "\\\\").replace('"', "'")
    lines = textwrap.wrap(text, _WIDTH - 4, break_long_words=False, break_on_hyphens=False)
    yield 'source = """\\'
    yield from (f"    {line} \\" for line in lines[:-1])
    yield f'    {lines[-1]}"""'


def _comment(text: str) -> list[str]:
    return textwrap.wrap(text, _WIDTH, initial_indent="# ", subsequent_indent="# ", break_long_words=False)


def listing() -> str:
    """All presets, for the terminal."""
    lines = ["Tracks (mpsolve new TRACK):"]
    for name in names("track"):
        one = preset("track", name)
        lines.append(f"  {name.ljust(14)}{one.title}; {one.v}, {one.vehicle}")
    lines += ["", "Vehicles (--vehicle NAME):"]
    lines += [f"  {name.ljust(14)}{preset('vehicle', name).title}" for name in names("vehicle")]
    return "\n".join(lines) + "\n"


def begun(file: Path | None) -> tuple[Problem, str]:
    """The problem of an input file, or of the first preset, with its title."""
    read = read_problem(file) if file is not None else _read_preset(FIRST, None)
    return read.problem, read.title or (file.stem if file is not None else "")


def problem_of(track: str, vehicle: str | None = None) -> tuple[Problem, str]:
    """The problem of a preset of a track, with a preset of a vehicle or with its usual one, and its title."""
    read = _read_preset(track, vehicle)
    return read.problem, read.title


def _read_preset(track: str, vehicle: str | None) -> ProblemFile:
    name = f"{track}.toml"
    return inputfile.problem_of(parsed(input_file(track, vehicle), name), Path(name))
