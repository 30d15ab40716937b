"""The JSON Schema of what `mpsolve certify --json` prints; `spectrum_data` says what each key means."""

from __future__ import annotations

from mpsolve.report.spectrum_data import FORMAT, VERSION
from mpsolve.schemas import parts as p


def certify_schema() -> p.Schema:
    """The schema of version 2 of the report; later versions add keys and change none."""
    ball, maybe = {"$ref": "#/$defs/ball"}, p.maybe({"$ref": "#/$defs/ball"})
    root = {"re": ball, "im": ball, "multiplicity": p.POSITIVE}
    root |= {
        "axis": {"enum": ["none", "real", "imaginary"]},
        "trend": {"enum": ["grows", "decays", "steady", "open"]},
        "frequency": ball,
        "growth_rate": ball,
        "doubling_time": maybe,
        "halving_time": maybe,
        "shape": p.maybe(
            p.table(
                {
                    "bodies": p.by_name(p.table({"re": ball, "im": ball})),
                    "places": p.rows({"$ref": "#/$defs/exact"}),
                    "rail": p.rows(p.table({"re": ball, "im": ball})),
                }
            )
        ),
    }
    properties = {
        "format": {"const": FORMAT},
        "version": {"const": VERSION},
        "title": p.TEXT,
        "verdict": {"type": "string", "pattern": "^(STABLE|UNSTABLE|NO GROWTH|UNDECIDED)"},
        "status": p.STATUS,
        "reason": p.maybe({"$ref": "#/$defs/reason"}),
        "known": {"type": "object"},
        "warnings": p.rows({"$ref": "#/$defs/reason"}),
        "stable": {"type": ["boolean", "null"]},
        "region": {"$ref": "#/$defs/region"},
        "digits": {"type": "integer", "minimum": 15},
        "count": p.maybe(p.COUNT),
        "unstable": p.maybe(p.COUNT),
        "neutral": p.COUNT,
        "unfelt": p.rows(p.table({"re": ball, "im": ball})),
        "problem": {"oneOf": [{"$ref": "#/$defs/problem"}, {"$ref": "#/$defs/case"}]},
        "units": p.table(dict.fromkeys(("q", "frequency", "growth_rate", "time"), p.TEXT)),
        "roots": p.rows(p.table(root)),
        "proved": p.rows(p.TEXT),
        "verified": p.TEXT,
        "assumed": p.TEXT,
        "cost": p.table(
            {"seconds": p.SECONDS, "verification": p.SECONDS, "evaluations": p.COUNT, "pieces": p.COUNT}
        ),
        "certificate": {"type": ["string", "null"]},
    }  # fmt: skip
    title = "Report of mpsolve certify --json"
    return p.head("certify", title, VERSION) | p.table(properties) | {"$defs": _definitions()}


def spectrum_parts() -> tuple[p.Schema, p.Schema]:
    """(the definitions, the table) of a spectrum inside another answer."""
    whole = certify_schema()
    return whole.pop("$defs"), {key: value for key, value in whole.items() if key[0] != "$"}


def _definitions() -> p.Schema:
    exact = {"$ref": "#/$defs/exact"}
    model = {"$ref": "#/$defs/model"}
    return {
        "ball": p.ROUND,
        "exact": p.table({"exact": p.TEXT, "decimal": p.TEXT}, {"unit": p.TEXT})
        | {"description": "an exact number, its decimal, and the unit of a parameter in SI"},
        "reason": p.REASON,
        "region": p.table(
            {"kind": {"enum": ["unstable", "below", "rectangle", "sheet"]}, "words": p.TEXT},
            dict.fromkeys(("height", "reach", "radius", "re_min", "re_max", "im_min", "im_max"), exact),
        ),
        "model": p.table({"model": p.TEXT, "parameters": p.by_name({"$ref": "#/$defs/value"})}, {"position": exact}),
        "value": p.one_of(exact, model, p.TEXT, p.rows({"$ref": "#/$defs/value"})),
        "problem": p.table({"velocity": exact, "track": model, "vehicle": p.rows(model)}),
        "case": p.table({"case": p.by_name(p.one_of(exact, p.rows(exact)))}),
    }
