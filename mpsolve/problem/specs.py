"""Specifications of tables and studies, from a mapping or a TOML file, in exact numbers.

Every mistake is an InputError under its key, as in mpsolve/problem/casefile.py.
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from difflib import get_close_matches
from fractions import Fraction
from pathlib import Path
from typing import Any

from mpsolve.errors import InputError
from mpsolve.numbers.exact import Exact
from mpsolve.numbers.model import shown
from mpsolve.problem.toml import check_keys, kind, name_of, parsed, refuse_other_kind, text_of

_RANGE = {"start": "the first value", "stop": "the last value", "step": "the step between values"}


def load(spec: Mapping[str, Any] | str | os.PathLike[str], known: Mapping[str, str]) -> dict[str, Any]:
    """The content of a spec, with no key at the top that is not in `known`; numbers as they are written."""
    if isinstance(spec, Mapping):
        content = dict(spec)
    elif isinstance(spec, (str, os.PathLike)):
        file = Path(spec)
        content = parsed(text_of(file), name_of(file))
        refuse_other_kind(content, known, file)
    else:
        raise InputError("spec", f"is {kind(spec)}: give a mapping, or the path of a TOML file")
    check_keys(content, known, "")
    return content


def choice(content: Mapping[str, str], key: str, allowed: tuple[str, ...]) -> str:
    """The text under `key`, one of `allowed`; InputError with the nearest of them."""
    listed = ", ".join(f'"{one}"' for one in allowed)
    if key not in content:
        raise InputError(key, f"is missing: give one of {listed}")
    value = content[key]
    if value in allowed:
        return str(value)
    near = get_close_matches(value.lower(), allowed, n=1, cutoff=0.5) if isinstance(value, str) else []
    stated = repr(str(value)[:40]) if isinstance(value, str) else kind(value)
    raise InputError(key, f'is {stated}: did you mean "{near[0]}"?' if near else f"is {stated}: give one of {listed}")


def steps(given: Mapping[str, Any], key: str) -> tuple[Fraction, Fraction, int]:
    """start, step and number of start, start + step, … up to stop, which counts if whole steps lead there."""
    ends = rationals(given, key, _RANGE)
    start, stop, step = ends["start"], ends["stop"], ends["step"]
    if not step or (stop - start) / step < 0:
        stated = f"is {shown(step)}, which does not lead from start to stop"
        raise InputError(f"{key}.step", f"{stated}: change its sign or value")
    return start, step, (stop - start) // step + 1


def rationals(given: Mapping[str, Any], key: str, known: Mapping[str, str]) -> dict[str, Fraction]:
    """The numbers in a table that has all keys of `known`, each with its meaning, and no other."""
    check_keys(given, known, f"{key}.")
    numbers = {}
    for name, meaning in known.items():
        if name not in given:
            raise InputError(f"{key}.{name}", f"is missing: give {meaning}")
        exact = Exact.parse(given[name], f"{key}.{name}")
        if not exact.is_rational:
            raise InputError(f"{key}.{name}", "is irrational: give a decimal or a ratio p/q")
        numbers[name] = exact.as_fraction()
    return numbers
