"""TOML files: their text, their numbers as they are written, and their keys."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from difflib import get_close_matches
from pathlib import Path
from typing import Any

from mpsolve.errors import InputError

MAX_BYTES = 1_000_000
"""Largest file that is read; a case of a thousand masses takes a tenth of it."""


class Written(str):
    """A TOML float as it stands in the file, told apart from a TOML string."""

    __slots__ = ()


def text_of(file: Path) -> str:
    """Return the text of a regular UTF-8 file of at most `MAX_BYTES`."""
    try:
        content = _bytes(file)
        return content.decode("utf-8-sig")
    except OSError as error:
        reason = f"cannot be read ({error.strerror}): give the path of a readable TOML file"
    except UnicodeDecodeError as error:
        reason = f"is not UTF-8 at byte {error.start}: save it as UTF-8 text"
    raise InputError(str(file), reason)


def _bytes(file: Path) -> bytes:
    if not file.is_file():
        state = "does not exist"
        if file.exists():
            state = "is a directory" if file.is_dir() else "is not a regular file"
        raise InputError(str(file), f"{state}: give the path of a TOML file")
    with file.open("rb") as stream:
        content = stream.read(MAX_BYTES + 1)
    if len(content) > MAX_BYTES:
        raise InputError(str(file), f"is longer than {MAX_BYTES} bytes: give a file with one case")
    return content


def parsed(text: str, key: str) -> dict[str, Any]:
    """The tables of a TOML text, floats as they are written; InputError under `key` for a text that is none."""
    try:
        return tomllib.loads(text, parse_float=Written)
    except tomllib.TOMLDecodeError as error:
        raise InputError(key, f"is not valid TOML ({error}): correct it there") from None
    except ValueError:  # Python refuses to read integers beyond its own limit of digits
        raise InputError(key, "has an integer with too many digits: give at most 400") from None
    except RecursionError:
        raise InputError(key, "is nested too deeply: lists in lists have no meaning here") from None


def check_keys(table: Mapping[str, Any], known: Mapping[str, str], prefix: str) -> None:
    """InputError under the first key of the table that is not known, with the nearest one that is."""
    for name in table:
        if name not in known:
            lower = {candidate.lower(): candidate for candidate in known}
            near = get_close_matches(name.lower(), lower, n=1, cutoff=0.5)
            advice = f"did you mean {lower[near[0]]}?" if near else f"the keys here are {', '.join(known)}"
            shown = name if name.isidentifier() and len(name) <= 40 else repr(name[:40])
            raise InputError(f"{prefix}{shown}", f"is unknown: {advice}")


def kind(value: object) -> str:
    """Return the name that TOML has for the type of `value`."""
    kinds = {bool: "a boolean", int: "a number", Written: "a number", str: "a text", list: "a list"}
    return "a table" if isinstance(value, dict) else kinds.get(type(value), "a date or time")
