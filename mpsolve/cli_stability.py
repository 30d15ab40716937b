"""The command about the least stable distance of masses on the paper's beam: critical-distance."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

import click

from mpsolve.cli_tools import UNDECIDED, certificate_path, one_sentence, progress, show

if TYPE_CHECKING:
    from mpsolve.numbers.exact import Exact
    from mpsolve.progress import Progress
    from mpsolve.report.answer import Answer, Source

_FILE = click.argument("file", type=click.Path(path_type=Path))
_DIGITS = click.option("--digits", type=int, default=30, show_default=True, help="Certified digits, 15 to 10000.")
_JSON = click.option("--json", "as_json", is_flag=True, help="Report for machines, in JSON.")


def _certificate_option(kind: str) -> Callable[[Callable[..., None]], Callable[..., None]]:
    text = f"Path of the certificate.  [default: NAME.{kind}.certificate.json in the working directory]"
    return click.option("-o", "--output", type=click.Path(path_type=Path), help=text)


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
        from mpsolve.report.distance import distance_answer
        from mpsolve.stability.distance import critical_distance

        case, (start, end) = source.case, _range(low, high)
        found = critical_distance(
            case.alpha, case.eta_b, case.eta_m, case.eta_n, case.eta_s, (start, end), digits, tell
        )
        return distance_answer(found, source, start, end, digits)

    _answer(file, output, "distance", as_json, answer)


COMMANDS = (distance,)


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
        from mpsolve.problem.casefile import read_input
        from mpsolve.problem.physical import PhysicalCase
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
