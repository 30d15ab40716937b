"""The command `mpsolve`: certify a case, verify, derive; the other commands are in the modules cli_*.py.

Exit status: 0 if what was asked for is proved (an unstable case too) or valid; 1 if it is undecided or
invalid, or if the certificate could not be written; 2 for input that cannot be used. Standard output carries
the report only; progress and errors go to standard error, progress only if that is a terminal.
"""

from __future__ import annotations

import errno
import io
import os
import sys
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING

import click

from mpsolve import cli_audit, cli_receptance, cli_report, cli_response, cli_stability, cli_study
from mpsolve.cli_tools import UNDECIDED, certificate_path, one_sentence, progress, show

if TYPE_CHECKING:
    from mpsolve.certificate.certify import Spectrum
    from mpsolve.model.inputfile import InputFile
    from mpsolve.sheet.region import Region


def _show_version(context: click.Context, _option: click.Parameter, asked: bool) -> None:
    if asked and not context.resilient_parsing:
        from mpsolve import __version__

        click.echo(f"mpsolve {__version__}")
        context.exit()


@click.group(context_settings={"help_option_names": ["-h", "--help"]})
@click.option(
    "--version", is_flag=True, is_eager=True, expose_value=False, callback=_show_version, help="Show the version."
)
def cli() -> None:
    """Certified stability analysis of masses that move along a beam on an elastic foundation."""


@cli.command()
@click.argument("file", type=click.Path(path_type=Path))
@click.option("--digits", type=int, default=30, show_default=True, help="Certified digits, 15 to 10000.")
@click.option(
    "--region",
    metavar="REGION",
    help="sheet, unstable (Im q < 0), or the rectangle RE_MIN,RE_MAX,IM_MIN,IM_MAX.  [default: sheet; unstable where "
    "the branch cuts leave their line, as on an overdamped track]",
)
@click.option(
    "--max-pieces", type=click.IntRange(1), default=100_000, show_default=True, help="Effort of the count, in pieces."
)
@click.option("--json", "as_json", is_flag=True, help="Report for machines, in JSON.")
@click.option(
    "-o",
    "--output",
    type=click.Path(path_type=Path),
    help="Path of the certificate.  [default: NAME.certificate.json in the working directory]",
)
def certify(file: Path, digits: int, region: str | None, max_pieces: int, as_json: bool, output: Path | None) -> None:
    """Find, count and prove every induced frequency of the case in FILE (TOML), and write a certificate.

    The forces that FILE may give (P, P_A, omega_f, phi_f of [[mass]], or [[load]]) have no part in it.

    Exit status 0: proved, stable or not. 1: undecided, with the reason and what helps, or the certificate
    could not be written. 2: the input cannot be used.
    """
    with one_sentence():
        from mpsolve.certificate.certify import certify as prove
        from mpsolve.model.inputfile import read_input

        source = read_input(file)
        path = certificate_path(source.path, output)
        with progress() as tell:
            spectrum = _told(lambda: prove(source.case, digits, _region(region, source), max_pieces, tell))
        _report(spectrum, source, path, as_json)
    sys.exit(0 if spectrum.proved else UNDECIDED)


def _told(prove: Callable[[], Spectrum]) -> Spectrum:
    """The result, with remedies that name options; InputError likewise."""
    from dataclasses import replace

    from mpsolve.errors import InputError
    from mpsolve.report.remedies import on_command_line

    try:
        found = prove()
    except InputError as error:
        raise InputError(error.key, on_command_line(str(error).removeprefix(f"{error.key}: "))) from None
    return replace(found, reason=on_command_line(found.reason))


def _region(text: str | None, source: InputFile) -> Region:
    from mpsolve.errors import InputError
    from mpsolve.model.parameters import PhysicalCase
    from mpsolve.sheet.region import Rectangle

    if text is None:
        case = source.case.dimensionless if isinstance(source.case, PhysicalCase) else source.case
        return "sheet" if case.cuts_on_line else "unstable"
    if text == "sheet":
        return "sheet"
    if text == "unstable":
        return "unstable"
    bounds = text.split(",")
    if len(bounds) != 4:
        raise InputError("region", f"is {text!r}: give sheet, unstable, or RE_MIN,RE_MAX,IM_MIN,IM_MAX")
    return Rectangle(*bounds)


