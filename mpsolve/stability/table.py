"""Tables of onsets over grids of any two parameters, with every printed digit proved."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from pathlib import Path
from typing import Any, Literal

from mpsolve.certificate.format import Certificate
from mpsolve.display import card
from mpsolve.errors import CertificateError, InputError, PrecisionError, known
from mpsolve.files import checked_suffix, write_whole
from mpsolve.model import specs
from mpsolve.numbers.decimals import fixed_digits
from mpsolve.numbers.exact import Exact
from mpsolve.numbers.packed import PackedBall, pack, unpack
from mpsolve.parallel.pool import run_bunches
from mpsolve.problem.case import Case
from mpsolve.problem.specs import Grid
from mpsolve.progress import Progress
from mpsolve.stability.masses import crossings_search
from mpsolve.stability.strips import UNIT, remark
from mpsolve.stability.table_text import csv_text, json_text, latex_text
from mpsolve.stability.together import Search, together
from mpsolve.stability.velocities import Interval, onset_search, velocities_search

Quantity = Literal["onset velocity", "onset mass", "unstable velocities"]
EntryStatus = Literal["proved", "stable", "unstable", "undecided"]

QUANTITIES = ("onset velocity", "onset mass", "unstable velocities")
SUFFIXES = (".csv", ".json", ".tex")
_TOP = {
    "title": "a text",
    "digits": "the digits of an entry",
    "quantity": "what is looked for",
    "fixed": "a section",
    "rows": "a section",
    "columns": "a section",
}
_DEFAULT_RANGE = {"onset velocity": (0, 2), "unstable velocities": (0, Fraction(7, 5))}
_GUARD = 5  # digits beyond those that are printed
_LEAST = 15


@dataclass(frozen=True)
class Span:
    """An unstable interval of α in proved decimals; an end that is no crossing is that of the range."""

    start: str
    end: str
    starts_at_crossing: bool
    ends_at_crossing: bool
    roots: int

    @property
    def text(self) -> str:
        """(0.69, 0.88): an end that belongs to the interval has a square bracket."""
        opening = "(" if self.starts_at_crossing else "["
        return f"{opening}{self.start}, {self.end}{')' if self.ends_at_crossing else ']'}"


@dataclass(frozen=True)
class Entry:
    """One entry of a table.

    status   "proved": `value` is the decimal, correctly rounded; "stable": proved to have no onset in the range;
             "unstable": proved to be unstable from the start of the range on; "undecided": `reason` says why
    value    the proved decimal or decimals, or None
    reason   what `status` means here; "" if proved
    spans    the unstable intervals, of "unstable velocities" only
    certificate  of the whole range, where one could be made
    """

    status: EntryStatus
    value: str | None = None
    reason: str = ""
    spans: tuple[Span, ...] = ()
    certificate: Certificate | None = field(default=None, repr=False)
    packed: PackedBall | None = field(default=None, repr=False)

    @property
    def ball(self) -> Any | None:
        """The flint.arb of a single number, with all digits that were computed; None otherwise."""
        return None if self.packed is None else unpack(self.packed)

    @property
    def text(self) -> str:
        """What stands in a table: the value, or else the status."""
        return self.value if self.value is not None else self.status


@dataclass(frozen=True)
class OnsetTable:
    """entries[i][j] belongs to rows.values[i] and columns.values[j]; `fixed` holds the other parameters as texts."""

    title: str
    quantity: str
    digits: int
    fixed: Mapping[str, str]
    alpha: tuple[Exact, Exact] | None
    row_grid: Grid
    column_grid: Grid
    entries: tuple[tuple[Entry, ...], ...]

    @property
    def rows(self) -> tuple[specs.Value, ...]:
        """The exact values of the rows' parameter."""
        return self.row_grid.values

    @property
    def columns(self) -> tuple[specs.Value, ...]:
        """The exact values of the columns' parameter."""
        return self.column_grid.values

    @property
    def proved(self) -> bool:
        """Whether no entry is undecided."""
        return all(entry.status != "undecided" for row in self.entries for entry in row)

    def to_csv(self) -> str:
        """A line a row, a column a column, and a last column with the notes of the row."""
        return csv_text(self)

    def to_json(self) -> str:
        """Everything, in the keys that mpsolve/stability/table_text.py lists."""
        return json_text(self)

    def to_latex(self) -> str:
        """A tabular for the package booktabs, with the notes below it."""
        return latex_text(self)

    def _repr_html_(self) -> str:
        """What a notebook shows."""
        return card(self)

    def save(self, path: str | os.PathLike[str]) -> Path:
        """Writes .csv, .json or .tex, whole or not at all.

        Raises InputError for another name, CertificateError if the file cannot be written.
        """
        file = Path(path)
        writers = dict(zip(SUFFIXES, (self.to_csv, self.to_json, self.to_latex), strict=True))
        return write_whole(file, writers[checked_suffix(file, SUFFIXES)]())

    def save_certificates(self, directory: str | os.PathLike[str]) -> list[Path]:
        """One file for each entry that has a certificate, under `certificate_name`; makes the directory if needed.

        Raises CertificateError if one cannot be written.
        """
        folder = Path(directory)
        try:
            folder.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise CertificateError(f"{folder} cannot be made: {error.strerror or error}") from error
        return [
            entry.certificate.save(folder / self.certificate_name(i, j))
            for i, row in enumerate(self.entries)
            for j, entry in enumerate(row)
            if entry.certificate is not None
        ]

    def certificate_name(self, i: int, j: int) -> str:
        """Such as eta_m_70-d_1.5.json; a value that is no short decimal stands by its number, #3."""
        parts = []
        for axis, k in ((self.row_grid, i), (self.column_grid, j)):
            text = axis.labels[k].replace(" ", "_")
            plain = len(text) <= 24 and text.replace("_", "a").replace(".", "0").replace("-", "0").isalnum()
            parts.append(f"{axis.parameter}_{text if plain else f'#{k + 1}'}")
        return "-".join(parts) + ".json"


