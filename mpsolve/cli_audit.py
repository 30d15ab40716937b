"""The command `audit`: every claim of a paper checked anew."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import click

from mpsolve.cli_tools import JSON, PATH, UNDECIDED, WORKERS, checked_output, command, echo_json, progress, show
from mpsolve.errors import InputError

if TYPE_CHECKING:
    from mpsolve.claims.report import Report


@command()
@click.argument("paper", required=False, type=click.Path())
@click.option(
    "--only", multiple=True, metavar="ID", help="Only this claim, or all whose names begin so (may be given again)."
)
@JSON
@click.option("--html", type=PATH, help="Write the report as one HTML page, too.")
@click.option("--certificates", type=PATH, help="Folder for the certificates.")
@WORKERS
def audit(
    paper: str | None,
    only: tuple[str, ...],
    as_json: bool,
    html: Path | None,
    certificates: Path | None,
    workers: int | None,
) -> None:
    """Check every claim of PAPER: conclusions, numbers, captions, equations. All of examples/paper takes minutes.

    PAPER is a folder whose __init__.py or paper.py exports PAPER = Paper(title, citation, claims), or the dotted name
    of such a module. It is a program, and runs: give only what you trust.

    Exit status 0: every check came to its end, whatever the verdicts. 1: one did not, or a file could not be
    written. 2: the input cannot be used.
    """
    from mpsolve.claims.load import audit as check
    from mpsolve.claims.load import load

    _admit(paper, html, certificates)
    with progress() as tell:
        report = check(load(paper or ""), only, workers, tell)
    _report(report, as_json)
    if certificates is not None:
        report.save_certificates(certificates)
    if html is not None:
        from mpsolve.claims.report import page
        from mpsolve.files import write_whole

        write_whole(html, page(report))
    sys.exit(0 if report.complete else UNDECIDED)


def _admit(paper: str | None, html: Path | None, certificates: Path | None) -> None:
    """InputError, before any work is done, without a paper or for a path that cannot be written."""
    if paper is None:
        raise InputError("paper", "is not given: name the folder of its claims, as in mpsolve audit examples/paper")
    if html is not None:
        checked_output(html, Path(paper), "the page", "html")
    if certificates is not None and certificates.exists() and not certificates.is_dir():
        raise InputError("certificates", f"{certificates} is a file: give the path of a folder")


def _report(report: Report, as_json: bool) -> None:
    from mpsolve.claims.report import as_data, document

    if as_json:
        echo_json(as_data(report))
    else:
        show(document(report))
