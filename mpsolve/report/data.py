"""The report for machines: a dictionary of plain values that `json` writes, with keys that stay."""

from __future__ import annotations

import os
from typing import Any

from mpsolve.certificate.on_sheet import AnySpectrum, sheet_of
from mpsolve.certificate.sheet import known_count
from mpsolve.fields import ball_arithmetic
from mpsolve.model.assumed import ASSUMED
from mpsolve.model.parameters import PhysicalCase
from mpsolve.numbers.decimals import decimal, working_bits
from mpsolve.numbers.rootball import RootBall
from mpsolve.report.statement import proved, radius_text
from mpsolve.report.vibration import Trend, Vibration, vibration
from mpsolve.spectrum.regions import Rectangle

FORMAT = "mpsolve report"
VERSION = 1
_BEAM = ("EI", "m", "k", "v", "c", "kp", "N")
_UNITS = {"frequency": "Hz", "growth_rate": "1/s", "time": "s"}
_DIMENSIONLESS_UNITS = {"frequency": "cycles per unit of τ", "growth_rate": "1 per unit of τ", "time": "τ"}


def as_data(
    spectrum: AnySpectrum,
    physical: PhysicalCase | None = None,
    title: str = "",
    certificate: str | os.PathLike[str] | None = None,
) -> dict[str, Any]:
    """The spectrum in plain values; every digit of every number is proved, to one unit in the last place.

    format, version   "mpsolve report", 1; a version adds no meaning to a key that is there
    title             the title of the input file, or ""
    status            "proved", "proved, not verified" or "undecided"
    reason            why undecided, and what helps; "" if proved
    why               the same in parts: {"code", "message", "numbers", "remedy"}; null if proved
    stable            true, false, or null where that is not decided
    region            "sheet", "unstable", or an object re_min, re_max, im_min, im_max of exact numbers
    digits            certified digits asked for, relative to |q|
    count             number of roots in the region with multiplicity; null if not proved
    unstable          number of those with Im q < 0; null if not proved
    radius            no root of the region has |q − iη_b| ≥ radius, an exact decimal; null if none was needed
    case              alpha, eta_b, eta_n, eta_s, eta_m, positions as exact texts p/q or root4(p/q)
    physical          EI, m, k, v, c, kp, N and mass = [{M, position, P, P_A, omega_f, phi_f}] as exact texts in SI
                      units, or null
    units             the units of frequency, growth_rate, and both times
    roots             sorted by (re, im), each with
        re, im        {"value", "radius"}: decimals; the exact number is within radius of value
        multiplicity  number of roots in the ball
        axis          "none", "real" or "imaginary": the axis on which the root is proved to lie
        trend         "grows", "decays", "steady" or "open"
        frequency     |Re q| ω/2π as {"value", "radius"}, ω = √(k/m) for a physical case and 1 otherwise
        growth_rate   −Im q ω, in the same form
        doubling_time, halving_time    ln 2/|Im q ω|, in the same form; null where it does not apply
    proved            the sentences that are proved
    assumed           what they rest on
    certificate       the path of the certificate, or null
    """
    spectrum = sheet_of(spectrum)
    return {
        "format": FORMAT,
        "version": VERSION,
        "title": title,
        "status": spectrum.status.value,
        "reason": spectrum.reason,
        "why": None if spectrum.why is None else spectrum.why.data(),
        "stable": spectrum.stable,
        "region": spectrum.region.as_dict() if isinstance(spectrum.region, Rectangle) else spectrum.region,
        "digits": spectrum.digits,
        "count": known_count(spectrum),
        "unstable": spectrum.unstable,
        "radius": None if spectrum.radius is None else radius_text(spectrum.radius),
        "case": spectrum.case.as_dict(),
        "physical": None if physical is None else physical_data(physical),
        "units": _DIMENSIONLESS_UNITS if physical is None else _UNITS,
        "roots": [_root(root, physical, spectrum.digits) for root in spectrum.roots],
        "proved": list(proved(spectrum)),
        "assumed": ASSUMED,
        "certificate": None if certificate is None else os.fspath(certificate),
    }


def physical_data(physical: PhysicalCase) -> dict[str, Any]:
    """The case in SI units as exact texts."""
    beam: dict[str, Any] = {name: str(getattr(physical, name)) for name in _BEAM}
    return beam | {"mass": [{name: str(value) for name, value in vars(mass).items()} for mass in physical.masses]}


def _root(root: RootBall, physical: PhysicalCase | None, digits: int) -> dict[str, Any]:
    motion = vibration(root, physical, digits)
    with ball_arithmetic(working_bits(digits)):
        return {
            "re": _number(root.q.real, digits),
            "im": _number(root.q.imag, digits),
            "multiplicity": root.multiplicity,
            "axis": root.symmetry.value,
            "trend": motion.trend.name.lower(),
            "frequency": _number(motion.frequency, digits),
            "growth_rate": _number(motion.rate, digits),
            "doubling_time": _time(motion, Trend.GROWS, digits),
            "halving_time": _time(motion, Trend.DECAYS, digits),
        }


def _time(motion: Vibration, state: Trend, digits: int) -> dict[str, str] | None:
    return _number(motion.time, digits) if motion.trend is state else None


def _number(ball: Any, digits: int) -> dict[str, str]:
    shown = decimal(ball, digits + 2)
    return {"value": shown.text, "radius": shown.radius_text}
