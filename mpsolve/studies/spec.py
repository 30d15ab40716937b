"""What a study computes, and over which entries: a problem, paths of its parameters, a plan; in exact numbers.

Every mistake in it is an InputError under its key.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from pathlib import Path
from typing import Any

from mpsolve.errors import InputError
from mpsolve.problem import specs
from mpsolve.problem.cases import Given, as_problem
from mpsolve.problem.inputfile import problem_of
from mpsolve.problem.problem import Problem
from mpsolve.spectrum.regions import Below, Rectangle
from mpsolve.studies.axes import MAX_CASES, counted, read_axes, total_of
from mpsolve.studies.design import Axis, Listed, Parts, Span, Value, draws
from mpsolve.studies.source import PROBLEM, problem_tables

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

_TOP = {
    "title": "a text",
    "problem": "the path of a problem file",
    **dict.fromkeys(PROBLEM, "of the problem, as in a problem file"),
    "study": "a section",
    "parameters": "a section",
}
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
_BLOCK = (2_048, 16_384)  # entries of a block in float64: many share one start; fewer where there are few


@dataclass(frozen=True)
class Spec:
    """A study: `total` entries in `blocks` of `block` entries each, which are the units of work and of storage.

    tables: the problem as in its file, numbers as texts. axes: by the path of the parameter. boxes: those that the
    proof of one entry may take (stable); two studies that differ in nothing else are the same.
    """

    title: str
    tables: Mapping[str, Any]
    kind: str
    digits: int
    region: Any
    roots: bool
    certificates: bool
    design: str
    seed: int
    total: int
    axes: Mapping[str, Axis]
    boxes: int = BOXES

    @cached_property
    def given(self) -> Given:
        """The problem whose parameters are varied."""
        return problem_of(self.tables, Path("problem")).given

    @cached_property
    def base(self) -> Problem:
        return as_problem(self.given)

    def problem(self, index: int) -> Problem:
        """The problem of one entry, exact; InputError where it cannot be."""
        problem = self.base
        for path, value in self.values(index).items():
            problem = problem.changed(path, value)
        return problem

    @property
    def names(self) -> tuple[str, ...]:
        """The paths that are varied, in the order of the spec; in a grid the last varies fastest."""
        return tuple(self.axes)

    @property
    def block(self) -> int:
        """Entries of a block: a function of the spec alone, because float64 digits depend on the neighbours."""
        least, most = _BLOCK
        return min(most, max(least, self.total // 16)) if self.kind == "float64" else 1

    @property
    def blocks(self) -> int:
        return -(-self.total // self.block)

    def indices(self, number: int) -> range:
        """The entries, counted from 0, of the block with this number."""
        return range(number * self.block, min((number + 1) * self.block, self.total))

    def values(self, index: int) -> dict[str, Value]:
        """The parameters of the entry `index`, 0 ≤ index < total; of a part of a box those of its middle."""
        return {name: axis.at(k) for (name, axis), k in zip(self.axes.items(), self._places(index), strict=True)}

    def part(self, index: int) -> dict[str, tuple[Value, Value]]:
        """The ranges that the entry `index` is about (stable)."""
        axes = zip(self.axes.items(), self._places(index), strict=True)
        return {name: axis.ends(k) for (name, axis), k in axes if isinstance(axis, Parts)}

    def _places(self, index: int) -> list[int]:
        """The number of the value along each axis, or what is drawn."""
        if self.design in ("random", "quasi-random"):
            spans = [name for name, axis in self.axes.items() if isinstance(axis, Span)]
            places = dict(zip(spans, draws(self.design, self.seed, index, len(spans)), strict=True))
        elif self.design == "list":
            places = {name: index for name, axis in self.axes.items() if counted(axis).count > 1}
        else:
            places, rest = {}, index
            for name in reversed(self.names):
                rest, places[name] = divmod(rest, counted(self.axes[name]).count)
        return [places.get(name, 0) for name in self.axes]

    def job(self, number: int) -> tuple[str, int, int]:
        """The arguments of `work` for a block: one that goes alone does not cost what all do."""
        if self.kind == "float64":
            return self.text, number, number
        axes: dict[str, Axis] = {name: Listed((value,)) for name, value in self.values(number).items()}
        axes |= {name: Parts(*ends, 1) for name, ends in self.part(number).items()}
        design = "grid" if self.kind == "stable" else "list"
        return replace(self, design=design, total=1, axes=axes).text, number, 0

    @cached_property
    def canonical(self) -> dict[str, Any]:
        """A mapping from which `read_spec` makes the same study; two studies are the same if these are equal."""
        own: dict[str, dict[str, Any]] = {
            "certified": {"digits": self.digits, "certificates": self.certificates},
            "float64": {"roots": self.roots},
            "stable": {"certificates": self.certificates, "boxes": self.boxes},
        }
        drawn = {"count": self.total, "seed": self.seed} if self.design in ("random", "quasi-random") else {}
        return {
            **self.tables,
            "study": {
                "kind": self.kind,
                "region": _region_text(self.region),
                **own[self.kind],
                "design": {"kind": self.design, **drawn},
            },
            "parameters": {name: axis.canonical for name, axis in self.axes.items()},
        }

    @cached_property
    def asked(self) -> str:
        """What is computed of each entry, as JSON; it does not depend on the other entries."""
        study = {name: one for name, one in self.canonical["study"].items() if name != "boxes"}
        return json.dumps([self.tables, study | {"design": None}], sort_keys=True)

    @cached_property
    def text(self) -> str:
        """`canonical` as JSON."""
        return json.dumps(self.canonical, ensure_ascii=True)


@lru_cache(maxsize=4)  # every block of a study comes with the same text
def spec_of(text: str) -> Spec:
    """The spec with this `text`."""
    return read_spec(json.loads(text))


def differences(
    first: Mapping[str, Any], second: Mapping[str, Any], prefix: str = ""
) -> Iterator[tuple[str, Any, Any]]:
    """(key, value in the first, value in the second) wherever two canonical specs differ; None: not given."""
    for name in {**first, **second}:
        one, other = first.get(name), second.get(name)
        if isinstance(one, Mapping) and isinstance(other, Mapping):
            yield from differences(one, other, f"{prefix}{name}.")
        elif one != other:
            yield f"{prefix}{name}", one, other


def read_spec(spec: Mapping[str, Any] | str | os.PathLike[str]) -> Spec:
    """The study that `spec` (a mapping, or the path of a TOML file) describes; see mpsolve/studies/run.py.

    Raises InputError under the key at fault.
    """
    content = specs.load(spec, _TOP)
    for name in ("study", "parameters"):
        if name not in content:
            raise InputError(name, f"is missing: add [{name}]")
    folder = Path(spec).parent if isinstance(spec, (str, os.PathLike)) else Path()
    tables = problem_tables(content, folder)
    problem = as_problem(problem_of(tables, Path("problem")).given)
    table = specs.section(content["study"], "study", _STUDY)
    kind = _named(table, "study.kind", KINDS)
    for name in _OTHERS[kind]:
        if name in table:
            others = " or ".join(f'"{one}"' for one in KINDS if name not in _OTHERS[one])
            raise InputError(f"study.{name}", f"is for kind = {others} only: drop it")
    design, count, seed = _design(table)
    if kind == "stable" and design != "grid":
        raise InputError("study.design", f'is a {design}, but kind = "stable" covers a box by its parts: drop it')
    axes = read_axes(content["parameters"], "parts" if kind == "stable" else design, problem)
    return Spec(
        title=specs.title(content),
        tables=tables,
        kind=kind,
        digits=_whole(table, "digits", MIN_DIGITS, MIN_DIGITS, MAX_DIGITS),
        region=_region(table.get("region", "unstable"), kind),
        roots=_yes_or_no(table, "roots", True),
        certificates=_yes_or_no(table, "certificates", kind == "stable"),
        design=design,
        seed=seed,
        total=total_of(axes, design, count),
        axes=axes,
        boxes=_whole(table, "boxes", BOXES, 1, 10**9),
    )


def _design(table: Mapping[str, Any]) -> tuple[str, int, int]:
    """Kind, count (0 where the parameters tell) and seed."""
    given = specs.section(table.get("design", {"kind": "grid"}), "study.design", _DESIGN)
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


def _region_text(region: Any) -> Any:
    if isinstance(region, Rectangle):
        return region.as_dict()
    return {"below": str(region.height)} if isinstance(region, Below) else region


def _named(table: Mapping[str, Any], key: str, allowed: tuple[str, ...]) -> str:
    """The text under the last name of `key`."""
    name = key.rpartition(".")[2]
    return specs.choice({key: table[name]} if name in table else {}, key, allowed)


def _whole(table: Mapping[str, Any], key: str, default: int, low: int, high: int) -> int:
    number = table.get(key.rpartition(".")[2], default)
    if isinstance(number, bool) or not isinstance(number, int) or not low <= number <= high:
        raise InputError(f"study.{key}", f"is {number!r}: give a whole number from {low} to {high}")
    return number


def _yes_or_no(table: Mapping[str, Any], key: str, default: bool) -> bool:
    value = table.get(key, default)
    if not isinstance(value, bool):
        raise InputError(f"study.{key}", f"is {value!r}: give true or false")
    return value
