"""Exports of a study: CSV and JSON here, NPZ and Parquet in mpsolve/studies/arrays.py; one block in memory at a time.

Every format has a line, object or row for each finished case, in the order of the design; `index` counts from 0.
The bytes depend on the study only, not on when and by whom its entries were computed.
"""

from __future__ import annotations

import csv
import json
import os
from collections.abc import Callable
from decimal import Context, Decimal, Inexact
from io import TextIOWrapper
from pathlib import Path
from typing import Any, BinaryIO

from mpsolve.errors import StudyError
from mpsolve.files import checked_suffix, whole_file
from mpsolve.studies.arrays import stored_results
from mpsolve.studies.blocks import ENGINE, Result, Root
from mpsolve.studies.columns import frequency_units, parameter_titles, root_titles, unit_of
from mpsolve.studies.design import Value
from mpsolve.studies.spec import Spec
from mpsolve.studies.store import Store, store_path

FORMAT = "mpsolve study"
VERSION = 3
ASSUMED = (
    "The model: an infinite track and vehicles that move at a constant velocity and never leave it, linear. The "
    "software: Python, and FLINT's ball arithmetic for what is certified; float64 results prove nothing."
)
KINDS = ("csv", "json", "npz", "parquet")
_DIGITS = Context(prec=15, traps=[Inexact])
_LONGEST = 24  # characters of a decimal


def export(store: str | os.PathLike[str], path: str | os.PathLike[str]) -> Path:
    """Writes the finished entries of the study in `store` to .csv, .json, .npz or .parquet, whole or not at all.

    Raises InputError for another name, CertificateError if it cannot be written, StudyError if the store is
    damaged or holds nothing.
    """
    from mpsolve.studies.arrays import write_npz, write_parquet

    file = Path(path)
    suffix = checked_suffix(file, tuple(f".{kind}" for kind in KINDS))
    writers: tuple[Callable[[Store, BinaryIO], None], ...] = write_csv, write_json, write_npz, write_parquet
    with Store.read(store_path(store)) as source:
        if not source.tally():
            raise StudyError(f"{store} holds no results of this version yet: run the study first")
        with whole_file(file) as target:
            dict(zip(KINDS, writers, strict=True))[suffix.removeprefix(".")](source, target)
    return file


def value_text(value: Value) -> str:
    """A decimal if 15 digits hold it, else p/q."""
    try:
        text = f"{_DIGITS.divide(Decimal(value.numerator), Decimal(value.denominator)):f}"
    except Inexact:
        return str(value)
    return text if len(text) <= _LONGEST else str(value)


def write_csv(source: Store, target: BinaryIO) -> None:
    """index, the parameters, status, reason, count, unstable, re_1, im_1, …: a root stands as often as it counts.

    A parameter is a decimal, exact where a short one is, else the nearest float; JSON has all of them exactly.
    A certified root's decimals are right to one unit in the last digit, a float64 root's give the floats back.
    """
    names, width = source.spec.names, source.width()
    with _text(target) as stream:
        writer = csv.writer(stream, lineterminator="\n")
        roots = [title for k in range(1, width + 1) for title in root_titles(source.spec, k)]
        writer.writerow(["index", *parameter_titles(source.spec), "status", "reason", "count", "unstable", *roots])
        for index, values, result in stored_results(source):
            given = (text if "/" not in (text := value_text(values[name])) else float(values[name]) for name in names)
            parts = [part for root in counted(result) for part in (root.re, root.im)]
            parts += [""] * (2 * width - len(parts))
            writer.writerow([index, *given, result.status, result.reason, result.count, result.unstable, *parts])


def counted(result: Result) -> list[Root]:
    """The roots, each as often as its multiplicity says."""
    return [root for root in result.roots for _ in range(root.multiplicity)]


def write_json(source: Store, target: BinaryIO) -> None:
    """An object with these keys, each entry on a line of its own.

    format, version   "mpsolve study", 3; a version adds no meaning to a key that is there
    title, engine     the version that computed the results
    spec              the spec, its numbers as exact texts
    units             of each parameter, and of re and im
    total, tally      the number of entries of the study, and of the finished ones by status
    assumed           what the results rest on
    entries           for each finished one
        index, parameters (texts: decimals where short ones are exact, else p/q), values (floats), status, reason
        count, unstable   null where it is not known
        roots             float64: [re, im]; certified: re, im {"value", "radius"}: the exact number is within radius
                          of value; multiplicity; axis, "none", "real" or "imaginary": where it is proved to lie
        certificate       only if the study keeps certificates and there is one
    """
    spec = source.spec
    head = {
        "format": FORMAT,
        "version": VERSION,
        "title": spec.title,
        "engine": ENGINE,
        "spec": spec.canonical,
        "units": units(spec),
        "total": spec.total,
        "tally": dict(sorted(source.tally().items())),
        "assumed": ASSUMED,
    }
    with _text(target) as stream:
        stream.write(json.dumps(head, indent=1, ensure_ascii=False).removesuffix("\n}") + ',\n "entries": [')
        separator = "\n"
        for index, values, result in stored_results(source):
            given = {name: value_text(value) for name, value in values.items()}
            near = {name: float(value) for name, value in values.items()}
            one = {"index": index, "parameters": given, "values": near, **_result(result)}
            stream.write(separator + json.dumps(one, ensure_ascii=False, allow_nan=False))
            separator = ",\n"
        stream.write("\n]}\n")


def units(spec: Spec) -> dict[str, str]:
    """Of each parameter, and of re and im; none for a dimensionless case."""
    re, im = frequency_units(spec)
    own = {path: unit_of(spec.base, path) if re else "" for path in spec.names}
    return own | {"re": re, "im": im}


def _result(result: Result) -> dict[str, Any]:
    content: dict[str, Any] = {
        "status": result.status,
        "reason": result.reason,
        "count": result.count,
        "unstable": result.unstable,
        "roots": [_root(root) for root in result.roots],
    }
    if result.certificate is not None:
        content["certificate"] = result.certificate.content
    return content


def _root(root: Root) -> Any:
    if isinstance(root.re, float):
        return [root.re, root.im]
    return {
        "re": {"value": root.re, "radius": root.re_radius},
        "im": {"value": root.im, "radius": root.im_radius},
        "multiplicity": root.multiplicity,
        "axis": root.axis,
    }


class _text(TextIOWrapper):  # noqa: N801
    """UTF-8 text on a binary file that stays open."""

    def __init__(self, target: BinaryIO) -> None:
        super().__init__(target, encoding="utf-8", newline="")

    def __exit__(self, *_: object) -> None:
        self.detach()
