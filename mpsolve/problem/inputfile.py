"""Read a problem from a TOML file: any track, any vehicles, or one of the paper's cases.

What a model takes stands in its own class; keys, bounds and messages come from there.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from difflib import get_close_matches
from pathlib import Path
from typing import Any, TypeVar

from mpsolve import tracks, vehicles
from mpsolve.errors import InputError
from mpsolve.frozen import frozen
from mpsolve.numbers.model import Model, Part, defaults, quantities
from mpsolve.numbers.units import split
from mpsolve.problem import toml
from mpsolve.problem.case import Case
from mpsolve.problem.casefile import InputFile, input_of, loads_in
from mpsolve.problem.cases import as_problem
from mpsolve.problem.checked import errors_under
from mpsolve.problem.lines import line_of
from mpsolve.problem.load import gives_forces
from mpsolve.problem.physical import PhysicalCase
from mpsolve.problem.problem import Problem
from mpsolve.problem.warned import Title
from mpsolve.vehicles.load import Load
from mpsolve.vehicles.vehicle import Placed

_M = TypeVar("_M", bound=Model)
_TOP = {
    "title": "a text",
    "source": toml.SOURCE,
    "v": "the velocity in m/s",
    "track": "a section",
    "vehicle": "sections",
    "load": "sections",
}
PLACE = {
    "position": "where its middle is, in m",
    "count": "how many of it run in a row",
    "spacing": "the distance from one to the next, in m",
    "source": toml.SOURCE,
}
LOAD = {
    "constant": "the constant force in N",
    "amplitude": "the amplitude of the harmonic force in N",
    "frequency": "its frequency in rad/s",
    "phase": "its phase in rad",
}
LOAD_UNITS = {"constant": "N", "amplitude": "N", "frequency": "rad/s", "phase": "rad"}


@frozen
class ProblemFile:
    """A problem that has passed every check, with the title ("" if none) and the path of its file.

    loads: the forces at the contacts from rear to front, or None where the file gives none.
    case: the paper's case that the file holds, or None. sources: where the numbers come from, as the file says.
    """

    problem: Problem
    title: str
    path: Path
    loads: tuple[Load, ...] | None = None
    case: Case | PhysicalCase | None = None
    sources: tuple[str, ...] = ()

    @property
    def given(self) -> Problem | Case | PhysicalCase:
        """What the file describes."""
        return self.problem if self.case is None else self.case


def read_problem(path: str | Path) -> ProblemFile:
    """The problem in the TOML file at `path`, each number exactly as written (0.1 is 1/10).

    The file holds v, [track] with `model` and its parameters, and [[vehicle]] with `model`, its parameters and its
    `position` (0 if left out), or `count` and `spacing` of a train whose rearmost one stands there. [[load]] gives
    the force at each contact from rear to front, or at none. Or it is a file as for `read_case`.
    InputError names the key at fault, such as track.k_pad or vehicle[2].wheel (counted from 1).
    """
    source = read_source(path)
    return source if isinstance(source, ProblemFile) else problem_file(source)


def problem_of(content: Mapping[str, Any], file: Path) -> ProblemFile:
    """The problem in the tables of a file, as `read_problem` reads it."""
    source = source_of(content, file)
    return source if isinstance(source, ProblemFile) else problem_file(source)


def read_source(path: str | Path) -> ProblemFile | InputFile:
    """The same, but a case of the paper stays the case that it is, whose ratios may be irrational."""
    file = Path(path)
    text = toml.text_of(file)
    content = toml.parsed(text, toml.name_of(file))
    toml.refuse_other_kind(content, _TOP | {"physical": "a section", "dimensionless": "a section"}, file)
    source = source_of(content, file)
    return replace(source, title=Title(source.title, _bare(content, text)))


def _bare(content: Mapping[str, Any], text: str) -> bool:
    """Whether the velocity stands without a unit, and without one in the comment beside it."""
    table, key = (content["physical"], "physical.v") if "physical" in content else (content, "v")
    if "v" not in table or split(str(table["v"]))[1]:
        return False
    line = line_of(text, key)
    return line is None or "m/s" not in text.splitlines()[line - 1]


def source_of(content: Mapping[str, Any], file: Path) -> ProblemFile | InputFile:
    """The same from the tables of a file."""
    if not {"track", "vehicle", "v"} & content.keys():
        return _known_case(content, file)
    for other in ("physical", "dimensionless", "mass"):
        if other in content:
            raise InputError(other, "stands beside [track] and [[vehicle]]: keep only one of the two descriptions")
    toml.check_keys(content, _TOP, "")
    title = toml.title_of(content)
    track = _model(
        _present(content, "track", "add [track] with its model"), "track", tracks.CATALOGUE, {"source": toml.SOURCE}
    )
    _present(content, "vehicle", "add [[vehicle]] with its model")
    placed = [one for j, entry in enumerate(toml.sections(content, "vehicle"), 1) for one in _vehicle(entry, j)]
    problem = Problem(track, placed, v=_present(content, "v", "give the velocity in m/s, 0 for vehicles at rest"))
    return ProblemFile(
        problem, title, file, _loads(content, problem.pencil.contacts), sources=toml.sources_of(content)
    )


def _known_case(content: Mapping[str, Any], file: Path) -> InputFile:
    if not {"physical", "dimensionless", "mass"} & content.keys():
        toml.check_keys(
            content, _TOP | {"physical": "a section", "dimensionless": "a section", "mass": "sections"}, ""
        )
        raise InputError(
            toml.name_of(file), "holds no problem: add v, [track] and [[vehicle]], or [physical] with [[mass]]"
        )
    return input_of(content, file)


def problem_file(source: InputFile) -> ProblemFile:
    """The paper's case in a file as a problem, with its own forces."""
    loads, case = source.loads, source.case
    if isinstance(case, PhysicalCase) and gives_forces(case):
        loads = tuple(Load(mass.P, mass.P_A, mass.omega_f, mass.phi_f) for mass in case.masses)
    with errors_under("" if isinstance(case, PhysicalCase) else "dimensionless."):
        return ProblemFile(as_problem(case), source.title, source.path, loads, case, source.sources)


