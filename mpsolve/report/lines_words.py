"""What is said of root loci, and their points as a table in the units that the user wrote."""

from __future__ import annotations

import numpy as np

from mpsolve.files import csv_text
from mpsolve.loci.answer import FrequencyLine, FrequencyLines, LineEnd
from mpsolve.numbers.spoken import rounded
from mpsolve.problem.over import Over
from mpsolve.report.ranges_asked import Asked
from mpsolve.report.ranges_words import Said, framed, frequency_text, growing, undecided, value_text
from mpsolve.spectrum.regions import Sheet

_SIDES = {
    "below": "the branch cut, which it meets from below,",
    "above": "the branch cut, which it meets from above,",
    "gap": "the branch point at which the cut begins,",
}


def said_of_lines(found: FrequencyLines, asked: Asked) -> Said:
    """The report of root loci."""
    asked = asked.answered(found.over)
    grows = any(line.crossings for line in found.lines)
    return Said("lines", found, asked, lines_verdict(found), framed(_lines(found, asked), found, asked), grows)


def lines_verdict(found: FrequencyLines) -> str:
    """One sentence."""
    if not found.proved:
        return undecided(found)
    number = len(found.lines)
    of = "of" if isinstance(found.region, Sheet) else "with"
    return f"Every root {of} {found.region} lies on {'one line' if number == 1 else f'one of {number} lines'}."


def _lines(found: FrequencyLines, asked: Asked) -> list[str]:
    (over,) = asked.overs
    lines = [lines_verdict(found)]
    for k, line in enumerate(found.lines, 1):
        first, last = (
            _end(end, over, found.digits, name) for end, name in zip(line.ends, ("start", "end"), strict=True)
        )
        lines.append(f"  line {k}: from {first} to {last}{_way(line, asked)}")
        for one in line.crossings:
            where = value_text(one.value, over, found.digits)
            way = {True: "; grows beyond it", False: "; decays beyond it"}[one.direction > 0] if one.direction else ""
            lines.append(f"    real at {over.path} = {where}: {frequency_text(one.q, asked, found.digits)}{way}")
    if found.counts is not None:
        lines.append(f"  {_growing(found.lines)}")
    return lines


def _growing(lines: tuple[FrequencyLine, ...]) -> str:
    """Whether any point of the lines grows."""
    growing_lines = sum(bool(line.crossings) or any(q.imag < 0 for q in line.q) for line in lines)
    return f"lines on which a vibration grows somewhere: {growing_lines}" if growing_lines else f"all: {growing(0)}"


def _way(line: FrequencyLine, asked: Asked) -> str:
    """The roots at its first and last point, in few figures."""
    if not line.q:
        return ""
    unit = " rad/s" if asked.si else ""
    each = (f"{rounded(q.real)} + {rounded(q.imag)}i{unit}" for q in (line.q[0], line.q[-1]))
    return f"; q = {' … '.join(each)}".replace("+ -", "− ").replace("+ −", "− ")


def _end(end: LineEnd, over: Over, digits: int, name: str) -> str:
    where = "" if end.value is None else f" at {over.path} = {value_text(end.value, over, digits)}"
    said = {
        "range": f"the {name} of the range",
        "region": f"the border of the region{where}",
        "collision": f"where it meets its mirror image{where}",
        "cut": f"{_SIDES[end.side or 'below']}{where}",
        "open": "where it is followed no further",
    }
    return said[end.kind]


def lines_csv(found: FrequencyLines, asked: Asked) -> str:
    """The rows of the answer: the parameter as the user wrote it, q, in SI its frequency in Hz, how the line ends."""
    (over,) = asked.overs
    name = f"{over.path} [{over.unit}]" if over.unit else over.path
    rate = "rad/s" if asked.si else "√(k/m)"
    rows = [["line", name, f"Re q [{rate}]", f"Im q [{rate}]", *(["frequency [Hz]"] if asked.si else []), "end"]]
    for k, line in enumerate(found.lines, 1):
        for value, q, end in line.points:
            re, im = float(q.real.mid()), float(q.imag.mid())
            hertz = [repr(re / (2 * np.pi))] if asked.si else []
            rows.append([str(k), repr(float(over.shown(value))), repr(re), repr(im), *hertz, end])
    return csv_text(rows)
