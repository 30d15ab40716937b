"""The problem of a study as plain tables: from the study's own file, or from the one that it names."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from mpsolve.errors import InputError
from mpsolve.numbers.exact import Exact
from mpsolve.numbers.model import rational
from mpsolve.problem.toml import Written, parsed, text_of

PROBLEM = ("v", "track", "vehicle", "physical", "mass", "dimensionless")
"""The keys of a problem file that say what is computed."""


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