@dataclass(frozen=True)
class _Job:
    quantity: str
    case: Case
    alpha: tuple[Exact, Exact] | None
    digits: int


def onset_table(
    spec: Mapping[str, Any] | str | os.PathLike[str], workers: int | None = None, progress: Progress | None = None
) -> OnsetTable:
    """The table that `spec` (a mapping, or the path of a TOML file) describes; the same for any number of workers.

        title = "…"                      # may be left out
        digits = 15                      # of each entry, 1 to 1000
        quantity = "onset velocity"      # or "onset mass", or "unstable velocities" (all ends)
        [fixed]                          # eta_b, eta_m (equal masses), d, eta_n, eta_s; masses = 1, 2 or 3
        eta_b = 0.05                     # alpha = [lo, hi]: the range of velocities, for velocities
        [rows]
        parameter = "eta_m"
        values = { start = 10, stop = 100, step = 10 }
        [columns]
        parameter = "d"                  # "one mass" may stand among its values
        values = [1, 1.5]

    Masses stand at 0, d, 2d; two if `masses` is left out. "onset mass" is the smallest mass ratio of each mass from
    which on the case is unstable, at alpha. workers: processes, as many as there are processors if None, 1 for
    this one alone; they are spawned, so that a script must call this under `if __name__ == "__main__":`.
    progress hears ("table", fraction). Raises InputError under the key at fault.
    """
    content = specs.load(spec, _TOP)
    title, digits = specs.title(content), specs.digits(content)
    quantity = specs.choice(content, "quantity", QUANTITIES)
    sought = "eta_m" if quantity == "onset mass" else "alpha"
    allowed = tuple(name for name in specs.PARAMETERS if name != sought)
    rows, columns = specs.grid(content, "rows", allowed), specs.grid(content, "columns", allowed)
    if rows.parameter == columns.parameter:
        raise InputError("columns.parameter", f"is {columns.parameter}, as in rows: give another")
    fixed = specs.fixed(content, {"rows": rows, "columns": columns})
    masses = specs.count_of_masses(fixed)
    if masses == 1 and "d" in {*fixed, rows.parameter, columns.parameter}:
        raise InputError("fixed.masses", "is 1, but a distance d is given: drop one of the two")
    alpha = _range(fixed, quantity)
    shown = {name: str(value) if name == "masses" else _exact_text(value, name) for name, value in fixed.items()}
    if sought == "alpha":
        fixed.pop("alpha", None)
        shown.pop("alpha", None)
    jobs = [
        _job(fixed, masses, (rows, i), (columns, j), quantity, alpha, digits)
        for i in range(len(rows.values))
        for j in range(len(columns.values))
    ]
    entries = run_bunches(_solve_all, jobs, workers, progress, "table")
    width = len(columns.values)
    lines = tuple(tuple(entries[k : k + width]) for k in range(0, len(entries), width))
    return OnsetTable(title, quantity, digits, shown, alpha, rows, columns, lines)


