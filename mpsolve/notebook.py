"""What a notebook shows of a Spectrum, a Response, a Table: a table, and a figure where it says more.

Pictures that results save by themselves are listed here too. Only mpsolve/display.py loads this module.
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable
from functools import singledispatch
from pathlib import Path
from typing import TYPE_CHECKING, Any

from mpsolve.errors import InputError
from mpsolve.numbers.balls import precision
from mpsolve.numbers.decimals import proved_digits
from mpsolve.numbers.spoken import decimal
from mpsolve.ranges.table import Table
from mpsolve.report import spectrum_words as words
from mpsolve.report.figures import figure_of, inline_svg
from mpsolve.report.figures_motion import displacements
from mpsolve.report.figures_plane import q_plane
from mpsolve.report.range_table import WITHOUT
from mpsolve.report.template import rendered
from mpsolve.report.vibration import in_words, motion_rows, vibrations
from mpsolve.spectrum.regions import Sheet
from mpsolve.spectrum.spectrum import Spectrum
from mpsolve.vibration.case_motion import Response

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_TEMPLATE = "card.html.j2"


@singledispatch
def card(result: Any) -> str:
    """The result in HTML."""
    raise TypeError(f"a {type(result).__name__} has no card")


@singledispatch
def save_picture(result: Any, path: Path) -> Path:  # noqa: ARG001 (what is registered below needs it)
    """Writes the picture of the result."""
    raise TypeError(f"a {type(result).__name__} has no picture")


@card.register
def problem_card(spectrum: Spectrum) -> str:
    """Verdict and roots with eight digits in the problem's units; the q-plane where its whole sheet was counted."""
    name = f"spectrum-{_mark(repr(spectrum.problem))}"
    plane = isinstance(spectrum.region, Sheet)
    units, motions = words.units_of(spectrum), vibrations(spectrum)
    rows = [
        (row[0], *_parts(motion.root.q), row[1], row[2].replace("-", "−"), in_words(row, units.time))
        for motion, row in zip(motions, motion_rows(motions), strict=True)
    ]
    return rendered(
        _TEMPLATE,
        head=words.verdict(spectrum),
        caption=f"Roots q in {units.q}, {spectrum.region}",
        headings=(
            "", "Re q", "Im q", f"frequency [{units.frequency}]", f"growth rate [{units.rate}]", "what it does",
        ),
        rows=rows,
        notes=(*words.proved(spectrum), *filter(None, [words.verified(spectrum)])),
        svg=_svg(lambda ax: q_plane(spectrum, ax), name, "The q-plane") if plane else "",
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
        svg=_svg(
            lambda ax: displacements(response, ax),
            f"response-{_mark(repr(response.case.as_dict()))}",
            "Displacements",
        ),
    )


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


def _parts(q: Any) -> tuple[str, str]:
    """Re q and Im q in eight digits."""
    with precision(128):
        real, imag = proved_digits(abs(q.real), 8), proved_digits(q.imag, 8)
    return ("" if q.real == 0 else "±") + real, imag.replace("-", "−")


def _mark(case: str) -> str:
    """A short name of the case, so that two figures of one notebook do not share ids."""
    return hashlib.sha256(case.encode()).hexdigest()[:8]


def _svg(draw: Callable[[Axes], Axes], name: str, title: str) -> str:
    """The figure, or nothing where matplotlib is missing: the table says it all."""
    try:
        return inline_svg(figure_of(draw), name, title, "Its numbers are in the table.")
    except InputError:
        return ""
