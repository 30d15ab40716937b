"""The report for people: the verdict, the case, every vibration, and the statement of what is proved."""

from __future__ import annotations

import io
import os
import shlex
from collections.abc import Iterator
from typing import Any

from rich.box import SIMPLE_HEAD
from rich.console import Console, Group
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from mpsolve.certificate.on_sheet import AnySpectrum, sheet_of
from mpsolve.certificate.sheet import SheetSpectrum
from mpsolve.fields import ball_arithmetic
from mpsolve.model.assumed import ASSUMED
from mpsolve.model.parameters import Case, PhysicalCase
from mpsolve.numbers.decimals import decimal, proved_digits, working_bits
from mpsolve.numbers.exact import Exact
from mpsolve.report.statement import limits, proved, verdict
from mpsolve.report.vibration import Trend, Vibration, vibrations

WIDTH = 88
_PLACES = 8  # digits of the physical quantities; every digit of q is printed
_TYPED = 36  # digits of a value that is typed; more are shortened
_ROW = 76  # longest q that is printed in one row
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


def plain(report: Group) -> str:
    """A report as plain text of `WIDTH` columns."""
    stream = io.StringIO()
    console = Console(file=stream, width=WIDTH, force_terminal=False, color_system=None, legacy_windows=False)
    console.print(report, soft_wrap=False)
    return "\n".join(line.rstrip() for line in stream.getvalue().splitlines()) + "\n"


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


def section(heading: str, body: Any) -> list[Any]:
    """A heading, the body indented, and an empty line."""
    return [Text(heading, style="bold"), Padding(body, (0, 0, 0, 2)), Text("")]


def columns_of(columns: int) -> Table:
    """An empty table of so many columns, without lines."""
    table = Table.grid(padding=(0, 2))
    for _ in range(columns):
        table.add_column(overflow="fold")
    return table


def _case(spectrum: SheetSpectrum, physical: PhysicalCase | None) -> Table:
    table = columns_of(3)
    for row in [*(beam_rows(physical) if physical else ()), *ratio_rows(spectrum.case), *_limits(spectrum)]:
        table.add_row(*(Text(cell) for cell in row))
    return table


def beam_rows(physical: PhysicalCase) -> Iterator[tuple[str, str, str]]:
    """Rows of quantity, value and meaning, in SI units."""
    for name, unit, meaning in (
        ("EI", "N m²", "bending stiffness of the beam"),
        ("m", "kg/m", "mass of the beam"),
        ("k", "N/m²", "stiffness of the foundation"),
        ("c", "N s/m²", "damping of the foundation"),
        ("kp", "N", "Pasternak modulus of the foundation"),
        ("N", "N", "axial force, compression positive"),
        ("v", "m/s", "velocity"),
    ):
        yield name, f"{shown(getattr(physical, name))} {unit}", meaning
    for j, mass in enumerate(physical.masses, 1):
        yield f"M{j}", f"{shown(mass.M)} kg", f"mass at s {_equals(mass.position)} m"
    yield "√(k/m)", f"{shown(physical.time_scale)} rad/s", "τ = √(k/m) t"
    yield "χ", f"{shown(physical.chi)} 1/m", "(k/4EI)^(1/4): ξ = χ s"
    yield "v_cr", f"{shown(physical.v_cr)} m/s", "critical velocity √(k/m)/χ on a Winkler foundation"
    if physical.N or physical.kp:
        yield "v_cr′", f"{_critical(physical)} m/s", "√(1 − η_N + η_S) v_cr, with N and kp, without damping"


def _critical(physical: PhysicalCase) -> str:
    with ball_arithmetic(working_bits(_PLACES)):
        share = 1 - physical.dimensionless.axial.ball()
        return f"≈ {proved_digits(share.sqrt() * physical.v_cr.ball(), _PLACES)}"


def ratio_rows(case: Case) -> Iterator[tuple[str, str, str]]:
    """Rows of the dimensionless parameters."""
    yield "α", shown(case.alpha), "velocity ratio v/v_cr"
    yield "η_b", shown(case.eta_b), "damping ratio c/(2√(mk))"
    yield "η_N", shown(case.eta_n), "axial force ratio"
    yield "η_S", shown(case.eta_s), "Pasternak modulus ratio"
    for j, (ratio, place) in enumerate(zip(case.eta_m, case.positions, strict=True), 1):
        yield f"η_M{j}", shown(ratio), f"mass ratio M χ/m, at ξ {_equals(place)}"


def _limits(spectrum: SheetSpectrum) -> Iterator[tuple[str, str, str]]:
    meaning = {"α_C": "velocity ratio at which the cuts join", "q_lm": "limiting frequency, where the cuts begin"}
    for name, value in limits(spectrum).items():
        yield name, value, meaning[name]


def shown(x: Exact) -> str:
    """x as it is typed: exactly if at most 36 digits do, else its first proved digits, marked ≈."""
    for digits in (12, _TYPED):
        short = x.short(digits)
        if Exact.parse(short) == x:
            return short
    with ball_arithmetic(working_bits(_PLACES)):
        return f"≈ {proved_digits(x.ball(), _PLACES)}"


def _equals(x: Exact) -> str:
    text = shown(x)
    return text if text.startswith("≈") else f"= {text}"


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


def root_rows(j: int, motion: Vibration, digits: int) -> list[tuple[str, str]]:
    """Label and digits of a root, at the precision that is set: one row, or two where one would be too long."""
    q = motion.root.q
    real, imag = decimal(abs(q.real), digits + 2).text, decimal(q.imag, digits + 2).text
    pair = "±" if q.real else ""
    if not q.imag:
        return [(f"q{j} =", pair + real)]
    whole = f"{pair}{real} {'-' if imag.startswith('-') else '+'} {imag.removeprefix('-')} i"
    if len(whole) <= _ROW:
        return [(f"q{j} =", whole)]
    return [(f"Re q{j} =", pair + real), (f"Im q{j} =", imag)]


def certificate_text(path: str) -> Text:
    """Where the certificate is, and how to check it."""
    return Text(f"{path}\nCheck it with: mpsolve verify {shlex.quote(path)}")
