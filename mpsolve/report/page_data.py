"""The numbers of a page for machines: what its figures and tables show, in one dictionary."""

from __future__ import annotations

import json
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from mpsolve import __version__
from mpsolve.certificate.format import Certificate
from mpsolve.certificate.sheet import SheetSpectrum
from mpsolve.fields import ball_arithmetic
from mpsolve.model.limits import critical_velocity_ratio
from mpsolve.motion.scale import Scale
from mpsolve.motion.solution import Response
from mpsolve.report.answer import number
from mpsolve.report.data import as_data
from mpsolve.report.figures_plane import gap_end
from mpsolve.report.page_loads import load_data
from mpsolve.report.page_parts import Parts
from mpsolve.report.page_words import margin_data
from mpsolve.stability.lines import FrequencyLines, LineEnd

FORMAT = "mpsolve page"
VERSION = 1
_DIGITS = 15
_FLOAT_DIGITS = 7


@dataclass(frozen=True)
class Proof:
    """A certificate of the page: the name of its file, and what it proves."""

    name: str
    proves: str
    certificate: Certificate

    @property
    def sha256(self) -> str:
        """The digest that the certificate carries."""
        return str(self.certificate.content["sha256"])


def proofs(parts: Parts, stem: str) -> tuple[Proof, ...]:
    """The certificates of the roots and of the margins, those that there are."""
    found = []
    if parts.spectrum.certificate is not None:
        found.append(Proof(f"{stem}.certificate.json", _proves(parts.spectrum), parts.spectrum.certificate))
    for margin in parts.margins:
        if margin.certificate is not None:
            what = {"velocity": "velocities", "mass": "sizes of the masses", "distance": "distances"}[margin.name]
            said = f"where the case is stable, over all {what} of the range"
            found.append(Proof(f"{stem}.{margin.name}.certificate.json", said, margin.certificate))
    return tuple(found)


def _proves(spectrum: SheetSpectrum) -> str:
    """What the certificate of the roots is about: no more than the region that was searched."""
    if spectrum.region == "sheet":
        return "all induced frequencies"
    if spectrum.unstable:
        return "all induced frequencies with Im q < 0; those with Im q ≥ 0 are not looked for"
    return "that no induced frequency has Im q < 0; those with Im q ≥ 0 are not looked for"


def page_data(parts: Parts, certificates: Iterable[Proof]) -> dict[str, Any]:
    """The whole page in plain values; decimals of proved numbers as texts, float64 results as numbers.

    format, version  "mpsolve page", 1; a version adds no meaning to a key that is there
    report           the roots: see report/data.py
    stable, verdict  of the case, by its roots or else by the search of a margin: true, false or null, and a sentence
    q_lm, alpha_C    branch points (float64) and critical velocity ratio (proved); null where the cuts leave the line
    margins          name, status, reason, unit, range, here, below, above, margin, at_least
    lines            alpha, counts and lines with alpha, re, im, ends; or {"undecided": reason}, as below
    chart            as `mpsolve chart -o chart.json` writes it
    response         t, w, steady, envelope, contact_force, contact_loss and their units, loads; float64
    loads            of each mass, constant + amplitude · sin(frequency · τ + phase) in units of 1 N or of the unit
                     force, as exact texts under these names
    certificates     file, sha256, what it proves
    """
    source, spectrum = parts.source, parts.spectrum
    listed = [{"file": one.name, "sha256": one.sha256, "proves": one.proves} for one in certificates]
    name = listed[0]["file"] if spectrum.certificate is not None else None
    return {
        "format": FORMAT,
        "version": VERSION,
        "mpsolve": __version__,
        "report": as_data(spectrum, source.physical, source.title, name),
        "stable": parts.stable,
        "verdict": parts.verdict,
        "q_lm": gap_end(source.case),
        "alpha_C": _critical(parts),
        "margins": [margin_data(margin, source) for margin in parts.margins],
        "lines": _undecided(parts.lines.reason) if parts.lines.value is None else _lines(parts.lines.value),
        "chart": _undecided(parts.chart.reason)
        if parts.chart.value is None
        else json.loads(parts.chart.value.to_json()),
        "response": _undecided(parts.response.reason)
        if parts.response.value is None
        else _response(parts.response.value, Scale.of(source.physical), parts.loads_said),
        "loads": load_data(parts.loads),
        "certificates": listed,
    }


def _undecided(reason: str) -> dict[str, str]:
    return {"undecided": reason}


def _critical(parts: Parts) -> dict[str, str] | None:
    if not parts.source.case.cuts_on_line:
        return None
    with ball_arithmetic(128) as field:
        return number(critical_velocity_ratio(parts.source.case, field), _DIGITS)


def _lines(lines: FrequencyLines) -> dict[str, Any]:
    return {
        "alpha": [str(alpha) for alpha in lines.alpha],
        "counts": list(lines.counts),
        "reasons": list(lines.reasons),
        "lines": [
            {
                "alpha": [str(alpha) for alpha in line.alpha],
                "re": [number(q.real, _DIGITS)["value"] for q in line.q],
                "im": [number(q.imag, _DIGITS)["value"] for q in line.q],
                "ends": [_end(end) for end in line.ends],
            }
            for line in lines
        ],
    }


def _end(end: LineEnd) -> dict[str, Any]:
    return {"kind": end.kind, "alpha": None if end.alpha is None else number(end.alpha, _DIGITS)}


def _response(motion: Response, scale: Scale, loads: str) -> dict[str, Any]:
    return {
        "loads": loads,
        "units": {"t": scale.time_name, "w": scale.length_name, "force": scale.force_name},
        "misfit": motion.misfit,
        "t": _floats(motion.tau * scale.time),
        "w": [_floats(row * scale.length) for row in motion.w],
        "steady": [_floats(row * scale.length) for row in motion.steady],
        "envelope": [_floats(row * scale.length) for row in motion.envelope],
        "contact_force": [_floats(row * scale.force) for row in motion.contact_forces],
        "contact_loss": [None if loss is None else loss * scale.time for loss in motion.contact_loss],
        "contact_note": list(motion.contact_note),
    }


def _floats(row: Any) -> list[float]:
    return [float(f"{x:.{_FLOAT_DIGITS}g}") for x in row]
