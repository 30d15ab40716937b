"""TOML files: their text, their numbers as they are written, and their keys."""

from __future__ import annotations

import json
import re
import sys
import tomllib
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from mpsolve.errors import InputError
from mpsolve.numbers.units import measured

MAX_BYTES = 1_000_000
"""Largest file that is read; a case of a thousand masses takes a tenth of it."""
_CONTROLS = re.compile(r"[\x00-\x08\x0b\x0c\x0e-\x1f]")
_NO_TEXT = "is no text: give a TOML file, a plain text; no spreadsheet, no PDF"
_WRITTEN = "mpsolve new ballasted -o mine.toml writes an input file"
_AT = re.compile(r" \(at line (\d+), column \d+\)$")
_BARE = re.compile(r"([\w.\[\]-]+)\s*=\s*([^\"'\[{#]*?)\s*(#.*)?$")
_KINDS = {
    "study": ("a study", "mpsolve study"),
    "rows": ("a table", "mpsolve table"),
    "columns": ("a table", "mpsolve table"),
    "track": ("a problem", "mpsolve certify"),
    "physical": ("a case", "mpsolve certify"),
    "dimensionless": ("a case", "mpsolve certify"),
}
"""The key by which a kind of file is known, what it is, and the command for it."""
SOURCE = "where the numbers come from"


class Written(str):
    """A TOML float as it stands in the file, told apart from a TOML string."""

    __slots__ = ()


def name_of(file: Path) -> str:
    """How messages call the file; "-" is standard input."""
    return "standard input" if str(file) == "-" else str(file)


def text_of(file: Path) -> str:
    """Return the text of a regular UTF-8 file of at most `MAX_BYTES`, or of standard input for "-"."""
    try:
        content = _bytes(file)
        return content.decode("utf-8-sig")
    except OSError as error:
        reason = f"cannot be read ({error.strerror}): give the path of a readable TOML file"
    except UnicodeDecodeError as error:
        reason = _undecoded(error.object, error.start)
    raise InputError(name_of(file), reason)


def _undecoded(content: bytes, at: int) -> str:
    """What a file is that is no UTF-8, as far as its bytes tell, and what to do."""
    if content.startswith((b"\xff\xfe", b"\xfe\xff")):
        return "is a text in UTF-16: save it as UTF-8"
    if _CONTROLS.search(content.decode("latin-1")):
        return _NO_TEXT
    line = content[:at].count(b"\n") + 1
    return f"has a character in line {line} that is not in UTF-8: save the file as UTF-8"


def _bytes(file: Path) -> bytes:
    if str(file) == "-":
        return _short_enough(_standard_input(), file)
    if not file.is_file():
        state = "does not exist"
        if file.exists():
            state = "is a directory" if file.is_dir() else "is not a regular file"
        raise InputError(str(file), f"{state}: give the path of a TOML file")
    with file.open("rb") as stream:
        return _short_enough(stream.read(MAX_BYTES + 1), file)


def _standard_input() -> bytes:
    """What stands there, as often as it is asked for: a command may look twice at what kind of file it is."""
    stream = sys.stdin.buffer
    if not _seen or _seen[0] is not stream:
        _seen[:] = [stream, stream.read(MAX_BYTES + 1)]
    return bytes(_seen[1])


_seen: list[Any] = []


def _short_enough(content: bytes, file: Path) -> bytes:
    if len(content) > MAX_BYTES:
        raise InputError(name_of(file), f"is longer than {MAX_BYTES} bytes: give a file with one case")
    return content


def parsed(text: str, key: str) -> dict[str, Any]:
    """The tables of a TOML text, floats as they are written; InputError under `key` for a text that is none."""
    other = _not_toml(text, key)
    if other:
        raise InputError(key, other)
    try:
        return tomllib.loads(text, parse_float=Written)
    except tomllib.TOMLDecodeError as error:
        raise InputError(key, _broken(text, str(error))) from None
    except ValueError:  # Python refuses to read integers beyond its own limit of digits
        raise InputError(key, "has an integer with too many digits: give at most 400") from None
    except RecursionError:
        raise InputError(key, "is nested too deeply: lists in lists have no meaning here") from None


def _not_toml(text: str, name: str) -> str:
    """What the text is where it is no TOML at all, and what to do; "" where it may be TOML."""
    if _CONTROLS.search(text):
        return _NO_TEXT
    start = text.lstrip()[:1]
    if start == "{":
        try:
            format_ = str(json.loads(text).get("format", ""))
        except (ValueError, RecursionError):
            format_ = ""
        if "certificate" in format_:
            return f"is a certificate, not an input file: check it with mpsolve verify {name}"
        if format_.startswith("mpsolve"):
            return f"is an answer ({format_}), not an input file: give the TOML file that was asked about"
        return f"is JSON, not TOML: {_WRITTEN}"
    if start == "<":
        return f"is a web page or a picture, not TOML: {_WRITTEN}"
    if "\r" in text.replace("\r\n", ""):
        return "has lines that end in a carriage return alone: save it with the line ends of Windows or Unix"
    said = "".join(line for line in text.splitlines(keepends=True) if not line.lstrip().startswith("#"))
    if said.strip() and not {"=", "["} & set(said):
        table = any(mark in said for mark in ",;\t")
        return f"is {'a table of values' if table else 'a text'}, not TOML, which has lines like v = 10: {_WRITTEN}"
    return ""


