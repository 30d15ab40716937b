"""What a study computes, and over which cases: read from a mapping or a TOML file, in exact numbers.

Every mistake in it is an InputError under its key, as in mpsolve/model/specs.py.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from math import prod
from typing import Any

from mpsolve.certificate.sheet import MAX_DIGITS, MIN_DIGITS
from mpsolve.errors import ContradictionError, InputError
from mpsolve.model import specs
from mpsolve.numbers.exact import Exact
from mpsolve.sheet.region import Region
from mpsolve.spectrum.regions import Rectangle
from mpsolve.studies.design import Axis, Listed, Span, Steps, Value, draws

KINDS = ("certified", "float64")
DESIGNS = ("grid", "list", "random", "quasi-random")
MAX_CASES = 10**12
PARAMETERS = {
    "alpha": specs.PARAMETERS["alpha"],
    "eta_b": specs.PARAMETERS["eta_b"],
    "eta_m": "the mass ratio of the first mass",
    "mass_ratio": "the mass of each other mass over that of the first, 1 if left out",
    "d": specs.PARAMETERS["d"],
    "eta_n": specs.PARAMETERS["eta_n"],
    "eta_s": specs.PARAMETERS["eta_s"],
}
"""In the order of the columns of an export; in a grid the last varies fastest."""

_TOP = {"title": "a text", "study": "a section", "parameters": "a section"}
_STUDY = {
    "kind": "what is computed",
    "digits": "certified digits",
    "region": "where roots are counted",
    "certificates": "whether they are kept",
    "masses": "the number of masses",
    "design": "which cases are made of the parameters",
}
_DESIGN = {"kind": "the kind of design", "count": "the number of cases", "seed": "a whole number"}
_BOUNDS = dict.fromkeys(("re_min", "re_max", "im_min", "im_max"), "the bound of the rectangle")
_SPAN = {"low": "the least value", "high": "the bound above"}
_POSITIVE = ("eta_m", "d")
_ANY_SIGN = ("eta_n",)
_REACH = 10**12  # no parameter of a beam is beyond it, and float64 holds it
_BLOCK = (2_048, 16_384)  # cases of a block in float64: many share one start; fewer where there are few


@dataclass(frozen=True)
class Spec:
    """A study: `total` cases in `blocks` of `block` cases each, which are the units of work and of storage."""

    title: str
    kind: str
    digits: int
    region: Region
    certificates: bool
    masses: int
    design: str
    seed: int
    total: int
    axes: Mapping[str, Axis]

    @property
    def names(self) -> tuple[str, ...]:
        """The parameters that the spec gives, in the order of PARAMETERS."""
        return tuple(self.axes)

    @property
    def block(self) -> int:
        """Cases of a block: a function of the spec alone, because float64 digits depend on the neighbours."""
        least, most = _BLOCK
        return 1 if self.kind == "certified" else min(most, max(least, self.total // 16))

    @property
    def blocks(self) -> int:
        return -(-self.total // self.block)

    def indices(self, number: int) -> range:
        """The cases, counted from 0, of the block with this number."""
        return range(number * self.block, min((number + 1) * self.block, self.total))

    def values(self, index: int) -> dict[str, Value]:
        """The parameters of the case `index`, 0 ≤ index < total."""
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
        """The arguments of `work` for a block: a certified case goes alone, so that its cost is not that of all."""
        if self.kind != "certified":
            return self.text, number, number
        axes = {name: Listed((value,)) for name, value in self.values(number).items()}
        return replace(self, design="list", total=1, axes=axes).text, number, 0

    @cached_property
    def canonical(self) -> dict[str, Any]:
        """A mapping from which `read_spec` makes the same study; two studies are the same if these are equal."""
        region = self.region.as_dict() if isinstance(self.region, Rectangle) else self.region
        certified = {"digits": self.digits, "region": region, "certificates": self.certificates}
        drawn = {"count": self.total, "seed": self.seed} if self.design in ("random", "quasi-random") else {}
        return {
            "study": {
                "kind": self.kind,
                **(certified if self.kind == "certified" else {}),
                "masses": self.masses,
                "design": {"kind": self.design, **drawn},
            },
            "parameters": {name: axis.canonical for name, axis in self.axes.items()},
        }

    @cached_property
    def asked(self) -> str:
        """What is computed of each case, as JSON; it does not depend on the other cases."""
        return json.dumps(self.canonical["study"] | {"design": None}, sort_keys=True)

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
    table = specs.section(content["study"], "study", _STUDY)
    kind = _named(table, "study.kind", KINDS)
    if kind == "float64":
        for name in ("digits", "region", "certificates"):
            if name in table:
                raise InputError(f"study.{name}", 'is for kind = "certified" only: drop it')
    masses = _masses(table, kind)
    design, count, seed = _design(table)
    axes = _axes(content["parameters"], design, masses)
    return Spec(
        title=specs.title(content),
        kind=kind,
        digits=_whole(table, "digits", MIN_DIGITS, MIN_DIGITS, MAX_DIGITS),
        region=_region(table.get("region", "sheet")),
        certificates=_yes_or_no(table, "certificates"),
        masses=masses,
        design=design,
        seed=seed,
        total=_total(axes, design, count),
        axes=axes,
    )


def _masses(table: Mapping[str, Any], kind: str) -> int:
    masses = _whole(table, "masses", 2, 1, 3)
    if masses == 3 and kind == "float64":
        raise InputError("study.masses", 'is 3, and float64 takes one mass or two: use kind = "certified"')
    return masses


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
        raise InputError("study.design.count", "is missing: give the number of cases")
    return kind, _whole(given, "design.count", 0, 1, MAX_CASES), _whole(given, "design.seed", 0, 0, 2**63 - 1)


def _axes(given: Any, design: str, masses: int) -> dict[str, Axis]:
    table = specs.section(given, "parameters", PARAMETERS)
    pair = ("d", "mass_ratio")
    for name in ("alpha", "eta_b", "eta_m", *(("d",) if masses > 1 else ())):
        if name not in table:
            raise InputError(f"parameters.{name}", f"is missing: give {PARAMETERS[name]}")
    for name in pair:
        if masses == 1 and name in table:
            raise InputError(f"parameters.{name}", "is given, but study.masses is 1: drop one of the two")
    axes = {name: _axis(table[name], name, design) for name in PARAMETERS if name in table}
    for name, axis in axes.items():
        _check_bounds(axis, name)
    return axes


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
        return Listed((_value(given, key, name),))
    if not given:
        raise InputError(key, "is empty: give at least one value")
    values = [_value(one, f"{key}[{j}]", name) for j, one in enumerate(given, 1)]
    seen: set[Value] = set()
    for j, value in enumerate(values, 1):
        if design == "grid" and value in seen:
            raise InputError(f"{key}[{j}]", f"is {value}, which is there already: drop one")
        seen.add(value)
    return Listed(tuple(values))


def _value(given: Any, key: str, name: str) -> Value:
    if name == "d" and given == specs.ONE_MASS:
        return specs.ONE_MASS
    exact = Exact.parse(given, key)
    return exact.as_fraction() if exact.is_rational else exact


def _check_bounds(axis: Axis, name: str) -> None:
    """The bounds of single parameters; what depends on several is found case by case."""
    for value in axis.extremes:
        if not isinstance(value, str) and not -_REACH <= value <= _REACH:
            raise InputError(f"parameters.{name}", f"reaches beyond ±{_REACH}: give smaller values")
        if isinstance(value, str) or name in _ANY_SIGN or value > 0 or (value == 0 and name not in _POSITIVE):
            continue
        bound = "must be above 0" if name in _POSITIVE else "must not be below 0"
        raise InputError(f"parameters.{name}", f"reaches {specs.label(Exact.parse(value))}, but {bound}")


def _total(axes: Mapping[str, Axis], design: str, count: int) -> int:
    if count:
        return count
    lengths = {name: _counted(axis).count for name, axis in axes.items()}
    longest = max(lengths, key=lambda name: lengths[name])
    if design == "list":
        for name, length in lengths.items():
            if length not in (1, lengths[longest]):
                stated = f"has {length} values, and {longest} has {lengths[longest]}"
                raise InputError(f"parameters.{name}", f"{stated}: give as many, or one for all cases")
    total = lengths[longest] if design == "list" else prod(lengths.values())
    if total > MAX_CASES:
        raise InputError("parameters", f"make more than {MAX_CASES} cases: give at most so many")
    return total


def _counted(axis: Axis) -> Listed | Steps:
    if isinstance(axis, Span):
        raise ContradictionError("a range between bounds has no values of its own, and was counted")
    return axis


def _region(given: Any) -> Region:
    if isinstance(given, Mapping):
        return Rectangle(**specs.rationals(given, "study.region", _BOUNDS))
    named = _named({"region": given}, "study.region", ("sheet", "unstable"))
    return "sheet" if named == "sheet" else "unstable"


def _named(table: Mapping[str, Any], key: str, allowed: tuple[str, ...]) -> str:
    """The text under the last name of `key`."""
    name = key.rpartition(".")[2]
    return specs.choice({key: table[name]} if name in table else {}, key, allowed)


def _whole(table: Mapping[str, Any], key: str, default: int, low: int, high: int) -> int:
    number = table.get(key.rpartition(".")[2], default)
    if isinstance(number, bool) or not isinstance(number, int) or not low <= number <= high:
        raise InputError(f"study.{key}", f"is {number!r}: give a whole number from {low} to {high}")
    return number


def _yes_or_no(table: Mapping[str, Any], key: str) -> bool:
    value = table.get(key, False)
    if not isinstance(value, bool):
        raise InputError(f"study.{key}", f"is {value!r}: give true or false")
    return value
