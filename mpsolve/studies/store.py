"""The store of a study: one SQLite file, written a block at a time, each in a transaction of its own.

A block is stored whole or not at all, whatever ends the process, and a block that is there stays. Blocks are
keyed by the engine and their number; with the study's spec, which the file holds, that is the exact entries.

While a study runs, and after it was killed, its last blocks are in the file NAME-wal beside it, which belongs to it:
SQLite moves them into the file itself now and then, when the study is next opened for writing, and at its end.
"""

from __future__ import annotations

import json
import os
import sqlite3
from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import replace
from json import JSONDecodeError
from pathlib import Path
from types import TracebackType
from urllib.parse import quote

from mpsolve.errors import InputError, StudyError
from mpsolve.studies.blocks import ENGINE, Block
from mpsolve.studies.columns import read_block, tables, write_block
from mpsolve.studies.spec import Spec, differences, spec_of

_APPLICATION = 0x6D707374  # "mpst", in the header of the file
_VERSION = 2  # of the tables
_PATIENCE = 60.0  # seconds to wait for another process that writes
_LOG = 64  # pages in NAME-wal after which SQLite moves them: some twenty certified entries, one block of float64
_ADVICE = {
    "SQLITE_FULL": "the disk is full: free some space and give the same command again; every finished block is safe",
    "SQLITE_IOERR": "the disk refuses ({error}): see whether it is full or failing; every finished block is safe",
    "SQLITE_BUSY": "another process has kept it locked for a minute: run again when that has ended",
    "SQLITE_READONLY": "it cannot be written: give a path where you may write, and copy the file there",
    "SQLITE_CANTOPEN": "it cannot be opened: give a path in a directory that exists and where you may write",
    "SQLITE_NOTADB": "it is no study, or is damaged at its start: give another path, or restore a copy of it",
    "SQLITE_CORRUPT": "it is damaged ({error}): restore a copy, or what `sqlite3 FILE .recover` can read of it",
}


def store_path(given: object) -> Path:
    """The path of a store, whatever was given for it; InputError if that is none."""
    try:
        path = Path(given)  # type: ignore[arg-type]
    except TypeError:
        path = None
    if path is None or "\0" in str(path):
        raise InputError("store", f"is {given!r}, which is no path: give the path of a file, such as study.sqlite")
    return path


class Store:
    """An open store; use as a context manager. Every error of the file is a StudyError that says what helps."""

    def __init__(self, path: Path, connection: sqlite3.Connection, spec: Spec) -> None:
        self.path, self.spec, self._connection = path, spec, connection

    @classmethod
    def create(cls, path: Path, spec: Spec) -> Store:
        """The store of `spec` at `path`, made if it is not there; InputError if it is that of another study."""
        with _explained(path):
            connection = sqlite3.connect(path, timeout=_PATIENCE, isolation_level=None)
            try:
                _require_study(connection, path, new=True)
                connection.execute("PRAGMA journal_mode = WAL")
                connection.execute("PRAGMA synchronous = FULL")
                connection.execute(f"PRAGMA wal_autocheckpoint = {_LOG}")
                _make(connection, spec)
                connection.execute("PRAGMA wal_checkpoint").fetchall()
                found = _spec(connection, path)
                _require_same(found, spec, path)
            except BaseException:
                connection.close()
                raise
        return cls(path, connection, found)

    @classmethod
    def read(cls, path: Path) -> Store:
        """The store at `path` as it is now; what is written later is not seen. InputError if there is no file."""
        try:
            state = "" if path.is_file() else "is a directory" if path.is_dir() else "does not exist"
        except OSError as error:  # a name that is too long, a folder that may not be looked into
            state = f"cannot be used ({error.strerror})"
        if state:
            raise InputError("store", f"{path} {state}: give the path of a file that `mpsolve study` wrote")
        with _explained(path):
            connection = sqlite3.connect(_address(path), uri=True, timeout=_PATIENCE, isolation_level=None)
            try:
                _require_study(connection, path)
                connection.execute("BEGIN")
                spec = _spec(connection, path)
            except BaseException:
                connection.close()
                raise
        return cls(path, connection, spec)

    def __enter__(self) -> Store:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        with suppress(sqlite3.Error):  # what is stored is stored; a failing disk has been told of already
            self._connection.close()

    def holds(self, number: int) -> bool:
        """Whether the block is there, undamaged. A part of a box that was left undecided is tried again."""
        with _explained(self.path):
            block = read_block(self._connection, self.spec, ENGINE, number)
        if block is None or not block.whole:
            return False
        return self.spec.kind != "stable" or "undecided" not in json.loads(block.tally)

    def put(self, block: Block) -> None:
        """Stores the block durably, whole or not at all."""
        with _explained(self.path):
            self._connection.execute("BEGIN IMMEDIATE")
            try:
                write_block(self._connection, self.spec, ENGINE, block)
            except BaseException:
                with suppress(sqlite3.Error):  # a full disk has ended the transaction already
                    self._connection.execute("ROLLBACK")
                raise
            self._connection.execute("COMMIT")

    def blocks(self, first: int = 0) -> Iterator[Block]:
        """The stored blocks in order, from the block number `first` on, one at a time."""
        with _explained(self.path):
            rows = self._connection.execute(
                "SELECT number FROM blocks WHERE engine = ? AND number >= ? ORDER BY number", (ENGINE, first)
            )
            for (number,) in rows:
                block = read_block(self._connection, self.spec, ENGINE, number)
                if block is not None:
                    yield block

    def tally(self) -> dict[str, int]:
        """The number of finished entries of each status."""
        total: Counter[str] = Counter()
        with _explained(self.path):
            for (text,) in self._connection.execute("SELECT tally FROM blocks WHERE engine = ?", (ENGINE,)):
                total.update(json.loads(text))
        return dict(total)

    def width(self) -> int:
        """The most roots of a case."""
        with _explained(self.path):
            found = self._connection.execute("SELECT max(width) FROM blocks WHERE engine = ?", (ENGINE,)).fetchone()
        return found[0] or 0

    def other_engines(self) -> list[str]:
        """Other versions whose results are in the file."""
        with _explained(self.path):
            rows = self._connection.execute("SELECT DISTINCT engine FROM blocks WHERE engine <> ?", (ENGINE,))
            return sorted(row[0] for row in rows)


