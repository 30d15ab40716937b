"""The command about one case as a whole: report."""

from __future__ import annotations

import sys
from pathlib import Path

import click

from mpsolve.cli_tools import UNDECIDED, checked_output, one_sentence, progress


@click.command()
@click.argument("file", type=click.Path(path_type=Path))
@click.option(
    "-o",
    "--output",
    type=click.Path(path_type=Path),
    help="Path of the page.  [default: NAME.html in the working directory]",
)
@click.option(
    "--pdf",
    type=click.Path(path_type=Path),
    metavar="FILE",
    help="Print the page to this PDF, too, by an installed Chromium, Chrome or Edge.",
)
@click.option("--digits", type=int, default=30, show_default=True, help="Certified digits of the roots, 15 to 10000.")
def report(file: Path, output: Path | None, pdf: Path | None, digits: int) -> None:
    """Write a page about the case in FILE (TOML): verdict, margins, roots, figures, response, certificates.

    The response is that to the loads of the file: P, P_A, omega_f, phi_f of each [[mass]], or constant, amplitude,
    frequency, phase of each [[load]] beside [dimensionless]; without any, to weights or unit forces.

    The page is one HTML file that needs no network. On an idle processor it takes about a minute for one or two
    masses, two for three and three for four, with fewer velocities and columns in the figures; more masses take
    longer. Exit status 0: all that can be asked of the case is proved, stable or not. 1: a part is undecided, as the
    page says, or the page could not be written. 2: the input cannot be used.
    """
    with one_sentence():
        from mpsolve.errors import InputError
        from mpsolve.files import checked_suffix, write_whole
        from mpsolve.model.inputfile import read_input
        from mpsolve.model.parameters import PhysicalCase
        from mpsolve.report.answer import Source
        from mpsolve.report.figures import require_matplotlib
        from mpsolve.report.page import report_page
        from mpsolve.report.page_parts import gather
        from mpsolve.report.pdf import browser, save_pdf

        given = read_input(file)
        path = checked_output(output or Path(f"{given.path.stem}.html"), given.path, "the page")
        if path.suffix.lower() == ".pdf":
            raise InputError("output", f"{path} is a page in HTML: give -o NAME.html, and --pdf {path} for the PDF")
        checked_suffix(path, (".html", ".htm"))
        require_matplotlib()
        printer = None
        if pdf is not None:
            checked_suffix(checked_output(pdf, given.path, "the PDF"), (".pdf",))
            printer = pdf, browser()
        physical = given.case if isinstance(given.case, PhysicalCase) else None
        case = given.case.dimensionless if isinstance(given.case, PhysicalCase) else given.case
        with progress() as tell:
            parts = gather(Source(case, physical, given.title), digits, tell, given.loads)
            page = report_page(parts, given.path.stem)
            write_whole(path, page)
            if printer is not None:
                save_pdf(page, *printer)
        click.echo("\n".join([parts.verdict, str(path), *([] if pdf is None else [str(pdf)])]))
    sys.exit(0 if parts.proved else UNDECIDED)


COMMANDS = (report,)
