"""Answers about ranges for machines: plain values with keys that stay, decimals beside exact numbers."""

from __future__ import annotations

from typing import Any

from mpsolve.ranges.answer import Answer
from mpsolve.report.ranges_asked import Asked
from mpsolve.report.ranges_words import trust
from mpsolve.report.spectrum_data import number, spectrum_data
from mpsolve.report.spectrum_words import ASSUMED

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


def _range(over: Any, asked: Asked) -> dict[str, Any]:
    own = asked.problem.parameters.get(over.path)
    ends = {"low": over.low, "high": over.high, "own": own}
    exact = {name: x if x is None else number(x) for name, x in ends.items()}
    return {**exact, "unit": over.si}
