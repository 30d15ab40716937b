"""The command about tables: onsets, or unstable ranges, over a grid of two parameters."""

from __future__ import annotations

import sys
from pathlib import Path

import click

from mpsolve.cli_tools import FILE, UNDECIDED, WORKERS, checked_file, command, output, progress
from mpsolve.errors import CertificateError


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
