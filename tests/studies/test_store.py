"""The store: nothing that was acknowledged is lost, whatever happens to the process, the disk or the file."""

from __future__ import annotations

import os
import random
import resource
import signal
import sqlite3
import stat
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager
from pathlib import Path
from typing import Any

import pytest

from mpsolve.errors import InputError, StudyError
from mpsolve.studies.blocks import Block
from mpsolve.studies.spec import read_spec
from mpsolve.studies.store import Store

ROOT = Path(__file__).parents[2]
Make = Callable[..., Block]
WRITER = """
import os
import sys
from pathlib import Path
from mpsolve.studies.blocks import Block, Result, pack
from mpsolve.studies.spec import spec_of
from mpsolve.studies.store import Store

path, spec, last = Path(sys.argv[1]), spec_of(sys.argv[2]), int(sys.argv[3])


def tell(word):
    # one write of a whole line: a kill between the two writes of an unbuffered print would leave half of one
    os.write(sys.stdout.fileno(), f"{word}\\n".encode())


for _ in sys.stdin:
    process = os.fork()
    if process:
        os.waitpid(process, 0)
        tell("ended")
        continue
    with Store.create(path, spec) as store:
        tell(os.getpid())
        for number in range(last):
            if not store.holds(number):
                data = pack([Result("proved", chr(97 + number % 26) * 50_000, 2, 0, ())])
                store.put(Block(number, f"key {number}", data, 2, '{"proved": 1}').sealed)
                tell(number)
    os._exit(0)
"""


class Writer:
    """A process that forks another at each `start`, which puts the blocks 0 to last − 1 that are not there."""

    def __init__(self, path: Path, text: str, last: int) -> None:
        arguments = [sys.executable, "-c", WRITER, str(path), text, str(last)]
        pipe = subprocess.PIPE
        self.process = subprocess.Popen(arguments, stdin=pipe, stdout=pipe, text=True, bufsize=1, cwd=ROOT)

    def start(self) -> int:
        """The id of the process that writes, when it has opened the store."""
        assert self.process.stdin is not None
        self.process.stdin.write("start\n")
        return int(self.line())

    def line(self) -> str:
        assert self.process.stdout is not None
        return self.process.stdout.readline().strip()

    def stored(self) -> list[int]:
        """The numbers that it said were stored, after its end."""
        return [int(line) for line in iter(self.line, "ended")]

    def __enter__(self) -> Writer:
        return self

    def __exit__(self, *error: object) -> None:
        self.process.communicate()
        assert self.process.returncode == 0


def numbers(path: Path) -> list[int]:
    """The blocks in the store, each of which is whole, after SQLite's own check of the file."""
    with closing(sqlite3.connect(path)) as connection:
        assert connection.execute("PRAGMA integrity_check").fetchone() == ("ok",)
    with Store.read(path) as store:
        blocks = list(store.blocks())
    assert all(block.whole for block in blocks)
    return [block.number for block in blocks]


def test_what_is_put_is_there(tmp_path: Path, wide: dict[str, Any], block: Make) -> None:
    path, spec = tmp_path / "study.sqlite", read_spec(wide | {"title": "Über allem"})
    with Store.create(path, spec) as store:
        assert not store.holds(3)
        for number in (3, 0, 7, 3):
            store.put(block(number))
        assert store.holds(3)
    with Store.read(path) as store:
        assert list(store.blocks()) == [block(0), block(3), block(7)]
        assert list(store.blocks(first=1)) == [block(3), block(7)]
        assert store.tally() == {"proved": 3}
        assert (store.width(), store.spec.title) == (2, "Über allem")
        assert store.spec.canonical == spec.canonical


def test_the_file_alone_holds_the_study_and_all_but_the_last_blocks(
    tmp_path: Path, wide: dict[str, Any], block: Make
) -> None:
    """What a copy without NAME-wal has while the store is open, as after kill -9."""
    path, copy = tmp_path / "study.sqlite", tmp_path / "copy.sqlite"
    with Store.create(path, read_spec(wide)) as store:
        copy.write_bytes(path.read_bytes())
        assert numbers(copy) == []
        for number in range(60):
            store.put(block(number))
        copy.write_bytes(path.read_bytes())
        assert len(numbers(copy)) >= 20


def test_readers_see_one_moment(tmp_path: Path, wide: dict[str, Any], block: Make) -> None:
    path = tmp_path / "study.sqlite"
    with Store.create(path, read_spec(wide)) as store:
        store.put(block(0))
        with Store.read(path) as reader:
            store.put(block(1))
            assert list(reader.blocks()) == [block(0)]


