"""Exports of a study as arrays: NPZ for NumPy, Parquet for data frames. Numbers are float64 there."""

from __future__ import annotations

import shutil
import tempfile
from collections.abc import Iterator
from contextlib import ExitStack
from itertools import islice
from typing import Any, BinaryIO
from zipfile import ZipFile, ZipInfo

import numpy as np

from mpsolve.errors import InputError
from mpsolve.studies.blocks import STATUSES, Result, checked
from mpsolve.studies.columns import parameter_titles
from mpsolve.studies.design import Value
from mpsolve.studies.spec import Spec
from mpsolve.studies.store import Store

_ROWS = 16_384  # entries in memory at a time
_Row = tuple[int, dict[str, Value], Result]


def write_npz(source: Store, target: BinaryIO) -> None:
    """Arrays over the finished entries, as `numpy.load` reads them.

    index int64; each parameter float64, named by its path and unit; status int8, an index into status_names; count
    and unstable int32, −1 where not known; q complex128 (entries, n): each root as often as it counts, then nan.
    """
    number, width = sum(source.tally().values()), source.width()
    columns = _columns(source, width)
    with ExitStack() as stack, ZipFile(target, "w") as archive:
        files = {name: stack.enter_context(tempfile.TemporaryFile()) for name in columns}
        for name, (kind, shape) in columns.items():
            header = {"descr": np.dtype(kind).str, "fortran_order": False, "shape": (number, *shape)}
            np.lib.format.write_array_header_1_0(files[name], header)
        for rows in _bunches(source):
            for name, column in _arrays(source, rows, width).items():
                files[name].write(column.astype(columns[name][0]).tobytes())
        for name, file in files.items():
            file.seek(0)
            with archive.open(ZipInfo(f"{name}.npy"), "w", force_zip64=True) as member:
                shutil.copyfileobj(file, member, 1 << 20)
        with archive.open(ZipInfo("status_names.npy"), "w", force_zip64=True) as member:
            np.lib.format.write_array(member, np.array(STATUSES[source.spec.kind]))


def _columns(source: Store, width: int) -> dict[str, tuple[str, tuple[int, ...]]]:
    """The type, little-endian on every machine, and the shape of an element of each array."""
    parameters = dict.fromkeys(parameter_titles(source.spec), ("<f8", ()))
    plain = {"status": ("i1", ()), "count": ("<i4", ()), "unstable": ("<i4", ())}
    return {"index": ("<i8", ()), **parameters, **plain, "q": ("<c16", (width,))}


def _bunches(source: Store) -> Iterator[list[_Row]]:
    rows = stored_results(source)
    while bunch := list(islice(rows, _ROWS)):
        yield bunch


def _arrays(source: Store, rows: list[_Row], width: int) -> dict[str, Any]:
    statuses = STATUSES[source.spec.kind]
    q = np.full((len(rows), width), complex(np.nan, np.nan))
    for place, (_, _, result) in zip(q, rows, strict=True):
        roots = [complex(float(root.re), float(root.im)) for root in result.roots for _ in range(root.multiplicity)]
        place[: len(roots)] = roots
    return {
        "index": np.array([index for index, _, _ in rows]),
        **{
            title: np.array([float(values[name]) for _, values, _ in rows])
            for name, title in zip(source.spec.names, parameter_titles(source.spec), strict=True)
        },
        "status": np.array([statuses.index(result.status) for _, _, result in rows]),
        "count": np.array([-1 if result.count is None else result.count for _, _, result in rows]),
        "unstable": np.array([-1 if result.unstable is None else result.unstable for _, _, result in rows]),
        "q": q,
    }


def write_parquet(source: Store, target: BinaryIO) -> None:
    """index int64; each parameter double, named by its path and unit; status, reason text; count, unstable int32;
    re, im lists of double and multiplicity a list of int32, an element a root; for certified results also re_text,
    im_text: the decimals, right to one unit in the last digit. The spec is in the metadata, under "mpsolve".
    """
    try:
        import pyarrow
        from pyarrow import parquet
    except ImportError:
        raise InputError("to", "parquet needs pyarrow: pip install 'mpsolve[parquet]'") from None

    certified = source.spec.kind == "certified"
    double, int32, text = pyarrow.float64(), pyarrow.int32(), pyarrow.string()
    fields = [("index", pyarrow.int64()), *((title, double) for title in parameter_titles(source.spec))]
    fields += [("status", text), ("reason", text), ("count", int32), ("unstable", int32)]
    fields += [("re", pyarrow.list_(double)), ("im", pyarrow.list_(double)), ("multiplicity", pyarrow.list_(int32))]
    fields += [("re_text", pyarrow.list_(text)), ("im_text", pyarrow.list_(text))] if certified else []
    schema = pyarrow.schema(fields, metadata={"mpsolve": source.spec.text})
    with parquet.ParquetWriter(target, schema) as writer:
        for rows in _bunches(source):
            table = [_row(row, source.spec, certified) for row in rows]
            writer.write_table(pyarrow.Table.from_pylist(table, schema=schema))


def _row(row: _Row, spec: Spec, certified: bool) -> dict[str, Any]:
    index, values, result = row
    roots = result.roots
    content: dict[str, Any] = {
        "index": index,
        **dict(zip(parameter_titles(spec), map(float, values.values()), strict=True)),
        "status": result.status,
        "reason": result.reason,
        "count": result.count,
        "unstable": result.unstable,
        "re": [float(root.re) for root in roots],
        "im": [float(root.im) for root in roots],
        "multiplicity": [root.multiplicity for root in roots],
    }
    if certified:
        content |= {"re_text": [root.re for root in roots], "im_text": [root.im for root in roots]}
    return content


def stored_results(store: Store, start: int = 0) -> Iterator[tuple[int, dict[str, Value], Result]]:
    """(index, exact parameters, result) of each finished entry from the index `start` on.

    Raises StudyError if the file is damaged.
    """
    spec = store.spec
    for block in store.blocks(start // spec.block):
        for index, (values, result) in zip(
            spec.indices(block.number), zip(*checked(spec, block, store.path), strict=True), strict=True
        ):
            if index >= start:
                yield index, values, result
