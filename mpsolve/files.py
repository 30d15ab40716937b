"""Files that are written whole or not at all."""

from __future__ import annotations

import io
import json
import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any, BinaryIO

from mpsolve.errors import CertificateError, InputError


def write_whole(path: Path, content: str | bytes) -> Path:
    """Writes `content` beside `path` first and then moves it there."""
    with whole_file(path) as file:
        file.write(content.encode("utf-8") if isinstance(content, str) else content)
    return path


@contextmanager
def whole_file(path: Path) -> Iterator[BinaryIO]:
    """A file beside `path` that is moved there at the end, or removed after an error.

    A link is followed; a device or a pipe, such as /dev/stdout, is written to as it is. Raises CertificateError if it
    cannot be written.
    """
    try:
        if path.exists() and not path.is_file() and not path.is_dir():
            with path.open("wb") as file:
                yield file
            return
        path = path.resolve()
        name = path.with_name(f".{path.name}.{os.urandom(4).hex()}")
        file = name.open("xb")
        try:
            with file:
                yield file
                file.flush()
                os.fsync(file.fileno())
            os.chmod(name, 0o644)
            os.replace(name, path)
        except BaseException:
            name.unlink()
            raise
    except OSError as error:
        cause = error.strerror or str(error)
        raise CertificateError(f"{path} cannot be written: {cause}; nothing was changed there") from error


def checked_suffix(path: Path, allowed: tuple[str, ...], key: str = "output") -> str:
    """The suffix of the path in lower case; InputError under `key` if it is not one of those allowed."""
    suffix = path.suffix.lower()
    if suffix not in allowed:
        raise InputError(key, f"{path} does not end in {', '.join(allowed)}: give a name that does")
    return suffix


def csv_text(rows: Iterable[Iterable[Any]]) -> str:
    """Rows as CSV, with the line ends of Unix."""
    import csv

    stream = io.StringIO()
    csv.writer(stream, lineterminator="\n").writerows(rows)
    return stream.getvalue()


def save_columns(table: Mapping[str, Any], path: Path) -> Path:
    """CSV, each number with all its digits; CertificateError if it cannot be written."""
    numbers = ([repr(float(x)) for x in row] for row in zip(*table.values(), strict=True))
    return write_whole(path, csv_text([table, *numbers]))


def save_arrays(arrays: Mapping[str, Any], path: Path) -> Path:
    """NPZ; CertificateError if it cannot be written."""
    import numpy as np

    stream = io.BytesIO()
    np.savez(stream, **arrays)
    return write_whole(path, stream.getvalue())


def save_json(table: Mapping[str, Any], path: Path, title: str, said: Sequence[str]) -> Path:
    """The same as an object: format, version, title, columns with name, unit and values, what is said."""
    columns = []
    for name, values in table.items():
        bare, _, unit = (
            name.removesuffix("]").rpartition(" [") if name.endswith("]") and " [" in name else (name, "", "")
        )
        columns.append({"name": bare, "unit": unit, "values": [float(x) for x in values]})
    content = {"format": "mpsolve response", "version": 1, "title": title, "columns": columns, "said": list(said)}
    return write_whole(path, json.dumps(content, ensure_ascii=False, indent=1, allow_nan=False) + "\n")
