"""The commands about many entries: study, export, status; and table, of onsets over a grid of two parameters."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from mpsolve.cli_tools import (
    DASK,
    FILE,
    JSON,
    PATH,
    UNDECIDED,
    WORKERS,
    checked_file,
    checked_output,
    cluster,
    command,
    echo_json,
    output,
    progress,
)
from mpsolve.errors import CertificateError

if TYPE_CHECKING:
    from mpsolve.studies.run import Progress, Study

_STORE = click.argument("store", type=PATH)


@command()
@click.argument("file", metavar="SPEC", type=PATH)
@click.option("-o", "--output", required=True, type=PATH, help="The store, such as study.sqlite.")
@WORKERS
@DASK
def study(file: Path, output: Path, workers: int | None, dask: str | None) -> None:
    """Compute all entries of the study that SPEC (TOML) describes, and store the results.

    What the store holds already is not computed again: an interrupted study goes on where it was. Exit status 0:
    every entry has an answer. 1: some are undecided, unresolved or refused, it was interrupted, or the store cannot
    be written. 2: the input cannot be used.
    """
    from mpsolve.studies.run import AHEAD
    from mpsolve.studies.run import study as compute

    checked_output(output, file, "the store")
    try:
        with cluster(dask, workers) as (executor, size), _progress() as tell:
            ahead = max(AHEAD, 2 * size)
            made = compute(file, executor, store=output, workers=workers, progress=tell, ahead=ahead)
    except KeyboardInterrupt:
        told = f"interrupted; what is finished is stored in {output}, and the same command goes on"
        click.echo(f"mpsolve: {told}", err=True)
        sys.exit(UNDECIDED)
    click.echo(_sentence(made))
    sys.exit(0 if made.answered else UNDECIDED)


@command()
@_STORE
@click.option("--to", required=True, type=click.Choice(("csv", "json", "npz", "parquet")), help="The format.")
@output("Path.  [default: NAME.FORMAT in the working directory]")
def export(store: Path, to: str, output: Path | None) -> None:
    """Write the results in STORE to a file for other programs.

    Exit status 0: all entries are there. 1: the study is not complete (the finished entries are written), or a file
    cannot be read or written. 2: the input cannot be used.
    """
    from mpsolve.studies.run import open_study

    found = open_study(store)
    path = checked_output(output or Path(f"{store.stem}.{to}"), store, "the export")
    if path.suffix.lower() != f".{to}":
        path = path.with_name(f"{path.name}.{to}")
    click.echo(found.save(path))
    if not found.complete:
        click.echo(
            f"mpsolve: {found.finished} of {found.total} entries are finished; the others are missing", err=True
        )
    sys.exit(0 if found.complete else UNDECIDED)


@command()
@_STORE
@JSON
def status(store: Path, as_json: bool) -> None:
    """Tell what is in STORE: which study, how many entries are finished, and with what result.

    Exit status 0: it is complete. 1: it is not, or the store cannot be read. 2: the input cannot be used.
    """
    from mpsolve.studies.run import open_study

    found = open_study(store)
    if as_json:
        echo_json(_data(found))
    else:
        click.echo(_report(found))
    sys.exit(0 if found.complete else UNDECIDED)


@command()
@FILE
@output("Write FILE.csv, .json or .tex.")
@WORKERS
def table(file: Path, output: Path | None, workers: int | None) -> None:
    """Prove a table of onsets, or of all unstable ranges, over a grid of two parameters, as FILE (TOML) describes it.

    FILE names a problem file, the range and the two grids (examples/rail_table.toml; examples/onset_table.toml in the
    paper's ratios). Without -o it is printed as CSV. Exit status 0: every entry is proved. 1: some are undecided, or
    the file could not be written. 2: the input cannot be used.
    """
    from mpsolve.files import write_whole
    from mpsolve.report.range_table import WRITERS, read_table, summary, table_csv

    kind = checked_file(output, file, "the table", WRITERS)
    with progress() as tell:
        made = read_table(file, workers, tell)
    if output is None:
        click.echo(table_csv(made), nl=False)
    else:
        try:
            write_whole(output, WRITERS[kind](made))
        except CertificateError:
            click.echo(table_csv(made), nl=False)  # nothing is lost where a file cannot be written
            raise
        click.echo(f"{summary(made)}\n{output}")
    sys.exit(0 if made.proved else UNDECIDED)


def _sentence(found: Study) -> str:
    counts = ", ".join(f"{number} {name}" for name, number in found.tally.items())
    return f"{found.finished} of {found.total} entries finished{counts and f': {counts}'}.\n{found.path}"


def _report(found: Study) -> str:
    lines = []
    for section, table in found.spec.canonical.items():
        each = (
            {f"{section}.{name}": one for name, one in table.items()} if isinstance(table, dict) else {section: table}
        )
        lines += [f"{name} = {_short(value)}" for name, value in each.items()]
    return "\n".join([*([found.spec.title] if found.spec.title else []), *lines, _sentence(found)])


def _short(value: Any) -> str:
    import json

    text = json.dumps(value, ensure_ascii=False)
    return text if len(text) <= 90 else text[:87] + "…"


def _data(found: Study) -> dict[str, Any]:
    from mpsolve.studies.blocks import ENGINE

    return {
        "format": "mpsolve study status",
        "version": 1,
        "title": found.spec.title,
        "engine": ENGINE,
        "spec": found.spec.canonical,
        "total": found.total,
        "finished": found.finished,
        "tally": dict(found.tally),
    }


@contextmanager
def _progress() -> Iterator[Progress | None]:
    """A bar on stderr with the rate and the time left; None where stderr is not a terminal."""
    if not sys.stderr.isatty():
        yield None
        return
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

    columns = (BarColumn(), MofNCompleteColumn(), TextColumn("{task.fields[rate]}"), TimeRemainingColumn())
    with Progress(*columns, console=Console(stderr=True), transient=True, speed_estimate_period=120) as bar:
        task = bar.add_task("", total=None, rate="")

        def tell(finished: int, total: int) -> None:
            bar.update(task, completed=finished, total=total)
            speed = bar.tasks[0].speed
            bar.update(task, rate=f"{speed:.3g} entries/s" if speed else "")

        yield tell
