"""The command `certify`: every induced frequency of the problem in a file, with a report and a certificate."""

from __future__ import annotations

import sys
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from mpsolve.cli_tools import (
    EFFORT,
    FILE,
    JSON,
    UNDECIDED,
    certificate_path,
    command,
    digits_option,
    echo_json,
    effort_of,
    output,
    progress,
    show,
)
from mpsolve.errors import CertificateError, InputError

if TYPE_CHECKING:
    from mpsolve.spectrum.spectrum import Spectrum

_REFUSED = ("verifier", "not-verified")


@command()
@FILE
@digits_option(30)
@click.option(
    "--region",
    metavar="REGION",
    help="unstable (Im q < 0); below=H (Im q < H, below the branch cuts); the rectangle RE_MIN,RE_MAX,IM_MIN,IM_MAX; "
    "sheet (everything, for masses alone on a beam). In the units of FILE: rad/s in SI, "
    "or with a unit, as in --region 'below=50 1/s'.  [default: the one of sheet, below and unstable that tells most]",
)
@EFFORT
@JSON
@output("Path of the certificate.  [default: NAME.certificate.json in the working directory]")
def certify(
    file: Path, digits: int, region: str | None, effort: str | None, as_json: bool, output: Path | None
) -> None:
    """Find, count and prove the induced frequencies of the problem in FILE (TOML), and write a certificate.

    FILE holds any track and vehicles, or a case of the paper. The forces in it have no part in this.

    Exit status 0: proved, stable or not. 1: undecided, with the reason and what helps, or the certificate
    could not be written. 2: the input cannot be used.
    """
    from mpsolve.certificate.certify import certify as prove
    from mpsolve.problem.inputfile import read_source

    source = read_source(file)
    path = certificate_path(source.path, output)
    options = {"region": region_of(region), "digits": digits, "effort": effort_of(effort)}
    with progress() as tell:
        spectrum = prove(source.given, progress=tell, **options)
    _report(spectrum, source.title, path, as_json, output is None)
    sys.exit(0 if spectrum.proved else UNDECIDED)


def region_of(text: str | None) -> Any:
    """The region that an option names, as `certify` takes it; InputError where it names none."""
    from mpsolve.spectrum.regions import Rectangle

    if text in (None, "sheet", "unstable"):
        return text
    word, equals, height = str(text).partition("=")
    if equals and word.strip() == "below":
        return ("below", height.strip())
    bounds = str(text).split(",")
    if len(bounds) != 4:
        raise InputError("region", f"is {text!r}: give unstable, below=H, RE_MIN,RE_MAX,IM_MIN,IM_MAX, or sheet")
    return Rectangle(*(bound.strip() for bound in bounds))


def _told(found: Spectrum) -> Spectrum:
    """With the names of options in what helps."""
    from mpsolve.report.remedies import on_command_line

    reason = found.reason and replace(found.reason, remedy=on_command_line(found.reason.remedy))
    return replace(found, reason=reason, verified=on_command_line(found.verified))


def _report(spectrum: Spectrum, title: str, path: Path, as_json: bool, by_default: bool) -> None:
    """Saves the certificate, and prints the report even if that fails; CertificateError then.

    by_default: the path is not the user's own, so that no other case's certificate may be overwritten there.
    """
    from mpsolve.certificate.format import own_name

    saved, failure = None, None
    refused = spectrum.reason is not None and spectrum.reason.code in _REFUSED
    if spectrum.certificate is not None and not refused:
        try:
            own = own_name(path, spectrum.certificate.content) if by_default else path
            saved = spectrum.certificate.save(own)
        except CertificateError as error:
            failure = error
    if as_json:
        from mpsolve.report.spectrum_data import spectrum_data

        echo_json(spectrum_data(spectrum, title, saved))
    else:
        from mpsolve.report.spectrum_text import spectrum_document

        show(spectrum_document(_told(spectrum), title, saved))
    if failure is not None:
        raise failure
