"""The command about tables: onsets, or unstable ranges, over a grid of two parameters."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import click

from mpsolve.cli_tools import UNDECIDED, checked_output, one_sentence, progress

_TABLES = (".csv", ".json", ".tex")


@click.command()
@click.argument("file", type=click.Path(path_type=Path))
@click.option(
    "-o",
    "--output",
    type=click.Path(path_type=Path),
    help="Write FILE.csv or .json (.tex too in the paper's ratios).",
)
@click.option(
    "--certificates", type=click.Path(path_type=Path), help="Folder for certificates (tables in the paper's ratios)."
)
@click.option("--workers", type=int, help="Processes.  [default: as many as there are processors]")
def table(file: Path, output: Path | None, certificates: Path | None, workers: int | None) -> None:
    """Prove a table of onsets, or of all unstable ranges, over a grid of two parameters, as FILE (TOML) describes it.

    FILE names a problem file, the range and the two grids (examples/rail_table.toml), or gives all of it in the
    paper's ratios (examples/onset_table.toml). Without -o it is printed as CSV. Exit status 0: every entry is proved.
    1: some are undecided, or the file could not be written. 2: the input cannot be used.
    """
    with one_sentence():
        from mpsolve.errors import InputError
        from mpsolve.files import checked_suffix, write_whole
        from mpsolve.report.range_table import is_of_a_problem, read_table, summary, table_csv, table_json

        ours = is_of_a_problem(file)
        if output is not None:
            checked_suffix(checked_output(output, file, "the table"), (".csv", ".json") if ours else _TABLES)
        if certificates is not None and (ours or (certificates.exists() and not certificates.is_dir())):
            stated = f"{certificates} is a file: give the path of a folder"
            raise InputError("certificates", "there are none for this kind of table: drop it" if ours else stated)
        if ours:
            with progress() as tell:
                made = read_table(file, workers, tell)
            proved = made.proved
            if output is None:
                click.echo(table_csv(made), nl=False)
            else:
                text = table_csv(made) if output.suffix.lower() == ".csv" else table_json(made)
                with _printed_else(text):
                    write_whole(output, text)
                click.echo(f"{summary(made)}\n{output}")
        else:
            proved = _of_ratios(file, output, certificates, workers)
    sys.exit(0 if proved else UNDECIDED)


@contextmanager
def _printed_else(text: str) -> Iterator[None]:
    """Nothing is lost where a file cannot be written: the table is printed then."""
    from mpsolve.errors import CertificateError

    try:
        yield
    except CertificateError:
        click.echo(text, nl=False)
        raise


def _of_ratios(file: Path, output: Path | None, certificates: Path | None, workers: int | None) -> bool:
    """The table of a file in the paper's ratios."""
    from mpsolve.stability.table import onset_table

    with progress() as tell:
        made = onset_table(file, workers, tell)
    if output is None:
        click.echo(made.to_csv(), nl=False)
    else:
        found = [entry.status for row in made.entries for entry in row]
        counts = (
            f"{found.count(one)} {one}" for one in ("proved", "stable", "unstable", "undecided") if one in found
        )
        with _printed_else(made.to_csv()):
            made.save(output)
        click.echo(f"{len(found)} entries: {', '.join(counts)}.\n{output}")
    if certificates is not None:
        made.save_certificates(certificates)
    return made.proved


COMMANDS = (table,)
