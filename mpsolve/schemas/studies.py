"""Studies: the file that asks for one, what is exported, what `status` tells; and starting values for solvers."""

from __future__ import annotations

from mpsolve.schemas import parts as p
from mpsolve.schemas.input import input_schema

_NUMBER = p.one_of(p.REAL, p.TEXT)
_AXIS = p.one_of(
    _NUMBER,
    {"type": "array", "minItems": 1, "items": _NUMBER},
    p.table({"start": _NUMBER, "stop": _NUMBER, "step": _NUMBER}),
    p.table({"low": _NUMBER, "high": _NUMBER}, {"parts": p.COUNT}),
)
_BOUNDS = dict.fromkeys(("re_min", "re_max", "im_min", "im_max"), _NUMBER)
_REGION = p.one_of({"enum": ["unstable", "sheet"]}, p.table({"below": _NUMBER}), p.table(_BOUNDS))


def study_file_schema() -> p.Schema:
    """A study: a problem as in a problem file, or the path of one, with a plan."""
    whole = input_schema()
    study = {
        "kind": {"enum": ["certified", "float64", "stable"]},
        "digits": {"type": "integer", "minimum": 15},
        "region": _REGION,
        "roots": p.YES,
        "certificates": p.YES,
        "boxes": p.POSITIVE,
        "design": p.table(
            {"kind": {"enum": ["grid", "list", "random", "quasi-random"]}}, {"count": p.COUNT, "seed": p.COUNT}
        ),
    }
    plan: p.Schema = {"study": p.table({}, study), "parameters": p.by_name({"anyOf": [_AXIS, p.by_name(_AXIS)]})}
    kinds = []
    for name in ("problem", "physical", "dimensionless"):
        inner = whole["$defs"][name]["properties"]
        needed = {key: inner[key] for key in whole["$defs"][name]["required"]}
        kinds.append(p.table(needed | plan, {key: value for key, value in inner.items() if key not in needed}))
    kinds.append(p.table({"problem": p.TEXT} | plan, {"title": p.TEXT}))
    definitions = {
        key: value for key, value in whole["$defs"].items() if key.startswith(("track-", "vehicle-", "load"))
    }
    return p.head("study-file", "Input of mpsolve study") | {"oneOf": kinds, "$defs": definitions}


def study_schema() -> p.Schema:
    """Of `mpsolve export --to json`."""
    certified = {
        "re": p.ROUND,
        "im": p.ROUND,
        "multiplicity": p.POSITIVE,
        "axis": {"enum": ["none", "real", "imaginary"]},
    }
    entry = {
        "index": p.COUNT,
        "parameters": p.by_name(p.TEXT),
        "values": p.by_name(p.REAL),
        "status": p.TEXT,
        "reason": p.TEXT,
        "count": p.maybe(p.COUNT),
        "unstable": p.maybe(p.COUNT),
        "roots": p.rows(p.one_of(p.rows(p.REAL), p.table(certified))),
    }
    keys: p.Schema = {
        "title": p.TEXT,
        "engine": p.TEXT,
        "spec": {"type": "object"},
        "units": p.by_name(p.TEXT),
        "total": p.COUNT,
        "tally": p.by_name(p.COUNT),
        "assumed": p.TEXT,
        "entries": p.rows(p.table(entry, {"certificate": {"type": "object"}})),
    }
    return p.document("study", "Entries of a study, from mpsolve export", "mpsolve study", 3, keys)


def status_schema() -> p.Schema:
    """Of `mpsolve status --json`."""
    keys: p.Schema = {
        "title": p.TEXT,
        "engine": p.TEXT,
        "spec": {"type": "object"},
        "total": p.COUNT,
        "finished": p.COUNT,
        "tally": p.by_name(p.COUNT),
    }
    return p.document("status", "Answer of mpsolve status", "mpsolve study status", 1, keys)


def seeds_schema() -> p.Schema:
    """Of `seeds(...).save("seeds.json")`."""
    seed = {"case": p.rows(p.TEXT), "q": p.rows(p.REAL), "radius": p.REAL, "roots": p.COUNT}
    keys: p.Schema = {
        "claim": p.TEXT,
        "parameters": p.rows(p.TEXT),
        "seeds": p.rows(p.table(seed)),
        "missing": p.rows({}),
        "undecided": p.rows({}),
    }
    return p.document("seeds", "Starting values of the library's seeds()", "mpsolve seeds", 2, keys)