def _present(content: Mapping[str, Any], key: str, advice: str) -> Any:
    if key not in content:
        raise InputError(key, f"is missing: {advice}")
    return content[key]


def _vehicle(entry: object, j: int) -> tuple[Placed, ...]:
    key = f"vehicle[{j}]"
    model = _model(entry, key, vehicles.CATALOGUE, PLACE)
    given = dict(entry) if isinstance(entry, dict) else {}
    with errors_under(f"{key}."):
        at = model.at(given.get("position", 0)).position
        if ("count" in given) != ("spacing" in given):
            missing = "spacing" if "count" in given else "count"
            raise InputError(missing, f"is missing: give {PLACE[missing]}, or leave count and spacing out")
        row = vehicles.train(model, given["count"], given["spacing"]) if "count" in given else (model.at(0),)
    return tuple(Placed(model, at + one.position) for one in row)


def _model(entry: object, key: str, catalogue: Sequence[type[_M]], more: Mapping[str, str] | None = None) -> _M:
    """The model that a section describes; `more` names the keys that are not the model's own."""
    names = {model.name: model for model in catalogue}  # type: ignore[attr-defined]
    if not isinstance(entry, dict):
        raise InputError(key, f"is {toml.kind(entry)}, not a section: give its model, one of {', '.join(names)}")
    name = entry.get("model")
    if name is None:
        raise InputError(f"{key}.model", f"is missing: give one of {', '.join(names)}")
    if not isinstance(name, str) or name not in names:
        near = get_close_matches(str(name).lower(), names, n=1, cutoff=0.5)
        advice = f"did you mean {near[0]}?" if near else f"the models are {', '.join(names)}"
        raise InputError(f"{key}.model", f"is {str(name)[:40]!r}, which is unknown: {advice}")
    own = {given: value for given, value in entry.items() if given not in ("model", *(more or {}))}
    return _made(names[name], own, key, {"model": "the name of the model"} | dict(more or {}))


def _made(model: type[_M], own: dict[str, Any], key: str, more: Mapping[str, str]) -> _M:
    """The model from its own keys, every one of which is described by its class."""
    described, optional = quantities(model), defaults(model)
    toml.check_keys(own, {name: quantity.meaning for name, quantity in described.items()} | dict(more), f"{key}.")
    for name, quantity in described.items():
        if name not in own and name not in optional:
            raise InputError(f"{key}.{name}", f"is missing: give the {quantity.told}")
        if isinstance(quantity, Part):
            part = own[name]
            if not isinstance(part, dict):
                raise InputError(f"{key}.{name}", f"is {toml.kind(part)}, not a section: give its parameters in it")
            inner = {inner: value for inner, value in part.items() if (inner, value) != ("model", quantity.kind.name)}
            own = own | {name: _made(quantity.kind, inner, f"{key}.{name}", {})}
    with errors_under(f"{key}."):
        return model(**own)


def _loads(content: Mapping[str, Any], contacts: int) -> tuple[Load, ...] | None:
    loads = loads_in(content, LOAD, LOAD_UNITS)
    if loads is not None and len(loads) != contacts:
        stated = f"is given for {len(loads)}, not {contacts} contacts"
        raise InputError("load", f"{stated}: give one [[load]] for each contact from rear to front, or none")
    return loads
