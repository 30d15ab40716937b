"""The report for people: the verdict, the case, every vibration, and the statement of what is proved."""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import Any

from rich.box import SIMPLE_HEAD
from rich.console import Group
from rich.table import Table
from rich.text import Text

from mpsolve.certificate.on_sheet import AnySpectrum, sheet_of
from mpsolve.certificate.sheet import SheetSpectrum
from mpsolve.fields import ball_arithmetic
from mpsolve.model.assumed import ASSUMED
from mpsolve.model.parameters import PhysicalCase
from mpsolve.numbers.decimals import proved_digits, working_bits
from mpsolve.report.layout import certificate_text, columns_of, plain, section
from mpsolve.report.rows import beam_rows, ratio_rows, root_rows
from mpsolve.report.statement import limits, proved, verdict
from mpsolve.report.vibration import Trend, Vibration, vibrations

_PLACES = 8  # digits of the physical quantities; every digit of q is printed
_COLOUR = {"UNSTABLE": "bold red", "STABLE": "bold green", "UNDECIDED": "bold yellow"}


def render(
    spectrum: AnySpectrum,
    physical: PhysicalCase | None = None,
    title: str = "",
    certificate: str | os.PathLike[str] | None = None,
) -> str:
    """The report as plain text of `WIDTH` columns; every digit is proved, to one unit in the last place.

    physical: the case in SI units that was certified, for frequencies in Hz and times in s; without it they
    are in the unit of the dimensionless time τ. certificate: the path where the certificate was saved.
    Raises InputError if `physical` is not the case of the spectrum.
    """
    return plain(document(spectrum, physical, title, certificate))


def document(
    spectrum: AnySpectrum,
    physical: PhysicalCase | None = None,
    title: str = "",
    certificate: str | os.PathLike[str] | None = None,
) -> Group:
    """The same report for a rich console, with the verdict in colour."""
    spectrum = sheet_of(spectrum)
    stated = verdict(spectrum)
    parts: list[Any] = [Text(title, style="bold"), Text("")] if title else []
    parts += [Text(stated, style=_COLOUR.get(stated.partition(":")[0], "bold")), Text("")]
    parts += section("Case", _case(spectrum, physical))
    motions = vibrations(spectrum, physical)
    if motions:
        parts += section("Induced frequencies", _motions(motions, physical))
        parts += section("Roots q, certified digits", _roots(motions, spectrum.digits))
    parts += section("Proved", Text("\n".join(proved(spectrum) or ("Nothing yet.",))))
    parts += section("Assumed, not proved", Text(ASSUMED))[:-1]
    if certificate is not None:
        parts += [Text(""), *section("Certificate", certificate_text(os.fspath(certificate)))[:-1]]
    return Group(*parts)


def _case(spectrum: SheetSpectrum, physical: PhysicalCase | None) -> Table:
    table = columns_of(3)
    for row in [*(beam_rows(physical) if physical else ()), *ratio_rows(spectrum.case), *_limits(spectrum)]:
        table.add_row(*(Text(cell) for cell in row))
    return table


def _limits(spectrum: SheetSpectrum) -> Iterator[tuple[str, str, str]]:
    meaning = {"α_C": "velocity ratio at which the cuts join", "q_lm": "limiting frequency, where the cuts begin"}
    for name, value in limits(spectrum).items():
        yield name, value, meaning[name]


def _motions(motions: tuple[Vibration, ...], physical: PhysicalCase | None) -> Table:
    units = ("1/τ", "1/τ", "τ") if physical is None else ("Hz", "1/s", "s")
    table = Table(box=SIMPLE_HEAD, show_edge=False, pad_edge=False)
    for heading in ("", f"frequency [{units[0]}]", f"growth rate [{units[1]}]", f"time [{units[2]}]", ""):
        table.add_column(Text(heading), justify="right" if heading else "left")
    for row in motion_rows(motions):
        table.add_row(*(Text(cell) for cell in row))
    return table


def motion_rows(motions: tuple[Vibration, ...]) -> Iterator[tuple[str, ...]]:
    """Rows of name, frequency, growth rate, time and trend."""
    return (_motion(j, motion) for j, motion in enumerate(motions, 1))


def _motion(j: int, motion: Vibration) -> tuple[str, ...]:
    doing = {Trend.GROWS: "GROWS, doubles", Trend.DECAYS: "decays, halves", Trend.STEADY: "steady"}
    time = "" if motion.time is None else proved_digits(motion.time, _PLACES)
    frequency, rate = proved_digits(motion.frequency, _PLACES), proved_digits(motion.rate, _PLACES)
    return f"q{j}", frequency, rate, time, doing.get(motion.trend, motion.trend.value) + _several(motion)


def in_words(row: tuple[str, ...], unit: str) -> str:
    """What the vibration of a row does, and in which time, as "decays, halves in 2.5 s"."""
    trend, bracket, several = row[4].partition(" (")
    return f"{trend}{f' in {row[3]} {unit}' if row[3] else ''}{bracket}{several}"


def _several(motion: Vibration) -> str:
    return "" if motion.root.multiplicity == 1 else f" ({motion.root.multiplicity} roots)"


def _roots(motions: tuple[Vibration, ...], digits: int) -> Table:
    """Every proved digit: a pair q, −q̄ in one row, or in two where a row would be too long."""
    table = columns_of(2)
    with ball_arithmetic(working_bits(digits)):
        for j, motion in enumerate(motions, 1):
            for label, number in root_rows(j, motion, digits):
                table.add_row(Text(label), Text(number))
    return table
