"""The report as one page: a single HTML file that needs no network, with its figures, numbers and certificates."""

from __future__ import annotations

import base64
import shlex
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from mpsolve import __version__
from mpsolve.errors import known
from mpsolve.fields import ball_arithmetic
from mpsolve.model.assumed import ASSUMED
from mpsolve.model.parameters import PhysicalCase
from mpsolve.numbers.decimals import decimal, working_bits
from mpsolve.report.html_environment import rendered_template
from mpsolve.report.page_data import Proof, page_data, proofs
from mpsolve.report.page_figures import ball_pictures, chart_picture, line_pictures, plane_pictures, response_pictures
from mpsolve.report.page_loads import load_rows
from mpsolve.report.page_parts import Parts
from mpsolve.report.page_words import Card, card, here_text
from mpsolve.report.remedies import for_reader
from mpsolve.report.rows import beam_rows, ratio_rows, shown
from mpsolve.report.statement import limits, proved
from mpsolve.report.text import in_words, motion_rows
from mpsolve.report.vibration import Vibration, vibrations

TEMPLATE = "page.html.j2"


@dataclass(frozen=True)
class Download:
    """A certificate as a link: the address holds the file itself."""

    proof: Proof
    address: str
    command: str


def report_page(parts: Parts, stem: str) -> str:
    """The page as HTML. stem: of the names of the certificates. Raises InputError if matplotlib is missing."""
    return rendered_template(TEMPLATE, **_context(parts, stem))


def _context(parts: Parts, stem: str) -> dict[str, Any]:
    source, spectrum = parts.source, parts.spectrum
    word, _, rest = parts.verdict.partition(": ")
    certificates = proofs(parts, stem)
    motions = vibrations(spectrum, source.physical)
    lines, chart = parts.lines.value, parts.chart.value
    return {
        "version": __version__,
        "title": source.title or stem,
        "word": word,
        "sentence": rest[:1].upper() + rest[1:],
        "stable": parts.stable,
        "witness": parts.witness,
        "cards": list(_cards(parts)),
        "here": {margin.name: here_text(margin, source) for margin in parts.margins},
        "beam": None if source.physical is None else list(_beam(source.physical)),
        "loads": list(load_rows(source, parts.loads)),
        "ratios": [*ratio_rows(source.case), *_limit_rows(parts)],
        "motions": [_motion(row, "τ" if source.physical is None else "s") for row in motion_rows(motions)],
        "units": ("1/τ", "1/τ") if source.physical is None else ("Hz", "1/s"),
        "digits": spectrum.digits,
        "roots": [_digits(k, motion, spectrum.digits) for k, motion in enumerate(motions, 1)],
        "spectrum": spectrum,
        "roots_reason": for_reader(spectrum.reason, "roots"),
        "below_only": spectrum.region == "unstable",
        "plane": plane_pictures(parts),
        "balls": ball_pictures(parts),
        "lines": [] if lines is None else line_pictures(lines, parts),
        "lines_reason": for_reader(parts.lines.reason, "lines"),
        "counts_open": _open_counts(parts),
        "chart": None if chart is None else chart_picture(chart, parts),
        "chart_reason": for_reader(parts.chart.reason, "chart"),
        "chart_table": [] if chart is None else _chart_rows(parts),
        "response": response_pictures(parts),
        "response_reason": for_reader(parts.response.reason, "response"),
        "loads_said": parts.loads_said,
        "contact": _contact(parts),
        "misfit": None if parts.response.value is None else f"{parts.response.value.misfit:.0e}",
        "proved": proved(spectrum),
        "margins_proved": [
            (one, margin.certificate is not None)
            for one, margin in zip(_cards(parts), parts.margins, strict=True)
            if one.status == "proved"
        ],
        "margins_open": [one for one in _cards(parts) if one.status == "undecided"],
        "assumed": ASSUMED,
        "downloads": [_download(proof) for proof in certificates],
        "data": page_data(parts, certificates),
    }


def _beam(physical: PhysicalCase) -> Iterator[tuple[str, str, str]]:
    for row in beam_rows(physical):
        yield row
        if row[0] == "v":
            yield "", f"{shown(physical.v * Fraction(18, 5))} km/h", "the same"


def _motion(row: tuple[str, ...], unit: str) -> tuple[str, str, str, str]:
    """Name, frequency, growth rate, and what the vibration does, in which time."""
    return row[0], row[1], row[2], in_words(row, unit)


def _cards(parts: Parts) -> Iterable[Card]:
    return (card(margin, parts.source, parts.stable) for margin in parts.margins)


def _limit_rows(parts: Parts) -> list[tuple[str, str, str]]:
    meaning = {"α_C": "velocity ratio at which the cuts join", "q_lm": "limiting frequency, where the cuts begin"}
    return [(name, value, meaning[name]) for name, value in limits(parts.spectrum).items()]


def _digits(k: int, motion: Vibration, digits: int) -> tuple[str, str, str, str]:
    """Name, real and imaginary part in all certified digits, and how many roots the ball holds."""
    q = motion.root.q
    with ball_arithmetic(working_bits(digits)):
        real, imag = (decimal(x, digits + 2).text for x in (abs(q.real), q.imag))
    return f"q{k}", ("±" if q.real else "") + real, imag.replace("-", "−"), str(motion.root.multiplicity)


def _open_counts(parts: Parts) -> list[tuple[str, str]]:
    """The velocity ratios of the lines at which the spectrum is undecided, and why."""
    lines = parts.lines.value
    if lines is None:
        return []
    said = zip(lines.alpha, lines.reasons, strict=True)
    return [(alpha.short(), for_reader(reason, "lines")) for alpha, reason in said if reason]


def _chart_rows(parts: Parts) -> list[tuple[str, str, str]]:
    """For each column: the factor, what is proved on it, and what is open."""
    chart = known(parts.chart.value, "the chart")
    rows = []
    for label, column in zip(chart.x.labels, chart.columns, strict=True):
        said = "; ".join(
            f"{'open' if band.unstable is None else f'{band.unstable} unstable' if band.unstable else 'stable'} "
            f"{band.start:.6g} to {band.end:.6g}"
            for band in column.bands
        )
        rows.append((label, said, for_reader(column.reason, "chart")))
    return rows


def _contact(parts: Parts) -> list[str]:
    """A sentence about the contact of each mass."""
    motion = parts.response.value
    if motion is None:
        return []
    unit = 1.0 if parts.source.physical is None else 1 / float(parts.source.physical.time_scale)
    said = []
    for k, (loss, note) in enumerate(zip(motion.contact_loss, motion.contact_note, strict=True), 1):
        if note:
            said.append(f"Mass {k}: {note}.")
        elif loss is None:
            said.append(f"Mass {k} keeps pressing on the beam at all times shown.")
        else:
            time = f"t = {loss * unit:.4g} s" if parts.source.physical is not None else f"τ = {loss:.4g}"
            said.append(
                f"Mass {k}: its contact force first falls to zero at {time}; beyond that the model no longer holds."
            )
    return said


def _download(proof: Proof) -> Download:
    content = base64.b64encode(proof.certificate.text.encode("ascii")).decode("ascii")
    return Download(proof, f"data:application/json;base64,{content}", f"mpsolve verify {shlex.quote(proof.name)}")