def _range(fixed: Mapping[str, Any], quantity: str) -> tuple[Exact, Exact] | None:
    """The range of velocities, or None where alpha is a parameter like others."""
    if quantity != "onset mass":
        return specs.velocity_range(fixed, _DEFAULT_RANGE[quantity])
    if "eta_m" in fixed:
        raise InputError("fixed.eta_m", "is given, but it is looked for: drop it")
    if isinstance(fixed.get("alpha"), (list, tuple)):
        raise InputError("fixed.alpha", "is a range, but the onset mass is that of one velocity: give a number")
    return None


def _exact_text(value: Any, name: str) -> str:
    if isinstance(value, (list, tuple)) or (name == "d" and value == specs.ONE_MASS):
        return str(value)
    return specs.label(Exact.parse(value, f"fixed.{name}"))


def _job(
    fixed: Mapping[str, Any],
    masses: int,
    row: tuple[Grid, int],
    column: tuple[Grid, int],
    quantity: str,
    alpha: tuple[Exact, Exact] | None,
    digits: int,
) -> _Job:
    values = {name: value for name, value in fixed.items() if name != "masses"}
    places = {}
    for (axis, k), key in ((row, "rows"), (column, "columns")):
        values[axis.parameter] = axis.values[k]
        places[axis.parameter] = f"{key}.values[{k + 1}]"
    with specs.errors_at(places):
        if quantity == "onset mass":
            values["eta_m"] = 1
            if "alpha" not in values:
                raise InputError("alpha", "is missing: give the velocity ratio, or a grid of it")
        return _Job(quantity, specs.case_of(values, masses), alpha, digits)


def _solve_all(jobs: Sequence[_Job]) -> list[Entry]:
    return together([_solve(job) for job in jobs])


def _solve(job: _Job) -> Search[Entry]:
    digits = max(_LEAST, job.digits + _GUARD)
    kinds = {"onset mass": _mass, "onset velocity": _onset, "unstable velocities": _ranges}
    try:
        return (yield from kinds[job.quantity](job, digits))
    except PrecisionError as error:
        return Entry("undecided", None, str(error))


def _mass(job: _Job, digits: int) -> Search[Entry]:
    case = job.case
    found = yield from crossings_search(case.alpha, case.eta_b, case.positions, None, case.eta_n, case.eta_s, digits)
    if not found.proved:
        return Entry("undecided", None, found.reason + remark("the level u of all masses", found.strips, UNIT))
    if not len(found):
        return Entry("stable", None, "stable for every mass", certificate=found.certificate)
    return _number(found[0].eta, job.digits, found.certificate)


def _onset(job: _Job, digits: int) -> Search[Entry]:
    low, high = known(job.alpha, "the range of alpha")
    case = job.case
    model = case.eta_b, case.eta_m, case.positions, case.eta_n, case.eta_s
    onset = yield from onset_search(*model, (low, high), digits)
    if not onset.proved:
        return Entry("undecided", None, onset.reason + remark("alpha", onset.ranges.strips, (low, high)))
    if onset.alpha is None:
        return Entry("stable", None, f"no onset for alpha in {_shown((low, high))}", certificate=onset.certificate)
    if onset.q is None:
        reason = f"unstable from alpha = {specs.label(low)} on, the start of the range"
        return Entry("unstable", None, reason, certificate=onset.certificate)
    return _number(onset.alpha, job.digits, onset.certificate)


def _ranges(job: _Job, digits: int) -> Search[Entry]:
    alpha, case = known(job.alpha, "the range of alpha"), job.case
    model = case.eta_b, case.eta_m, case.positions, case.eta_n, case.eta_s
    found = yield from velocities_search(*model, alpha, digits)
    if not found.proved:
        return Entry("undecided", None, found.reason + remark("alpha", found.strips, alpha))
    if not len(found):
        return Entry("stable", None, f"stable for all alpha in {_shown(alpha)}", certificate=found.certificate)
    spans = tuple(_span(interval, job) for interval in found)
    return Entry("proved", " ".join(span.text for span in spans), "", spans, found.certificate)


def _span(interval: Interval, job: _Job) -> Span:
    low, high = map(specs.label, known(job.alpha, "the range of alpha"))
    start = low if interval.q_start is None else fixed_digits(interval.start, job.digits)
    end = high if interval.q_end is None else fixed_digits(interval.end, job.digits)
    return Span(start, end, interval.q_start is not None, interval.q_end is not None, interval.roots)


def _number(ball: Any, digits: int, certificate: Certificate | None) -> Entry:
    return replace(Entry("proved", fixed_digits(ball, digits), certificate=certificate), packed=pack(ball))


def _shown(ends: tuple[Exact, Exact]) -> str:
    return f"[{specs.label(ends[0])}, {specs.label(ends[1])}]"