def test_another_study_is_told_what_differs(tmp_path: Path, wide: dict[str, Any], block: Make) -> None:
    path = tmp_path / "study.sqlite"
    with Store.create(path, read_spec(wide)) as store:
        store.put(block(0))
    other = wide | {"dimensionless": wide["dimensionless"] | {"eta_m": [41]}}
    with pytest.raises(
        InputError, match=r"belongs to another study .*eta_m is \[40\] there and \[41\] here"
    ) as caught:
        Store.create(path, read_spec(other))
    assert caught.value.key == "store"
    assert numbers(path) == [0]


def test_results_of_another_version_are_neither_used_nor_lost(
    tmp_path: Path, wide: dict[str, Any], block: Make, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "study.sqlite"
    with monkeypatch.context() as older:
        older.setattr("mpsolve.studies.store.ENGINE", "mpsolve 0.0, results 0")
        with Store.create(path, read_spec(wide)) as store:
            store.put(block(0))
    with Store.create(path, read_spec(wide)) as store:
        assert not store.holds(0)
        assert store.other_engines() == ["mpsolve 0.0, results 0"]
        store.put(block(0))
    with closing(sqlite3.connect(path)) as connection:
        assert connection.execute("SELECT count(*) FROM blocks").fetchone() == (2,)


def test_killed_twenty_times_in_mid_write(tmp_path: Path, wide: dict[str, Any]) -> None:
    """kill -9 at random moments: every block that was acknowledged is there, whole, and at most one more."""
    path, text, moments = tmp_path / "study.sqlite", read_spec(wide).text, random.Random(1)
    acknowledged: set[int] = set()
    with Writer(path, text, 10_000) as writer:
        for _ in range(20):
            process = writer.start()
            time.sleep(moments.uniform(0, 0.1))
            os.kill(process, signal.SIGKILL)
            new = writer.stored()
            assert acknowledged.isdisjoint(new)  # nothing is done twice
            acknowledged |= set(new)
            present = set(numbers(path))
            assert acknowledged <= present
            assert len(present - acknowledged) <= 1  # stored, and killed before it could say so
            acknowledged = present
    assert len(acknowledged) > 20
    assert sorted(acknowledged) == list(range(len(acknowledged)))


def test_killed_while_the_store_is_made(tmp_path: Path, wide: dict[str, Any], block: Make) -> None:
    """An empty file, or one without the tables, is what such a kill leaves."""
    empty, bare = tmp_path / "empty.sqlite", tmp_path / "bare.sqlite"
    empty.touch()
    with closing(sqlite3.connect(bare)) as connection:
        connection.execute("PRAGMA journal_mode = WAL")
    for path in (empty, bare):
        with Store.create(path, read_spec(wide)) as store:
            store.put(block(0))
        assert numbers(path) == [0]


def test_two_writers_at_once(tmp_path: Path, wide: dict[str, Any]) -> None:
    path, text = tmp_path / "study.sqlite", read_spec(wide).text
    with Writer(path, text, 60) as one, Writer(path, text, 60) as other:
        for writer in (one, other):
            writer.start()
        assert {number for writer in (one, other) for number in writer.stored()} == set(range(60))
    assert numbers(path) == list(range(60))


@contextmanager
def unprivileged() -> Iterator[None]:
    """As a user whom permissions hold back, which root is not."""
    if os.geteuid():
        yield
        return
    os.seteuid(65534)
    try:
        yield
    finally:
        os.seteuid(0)


@pytest.fixture
def locked() -> Iterator[Path]:
    """A directory that every user may enter and nobody may write to, at the end."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        yield folder
        folder.chmod(stat.S_IRWXU)


def test_a_directory_that_cannot_be_written(locked: Path, wide: dict[str, Any], block: Make) -> None:
    path, spec = locked / "study.sqlite", read_spec(wide)
    with Store.create(path, spec) as store:
        store.put(block(0))
    path.chmod(0o444)
    locked.chmod(0o555)
    with unprivileged():
        assert numbers_only_read(path) == [0]
        with pytest.raises(StudyError, match=r"cannot be written|cannot be opened"):
            Store.create(path, spec)
        with pytest.raises(StudyError, match="give a path in a directory that exists and where you may write"):
            Store.create(locked / "new.sqlite", spec)
    assert list(locked.iterdir()) == [path]
    with Store.read(path) as store:
        assert list(store.blocks()) == [block(0)]


def numbers_only_read(path: Path) -> list[int]:
    with Store.read(path) as store:
        return [block.number for block in store.blocks()]


def test_no_directory(tmp_path: Path, wide: dict[str, Any]) -> None:
    with pytest.raises(StudyError, match="give a path in a directory that exists"):
        Store.create(tmp_path / "none" / "study.sqlite", read_spec(wide))
    with pytest.raises(InputError, match="does not exist"):
        Store.read(tmp_path / "none.sqlite")
    with pytest.raises(InputError, match="is a directory"):
        Store.read(tmp_path)


@pytest.fixture
def small_disk(tmp_path: Path) -> Iterator[Path]:
    """A file system of one megabyte."""
    folder = tmp_path / "disk"
    folder.mkdir()
    mount = ["mount", "-t", "tmpfs", "-o", "size=1m", "tmpfs", str(folder)]
    if os.geteuid() or subprocess.run(mount, capture_output=True, check=False).returncode:
        pytest.skip("a full disk takes the right to mount one; the limit of a file's size stands in for it")
    try:
        yield folder
    finally:
        subprocess.run(["umount", "--lazy", str(folder)], check=True)


def fill(path: Path, spec: Any, block: Make) -> tuple[int, str]:
    """The number of blocks that went in before an error, and the error."""
    with Store.create(path, spec) as store:
        for number in range(1000):
            try:
                store.put(block(number, 20_000))
            except StudyError as error:
                return number, str(error)
    raise AssertionError("the disk has no end")


def test_a_full_disk(small_disk: Path, wide: dict[str, Any], block: Make) -> None:
    path, spec, ballast = small_disk / "study.sqlite", read_spec(wide), small_disk / "ballast"
    ballast.write_bytes(bytes(400_000))
    stored, said = fill(path, spec, block)
    assert "the disk is full: free some space and give the same command again; every finished block is safe" in said
    assert stored > 5
    assert numbers_only_read(path) == list(range(stored))
    ballast.unlink()
    with Store.create(path, spec) as store:
        store.put(block(stored, 20_000))
    assert numbers(path) == list(range(stored + 1))


def test_a_file_that_may_not_grow(tmp_path: Path, wide: dict[str, Any], block: Make) -> None:
    """The limit of a file's size (RLIMIT_FSIZE) stands in for a full disk where none can be mounted."""
    path, spec = tmp_path / "study.sqlite", read_spec(wide)
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (500_000, hard))
    try:
        stored, said = fill(path, spec, block)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
    assert "every finished block is safe" in said
    assert stored > 5
    assert numbers(path) == list(range(stored))
    with Store.create(path, spec) as store:
        store.put(block(stored))
    assert numbers(path) == list(range(stored + 1))


