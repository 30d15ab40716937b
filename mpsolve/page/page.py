"""The page: one HTML file that needs no network, with its numbers as JSON and its certificates inside."""

from __future__ import annotations

import base64
import json
import re
from dataclasses import dataclass, replace
from typing import Any

from mpsolve import __version__
from mpsolve.numbers.balls import precision
from mpsolve.numbers.decimals import decimal, working_bits
from mpsolve.numbers.model import Model, Part, quantities
from mpsolve.numbers.spoken import beside, rounded
from mpsolve.page import charts, figures
from mpsolve.page.limit_words import limit_rows
from mpsolve.page.parts import Parts
from mpsolve.page.plain import plain, scope
from mpsolve.page.words import Speech, cards, doing, speech
from mpsolve.pictures.axes import STYLE
from mpsolve.problem.case import Case
from mpsolve.problem.casefile import DIMENSIONLESS
from mpsolve.problem.problem import Problem
from mpsolve.problem.warned import titled
from mpsolve.report.remedies import on_command_line
from mpsolve.report.spectrum_data import spectrum_data
from mpsolve.report.spectrum_text import alike
from mpsolve.report.spectrum_words import ASSUMED, proved, verdict, verified_briefly
from mpsolve.report.template import rendered
from mpsolve.report.vibration import once
from mpsolve.spectrum.spectrum import Root
from mpsolve.tracks.waveguide import Track


@dataclass(frozen=True)
class Download:
    """A certificate as a link: the address holds the file itself."""

    name: str
    proves: str
    address: str
    sha256: str


def page_html(parts: Parts, stem: str) -> str:
    """The page as HTML. stem: of the names of the certificates."""
    speak, spectrum = speech(parts), parts.spectrum
    word, _, rest = verdict(spectrum).partition(": ")
    shape = figures.shape(parts)
    return rendered(
        "page.html.j2",
        version=__version__,
        style=STYLE,
        title=parts.title or stem,
        word=word,
        sentence=on_command_line(rest[:1].upper() + rest[1:]),
        mood={True: "good", False: "bad", None: "open"}[spectrum.stable],
        cards=[replace(card, figure=_together(card.figure)) for card in cards(parts)],
        limits=limit_rows(parts),
        warnings=[str(one) for one in (*titled(parts.given, parts.title), *spectrum.warnings)],
        late=parts.late,
        drawing=figures.drawing(parts),
        tables=tables(parts),
        units=("Hz", "1/s") if speak.si else ("1/τ", "1/τ"),
        roots=[_root(root, speak, spectrum.digits) for root in once(spectrum)],
        proved_roots=spectrum.proved,
        digits=spectrum.digits,
        plane=figures.plane(parts),
        shape=None if shape is None else shape[0],
        amplitudes=[] if shape is None else shape[1],
        lines=figures.lines(parts),
        lines_reason=on_command_line(parts.lines.reason) or "no vibration lies below the cuts at these velocities",
        chart=charts.chart(parts),
        chart_status=charts.chart_status(parts),
        chart_reason=on_command_line(parts.chart.reason),
        motion=figures.motion(parts),
        motion_reason=on_command_line(parts.response.reason),
        critical=_critical(parts, speak),
        critical_status=_critical_status(parts),
        critical_reason=on_command_line(parts.critical.reason),
        plain=plain(parts),
        scope=scope(parts),
        sources=parts.sources,
        proved=proved(spectrum),
        verified=on_command_line(verified_briefly(spectrum)).split("\n"),
        also=[card for card in cards(parts) if card.status == "proved"],
        assumed=ASSUMED,
        downloads=downloads(parts, stem),
        data=page_data(parts),
    )


def _together(said: str) -> str:
    """A number and its unit stay on one line."""
    return re.sub(r"(?<=\d) (?=\D)", "\u00a0", said)


