"""The command `audit`: every claim of the paper checked anew."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import click

from mpsolve.cli_tools import UNDECIDED, one_sentence, progress, show

if TYPE_CHECKING:
    from mpsolve.audit.run import Report


@click.command()
@click.option(
    "--only", multiple=True, metavar="ID", help="Only this claim, or all whose names begin so (may be given again)."
)
@click.option("--json", "as_json", is_flag=True, help="Report for machines, in JSON.")
@click.option("--html", type=click.Path(path_type=Path), help="Write the report as one HTML page, too.")
@click.option("--certificates", type=click.Path(path_type=Path), help="Folder for the certificates.")
@click.option("--workers", type=int, help="Processes.  [default: as many as there are processors]")
def audit(
    only: tuple[str, ...], as_json: bool, html: Path | None, certificates: Path | None, workers: int | None
) -> None:
    """Check every claim that the paper prints: conclusions, numbers, captions, equations. All of it takes minutes.

    Exit status 0: every check came to its end, whatever the verdicts. 1: one did not, or a file could not be
    written. 2: the input cannot be used.
    """
    with one_sentence():
        from mpsolve.audit.run import audit as check
        from mpsolve.audit.run import chosen

        claims = chosen(only)
        _admit(html, certificates)
        with progress() as tell:
            report = check(claims, workers, tell)
        _report(report, as_json)
        if certificates is not None:
            report.save_certificates(certificates)
        if html is not None:
            from mpsolve.audit.page import page
            from mpsolve.files import write_whole

            write_whole(html, page(report))
    sys.exit(0 if report.complete else UNDECIDED)


def _admit(html: Path | None, certificates: Path | None) -> None:
    """InputError, before any work is done, for a path that cannot be written."""
    from mpsolve.errors import InputError

    if html is not None and (html.is_dir() or not html.parent.is_dir()):
        raise InputError("html", f"{html} cannot be a file there: give a path in a folder that exists")
    if certificates is not None and certificates.exists() and not certificates.is_dir():
        raise InputError("certificates", f"{certificates} is a file: give the path of a folder")


def _report(report: Report, as_json: bool) -> None:
    from mpsolve.audit.tables import as_data, document

    if as_json:
        import json

        click.echo(json.dumps(as_data(report), indent=1, ensure_ascii=False))
    else:
        show(document(report))


COMMANDS = (audit,)