def _report(spectrum: Spectrum, source: InputFile, path: Path, as_json: bool) -> None:
    """Saves the certificate, and prints the report even if that fails; CertificateError then."""
    from mpsolve.errors import CertificateError
    from mpsolve.model.parameters import PhysicalCase

    physical = source.case if isinstance(source.case, PhysicalCase) else None
    saved, failure = None, None
    if spectrum.certificate is not None:
        try:
            saved = spectrum.certificate.save(path)
        except CertificateError as error:
            failure = error
    if as_json:
        import json

        from mpsolve.report.data import as_data

        click.echo(json.dumps(as_data(spectrum, physical, source.title, saved), indent=1, ensure_ascii=False))
    else:
        from mpsolve.report.text import document

        show(document(spectrum, physical, source.title, saved))
    if failure is not None:
        raise failure


@cli.command()
@click.argument("files", nargs=-1, required=True, metavar="FILE...", type=click.Path(path_type=Path))
def verify(files: tuple[Path, ...]) -> None:
    """Check certificates, by other formulas than those that proved them; a line for each FILE.

    Exit status 0: all are valid. 1: one is not, or cannot be read.
    """
    from mpsolve.certificate.verify import verify as check

    valid = True
    for file in files:
        result = check(file)
        valid = valid and result.valid
        verdict = f"valid: {file}: {result.claim}" if result.valid else f"invalid: {file}: {result.reason}"
        click.echo(verdict)
    sys.exit(0 if valid else 1)


@cli.command()
@click.argument("file", required=False, type=click.Path(path_type=Path))
@click.option("--latex", is_flag=True, help="A LaTeX document instead of text.")
@click.option("--masses", type=int, default=2, show_default=True, help="Number of moving masses, without FILE.")
def derive(file: Path | None, latex: bool, masses: int) -> None:
    """Derive the model symbolically, from the equations of motion on, and print every step.

    With FILE (TOML): the track and the vehicles in it, from their mechanics to the matrices that are computed with.
    Without: the paper's beam, to the kernel. Exit status 0: printed. 2: the input cannot be used.
    """
    with one_sentence():
        from mpsolve.model.derivation import derivation, render

        if file is None:
            steps = derivation(masses)
        else:
            from mpsolve.derivation.problem import derivation_of
            from mpsolve.problem.inputfile import read_problem

            steps = derivation_of(read_problem(file).problem)
        click.echo(render(steps, "latex" if latex else "text"), nl=False)


@cli.command()
@click.argument("name", required=False)
def models(name: str | None) -> None:
    """Show every track and vehicle, or the one with NAME: drawing, parameters, units, meaning.

    Exit status 0: shown. 2: there is no such model.
    """
    with one_sentence():
        from mpsolve.report.models import listing

        click.echo(listing(name), nl=False)


for module in (cli_stability, cli_response, cli_receptance, cli_study, cli_report, cli_audit):
    for command in module.COMMANDS:
        cli.add_command(command)


_FULL = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EIO, errno.EBADF)  # of a stream that takes no more


def main() -> None:
    """Run the command with standard output and error in UTF-8, whatever the locale says."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(encoding="utf-8", errors="replace" if os.name == "nt" else "strict")
    try:
        cli(prog_name="mpsolve")
    except OSError as error:  # a closed pipe is click's affair; a full disk behind it is told here
        if error.filename is not None or error.errno not in _FULL:
            raise
        with suppress(OSError):  # what is buffered still cannot be written: let the interpreter end in silence
            sys.stdout.flush()
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
        told = f"standard output cannot be written ({error.strerror}): make room, or send it elsewhere"
        print(f"mpsolve: {told}", file=sys.stderr)
        sys.exit(1)
