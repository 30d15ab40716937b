"""The report for machines on any problem: plain values with keys that stay, decimals beside exact numbers."""

from __future__ import annotations

import os
from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from mpsolve.errors import MpsolveError
from mpsolve.numbers.balls import precision
from mpsolve.numbers.decimals import decimal, working_bits
from mpsolve.numbers.exact import Exact
from mpsolve.numbers.model import Model, quantities
from mpsolve.problem.case import Case
from mpsolve.problem.cases import Given, as_problem
from mpsolve.problem.warned import titled
from mpsolve.report.spectrum_words import ASSUMED, proved, units_of, verdict, verified
from mpsolve.report.vibration import Trend, vibration
from mpsolve.spectrum.regions import Answered, Below, HalfPlane, Rectangle
from mpsolve.spectrum.spectrum import Root, Spectrum
from mpsolve.tracks.waveguide import Track

FORMAT = "mpsolve report"
VERSION = 2


def spectrum_data(
    spectrum: Spectrum, title: str = "", certificate: str | os.PathLike[str] | None = None
) -> dict[str, Any]:
    """The spectrum in plain values; every digit of every number is proved, to one unit in the last place.

    format, version   "mpsolve report", 2; a version adds no meaning to a key that is there
    title             the title of the input file, or ""
    verdict           one sentence
    status            "proved", "proved, not verified" or "undecided"
    reason            why undecided, in parts: {"code", "message", "numbers", "remedy"}; null if proved
    known             what is proved all the same where the answer is undecided: "count"; "growth", a rate below which
                      all growth is; "outside", a rectangle that holds all roots with Im q < 0; "strips" with their
                      counts, and the "open" ones
    warnings          what is likely to be a mistake in the problem, in the parts of a reason; no part of the proof
    stable            true, false, or null where that is not decided
    region            {"kind", "words"} and the numbers of the region as {"exact", "decimal"}
    digits            certified digits asked for, relative to |q|
    count             number of roots in the region with multiplicity; null if not proved
    unstable          number of those with Im q < 0; null if not proved
    neutral           how often q = 0 is a root by construction, beside those
    unfelt            roots of motions that no contact feels, beside those, as {"re", "im"}
    problem           velocity, track, vehicles, or the ratios of a case; as {"exact", "decimal"}, in SI with "unit"
    units             the units of q, frequency, growth_rate, and of both times
    roots             sorted by (re, im), each with
        re, im        {"value", "radius"}: decimals; the exact number is within radius of value
        multiplicity  number of roots in the ball
        axis          "none", "real" or "imaginary": the axis on which the root is proved to lie
        trend         "grows", "decays", "steady" or "open"
        frequency     |Re q|/2π, in the same form
        growth_rate   −Im q, in the same form
        shape         {"bodies": {name: {"re", "im"}}, "places", "rail": [{"re", "im"}]}: complex amplitudes of the
                      vehicle's coordinates, the largest 1, and of the rail at its contacts; null where it is not told
        doubling_time, halving_time    ln 2/|Im q|, in the same form; null where it does not apply
    proved, verified, assumed    sentences
    cost              seconds of processor time, seconds of verification, evaluations, pieces
    certificate       the path of the certificate, or null
    """
    units, cost = units_of(spectrum), spectrum.cost
    return {
        "format": FORMAT,
        "version": VERSION,
        "title": title,
        "verdict": verdict(spectrum),
        "status": spectrum.status.value,
        "reason": None if spectrum.reason is None else spectrum.reason.data(),
        "known": _known(spectrum.known),
        "warnings": [one.data() for one in (*titled(spectrum.problem, title), *spectrum.warnings)],
        "stable": spectrum.stable,
        "region": region_data(spectrum.region),
        "digits": spectrum.digits,
        "count": spectrum.count if spectrum.proved else None,
        "unstable": spectrum.unstable,
        "neutral": spectrum.neutral,
        "unfelt": [_complex(q, 16) for q in spectrum.unfelt],
        "problem": problem_data(spectrum.problem),
        "units": {"q": units.q, "frequency": units.frequency, "growth_rate": units.rate, "time": units.time},
        "roots": [_root(root, spectrum.digits) for root in spectrum.roots],
        "proved": list(proved(spectrum)),
        "verified": verified(spectrum),
        "assumed": ASSUMED,
        "cost": {
            "seconds": round(cost.seconds, 3),
            "verification": round(cost.verification, 3),
            "evaluations": cost.evaluations,
            "pieces": cost.pieces,
        },
        "certificate": None if certificate is None else os.fspath(certificate),
    }


