"""The section [study] of a spec: which kind of work, how exact, where, and over which design."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from mpsolve.errors import InputError
from mpsolve.numbers.model import whole
from mpsolve.problem import specs
from mpsolve.problem.toml import section
from mpsolve.spectrum.regions import Below, Rectangle
from mpsolve.studies.axes import MAX_CASES

KINDS = ("certified", "float64", "stable")
DESIGNS = ("grid", "list", "random", "quasi-random")
MIN_DIGITS, MAX_DIGITS = 15, 10_000
BOXES = 100_000
"""Of the proof of one entry, unless the spec says otherwise."""
_OTHERS = {
    "certified": ("roots", "boxes"),
    "float64": ("digits", "certificates", "boxes"),
    "stable": ("digits", "roots"),
}
"""By kind what is for other kinds only."""
_STUDY = {
    "kind": "what is computed",
    "digits": "certified digits",
    "region": "where roots are counted",
    "roots": "whether roots are sought beside the counts",
    "certificates": "whether they are kept",
    "boxes": "the most boxes of a proof",
    "design": "which entries are made of the parameters",
}
_DESIGN = {"kind": "the kind of design", "count": "the number of entries", "seed": "a whole number"}
_BOUNDS = dict.fromkeys(("re_min", "re_max", "im_min", "im_max"), "the bound of the rectangle")
_BELOW = {"below": "the height"}


@dataclass(frozen=True)
class Plan:
    """What stands in the section; `Spec` says what each means. count: of a random design, else 0."""

    kind: str
    digits: int
    region: Any
    roots: bool
    certificates: bool
    design: str
    count: int
    seed: int
    boxes: int


def read_plan(given: Any) -> Plan:
    """The plan in a section [study]; InputError under the key at fault."""
    table = section(given, "study", _STUDY)
    kind = _named(table, "study.kind", KINDS)
    for name in _OTHERS[kind]:
        if name in table:
            others = " or ".join(f'"{one}"' for one in KINDS if name not in _OTHERS[one])
            raise InputError(f"study.{name}", f"is for kind = {others} only: drop it")
    design, count, seed = _design(table)
    if kind == "stable" and design != "grid":
        raise InputError("study.design", f'is a {design}, but kind = "stable" covers a box by its parts: drop it')
    return Plan(
        kind=kind,
        digits=_whole(table, "digits", MIN_DIGITS, MIN_DIGITS, MAX_DIGITS),
        region=_region(table.get("region", "unstable"), kind),
        roots=_yes_or_no(table, "roots", True),
        certificates=_yes_or_no(table, "certificates", kind == "stable"),
        design=design,
        count=count,
        seed=seed,
        boxes=_whole(table, "boxes", BOXES, 1, 10**9),
    )


def _design(table: Mapping[str, Any]) -> tuple[str, int, int]:
    """Kind, count (0 where the parameters tell) and seed."""
    given = section(table.get("design", {"kind": "grid"}), "study.design", _DESIGN)
    kind = _named(given, "study.design.kind", DESIGNS)
    if kind in ("grid", "list"):
        for name in ("count", "seed"):
            if name in given:
                raise InputError(f"study.design.{name}", f"is for random designs, and this is a {kind}: drop it")
        return kind, 0, 0
    if "count" not in given:
        raise InputError("study.design.count", "is missing: give the number of entries")
    return kind, _whole(given, "design.count", 0, 1, MAX_CASES), _whole(given, "design.seed", 0, 0, 2**63 - 1)


def _region(given: Any, kind: str) -> Any:
    """ "unstable", "sheet", Below or a Rectangle."""
    if isinstance(given, Mapping) and kind == "stable":
        raise InputError("study.region", 'is not for kind = "stable", which is about all roots that grow: drop it')
    if isinstance(given, Mapping) and "below" in given:
        height = specs.rationals(given, "study.region", _BELOW)["below"]
        if height <= 0:
            raise InputError("study.region.below", 'is not above 0: give a height, or region = "unstable"')
        return Below(height)
    if isinstance(given, Mapping):
        if kind == "float64":
            raise InputError("study.region", 'is a rectangle, which is for kind = "certified": give another region')
        return Rectangle(**specs.rationals(given, "study.region", _BOUNDS))
    return _named({"region": given}, "study.region", ("unstable",) if kind == "stable" else ("unstable", "sheet"))


def region_text(region: Any) -> Any:
    if isinstance(region, Rectangle):
        return region.as_dict()
    return {"below": str(region.height)} if isinstance(region, Below) else region


def _named(table: Mapping[str, Any], key: str, allowed: tuple[str, ...]) -> str:
    """The text under the last name of `key`."""
    name = key.rpartition(".")[2]
    return specs.choice({key: table[name]} if name in table else {}, key, allowed)


def _whole(table: Mapping[str, Any], key: str, default: int, low: int, high: int) -> int:
    return whole(table.get(key.rpartition(".")[2], default), f"study.{key}", low, high)


def _yes_or_no(table: Mapping[str, Any], key: str, default: bool) -> bool:
    value = table.get(key, default)
    if not isinstance(value, bool):
        raise InputError(f"study.{key}", f"is {value!r}: give true or false")
    return value