def test_a_file_of_something_else(tmp_path: Path, wide: dict[str, Any]) -> None:
    text, other = tmp_path / "text.sqlite", tmp_path / "other.sqlite"
    text.write_text("no database at all, " * 100)
    with closing(sqlite3.connect(other)) as connection:
        connection.execute("CREATE TABLE mine (x)")
    for path, said in (
        (text, "it is no study, or is damaged at its start"),
        (other, "is an SQLite file, but no study: give another path or, if this is a copy, copy "),
    ):
        before = path.read_bytes()
        for opened in (lambda p: Store.create(p, read_spec(wide)), Store.read):
            with pytest.raises(StudyError, match=said):
                opened(path)
        assert path.read_bytes() == before


def test_tables_of_another_version(tmp_path: Path, wide: dict[str, Any]) -> None:
    path = tmp_path / "study.sqlite"
    Store.create(path, read_spec(wide)).__exit__(None, None, None)
    with closing(sqlite3.connect(path)) as connection:
        connection.execute("PRAGMA user_version = 99")
    with pytest.raises(StudyError, match="tables of version 99, not 2"):
        Store.read(path)


@pytest.mark.parametrize("part", ["spec", "tables", "cut"])
def test_a_damaged_file(tmp_path: Path, wide: dict[str, Any], block: Make, part: str) -> None:
    """Random bytes over the pages of the tables, or half the file: a StudyError, never a wrong answer."""
    path = tmp_path / "study.sqlite"
    with Store.create(path, read_spec(wide)) as store:
        for number in range(50):
            store.put(block(number, 5000))
    if part == "spec":
        with closing(sqlite3.connect(path)) as connection:
            connection.execute("UPDATE study SET spec = '{' || spec")
            connection.commit()
    elif part == "cut":
        os.truncate(path, path.stat().st_size // 2)
    else:
        content = bytearray(path.read_bytes())
        content[4096 : 12 * 4096] = random.Random(1).randbytes(11 * 4096)
        path.write_bytes(bytes(content))
    damaged = path.read_bytes()
    with pytest.raises(StudyError, match="damaged"), Store.read(path) as store:
        list(store.blocks())
    assert path.read_bytes() == damaged