def page_data(parts: Parts) -> dict[str, Any]:
    """The numbers of the page for programs."""
    return {
        "format": "mpsolve page",
        "version": 1,
        "spectrum": spectrum_data(parts.spectrum, parts.title),
        "cards": [vars(card) for card in cards(parts)],
        "limits": [vars(row) for row in limit_rows(parts)],
        "late": list(parts.late),
    }


def downloads(parts: Parts, stem: str) -> list[Download]:
    """The certificates that came with the answers."""
    out = []
    answers = (("", "the induced frequencies", parts.spectrum), ("onset.", "the onset", parts.reach.value))
    for kind, proves, answer in answers:
        certificate = getattr(answer, "certificate", None)
        if certificate is None:
            continue
        text = certificate.text
        address = base64.b64encode(text.encode("ascii")).decode("ascii")
        name, address = f"{stem}.{kind}certificate.json", f"data:application/json;base64,{address}"
        out.append(Download(name, proves, address, str(json.loads(text)["sha256"])))
    return out


def tables(parts: Parts) -> list[tuple[str, list[tuple[str, str, str]]]]:
    """What the file holds: a table of the track, one of each kind of vehicle."""
    if isinstance(parts.given, Case):
        rows = [(name, _ratio(getattr(parts.given, name)), said) for name, said in DIMENSIONLESS.items()]
        return [("The case in the paper's ratios", rows)]
    return tables_of(parts.problem)


def tables_of(problem: Problem) -> list[tuple[str, list[tuple[str, str, str]]]]:
    """The same of a problem: velocity and track, and each kind of vehicle; rows of name, value, meaning."""
    first = [("v", beside(problem.v, "m/s"), "velocity")]
    track = _rows(problem.track) if isinstance(problem.track, Track) else [("matrix", "", "equations of one's own")]
    out = [("Track", first + track)]
    for vehicle, places in alike(problem):
        at = ", ".join(map(rounded, places[:6])) + (" …" if len(places) > 6 else "")
        times = f"{len(places)} × " if len(places) > 1 else ""
        rows = [("position", f"{at} m", "of the middle, ahead is positive"), *_rows(vehicle)]
        out.append((f"Vehicle: {times}{vehicle.name}", rows))
    return out


def _ratio(value: Any) -> str:
    """A ratio, or a list of them, as decimals where they end."""
    if isinstance(value, tuple):
        return ", ".join(map(_ratio, value))
    return beside(value.as_fraction(), "") if value.is_rational else str(value.short())


def _rows(model: Model) -> list[tuple[str, str, str]]:
    rows: list[tuple[str, str, str]] = []
    for name, quantity in quantities(type(model)).items():
        value = getattr(model, name)
        if isinstance(quantity, Part):
            rows += [(f"{name}.{inner}", said, meaning) for inner, said, meaning in _rows(value)]
        elif value is None or isinstance(value, tuple):
            rows.append((name, "none" if value is None else "…", quantity.meaning))
        else:
            rows.append((name, beside(value, quantity.unit), quantity.meaning))
    return rows


def _root(root: Root, speak: Speech, digits: int) -> tuple[str, str, str, str, str, str, int]:
    """Frequency, growth, damping in percent, what it does, Re q and Im q in all digits, the number of roots held."""
    with precision(working_bits(digits)):
        real, imag = (decimal(x, digits + 2).text for x in (abs(root.q.real), root.q.imag))
        damping = rounded(100 * root.q.imag / abs(root.q), 3) if abs(root.q) > 0 else ""
    pair = "±" if not root.q.real.contains(0) else ""
    growth, damping = (said.replace("-", "−") for said in (rounded(root.growth), damping))
    return (
        rounded(root.frequency),
        growth,
        damping,
        doing(root, speak),
        pair + real,
        imag.replace("-", "−"),
        root.multiplicity,
    )


def _critical_status(parts: Parts) -> str:
    found = parts.critical.value
    return "proved" if found is not None and found.status.holds else "open"


def _critical(parts: Parts, speak: Speech) -> list[tuple[str, str]]:
    found = parts.critical.value
    if found is None:
        return []
    return [(speak.velocity(one.value), one.name or str(one.kind.value)) for one in found]
