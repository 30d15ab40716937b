"""What a study computes, and over which entries: a problem, paths of its parameters, a plan; in exact numbers.

Every mistake in it is an InputError under its key.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from math import prod
from pathlib import Path
from typing import Any

from mpsolve.errors import ContradictionError, InputError
from mpsolve.model import specs
from mpsolve.model.toml import Written, parsed, text_of
from mpsolve.numbers.exact import Exact
from mpsolve.numbers.model import Quantity, rational
from mpsolve.numbers.units import measured
from mpsolve.problem.cases import Given, as_problem
from mpsolve.problem.inputfile import problem_of
from mpsolve.problem.parameters import quantity_of
from mpsolve.problem.problem import Problem
from mpsolve.spectrum.regions import Below, Rectangle
from mpsolve.studies.design import Axis, Listed, Span, Steps, Value, draws

KINDS = ("certified", "float64")
DESIGNS = ("grid", "list", "random", "quasi-random")
MAX_CASES = 10**12
MIN_DIGITS, MAX_DIGITS = 15, 10_000

_PROBLEM = ("v", "track", "vehicle", "physical", "mass", "dimensionless")
_TOP = {
    "title": "a text",
    "problem": "the path of a problem file",
    **dict.fromkeys(_PROBLEM, "of the problem, as in a problem file"),
    "study": "a section",
    "parameters": "a section",
}
_STUDY = {
    "kind": "what is computed",
    "digits": "certified digits",
    "region": "where roots are counted",
    "roots": "whether roots are sought beside the counts",
    "certificates": "whether they are kept",
    "design": "which entries are made of the parameters",
}
_DESIGN = {"kind": "the kind of design", "count": "the number of entries", "seed": "a whole number"}
_BOUNDS = dict.fromkeys(("re_min", "re_max", "im_min", "im_max"), "the bound of the rectangle")
_BELOW = {"below": "the height"}
_SPAN = {"low": "the least value", "high": "the bound above"}
_AXIS = {"start", "stop", "step", "low", "high"}
_BLOCK = (2_048, 16_384)  # entries of a block in float64: many share one start; fewer where there are few


@dataclass(frozen=True)
class Spec:
    """A study: `total` entries in `blocks` of `block` entries each, which are the units of work and of storage.

    tables: the problem as in its file, numbers as texts. axes: by the path of the parameter.
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
        return 1 if self.kind == "certified" else min(most, max(least, self.total // 16))

    @property
    def blocks(self) -> int:
        return -(-self.total // self.block)

    def indices(self, number: int) -> range:
        """The entries, counted from 0, of the block with this number."""
        return range(number * self.block, min((number + 1) * self.block, self.total))

    def values(self, index: int) -> dict[str, Value]:
        """The parameters of the entry `index`, 0 ≤ index < total."""
        if self.design in ("random", "quasi-random"):
            spans = [name for name, axis in self.axes.items() if isinstance(axis, Span)]
            places = dict(zip(spans, draws(self.design, self.seed, index, len(spans)), strict=True))
        elif self.design == "list":
            places = {name: index for name, axis in self.axes.items() if _counted(axis).count > 1}
        else:
            places, rest = {}, index
            for name in reversed(self.names):
                rest, places[name] = divmod(rest, _counted(self.axes[name]).count)
        return {name: axis.at(places.get(name, 0)) for name, axis in self.axes.items()}

    def job(self, number: int) -> tuple[str, int, int]:
        """The arguments of `work` for a block: a certified entry goes alone, so that its cost is not that of all."""
        if self.kind != "certified":
            return self.text, number, number
        axes = {name: Listed((value,)) for name, value in self.values(number).items()}
        return replace(self, design="list", total=1, axes=axes).text, number, 0

    @cached_property
    def canonical(self) -> dict[str, Any]:
        """A mapping from which `read_spec` makes the same study; two studies are the same if these are equal."""
        own = {"digits": self.digits, "certificates": self.certificates}
        drawn = {"count": self.total, "seed": self.seed} if self.design in ("random", "quasi-random") else {}
        return {
            **self.tables,
            "study": {
                "kind": self.kind,
                "region": _region_text(self.region),
                **(own if self.kind == "certified" else {"roots": self.roots}),
                "design": {"kind": self.design, **drawn},
            },
            "parameters": {name: axis.canonical for name, axis in self.axes.items()},
        }

    @cached_property
    def asked(self) -> str:
        """What is computed of each entry, as JSON; it does not depend on the other entries."""
        return json.dumps([self.tables, self.canonical["study"] | {"design": None}], sort_keys=True)

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
    tables = _tables(content, folder)
    problem = as_problem(problem_of(tables, Path("problem")).given)
    table = specs.section(content["study"], "study", _STUDY)
    kind = _named(table, "study.kind", KINDS)
    for name in ("digits", "certificates") if kind == "float64" else ("roots",):
        if name in table:
            other = "certified" if kind == "float64" else "float64"
            raise InputError(f"study.{name}", f'is for kind = "{other}" only: drop it')
    design, count, seed = _design(table)
    axes = _axes(content["parameters"], design, problem)
    return Spec(
        title=specs.title(content),
        tables=tables,
        kind=kind,
        digits=_whole(table, "digits", MIN_DIGITS, MIN_DIGITS, MAX_DIGITS),
        region=_region(table.get("region", "unstable"), kind),
        roots=_yes_or_no(table, "roots", True),
        certificates=_yes_or_no(table, "certificates", False),
        design=design,
        seed=seed,
        total=_total(axes, design, count),
        axes=axes,
    )


def _tables(content: Mapping[str, Any], folder: Path) -> dict[str, Any]:
    """The problem's own tables, from the study's file or from the one that it names."""
    own = {name: content[name] for name in _PROBLEM if name in content}
    if "problem" not in content:
        if not own:
            raise InputError("problem", "is missing: give the path of a problem file, or its tables here")
        return _texts(own)
    if own:
        raise InputError("problem", f"is given beside {', '.join(own)}: keep one of the two")
    name = content["problem"]
    if not isinstance(name, str):
        raise InputError("problem", "is no text: give the path of a problem file")
    read = parsed(text_of(folder / name), str(folder / name))
    return _texts({key: value for key, value in read.items() if key in _PROBLEM})


def _texts(table: Mapping[str, Any]) -> dict[str, Any]:
    return {name: _plain(value) for name, value in table.items()}


def _plain(value: Any) -> Any:
    """As JSON holds it: numbers as exact texts, whole ones as they are."""
    if isinstance(value, Mapping):
        return {str(key): _plain(inner) for key, inner in value.items()}
    if isinstance(value, (list, tuple)):
        return [_plain(inner) for inner in value]
    if isinstance(value, Written):
        return str(Exact.parse(value, "problem"))
    if isinstance(value, (str, bool, int)):
        return value
    return str(rational(value, "problem"))


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


def _axes(given: Any, design: str, problem: Problem) -> dict[str, Axis]:
    if not isinstance(given, Mapping):
        raise InputError("parameters", "is no section: give paths and their values in it")
    flat = dict(_flattened(given, ""))
    if not flat:
        raise InputError("parameters", "is empty: give at least one path, such as v or track.k")
    asked = {path: _quantity(problem, path) for path in flat}
    axes = {
        path: _axis(_measured(value, asked[path], f"parameters.{path}"), path, design) for path, value in flat.items()
    }
    for path, axis in axes.items():
        for value in axis.extremes:
            try:
                problem.changed(path, value)
            except InputError as error:
                raise InputError(f"parameters.{path}", str(error).removeprefix(f"{error.key}: ")) from None
    return axes


def _quantity(problem: Problem, path: str) -> Quantity:
    try:
        return quantity_of(problem.track, problem.vehicles, problem.v, path)
    except InputError as error:
        raise InputError(f"parameters.{path}", str(error).removeprefix(f"{error.key}: ")) from None


def _measured(given: Any, asked: Quantity, key: str) -> Any:
    """Texts with units, in lists and tables too, in the parameter's own unit."""
    if isinstance(given, Mapping):
        return {name: _measured(value, asked, f"{key}.{name}") for name, value in given.items()}
    if isinstance(given, (list, tuple)):
        return [_measured(value, asked, f"{key}[{j}]") for j, value in enumerate(given, 1)]
    return measured(given, asked.unit, key, asked.meaning)


def _flattened(table: Mapping[str, Any], prefix: str) -> Iterator[tuple[str, Any]]:
    """track.k = … in TOML is a table in a table: paths again."""
    for name, value in table.items():
        if isinstance(value, Mapping) and not _AXIS & value.keys():
            yield from _flattened(value, f"{prefix}{name}.")
        else:
            yield f"{prefix}{name}", value


def _axis(given: Any, name: str, design: str) -> Axis:
    key, drawn = f"parameters.{name}", design in ("random", "quasi-random")
    if isinstance(given, Mapping) and ({"low", "high"} & given.keys()):
        if not drawn:
            raise InputError(key, f'is a range, but a {design} draws nothing: give design = {{kind = "random", …}}')
        span = Span(**specs.rationals(given, key, _SPAN))
        if not span.low < span.high:
            raise InputError(f"{key}.high", "is not above low: give the bounds in order")
        return span
    if drawn and isinstance(given, (Mapping, list, tuple)):
        raise InputError(key, f"is several values, but a {design} design draws: give {{low, high}} or one number")
    if isinstance(given, Mapping):
        return Steps(*specs.steps(given, key))
    if not isinstance(given, (list, tuple)):
        return Listed((rational(given, key),))
    if not given:
        raise InputError(key, "is empty: give at least one value")
    values = [rational(one, f"{key}[{j}]") for j, one in enumerate(given, 1)]
    seen: set[Value] = set()
    for j, value in enumerate(values, 1):
        if design == "grid" and value in seen:
            raise InputError(f"{key}[{j}]", f"is {value}, which is there already: drop one")
        seen.add(value)
    return Listed(tuple(values))


def _total(axes: Mapping[str, Axis], design: str, count: int) -> int:
    if count:
        return count
    lengths = {name: _counted(axis).count for name, axis in axes.items()}
    longest = max(lengths, key=lambda name: lengths[name])
    if design == "list":
        for name, length in lengths.items():
            if length not in (1, lengths[longest]):
                stated = f"has {length} values, and {longest} has {lengths[longest]}"
                raise InputError(f"parameters.{name}", f"{stated}: give as many, or one for all entries")
    total = lengths[longest] if design == "list" else prod(lengths.values())
    if total > MAX_CASES:
        raise InputError("parameters", f"make more than {MAX_CASES} entries: give at most so many")
    return total


def _counted(axis: Axis) -> Listed | Steps:
    if isinstance(axis, Span):
        raise ContradictionError("a range between bounds has no values of its own, and was counted")
    return axis


def _region(given: Any, kind: str) -> Any:
    """ "unstable", "sheet", Below or a Rectangle."""
    if isinstance(given, Mapping) and "below" in given:
        height = specs.rationals(given, "study.region", _BELOW)["below"]
        if height <= 0:
            raise InputError("study.region.below", 'is not above 0: give a height, or region = "unstable"')
        return Below(height)
    if isinstance(given, Mapping):
        if kind == "float64":
            raise InputError("study.region", 'is a rectangle, which is for kind = "certified": give another region')
        return Rectangle(**specs.rationals(given, "study.region", _BOUNDS))
    return _named({"region": given}, "study.region", ("unstable", "sheet"))


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