@contextmanager
def _explained(path: Path) -> Iterator[None]:
    """Every sqlite3.Error as a StudyError."""
    try:
        yield
    except JSONDecodeError as error:
        raise StudyError(f"{path}: {_ADVICE['SQLITE_CORRUPT'].format(error=error)}") from error
    except sqlite3.Error as error:
        name = getattr(error, "sqlite_errorname", "")
        for start, advice in _ADVICE.items():
            if name.startswith(start):
                raise StudyError(f"{path}: {advice.format(error=error)}") from error
        raise StudyError(
            f"{path} cannot be used ({error}): see whether it is whole, and whether you may write"
        ) from error


def _address(path: Path) -> str:
    """For reading. Where nothing can be written, a file that has no log of its own is read as it stands."""
    effective = os.access in os.supports_effective_ids
    if all(os.access(place, os.W_OK, effective_ids=effective) for place in (path.parent, path)):
        mode = "rw"
    else:
        mode = "ro" if path.with_name(f"{path.name}-wal").exists() else "ro&immutable=1"
    return f"file:{quote(str(path.resolve()))}?mode={mode}"


def _require_study(connection: sqlite3.Connection, path: Path, new: bool = False) -> None:
    """StudyError for an SQLite file of something else, or of another version of the tables."""
    (application,) = connection.execute("PRAGMA application_id").fetchone()
    (version,) = connection.execute("PRAGMA user_version").fetchone()
    (tables,) = connection.execute("SELECT count(*) FROM sqlite_master").fetchone()
    if new and not application and not tables:
        return
    if application != _APPLICATION:
        stated = f"{path} is an SQLite file, but no study"
        raise StudyError(f"{stated}: give another path or, if this is a copy, copy {path.name}-wal with it")
    if version != _VERSION:
        raise StudyError(f"{path} has tables of version {version}, not {_VERSION}: use the mpsolve that wrote it")


def _make(connection: sqlite3.Connection, spec: Spec) -> None:
    """The tables and the spec, all or nothing, unless they are there."""
    connection.execute("BEGIN IMMEDIATE")
    try:
        for statement in tables(spec):
            connection.execute(statement)
        connection.execute(
            "INSERT INTO study SELECT ?, ? WHERE NOT EXISTS (SELECT 1 FROM study)", (spec.text, spec.title)
        )
        connection.execute(f"PRAGMA application_id = {_APPLICATION}")
        connection.execute(f"PRAGMA user_version = {_VERSION}")
    except BaseException:
        connection.execute("ROLLBACK")
        raise
    connection.execute("COMMIT")


def _spec(connection: sqlite3.Connection, path: Path) -> Spec:
    row = connection.execute("SELECT spec, title FROM study").fetchone()
    try:
        return replace(spec_of(row[0]), title=row[1])
    except (TypeError, ValueError) as error:
        raise StudyError(f"{path} is damaged: it holds no readable spec ({error}); restore a copy of it") from None


def _require_same(found: Spec, wanted: Spec, path: Path) -> None:
    differing = [
        f"{key} is {_shown(old)} there and {_shown(new)} here"
        for key, old, new in differences(found.canonical, wanted.canonical)
        if key != "study.boxes"  # how long a proof may take is no part of what is asked
    ]
    if differing:
        stated = f"{path} belongs to another study ({'; '.join(differing)})"
        raise InputError("store", f"{stated}: give another file, or that spec")


def _shown(value: object) -> str:
    text = "not given" if value is None else json.dumps(value, ensure_ascii=False)
    return text if len(text) <= 60 else text[:57] + "…"