def _broken(text: str, said: str) -> str:
    """What is wrong with a line that is no TOML, in the words of people, and how it is written."""
    at = _AT.search(said)
    why = _AT.sub("", said)
    if at is None:
        return f"is not valid TOML ({why}): close what is open at its end"
    line = text.splitlines()[int(at[1]) - 1].strip() if text else ""
    bare = _BARE.match(line)
    shown = f"{bare[1]} = {bare[2]}" if bare else line
    head = f"is not valid TOML in line {at[1]}, {shown[:60].strip()}"
    if bare and not bare[2]:
        return f"{head}: give a value behind the ="
    if bare and re.fullmatch(r"[+-]?\d+,\d[\w+-]*", bare[2]):
        return f"{head}: write the number with a point, as {bare[1]} = {bare[2].replace(',', '.')}"
    if bare and re.match(r"[+-]?[\d.]+\s*[^\W\d]|[^\W\d]", bare[2]):
        return f'{head}: put a value with a unit, or a word, in quotes, as {bare[1]} = "{bare[2]}"'
    if "twice" in why or "overwrite" in why:
        return f"{head} ({why}): it stands there for the second time, keep one"
    return f"{head} ({why}): correct it there"


def refuse_other_kind(content: Mapping[str, Any], known: Mapping[str, Any], file: Path) -> None:
    """InputError that names the right command, where the tables are those of another kind of file.

    known: the keys of the kind that is wanted.
    """
    for key, (kind_, command) in _KINDS.items():
        if key in content and key not in known:
            raise InputError(name_of(file), f"is {kind_}, as its [{key}] shows: use {command} {file}")


def check_keys(table: Mapping[str, Any], known: Mapping[str, str], prefix: str) -> None:
    """InputError under the first key of the table that is not known, with the nearest one that is."""
    for name in table:
        if name not in known:
            from difflib import get_close_matches

            lower = {candidate.lower(): candidate for candidate in known}
            near = get_close_matches(name.lower(), lower, n=1, cutoff=0.5)
            if "spacing" in name.lower() and prefix.startswith("track"):
                stated = "is unknown: values are per metre of track, so divide them by the distance of the sleepers"
                raise InputError(f"{prefix}{_shown(name)}", f'{stated} first, as m_sleeper = "145 kg/(0.6 m)"')
            advice = f"did you mean {lower[near[0]]}?" if near else f"the keys here are {', '.join(known)}"
            raise InputError(f"{prefix}{_shown(name)}", f"is unknown: {advice}")


def _shown(name: str) -> str:
    return name if name.isidentifier() and len(name) <= 40 else repr(name[:40])


def kind(value: object) -> str:
    """The name that TOML has for the type of `value`, or Python's where it has none."""
    kinds = {bool: "a boolean", int: "a number", Written: "a number", str: "a text", list: "a list", dict: "a table"}
    if type(value) in kinds:
        return kinds[type(value)]
    from datetime import date, time

    return "a date or time" if isinstance(value, (date, time)) else f"of type {type(value).__name__}"


def title_of(content: Mapping[str, Any]) -> str:
    """The title of a file, "" where it has none."""
    text = content.get("title", "")
    if type(text) is not str:
        raise InputError("title", f'is {kind(text)}, not a text: write title = "…"')
    return text


def sections(content: Mapping[str, Any], key: str, each: str = "") -> list[Any]:
    """The sections of that name in double brackets; none where there is none."""
    entries = content.get(key, [])
    if not isinstance(entries, list):
        raise InputError(key, f"is {kind(entries)}: write [[{key}]] in double brackets for each{each}")
    return entries


def section(
    value: object, key: str, known: Mapping[str, str], units: Mapping[str, str] | None = None
) -> dict[str, Any]:
    """The entries of a section, none of which is unknown; a text with a unit of its own is converted."""
    if not isinstance(value, Mapping):
        raise InputError(key, f"is {kind(value)}, not a section: give {', '.join(known)} in it")
    check_keys(value, known, f"{key}.")
    own = units or {}
    return {name: measured(x, own[name], f"{key}.{name}") if name in own else x for name, x in value.items()}


def sources_of(content: Mapping[str, Any]) -> tuple[str, ...]:
    """The sources of the file, its track and its vehicles, each once; InputError for what is no text."""
    found = [*_texts(content.get("source"), "source")]
    track, placed = content.get("track"), content.get("vehicle")
    if isinstance(track, dict):
        found += [f"Track: {text}" for text in _texts(track.get("source"), "track.source")]
    for j, entry in enumerate(placed if isinstance(placed, list) else [], 1):
        if isinstance(entry, dict):
            found += [f"Vehicle: {text}" for text in _texts(entry.get("source"), f"vehicle[{j}].source")]
    return tuple(dict.fromkeys(found))


def _texts(given: str | None, key: str) -> list[str]:
    each = [] if given is None else given if isinstance(given, list) else [given]
    for one in each:
        if type(one) is not str or not one.strip():
            stated = "is empty" if type(one) is str else f"is {kind(one)}, not a text"
            raise InputError(key, f'{stated}: write source = "…", a book, a paper or a measurement')
    return [" ".join(one.split()).rstrip(".") for one in each]
