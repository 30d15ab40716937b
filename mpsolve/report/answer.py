"""What a question about a whole range of a parameter is answered with: one sentence, numbers, and what is open."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Any

from rich.box import SIMPLE_HEAD
from rich.console import Group
from rich.table import Table
from rich.text import Text

from mpsolve.certificate.format import Certificate
from mpsolve.fields import ball_arithmetic
from mpsolve.model.assumed import ASSUMED
from mpsolve.numbers.decimals import decimal, proved_digits, working_bits
from mpsolve.numbers.exact import Exact
from mpsolve.problem.case import Case
from mpsolve.problem.physical import PhysicalCase
from mpsolve.problem.specs import label
from mpsolve.report.layout import certificate_text, columns_of, section
from mpsolve.report.rows import beam_rows, physical_data, ratio_rows

VERSION = 1
PLACES = 8  # digits of the quantities that follow from the certified ones
_DIGITS_SAID = "The last digit of every number is right to one unit."


@dataclass(frozen=True)
class Source:
    """The case that was asked about, in SI units too where it was given so."""

    case: Case
    physical: PhysicalCase | None
    title: str

    @property
    def omega(self) -> Any:
        """√(k/m) in rad/s, or 1, as a ball at the present precision."""
        return Exact.parse(1).ball() if self.physical is None else self.physical.time_scale.ball()


@dataclass(frozen=True)
class Answer:
    """sentence: the verdict, beginning with PROVED or UNDECIDED. data: the report for machines.

    unused: the parameters of the case that have no part in the answer, each with the reason. headings, rows: the
    quantities, under `heading`; digits: names and certified decimals; open: what is open, and what helps.
    """

    source: Source
    sentence: str
    unused: tuple[str, ...]
    headings: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    digits: tuple[tuple[str, str], ...]
    open: tuple[str, ...]
    data: dict[str, Any]
    certificate: Certificate | None
    heading: str = "Crossings"

    @property
    def proved(self) -> bool:
        return self.sentence.startswith("PROVED")


def answer_document(answer: Answer, certificate: str | os.PathLike[str] | None = None) -> Group:
    """The report for people; certificate: the path where it was saved."""
    source = answer.source
    parts: list[Any] = [Text(source.title, style="bold"), Text("")] if source.title else []
    parts += [Text(answer.sentence, style="bold green" if answer.proved else "bold yellow"), Text("")]
    parts += section("Case", _case(answer))
    if answer.rows:
        parts += section(answer.heading, _rows(answer))
    if answer.digits:
        table = columns_of(2)
        for name, number in answer.digits:
            table.add_row(Text(f"{name} ="), Text(number))
        parts += section("Certified digits", table)
    if answer.open:
        parts += section("Open, and what helps", Text("\n".join(answer.open)))
    parts += section("Assumed, not proved", Text(f"{ASSUMED} {_DIGITS_SAID}" if answer.rows else ASSUMED))[:-1]
    if certificate is not None:
        parts += [Text(""), *section("Certificate", certificate_text(os.fspath(certificate)))[:-1]]
    return Group(*parts)


def answer_data(answer: Answer, certificate: str | os.PathLike[str] | None = None) -> dict[str, Any]:
    """The report for machines: `data` between the keys that all answers share.

    format, version   "mpsolve onset" and the like, 1; a version adds no meaning to a key that is there
    title, status ("proved" or "undecided"), proved (the sentences; "" if undecided)
    case              as in a certificate; physical: SI units, or null
    …                 the answer's own keys; a number is {"value", "radius"}: the exact one is within radius of value
    assumed, certificate (its path, or null)
    """
    source = answer.source
    head = {
        "format": answer.data["format"],
        "version": VERSION,
        "title": source.title,
        "status": "proved" if answer.proved else "undecided",
        "proved": f"{answer.sentence} {_DIGITS_SAID}" if answer.proved else "",
        "case": source.case.as_dict(),
        "physical": None if source.physical is None else physical_data(source.physical),
    }
    tail = {"assumed": ASSUMED, "certificate": None if certificate is None else os.fspath(certificate)}
    return head | answer.data | tail


def number(ball: Any, digits: int) -> dict[str, str]:
    """A ball for machines."""
    with ball_arithmetic(working_bits(digits)):
        shown = decimal(ball, digits)
    return {"value": shown.text, "radius": shown.radius_text}


def short(ball: Any) -> str:
    """A ball in the few digits of a table."""
    return proved_digits(ball, PLACES)


def between(low: Exact, symbol: str, high: Exact) -> str:
    return f"{label(low)} ≤ {symbol} ≤ {label(high)}"


def _case(answer: Answer) -> Table:
    source = answer.source
    table = columns_of(3)
    for row in [*(beam_rows(source.physical) if source.physical else ()), *ratio_rows(source.case)]:
        table.add_row(*(Text(cell) for cell in row))
    for said in answer.unused:
        table.add_row(Text("not used:"), Text(said.partition(": ")[0]), Text(said.partition(": ")[2]))
    return table


def _rows(answer: Answer) -> Table:
    table = Table(box=SIMPLE_HEAD, show_edge=False, pad_edge=False)
    for heading in answer.headings:
        table.add_column(Text(heading), justify="right" if heading else "left")
    for row in answer.rows:
        table.add_row(*(Text(cell) for cell in row))
    return table
