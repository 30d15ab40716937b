"""What a study computes, and over which entries: a problem, paths of its parameters, a plan; in exact numbers.

Every mistake in it is an InputError under its key.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, fields, replace
from functools import cached_property, lru_cache
from pathlib import Path
from typing import Any

from mpsolve.errors import InputError
from mpsolve.numbers.exact import Exact
from mpsolve.numbers.model import rational
from mpsolve.problem import specs
from mpsolve.problem.cases import Given, as_problem
from mpsolve.problem.inputfile import problem_of
from mpsolve.problem.problem import Problem
from mpsolve.problem.toml import Written, parsed, refuse_other_kind, text_of, title_of
from mpsolve.studies.axes import counted, read_axes, total_of
from mpsolve.studies.design import Axis, Listed, Parts, Span, Value, draws
from mpsolve.studies.plan import BOXES, read_plan, region_text

PROBLEM = ("v", "track", "vehicle", "physical", "mass", "dimensionless")
"""The keys of a problem file that say what is computed."""
_TOP = {
    "title": "a text",
    "problem": "the path of a problem file",
    **dict.fromkeys(PROBLEM, "of the problem, as in a problem file"),
    "study": "a section",
    "parameters": "a section",
}
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
                "region": region_text(self.region),
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
    if isinstance(spec, (str, os.PathLike)) and not {"study", "parameters"} & content.keys():
        refuse_other_kind(content, {}, Path(spec))
    for name in ("study", "parameters"):
        if name not in content:
            raise InputError(name, f"is missing: add [{name}]")
    folder = Path(spec).parent if isinstance(spec, (str, os.PathLike)) else Path()
    tables = problem_tables(content, folder)
    problem = as_problem(problem_of(tables, Path("problem")).given)
    plan = read_plan(content["study"])
    axes = read_axes(content["parameters"], "parts" if plan.kind == "stable" else plan.design, problem)
    total = total_of(axes, plan.design, plan.count)
    settings = {one.name: getattr(plan, one.name) for one in fields(plan) if one.name != "count"}
    return Spec(title_of(content), tables, total=total, axes=axes, **settings)


def problem_tables(content: Mapping[str, Any], folder: Path) -> dict[str, Any]:
    """The problem's own tables, from the study's file or from the one that it names."""
    own = {name: content[name] for name in PROBLEM if name in content}
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
    return _texts({key: value for key, value in read.items() if key in PROBLEM})


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
