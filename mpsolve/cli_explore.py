"""The command `explore`: a local page with sliders, live roots, and proofs on request."""

from __future__ import annotations

from pathlib import Path

import click

from mpsolve.cli_tools import PATH, command
from mpsolve.errors import InputError


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
