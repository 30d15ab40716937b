"""Answers about ranges for machines: plain values with keys that stay; and as tables in CSV."""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING, Any

from mpsolve.files import csv_text
from mpsolve.numbers.spoken import decimal
from mpsolve.ranges.answer import Answer
from mpsolve.ranges.cells import BOUNDARY
from mpsolve.ranges.chart import Chart
from mpsolve.report.ranges_asked import Asked
from mpsolve.report.ranges_words import Said, trust
from mpsolve.report.spectrum_data import number, spectrum_data
from mpsolve.report.spectrum_words import ASSUMED

if TYPE_CHECKING:
    from mpsolve.problem.over import Over

FORMAT = "mpsolve ranges"
VERSION = 1


def ranges_data(question: str, verdict: str, found: Answer, asked: Asked) -> dict[str, Any]:
    """The answer in plain values.

    format, version   "mpsolve ranges", 1; a version adds no meaning to a key that is there
    question          "onset", "unstable_ranges", "crossings", "lines", "worst", "robust" or "chart"
    title, verdict    the title of the file, or "", and one sentence
    ranges            for each path {"low", "high", "own": {"exact", "decimal"}, "unit"}, in the model's units; own is
                      the file's value
    warnings          reasons in parts: what looks like a mistake, where the file's own value is outside a range
    answer            what the library's to_dict gives; a ball is {"decimal", "lower", "upper", "ball"}, the last as
                      [mantissa, exponent of 2] of the middle and of the radius, mantissas as texts
    spectrum          the report of certify at a counterexample, or null
    certificate       the sha256 of the certificate that passed the verifier, or null
    trust, assumed    sentences
    """
    spectrum = getattr(found, "spectrum", None)
    return {
        "format": FORMAT,
        "version": VERSION,
        "question": question,
        "title": asked.title,
        "verdict": verdict,
        "ranges": {one.path: _range(one, asked) for one in asked.overs},
        "warnings": [reason.data() for reason in asked.warnings],
        "answer": found.to_dict(),
        "spectrum": None if spectrum is None else spectrum_data(spectrum, asked.title),
        "certificate": None if found.certificate is None else found.certificate.content["sha256"],
        "trust": trust(found),
        "assumed": ASSUMED,
    }


def parts_data(each: list[dict[str, Any]]) -> dict[str, Any]:
    """Several answers over neighbouring default ranges, between which a wave speed is left out, under `parts`."""
    return {"format": FORMAT, "version": VERSION, "question": each[0]["question"], "parts": each}


def _range(over: Over, asked: Asked) -> dict[str, Any]:
    own = asked.problem.parameters.get(over.path)
    ends = {"low": over.low, "high": over.high, "own": own}
    exact = {name: x if x is None else number(x) for name, x in ends.items()}
    return {**exact, "unit": over.si}


def rows_csv(said: list[Said]) -> str:
    """The rows of the answers, one after another; the quantity that is looked for in the model's unit."""
    rows = [dict(row) for one in said for row in one.answer.rows()]
    (over, *_) = said[0].asked.overs
    rate = "rad/s" if said[0].asked.si else "√(k/m)"
    units = {"value": over.si, "start": over.si, "end": over.si, "q": rate, "re q": rate, "im q": rate}
    names = list(dict.fromkeys(name for row in rows for name in row))
    named = {name: over.path if name == "value" else name for name in names}
    headings = [f"{named[name]} [{units[name]}]" if units.get(name) else named[name] for name in names]
    return csv_text([headings, *([_text(row.get(name)) for name in names] for row in rows)])


def cells_csv(chart: Chart, asked: Asked) -> str:
    """A line for each cell: its ends in the model's units, exact, and what is proved of it.

    roots: how many grow, or "boundary" where one passes or may pass, or "open".
    """
    names = [f"{one.path} {end} [{one.si}]" if one.si else f"{one.path} {end}"
             for one in asked.overs for end in ("low", "high")]  # fmt: skip
    rows = [[*names, "roots"]]
    for i in range(len(chart.x) - 1):
        for j in range(len(chart.y) - 1):
            ends = (chart.x[i], chart.x[i + 1], chart.y[j], chart.y[j + 1])
            count = int(chart.counts[i, j])
            shown = str(count) if count >= 0 else "boundary" if count == BOUNDARY else "open"
            rows.append([*map(decimal, ends), shown])
    return csv_text(rows)


def _text(value: Any) -> str:
    if isinstance(value, Fraction):
        return decimal(value)
    return "" if value is None else repr(value) if isinstance(value, float) else str(value)
