"""The report for people on any track and vehicle: the verdict, the vibrations, the problem, what is proved."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator
from fractions import Fraction
from typing import Any

from mpsolve.numbers.balls import precision
from mpsolve.numbers.decimals import decimal, proved_digits, working_bits
from mpsolve.numbers.exact import Exact
from mpsolve.numbers.model import Model, defaults, quantities
from mpsolve.numbers.spoken import rounded, said_in, spoken
from mpsolve.problem.case import Case
from mpsolve.problem.cases import Given, as_paper, as_problem
from mpsolve.problem.physical import PhysicalCase
from mpsolve.problem.problem import Problem
from mpsolve.problem.warned import titled
from mpsolve.report.blocks import Columns, Document, Line, Section, certificate_words
from mpsolve.report.spectrum_words import ASSUMED, Units, beyond, proved, units_of, verdict, verified_briefly
from mpsolve.report.vibration import Trend, Vibration, vibrations
from mpsolve.spectrum.spectrum import Spectrum
from mpsolve.tracks.waveguide import Track

_COLOUR = {"UNSTABLE": "bold red", "STABLE": "bold green", "UNDECIDED": "bold yellow"}
_PLACES = 8  # digits of the physical quantities; every digit of q is printed
_TYPED = 36  # digits of a value that is typed; more are shortened
_ROW = 76  # longest q that is printed in one row


def spectrum_document(
    spectrum: Spectrum, title: str = "", certificate: str | os.PathLike[str] | None = None
) -> Document:
    """The report as blocks; certificate: the path where it was saved."""
    stated, motions = verdict(spectrum), vibrations(spectrum)
    blocks: list[Line | Section] = [Line(title, "bold")] if title else []
    blocks += [Line(stated, _COLOUR.get(re.split(r"[ :]", stated)[0], "bold")), *warnings_of(spectrum, title)]
    if motions or beyond(spectrum):
        table = _motions(motions, spectrum) if motions else f"None. {beyond(spectrum)}"
        blocks.append(Section("Vibrations", table))
    if spectrum.unfelt:
        blocks.append(Section("Roots of motions that no contact feels", Columns(list(_unfelt(spectrum)))))
    blocks.append(Section("Problem", Columns(list(_problem(spectrum)))))
    if motions:
        roots = Columns(_roots(motions, spectrum.digits))
        blocks.append(Section(f"Roots q in {units_of(spectrum).q}, certified digits", roots))
    blocks.append(Section("Proved", "\n".join(proved(spectrum) or ("Nothing yet.",))))
    if verified_briefly(spectrum):
        blocks.append(Section("Verified", verified_briefly(spectrum)))
    blocks.append(Section("Assumed, not proved", ASSUMED))
    ratios = paper_rows(spectrum.problem)
    if ratios:
        blocks.append(Section("In the ratios of the paper", Columns(ratios)))
    blocks.append(Section("Cost", cost_words(spectrum)))
    if certificate is not None:
        blocks.append(Section("Certificate", certificate_words(os.fspath(certificate))))
    return Document(tuple(blocks))


def warnings_of(spectrum: Spectrum, title: str = "") -> Iterator[Line]:
    """A sentence for each warning."""
    found = (*titled(spectrum.problem, title), *spectrum.warnings)
    return (Line(f"Warning: {warning}.", "yellow") for warning in found)


def cost_words(spectrum: Spectrum) -> str:
    """Processor time, and what was counted on the way."""
    cost = spectrum.cost
    said = [f"{cost.seconds:.2f} s of processor time"]
    if cost.verification:
        said.append(f"{cost.verification:.2f} s to verify")
    said += [f"{cost.evaluations} evaluations"] * bool(cost.evaluations)
    said += [f"{cost.pieces} pieces of paths"] * bool(cost.pieces)
    return ", ".join(said)


def problem_rows(problem: Problem) -> Iterator[tuple[str, str, str]]:
    """Rows of quantity, value and meaning: the velocity, the track, every vehicle."""
    yield "v", _valued(problem.v, "m/s"), "velocity"
    track = problem.track
    if isinstance(track, Track):
        yield "track", track.name, ""
        yield from _parameters(track)
    else:
        size = len(track.matrix)
        yield "track", f"{size} × {size} matrix of one's own", ""
    for vehicle, places in alike(problem):
        yield "vehicle", vehicle.name, f"at x = {', '.join(map(_exact, places))} m"
        yield from _parameters(vehicle)


def alike(problem: Problem) -> list[tuple[Any, list[Fraction]]]:
    """Each kind of vehicle, and where the middles of those of it are."""
    seen: dict[Any, list[Fraction]] = {}
    for placed in problem.vehicles:
        seen.setdefault(placed.vehicle, []).append(placed.position)
    return list(seen.items())


def _parameters(model: Model) -> Iterator[tuple[str, str, str]]:
    described, left_out = quantities(type(model)), defaults(type(model))
    for name, value in model.parameters.items():
        quantity = described[name]
        if name in left_out and left_out[name] == value:
            continue
        if isinstance(value, Fraction):
            yield f"  {name}", _valued(value, quantity.unit), quantity.meaning
        elif isinstance(value, Model):
            yield f"  {name}", getattr(value, "name", ""), quantity.meaning
            yield from ((f"  {key}", text, meaning) for key, text, meaning in _parameters(value))
        else:
            yield f"  {name}", "as given", quantity.meaning


def _exact(x: Fraction) -> str:
    return shown(Exact.parse(x))


def _valued(x: Fraction, unit: str) -> str:
    """Exactly, and in the unit that people use: "6400000 N m² (6.4 MN m²)"."""
    own = f"{_exact(x)} {unit}".strip()
    return own if not x or said_in(x, unit) == unit else f"{own} ({spoken(x, unit)})"


def paper_rows(given: Given) -> list[tuple[str, str, str]]:
    """The ratios of the paper, where a problem in SI has them; empty for all else."""
    paper = None if isinstance(given, Case) else as_paper(given)
    if not isinstance(paper, PhysicalCase):
        return []
    return [*unit_rows(paper), *ratio_rows(paper.dimensionless)]


def _problem(spectrum: Spectrum) -> Iterable[tuple[str, str, str]]:
    given = spectrum.problem
    return ratio_rows(given) if isinstance(given, Case) else problem_rows(as_problem(given))


def _motions(motions: tuple[Vibration, ...], spectrum: Spectrum) -> Columns:
    units = units_of(spectrum)
    heading = ("", f"frequency [{units.frequency}]", f"growth [{units.rate}]", "what it does")
    with precision(working_bits(spectrum.digits)):
        rows = [motion_row(j, motion, units) for j, motion in enumerate(motions, 1)]
    return Columns(rows, heading, frozenset((1, 2)))


def motion_row(j: int, motion: Vibration, units: Units) -> tuple[str, str, str, str]:
    """Name, frequency, growth rate, and what the vibration does in which time, in few figures."""
    does = motion.trend.value
    if motion.time is not None:
        time = spoken(motion.time, "s") if units.time == "s" else f"{rounded(motion.time)} {units.time}"
        does = f"GROWS, doubles every {time}" if motion.trend is Trend.GROWS else f"decays, halves every {time}"
    number = motion.root.multiplicity
    several = f" ({number} roots)" if number > 1 else ""
    return f"q{j}", rounded(motion.frequency), rounded(motion.rate), does + several


def _roots(motions: tuple[Vibration, ...], digits: int) -> list[tuple[str, str]]:
    with precision(working_bits(digits)):
        return [row for j, motion in enumerate(motions, 1) for row in root_rows(j, motion, digits)]


def _unfelt(spectrum: Spectrum) -> Iterator[tuple[str]]:
    with precision(working_bits(_PLACES)):
        for q in spectrum.unfelt:
            if not q.real < 0:
                re_, im = proved_digits(abs(q.real), _PLACES), proved_digits(q.imag, _PLACES)
                yield (f"{'' if q.real == 0 else '±'}{re_} + {im} i",)


def unit_rows(physical: PhysicalCase) -> Iterator[tuple[str, str, str]]:
    """Rows of what the ratios are made with, in SI units."""
    yield "√(k/m)", f"{shown(physical.time_scale)} rad/s", "τ = √(k/m) t"
    yield "χ", f"{shown(physical.chi)} 1/m", "(k/4EI)^(1/4): ξ = χ s"
    yield "v_cr", f"{shown(physical.v_cr)} m/s", "critical velocity √(k/m)/χ on a Winkler foundation"
    if physical.N or physical.kp:
        yield "v_cr′", f"{_critical(physical)} m/s", "√(1 − η_N + η_S) v_cr, with N and kp, without damping"


def _critical(physical: PhysicalCase) -> str:
    with precision(working_bits(_PLACES)):
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


def shown(x: Exact) -> str:
    """x as it is typed: exactly if at most 36 digits do, else its first proved digits, marked ≈."""
    for digits in (12, _TYPED):
        short = x.short(digits)
        if Exact.parse(short) == x:
            return short
    with precision(working_bits(_PLACES)):
        return f"≈ {proved_digits(x.ball(), _PLACES)}"


def _equals(x: Exact) -> str:
    text = shown(x)
    return text if text.startswith("≈") else f"= {text}"


def root_rows(j: int, motion: Vibration, digits: int) -> list[tuple[str, str]]:
    """Label and digits of a root, at the precision that is set: one row, or two where one would be too long."""
    q = motion.root.q
    real, imag = decimal(abs(q.real), digits + 2).text, decimal(q.imag, digits + 2).text
    pair = "" if q.real == 0 else "±"
    if q.imag == 0:
        return [(f"q{j} =", pair + real)]
    whole = f"{pair}{real} {'-' if imag.startswith('-') else '+'} {imag.removeprefix('-')} i"
    if len(whole) <= _ROW:
        return [(f"q{j} =", whole)]
    return [(f"Re q{j} =", pair + real), (f"Im q{j} =", imag)]
