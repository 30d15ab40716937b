"""The commands about stability over whole ranges: onset, crossings, critical-distance, table, chart."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

import click

from mpsolve.cli_tools import UNDECIDED, certificate_path, checked_output, one_sentence, progress, show

if TYPE_CHECKING:
    from mpsolve.numbers.exact import Exact
    from mpsolve.progress import Progress
    from mpsolve.report.answer import Answer, Source
    from mpsolve.stability.table import OnsetTable

_FILE = click.argument("file", type=click.Path(path_type=Path))
_DIGITS = click.option("--digits", type=int, default=30, show_default=True, help="Certified digits, 15 to 10000.")
_JSON = click.option("--json", "as_json", is_flag=True, help="Report for machines, in JSON.")
_WORKERS = click.option("--workers", type=int, help="Processes.  [default: as many as there are processors]")


def _certificate_option(kind: str) -> Callable[[Callable[..., None]], Callable[..., None]]:
    text = f"Path of the certificate.  [default: NAME.{kind}.certificate.json in the working directory]"
    return click.option("-o", "--output", type=click.Path(path_type=Path), help=text)


@click.command()
@_FILE
@click.option("--from", "low", default="0", show_default=True, help="Where the range of velocity ratios starts.")
@click.option("--to", "high", default="2", show_default=True, help="Where it ends.")
@click.option("--all", "everything", is_flag=True, help="All unstable ranges instead of the first onset.")
@_DIGITS
@_JSON
@_certificate_option("onset")
def onset(file: Path, low: str, high: str, everything: bool, digits: int, as_json: bool, output: Path | None) -> None:
    """Prove the first velocity ratio at which the case in FILE (TOML) becomes unstable, and write a certificate.

    The velocity of the case itself is not used. Exit status 0: proved. 1: undecided, with the reason and what
    helps, or the certificate could not be written. 2: the input cannot be used.
    """

    def answer(source: Source, tell: Progress | None) -> Answer:
        from mpsolve.report.onsets import onset_answer, ranges_answer
        from mpsolve.stability.velocities import onset_velocity, unstable_velocities

        case, (start, end) = source.case, _range(low, high)
        model = case.eta_b, case.eta_m, case.positions, case.eta_n, case.eta_s
        if everything:
            return ranges_answer(unstable_velocities(*model, (start, end), digits, tell), source, digits)
        return onset_answer(onset_velocity(*model, (start, end), digits, tell), source, start, end, digits)

    _answer(file, output, "onset", as_json, answer)


@click.command()
@_FILE
@_DIGITS
@_JSON
@_certificate_option("crossings")
def crossings(file: Path, digits: int, as_json: bool, output: Path | None) -> None:
    """Prove all masses at which the case in FILE (TOML) becomes unstable or stable, at its velocity.

    The masses grow from 0 to infinity in the proportions of the case. Exit status as for onset.
    """

    def answer(source: Source, _tell: Progress | None) -> Answer:
        from mpsolve.report.crossings import crossings_answer, largest
        from mpsolve.stability.masses import crossing_masses

        case, unit = source.case, largest(source)
        shares = [ratio / unit for ratio in case.eta_m]
        found = crossing_masses(case.alpha, case.eta_b, case.positions, shares, case.eta_n, case.eta_s, digits)
        return crossings_answer(found, source, digits)

    _answer(file, output, "crossings", as_json, answer)


@click.command("critical-distance")
@_FILE
@click.option("--from", "low", required=True, help="Where the range of distances starts, in units of 1/χ.")
@click.option("--to", "high", required=True, help="Where it ends.")
@_DIGITS
@_JSON
@_certificate_option("distance")
def distance(file: Path, low: str, high: str, digits: int, as_json: bool, output: Path | None) -> None:
    """Prove the distance of equally spaced masses at which the case in FILE (TOML) is least stable.

    That is where the least Im q over all roots is smallest. The positions of the case are not used.
    Exit status as for onset.
    """

    def answer(source: Source, tell: Progress | None) -> Answer:
        from mpsolve.report.crossings import distance_answer
        from mpsolve.stability.distance import critical_distance

        case, (start, end) = source.case, _range(low, high)
        found = critical_distance(
            case.alpha, case.eta_b, case.eta_m, case.eta_n, case.eta_s, (start, end), digits, tell
        )
        return distance_answer(found, source, start, end, digits)

    _answer(file, output, "distance", as_json, answer)


@click.command()
@_FILE
@click.option(
    "-o", "--output", type=click.Path(path_type=Path), help="Write FILE.csv, .json or .tex, not the terminal."
)
@click.option("--certificates", type=click.Path(path_type=Path), help="Folder for a certificate of each entry.")
@_WORKERS
def table(file: Path, output: Path | None, certificates: Path | None, workers: int | None) -> None:
    """Prove a table of onsets over a grid of two parameters, as FILE (TOML) describes it.

    Without -o it is printed as CSV. Exit status 0: every entry is proved. 1: some are undecided (the notes say
    why), or a file could not be written. 2: the input cannot be used.
    """
    with one_sentence():
        from mpsolve.errors import InputError
        from mpsolve.files import checked_suffix
        from mpsolve.stability.table import SUFFIXES, onset_table

        if output is not None:
            checked_suffix(checked_output(output, file, "the table"), SUFFIXES)
        if certificates is not None and certificates.exists() and not certificates.is_dir():
            raise InputError("certificates", f"{certificates} is a file: give the path of a folder")
        with progress() as tell:
            made = onset_table(file, workers, tell)
        _save_table(made, output)
        if certificates is not None:
            made.save_certificates(certificates)
    sys.exit(0 if made.proved else UNDECIDED)


def _save_table(made: OnsetTable, output: Path | None) -> None:
    """To the file, and a summary; as CSV on standard output without one, or if it cannot be written."""
    from mpsolve.errors import CertificateError

    try:
        if output is not None:
            click.echo(f"{_summary(made)}\n{made.save(output)}")
            return
    except CertificateError:
        click.echo(made.to_csv(), nl=False)
        raise
    click.echo(made.to_csv(), nl=False)


def _summary(made: OnsetTable) -> str:
    entries = [entry.status for row in made.entries for entry in row]
    counts = (f"{entries.count(status)} {status}" for status in ("proved", "stable", "unstable", "undecided"))
    return f"{len(entries)} entries: {', '.join(text for text in counts if not text.startswith('0 '))}."


@click.command()
@_FILE
@click.option("-o", "--output", type=click.Path(path_type=Path), required=True, help="NAME.png, .svg, .pdf or .json.")
@_WORKERS
def chart(file: Path, output: Path, workers: int | None) -> None:
    """Prove the columns of a stability chart, as FILE (TOML) describes it, and draw it.

    Exit status 0: every column is proved. 1: some are open (hatched), or the file could not be written. 2: the
    input cannot be used.
    """
    with one_sentence():
        from mpsolve.files import checked_suffix
        from mpsolve.stability.chart import SUFFIXES, stability_chart

        checked_suffix(checked_output(output, file, "the chart"), SUFFIXES)
        with progress() as tell:
            made = stability_chart(file, workers, tell)
        made.save(output)
        proved = sum(column.proved for column in made.columns)
        click.echo(f"{proved} of {len(made.columns)} columns proved.\n{output}")
    sys.exit(0 if made.proved else UNDECIDED)


COMMANDS = (onset, crossings, distance, table, chart)


def _range(low: str, high: str) -> tuple[Exact, Exact]:
    """The ends, in order; InputError names the option."""
    from mpsolve.errors import InputError
    from mpsolve.numbers.exact import Exact

    ends = Exact.parse(low, "--from"), Exact.parse(high, "--to")
    if not ends[0] < ends[1]:
        raise InputError("--to", f"is {high}, not above --from {low}: give the ends in order")
    for end, key in zip(ends, ("--from", "--to"), strict=True):
        if end < 0 or not end.is_rational:
            raise InputError(key, f"is {end.short()}: give a decimal or a ratio p/q that is not negative")
    return ends


def _answer(
    file: Path, output: Path | None, kind: str, as_json: bool, answer: Callable[[Source, Progress | None], Answer]
) -> None:
    """Reads, answers, saves the certificate, reports, and exits."""
    with one_sentence():
        from mpsolve.model.inputfile import read_input
        from mpsolve.model.parameters import PhysicalCase
        from mpsolve.report.answer import Source

        given = read_input(file)
        path = certificate_path(given.path, output, kind)
        physical = given.case if isinstance(given.case, PhysicalCase) else None
        case = given.case.dimensionless if isinstance(given.case, PhysicalCase) else given.case
        with progress() as tell:
            found = answer(Source(case, physical, given.title), tell)
        _report(found, path, as_json, output is None)
    sys.exit(0 if found.proved else UNDECIDED)


def _report(found: Answer, path: Path, as_json: bool, by_default: bool) -> None:
    """Saves the certificate, and prints the report even if that fails; CertificateError then."""
    from mpsolve.certificate.own_name import own_name
    from mpsolve.errors import CertificateError
    from mpsolve.report.answer import answer_data, answer_document

    saved, failure = None, None
    if found.certificate is not None:
        try:
            saved = found.certificate.save(own_name(path, found.certificate.content) if by_default else path)
        except CertificateError as error:
            failure = error
    if as_json:
        import json

        click.echo(json.dumps(answer_data(found, saved), indent=1, ensure_ascii=False))
    else:
        show(answer_document(found, saved))
    if failure is not None:
        raise failure
