"""Stability charts: the number of unstable roots along α, proved on each of a row of columns."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from pathlib import Path
from typing import Any

from mpsolve.certificate.format import Certificate
from mpsolve.display import save_picture
from mpsolve.errors import InputError, PrecisionError
from mpsolve.files import checked_suffix, write_whole
from mpsolve.model import specs
from mpsolve.model.assumed import ASSUMED
from mpsolve.model.parameters import Case
from mpsolve.model.specs import Grid
from mpsolve.numbers.decimals import fixed_digits
from mpsolve.numbers.exact import Exact
from mpsolve.parallel.pool import run_bunches
from mpsolve.progress import Progress
from mpsolve.stability.passages import Passages
from mpsolve.stability.search import Strip
from mpsolve.stability.together import Search, together
from mpsolve.stability.velocities import UnstableRanges, velocities_search
from mpsolve.stability.zero import Zero

FORMAT = "mpsolve chart"
VERSION = 1
AXES = ("eta_m", "d")
SUFFIXES = (".png", ".svg", ".pdf", ".json")
_GUIDE = (
    "Proved on each column, all along its height{}; between columns nothing is proved: the width of the columns and "
    "the lines that join crossings are a guide to the eye."
)
_BUT = " except where it is open (hatched in the picture)"
_TOP = {
    "title": "a text",
    "digits": "the digits of a crossing",
    "fixed": "a section",
    "x": "a section: the horizontal axis",
}
_DEFAULT_RANGE = (0, Fraction(7, 5))
_GUARD = 5
_LEAST = 15


@dataclass(frozen=True)
class Point:
    """A proved crossing, by its correctly rounded alpha and q; direction +1: unstable above it, −1: stable again."""

    alpha: str
    q: str
    direction: int


@dataclass(frozen=True)
class Band:
    """start ≤ α ≤ end: the number of unstable roots there, None where it is open."""

    start: float
    end: float
    unstable: int | None


@dataclass(frozen=True)
class Column:
    """What is proved at one x for the whole range of α: `bands` from bottom to top, with a Point at each change.

    strips are the ranges in which crossings may have been missed.
    """

    points: tuple[Point, ...]
    bands: tuple[Band, ...]
    strips: tuple[Strip, ...]
    proved: bool
    reason: str
    certificate: Certificate | None = field(default=None, repr=False)


@dataclass(frozen=True)
class StabilityChart:
    """columns[k] belongs to x.values[k]; `fixed` holds the other parameters as texts."""

    title: str
    digits: int
    fixed: Mapping[str, str]
    alpha: tuple[Exact, Exact]
    x: Grid
    columns: tuple[Column, ...]

    @property
    def proved(self) -> bool:
        """Whether nothing on any column is open."""
        return all(column.proved for column in self.columns)

    @property
    def guide(self) -> str:
        """What is proved, and what only guides the eye."""
        return _GUIDE.format("" if self.proved else _BUT)

    def to_json(self) -> str:
        """The data: x, and for each column points, bands and strips; alphas of bands and strips are float64."""
        content = {
            "format": FORMAT,
            "version": VERSION,
            "title": self.title,
            "digits": self.digits,
            "fixed": dict(self.fixed),
            "alpha": dict(zip(("start", "end"), map(specs.label, self.alpha), strict=True)),
            "x": {"parameter": self.x.parameter, "values": list(self.x.labels)},
            "columns": [_plain(column) for column in self.columns],
            "proved": self.guide,
            "assumed": ASSUMED,
        }
        return json.dumps(content, indent=1, ensure_ascii=False) + "\n"

    def save(self, path: str | os.PathLike[str]) -> Path:
        """Writes the picture (.png, .svg, .pdf) or the data (.json).

        Raises InputError for another name or where matplotlib is missing, CertificateError if
        the file cannot be written.
        """
        file = Path(path)
        if checked_suffix(file, SUFFIXES) == ".json":
            return write_whole(file, self.to_json())
        return save_picture(self, file)


@dataclass(frozen=True)
class _Job:
    case: Case
    alpha: tuple[Exact, Exact]
    digits: int


def stability_chart(
    spec: Mapping[str, Any] | str | os.PathLike[str], workers: int | None = None, progress: Progress | None = None
) -> StabilityChart:
    """The chart that `spec` (a mapping, or the path of a TOML file) describes; the same for any number of workers.

        title = "…"                       # may be left out
        digits = 15                       # of the crossings in the data
        [fixed]                           # eta_b, and eta_m or d, eta_n, eta_s; masses = 1, 2 or 3
        eta_b = 0.05
        d = 1.5
        alpha = [0, 1.4]                  # the vertical axis; this if left out
        [x]                               # the horizontal axis: eta_m (of each mass) or d
        parameter = "eta_m"
        values = { start = 10, stop = 100, step = 10 }

    workers and progress ("chart", fraction) as in `onset_table`. Raises InputError under the key at fault.
    """
    content = specs.load(spec, _TOP)
    title, digits = specs.title(content), specs.digits(content)
    x = specs.grid(content, "x", AXES)
    if specs.ONE_MASS in x.values:
        raise InputError("x.values", "holds one mass, which has no place on an axis: make a chart with masses = 1")
    fixed = specs.fixed(content, {"x": x})
    masses = specs.count_of_masses(fixed)
    if masses == 1 and "d" in {*fixed, x.parameter}:
        raise InputError("fixed.masses", "is 1, but a distance d is given: drop one of the two")
    alpha = specs.velocity_range(fixed, _DEFAULT_RANGE)
    fixed = {name: value for name, value in fixed.items() if name not in ("masses", "alpha")}
    shown = {"masses": str(masses)}
    shown |= {name: specs.label(Exact.parse(value, f"fixed.{name}")) for name, value in fixed.items()}
    jobs = []
    for k, value in enumerate(x.values, 1):
        with specs.errors_at({x.parameter: f"x.values[{k}]"}):
            jobs.append(_Job(specs.case_of(fixed | {x.parameter: value}, masses), alpha, digits))
    columns = run_bunches(_columns, jobs, workers, progress, "chart")
    return StabilityChart(title, digits, shown, alpha, x, tuple(columns))


def case_chart(
    case: Case,
    factors: Sequence[Fraction],
    alpha: tuple[Exact, Exact],
    digits: int = 15,
    workers: int | None = None,
    progress: Progress | None = None,
) -> StabilityChart:
    """The chart of a case over all its masses times each of the `factors` > 0; it may have any masses and places."""
    scaled = [replace(case, eta_m=tuple(ratio * factor for ratio in case.eta_m)) for factor in factors]
    columns = run_bunches(_columns, [_Job(one, alpha, digits) for one in scaled], workers, progress, "chart")
    x = Grid("factor", tuple(Exact.parse(factor, "factors") for factor in factors))
    fixed = {name: specs.label(getattr(case, name)) for name in ("eta_b", "eta_n", "eta_s")}
    return StabilityChart("", digits, {"masses": str(case.count)} | fixed, alpha, x, tuple(columns))


def _columns(jobs: Sequence[_Job]) -> list[Column]:
    return together([_column(job) for job in jobs])


def _column(job: _Job) -> Search[Column]:
    case = job.case
    digits = max(_LEAST, job.digits + _GUARD)
    low, high = map(float, job.alpha)
    try:
        model = case.eta_b, case.eta_m, case.positions, case.eta_n, case.eta_s
        found = yield from velocities_search(*model, job.alpha, digits)
        zeros = found.passages.zeros if found.passages is not None else ()
        points = tuple(
            Point(fixed_digits(zero.t, job.digits), fixed_digits(zero.x, job.digits), zero.direction)
            for zero in zeros
        )
    except PrecisionError as error:
        strip = Strip(low, high, str(error))
        return Column((), (Band(low, high, None),), (strip,), False, str(error))
    bands = _bands(found, low, high)
    return Column(points, bands, found.strips, found.proved, found.reason, found.certificate)


def _bands(found: UnstableRanges, low: float, high: float) -> tuple[Band, ...]:
    if found.passages is not None:
        return _counted(found.passages, low, high)
    bands = []  # without damping: stable below the range that is unknown
    for start, end in found.unknown:
        bands += [Band(low, start, 0), Band(start, end, None)]
        low = end
    return tuple(band for band in (*bands, Band(low, high, 0)) if band.start < band.end)


def _counted(found: Passages, low: float, high: float) -> tuple[Band, ...]:
    """A band for each gap between events, and for each strip."""
    bands = []
    for event, count in zip((*found.events, None), found.counts, strict=True):
        end = high if event is None else float(event.t.mid()) if isinstance(event, Zero) else event.start
        bands.append(Band(low, end, count))
        low = end
        if isinstance(event, Strip):
            bands.append(Band(event.start, event.end, None))
            low = event.end
    return tuple(band for band in bands if band.start < band.end)


def _plain(column: Column) -> dict[str, Any]:
    return {
        "status": "proved" if column.proved else "undecided",
        "reason": column.reason,
        "points": [vars(point) for point in column.points],
        "bands": [vars(band) for band in column.bands],
        "strips": [vars(strip) for strip in column.strips],
    }
