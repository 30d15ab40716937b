"""The tables of a study, for any program that reads SQLite: a row an entry, a row a root, columns with their units.

    SELECT "v [m/s]", count, "growth [1/s]" FROM entries WHERE unstable > 0 ORDER BY "v [m/s]"

entries: engine, index, the parameters that are varied, status, reason, count, unstable, and the growth of the root
that grows fastest (below 0 where all decay). roots: engine, index, number, re, im, and what certified roots have
besides. certificates: engine, index, content. blocks: what has been computed together, with a seal of its results.
"""

from __future__ import annotations

import json
import sqlite3
from collections.abc import Iterator
from typing import Any

from mpsolve.certificate.format import Certificate
from mpsolve.problem.case import Case
from mpsolve.problem.parameters import quantity_of
from mpsolve.problem.problem import Problem
from mpsolve.studies.blocks import Block, Result, Root, pack
from mpsolve.studies.spec import Spec


def root_titles(spec: Spec, k: int) -> tuple[str, str]:
    """The columns of root number k where each root has columns of its own."""
    re, im = frequency_units(spec)
    return titled(f"re_{k}", re), titled(f"im_{k}", im)


def titled(name: str, unit: str) -> str:
    """A column's name with its unit in brackets."""
    return f"{name} [{unit}]" if unit else name


def parameter_titles(spec: Spec) -> tuple[str, ...]:
    """The column of each parameter that is varied: its path and its unit; a dimensionless case has none."""
    if isinstance(spec.given, Case):
        return spec.names
    return tuple(titled(path, unit_of(spec.base, path)) for path in spec.names)


def frequency_units(spec: Spec) -> tuple[str, str]:
    """The units of Re q and Im q."""
    return ("", "") if isinstance(spec.given, Case) else ("rad/s", "1/s")


def unit_of(problem: Problem, path: str) -> str:
    """The unit of the parameter at a path, "" for a factor."""
    return quantity_of(problem.track, problem.vehicles, problem.v, path).unit


def tables(spec: Spec) -> Iterator[str]:
    """The statements that make the tables."""
    parameters = "".join(f", {_quoted(title)} REAL NOT NULL" for title in parameter_titles(spec))
    re, im = (_quoted(titled(name, unit)) for name, unit in zip(("re", "im"), frequency_units(spec), strict=True))
    yield "CREATE TABLE IF NOT EXISTS study (spec TEXT NOT NULL, title TEXT NOT NULL)"
    yield (
        f'CREATE TABLE IF NOT EXISTS entries (engine TEXT NOT NULL, "index" INTEGER NOT NULL{parameters}, '
        f"status TEXT NOT NULL, reason TEXT NOT NULL, count INTEGER, unstable INTEGER, {_growth(spec)} REAL, "
        'PRIMARY KEY (engine, "index")) WITHOUT ROWID'
    )
    yield (
        'CREATE TABLE IF NOT EXISTS roots (engine TEXT NOT NULL, "index" INTEGER NOT NULL, number INTEGER NOT NULL, '
        f"{re} REAL NOT NULL, {im} REAL NOT NULL, re_text TEXT, im_text TEXT, re_radius TEXT, im_radius TEXT, "
        'multiplicity INTEGER NOT NULL, axis TEXT NOT NULL, PRIMARY KEY (engine, "index", number)) WITHOUT ROWID'
    )
    yield (
        'CREATE TABLE IF NOT EXISTS certificates (engine TEXT NOT NULL, "index" INTEGER NOT NULL, '
        'content TEXT NOT NULL, PRIMARY KEY (engine, "index"))'
    )
    yield (
        "CREATE TABLE IF NOT EXISTS blocks (engine TEXT NOT NULL, number INTEGER NOT NULL, key TEXT NOT NULL, "
        "width INTEGER NOT NULL, tally TEXT NOT NULL, seal TEXT NOT NULL, PRIMARY KEY (engine, number)) WITHOUT ROWID"
    )


def _growth(spec: Spec) -> str:
    return _quoted(titled("growth", frequency_units(spec)[1]))


def _quoted(name: str) -> str:
    return '"' + name.replace('"', '""') + '"'


def write_block(connection: sqlite3.Connection, spec: Spec, engine: str, block: Block) -> None:
    """The block's rows in place of those that are there, within the caller's transaction."""
    indices = spec.indices(block.number)
    place = (engine, indices[0], indices[-1])
    for table in ("entries", "roots", "certificates"):
        connection.execute(f'DELETE FROM {table} WHERE engine = ? AND "index" BETWEEN ? AND ?', place)
    found = list(zip(indices, block.results, strict=True))
    _insert(connection, "entries", (_entry(spec, engine, index, result) for index, result in found))
    _insert(connection, "roots", (row for index, result in found for row in _roots(engine, index, result)))
    kept = ((engine, k, json.dumps(r.certificate.content)) for k, r in found if r.certificate is not None)
    _insert(connection, "certificates", kept)
    head = (engine, block.number, block.key, block.width, block.tally, block.seal)
    connection.execute("INSERT OR REPLACE INTO blocks VALUES (?, ?, ?, ?, ?, ?)", head)


def _insert(connection: sqlite3.Connection, table: str, rows: Iterator[tuple[Any, ...]]) -> None:
    rows = iter(rows)
    first = next(rows, None)
    if first is not None:
        statement = f"INSERT INTO {table} VALUES ({', '.join('?' * len(first))})"
        connection.execute(statement, first)
        connection.executemany(statement, rows)


def _entry(spec: Spec, engine: str, index: int, result: Result) -> tuple[Any, ...]:
    values = (float(value) for value in spec.values(index).values())
    growth = max((-float(root.im) for root in result.roots), default=None)
    return (engine, index, *values, result.status, result.reason, result.count, result.unstable, growth)


def _roots(engine: str, index: int, result: Result) -> Iterator[tuple[Any, ...]]:
    for number, root in enumerate(result.roots):
        exact = isinstance(root.re, str)
        texts = (root.re, root.im) if exact else (None, None)
        rest = (root.re_radius, root.im_radius, root.multiplicity, root.axis)
        yield (engine, index, number, float(root.re), float(root.im), *texts, *rest)


def read_block(connection: sqlite3.Connection, spec: Spec, engine: str, number: int) -> Block | None:
    """The block made again from its rows, or None; whether it is whole its seal tells."""
    query = "SELECT key, width, tally, seal FROM blocks WHERE engine = ? AND number = ?"
    head = connection.execute(query, (engine, number)).fetchone()
    if head is None:
        return None
    key, width, tally, seal = head
    return Block(number, key, pack(list(_results(connection, spec, engine, number))), width, tally, seal)


def _results(connection: sqlite3.Connection, spec: Spec, engine: str, number: int) -> Iterator[Result]:
    indices = spec.indices(number)
    place = (engine, indices[0], indices[-1])
    where = 'WHERE engine = ? AND "index" BETWEEN ? AND ? ORDER BY "index"'
    roots: dict[int, list[Root]] = {}
    for _, index, _, re, im, *rest in connection.execute(f"SELECT * FROM roots {where}, number", place):
        root = Root(re, im) if rest[0] is None else Root(*rest)
        roots.setdefault(index, []).append(root)
    kept = dict(connection.execute(f'SELECT "index", content FROM certificates {where}', place))
    entries = f'SELECT "index", status, reason, count, unstable FROM entries {where}'
    for index, status, reason, count, unstable in connection.execute(entries, place):
        certificate = Certificate(json.loads(kept[index])) if index in kept else None
        yield Result(status, reason, count, unstable, tuple(roots.get(index, ())), certificate)
