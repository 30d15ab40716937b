"""The report for people on any track and vehicle: the verdict, the vibrations, the problem, what is proved."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator
from fractions import Fraction
from typing import Any

from rich.box import SIMPLE_HEAD
from rich.console import Group
from rich.table import Table
from rich.text import Text

from mpsolve.model.parameters import Case, PhysicalCase
from mpsolve.numbers.balls import precision
from mpsolve.numbers.decimals import proved_digits, working_bits
from mpsolve.numbers.exact import Exact
from mpsolve.numbers.model import Model, defaults, quantities
from mpsolve.numbers.spoken import rounded, said_in, spoken
from mpsolve.problem.cases import Given, as_paper, as_problem
from mpsolve.problem.problem import Problem
from mpsolve.report.spectrum_words import ASSUMED, Units, proved, units_of, verdict, verified
from mpsolve.report.text import beam_rows, certificate_text, columns_of, ratio_rows, root_rows, section, shown
from mpsolve.report.vibration import Trend, Vibration, own_vibrations
from mpsolve.spectrum.spectrum import Spectrum
from mpsolve.tracks.waveguide import Track

_COLOUR = {"UNSTABLE": "bold red", "STABLE": "bold green", "UNDECIDED": "bold yellow"}
_PLACES = 8


def spectrum_document(
    spectrum: Spectrum, title: str = "", certificate: str | os.PathLike[str] | None = None
) -> Group:
    """The report for a rich console; certificate: the path where it was saved."""
    stated = verdict(spectrum)
    parts: list[Any] = [Text(title, style="bold"), Text("")] if title else []
    parts += [Text(stated, style=_COLOUR.get(stated.partition(":")[0], "bold")), Text("")]
    parts += warnings_of(spectrum)
    motions = own_vibrations(spectrum)
    if motions:
        parts += section("Vibrations", _motions(motions, spectrum))
    if spectrum.unfelt:
        parts += section("Roots of motions that no contact feels", _unfelt(spectrum))
    parts += section("Problem", _problem(spectrum))
    if motions:
        parts += section(f"Roots q in {units_of(spectrum).q}, certified digits", _roots(motions, spectrum.digits))
    parts += section("Proved", Text("\n".join(proved(spectrum) or ("Nothing yet.",))))
    if verified(spectrum):
        parts += section("Verified", Text(verified(spectrum)))
    parts += section("Assumed, not proved", Text(ASSUMED))
    ratios = paper_rows(spectrum.problem)
    if ratios:
        parts += section("In the ratios of the paper", _table(ratios))
    parts += section("Cost", Text(cost_words(spectrum)))[:-1]
    if certificate is not None:
        parts += [Text(""), *section("Certificate", certificate_text(os.fspath(certificate)))[:-1]]
    return Group(*parts)


def warnings_of(spectrum: Spectrum) -> list[Any]:
    """A sentence for each warning, and an empty line; nothing where there is none."""
    lines: list[Any] = [Text(f"Warning: {warning}.", style="yellow") for warning in spectrum.warnings]
    return [*lines, Text("")] if lines else []


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
    for placed in problem.vehicles:
        yield "vehicle", placed.vehicle.name, f"at x = {_exact(placed.position)} m"
        yield from _parameters(placed.vehicle)


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
    units = [row for row in beam_rows(paper) if row[0] in ("√(k/m)", "χ", "v_cr", "v_cr′")]
    return [*units, *ratio_rows(paper.dimensionless)]


def _problem(spectrum: Spectrum) -> Table:
    given = spectrum.problem
    return _table(ratio_rows(given) if isinstance(given, Case) else problem_rows(as_problem(given)))


def _table(rows: Iterable[tuple[str, str, str]]) -> Table:
    table = columns_of(3)
    for row in rows:
        table.add_row(*(Text(cell) for cell in row))
    return table


def _motions(motions: tuple[Vibration, ...], spectrum: Spectrum) -> Table:
    units = units_of(spectrum)
    table = Table(box=SIMPLE_HEAD, show_edge=False, pad_edge=False)
    for heading in ("", f"frequency [{units.frequency}]", f"growth [{units.rate}]", "what it does"):
        table.add_column(Text(heading), justify="right" if "[" in heading else "left")
    with precision(working_bits(spectrum.digits)):
        for j, motion in enumerate(motions, 1):
            table.add_row(*(Text(cell) for cell in motion_row(j, motion, units)))
    return table


def motion_row(j: int, motion: Vibration, units: Units) -> tuple[str, str, str, str]:
    """Name, frequency, growth rate, and what the vibration does in which time, in few figures."""
    does = motion.trend.value
    if motion.time is not None:
        time = spoken(motion.time, "s") if units.time == "s" else f"{rounded(motion.time)} {units.time}"
        does = f"GROWS, doubles every {time}" if motion.trend is Trend.GROWS else f"decays, halves every {time}"
    number = motion.root.multiplicity
    several = f" ({number} roots)" if number > 1 else ""
    return f"q{j}", rounded(motion.frequency), rounded(motion.rate), does + several


def _roots(motions: tuple[Vibration, ...], digits: int) -> Table:
    table = columns_of(2)
    with precision(working_bits(digits)):
        for j, motion in enumerate(motions, 1):
            for label, number in root_rows(j, motion, digits):
                table.add_row(Text(label), Text(number))
    return table


def _unfelt(spectrum: Spectrum) -> Table:
    table = columns_of(1)
    with precision(working_bits(_PLACES)):
        for q in spectrum.unfelt:
            if not q.real < 0:
                re, im = proved_digits(abs(q.real), _PLACES), proved_digits(q.imag, _PLACES)
                table.add_row(Text(f"{'' if q.real == 0 else '±'}{re} + {im} i"))
    return table
