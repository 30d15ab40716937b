"""What a notebook shows of a Spectrum, a Response, a Table: a table, and a figure where it says more.

Only mpsolve/display.py loads this module.
"""

from __future__ import annotations

import hashlib
from functools import singledispatch
from typing import Any

import numpy as np

from mpsolve.numbers.balls import precision
from mpsolve.numbers.decimals import proved_digits
from mpsolve.numbers.spoken import decimal
from mpsolve.pictures.axes import alone
from mpsolve.pictures.lines import Curve, lines_picture
from mpsolve.pictures.plane import NO_CUT, spectrum_picture
from mpsolve.ranges.table import Table
from mpsolve.report import spectrum_words as words
from mpsolve.report.range_table import WITHOUT
from mpsolve.report.template import rendered
from mpsolve.report.vibration import Trend, Vibration, vibrations
from mpsolve.spectrum.regions import Sheet
from mpsolve.spectrum.spectrum import Spectrum
from mpsolve.vibration.case_motion import Response

_TEMPLATE, _PLACES = "card.html.j2", 8
_DOES = {Trend.GROWS: "GROWS, doubles", Trend.DECAYS: "decays, halves"}


@singledispatch
def card(result: Any) -> str:
    """The result in HTML."""
    raise TypeError(f"a {type(result).__name__} has no card")


@card.register
def problem_card(spectrum: Spectrum) -> str:
    """Verdict and roots with eight digits in the problem's units; the q-plane where its whole sheet was counted."""
    picture, cuts_seen = ("", True)
    if isinstance(spectrum.region, Sheet):
        picture, cuts_seen = spectrum_picture(spectrum, _name(spectrum.problem))
    units, motions = words.units_of(spectrum), vibrations(spectrum)
    rows = [(f"q{j}", *_row(motion, units.time)) for j, motion in enumerate(motions, 1)]
    return rendered(
        _TEMPLATE,
        head=words.verdict(spectrum),
        caption=f"Roots q in {units.q}, {spectrum.region}",
        headings=(
            "", "Re q", "Im q", f"frequency [{units.frequency}]", f"growth rate [{units.rate}]", "what it does",
        ),
        rows=rows,
        notes=filter(None, ["" if cuts_seen else NO_CUT, *words.proved(spectrum), words.verified_briefly(spectrum)]),
        svg=alone(picture) if picture else "",
    )  # fmt: skip


@card.register
def response_card(response: Response) -> str:
    """Extremes of each contact point and force, and the displacements over time; float64, dimensionless."""
    values = [(f"displacement at ξ = {place:.6g}", row) for place, row in zip(response.xi, response.w, strict=True)]
    values += [(f"contact force of mass {k}", row) for k, row in enumerate(response.contact_forces, 1)]
    rows = [(name, f"{row.min():.6g}", f"{row.max():.6g}") for name, row in values if row.size]
    notes = [
        f"mass {k}: {note or f'contact is lost at τ = {loss:.6g}'}"
        for k, (loss, note) in enumerate(zip(response.contact_loss, response.contact_note, strict=True), 1)
        if loss is not None
    ]
    notes.append(f"Computed in float64, not proved; the estimated error is {response.error:.0e} of the largest part.")
    return rendered(
        _TEMPLATE,
        head=f"Response for τ from {response.tau.min():.6g} to {response.tau.max():.6g}"
        if response.tau.size
        else "Response at no time",
        caption="Least and greatest values, in w_st of the unit force and in unit forces",
        headings=("", "least", "greatest"),
        rows=rows,
        notes=notes,
        svg=alone(_displacements(response)) if response.tau.size > 1 else "",
    )


def _displacements(response: Response) -> str:
    """At each ξ over τ, between the envelopes: the steady part ± the bound of the harmonic one."""
    order = np.argsort(response.tau)
    tau, apart = response.tau[order], [np.nan]
    curves = [Curve(tau, row[order], f"ξ = {x:.6g}") for x, row in zip(response.xi, response.w, strict=True)]
    for x, row, bound in zip(response.xi, response.steady, response.envelope, strict=True):
        edges = np.concatenate([(row + bound)[order], apart, (row - bound)[order]])
        curves.append(Curve(np.concatenate([tau, apart, tau]), edges, f"envelope, ξ = {x:.6g}"))
    title = "displacement, down is positive, w_st"
    return lines_picture(curves, "time τ", title, "Displacements", name=_name(response.case))


@card.register
def table_card(table: Table) -> str:
    """The entries as they stand in the table, and what they mean."""
    (path, values), (column, labels) = table.rows, table.columns
    unit = f" [{table.over.unit}]" if table.over.unit else ""
    return rendered(
        _TEMPLATE,
        head=table.title or table.quantity,
        caption=f"{table.quantity} of {table.over.path}{unit}",
        headings=(f"{path} \\ {column}", *map(decimal, labels)),
        rows=[
            (decimal(value), *(entry.text for entry in row)) for value, row in zip(values, table.entries, strict=True)
        ],
        notes=[WITHOUT],
        svg="",
    )


def _row(motion: Vibration, unit: str) -> tuple[str, ...]:
    """Re q, Im q, frequency and growth rate in eight digits, and what the vibration does in which time."""
    frequency, rate = (proved_digits(x, _PLACES) for x in (motion.frequency, motion.rate))
    time = "" if motion.time is None else f" in {proved_digits(motion.time, _PLACES)} {unit}"
    number = motion.root.multiplicity
    several = f" ({number} roots)" if number > 1 else ""
    does = f"{_DOES.get(motion.trend, motion.trend.value)}{time}{several}"
    return *_parts(motion.root.q), frequency, rate.replace("-", "−"), does


def _parts(q: Any) -> tuple[str, str]:
    with precision(128):
        real, imag = proved_digits(abs(q.real), _PLACES), proved_digits(q.imag, _PLACES)
    return ("" if q.real == 0 else "±") + real, imag.replace("-", "−")


def _name(case: object) -> str:
    """A short name of the case, so that two pictures of one notebook do not share ids."""
    return f"picture-{hashlib.sha256(repr(case).encode()).hexdigest()[:8]}"
