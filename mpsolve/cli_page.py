"""The commands that make a page: report writes one, explore serves one."""

from __future__ import annotations

import sys
from pathlib import Path

import click

from mpsolve.cli_tools import (
    FILE,
    PATH,
    UNDECIDED,
    checked_file,
    checked_output,
    command,
    digits_option,
    output,
    progress,
    seconds_of,
)
from mpsolve.errors import InputError


@command()
@FILE
@output("Path of the page.  [default: NAME.html in the working directory]")
@click.option("--pdf", type=PATH, metavar="FILE", help="The page as a PDF, too.")
@digits_option(20, " of the roots")
@click.option("--effort", default="60", show_default=True, metavar="SECONDS", help="Processor time for all parts.")
@click.option(
    "--prove-chart/--computed-chart",
    default=True,
    help="The chart of velocity and mass: proved, or counted in floats.",
)
def report(file: Path, output: Path | None, pdf: Path | None, digits: int, effort: str, prove_chart: bool) -> None:
    """Write a page about the problem in FILE: verdict, margins, vibrations, motion, what is proved, certificates.

    The page is one HTML file that needs no network. Its parts are made in the order of their importance within
    --effort; what was not ready in time, or at the first Ctrl-C, is named on it. The motion is that under the loads
    of the file, or weights.

    Exit status 0: the vibrations are proved, stable or not. 1: they are undecided, as the page says, or the page
    could not be written. 2: the input cannot be used.
    """
    from mpsolve.files import checked_suffix, write_whole
    from mpsolve.page.page import page_html
    from mpsolve.page.paper import require_printer, save_pdf
    from mpsolve.page.parts import gather
    from mpsolve.problem.inputfile import read_source
    from mpsolve.report.remedies import on_command_line

    source = read_source(file)
    path = checked_output(output or Path(f"{source.path.stem}.html"), source.path, "the page")
    if path.suffix.lower() == ".pdf":
        raise InputError("output", f"{path} is a page in HTML: give -o NAME.html, and --pdf {path} for the PDF")
    seconds = seconds_of(effort, "effort")
    checked_suffix(path, (".html", ".htm"))
    if checked_file(pdf, source.path, "the PDF", (".pdf",), "pdf"):
        require_printer()
    with progress() as tell:
        parts = gather(
            source.given,
            source.title,
            digits=digits,
            seconds=seconds,
            tell=tell or (lambda _stage, _fraction: None),
            loads=source.loads,
            sources=source.sources,
            prove_chart=prove_chart,
        )
        write_whole(path, page_html(parts, source.path.stem))
        if pdf is not None:
            save_pdf(parts, source.path.stem, pdf)
    click.echo("\n".join([on_command_line(parts.verdict), str(path), *([] if pdf is None else [str(pdf)])]))
    sys.exit(0 if parts.spectrum.proved else UNDECIDED)


@command()
@click.argument("file", required=False, type=PATH)
@click.option(
    "--port", type=click.IntRange(1, 65535), default=8080, show_default=True, help="Port of the page on this machine."
)
@click.option("--browser/--no-browser", default=True, show_default=True, help="Open the page in a browser.")
def explore(file: Path | None, port: int, browser: bool) -> None:
    """Open a page on this machine on which the problem in FILE is changed, looked at and proved.

    Without FILE it begins with a preset. Nothing leaves the machine. Ctrl-C ends it. Needs the extra `explore`.

    Exit status 0: ended. 2: the file cannot be used, or the extra is missing.
    """
    try:
        from mpsolve.explorer.page import serve
    except ModuleNotFoundError as error:
        if error.name != "nicegui":
            raise
        raise InputError("explore", "needs NiceGUI, which is not installed: pip install 'mpsolve[explore]'") from None
    from mpsolve.presets.written import begun

    problem, title = begun(file)
    click.echo(f"http://127.0.0.1:{port}  (Ctrl-C ends it)")
    serve(problem, title, port, browser)
