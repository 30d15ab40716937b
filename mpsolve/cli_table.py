"""The command about tables: onsets, or unstable ranges, over a grid of two parameters."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import click

from mpsolve.cli_tools import FILE, UNDECIDED, checked_output, one_sentence, output, progress


@click.command()
@FILE
@output("Write FILE.csv, .json or .tex.")
@click.option("--workers", type=int, help="Processes.  [default: as many as there are processors]")
def table(file: Path, output: Path | None, workers: int | None) -> None:
    """Prove a table of onsets, or of all unstable ranges, over a grid of two parameters, as FILE (TOML) describes it.

    FILE names a problem file, the range and the two grids (examples/rail_table.toml; examples/onset_table.toml in the
    paper's ratios). Without -o it is printed as CSV. Exit status 0: every entry is proved. 1: some are undecided, or
    the file could not be written. 2: the input cannot be used.
    """
    with one_sentence():
        from mpsolve.files import checked_suffix, write_whole
        from mpsolve.report.range_table import WRITERS, read_table, summary, table_csv

        if output is not None:
            checked_suffix(checked_output(output, file, "the table"), tuple(WRITERS))
        with progress() as tell:
            made = read_table(file, workers, tell)
        if output is None:
            click.echo(table_csv(made), nl=False)
        else:
            with _printed_else(table_csv(made)):
                write_whole(output, WRITERS[output.suffix.lower()](made))
            click.echo(f"{summary(made)}\n{output}")
    sys.exit(0 if made.proved else UNDECIDED)


@contextmanager
def _printed_else(text: str) -> Iterator[None]:
    """Nothing is lost where a file cannot be written: the table is printed then."""
    from mpsolve.errors import CertificateError

    try:
        yield
    except CertificateError:
        click.echo(text, nl=False)
        raise


COMMANDS = (table,)