def _known(known: Mapping[str, Any]) -> dict[str, Any]:
    """{"count", "growth": number, "outside": region, "strips": [{"region", "count"}], "open": [region]}, or less."""
    out = dict(known)
    if "growth" in known:
        out["growth"] = number(known["growth"])
    if "outside" in known:
        out["outside"] = region_data(known["outside"])
    if "strips" in known:
        out["strips"] = [{"region": region_data(strip), "count": count} for strip, count in known["strips"]]
        out["open"] = [region_data(strip) for strip in known["open"]]
    return out


def region_data(region: Answered) -> dict[str, Any]:
    """Kind, words and numbers of a region."""
    kinds = {HalfPlane: "unstable", Below: "below", Rectangle: "rectangle"}
    numbers = {name: number(value) for name, value in vars(region).items() if value is not None}
    return {"kind": kinds.get(type(region), "sheet"), "words": str(region)} | numbers


def problem_data(given: Given) -> dict[str, Any]:
    """The track, the vehicles and the velocity, or the ratios of a case."""
    if isinstance(given, Case):
        return {"case": {name: _several(value) for name, value in vars(given).items()}}
    problem = as_problem(given)
    track = problem.track
    told = _model(track) if isinstance(track, Track) else {"model": "matrix", "parameters": {}}
    vehicles = [_model(one.vehicle) | {"position": number(one.position, "m")} for one in problem.vehicles]
    return {"velocity": number(problem.v, "m/s"), "track": told, "vehicle": vehicles}


def number(x: Any, unit: str | None = None) -> dict[str, str]:
    """An exact number: its text, a decimal for people and programs that cannot read it, its unit if it is told."""
    exact = Exact.parse(x)
    return {"exact": str(exact), "decimal": exact.short(17)} | ({} if unit is None else {"unit": unit})


def _several(value: Any) -> Any:
    return [number(x) for x in value] if isinstance(value, tuple) else number(value)


def _model(model: Any) -> dict[str, Any]:
    kind: Any = type(model)
    described = quantities(kind)
    values = {name: _value(x, described[name].unit) for name, x in model.parameters.items()}
    return {"model": model.name, "parameters": values}


def _value(value: Any, unit: str | None) -> Any:
    """A parameter; the entries of a list have no unit of their own, as rotations stand among displacements."""
    if isinstance(value, Fraction):
        return number(value, unit)
    if isinstance(value, Model):
        return _model(value)
    return [_value(one, None) for one in value] if isinstance(value, tuple) else value


def _root(root: Root, digits: int) -> dict[str, Any]:
    motion = vibration(root, digits)
    with precision(working_bits(digits)):
        time = None if motion.time is None else _ball(motion.time, digits)
        return _complex(root.q, digits) | {
            "multiplicity": root.multiplicity,
            "axis": root.symmetry.value,
            "trend": motion.trend.value,
            "frequency": _ball(motion.frequency, digits),
            "growth_rate": _ball(motion.rate, digits),
            "doubling_time": time if motion.trend is Trend.GROWS else None,
            "halving_time": time if motion.trend is Trend.DECAYS else None,
            "shape": _shape(root, digits),
        }


def _shape(root: Root, digits: int) -> dict[str, Any] | None:
    try:
        shape = root.shape
    except MpsolveError:
        return None
    return {
        "bodies": {name: _complex(x, digits) for name, x in shape.bodies.items()},
        "places": [number(x) for x in shape.places],
        "rail": [_complex(x, digits) for x in shape.rail],
    }


def _complex(q: Any, digits: int) -> dict[str, dict[str, str]]:
    with precision(working_bits(digits)):
        return {"re": _ball(q.real, digits), "im": _ball(q.imag, digits)}


def _ball(ball: Any, digits: int) -> dict[str, str]:
    told = decimal(ball, digits + 2)
    return {"value": told.text, "radius": told.radius_text}
