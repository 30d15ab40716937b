"""The whole sheet of an Euler–Bernoulli beam with masses, above and below its cuts: counts and roots in float64."""

from __future__ import annotations

from typing import Any

import numpy as np

from mpsolve.batch.entries import Entries
from mpsolve.batch.halves import halves_of, on_line
from mpsolve.batch.sheet_count import count_sheet
from mpsolve.batch.sheet_roots import SheetSearch, whole_sheet
from mpsolve.errors import InputError
from mpsolve.numbers.arrays import Complexes, Integers, Truths
from mpsolve.problem.problem import Problem
from mpsolve.tracks.euler_bernoulli import EulerBernoulli
from mpsolve.vehicles.mass import Mass

UNKNOWN = "float64 does not tell the roots of this case"
OFF_LINE = (
    "the cuts leave their line, or the beam buckles: damping from critical on, too much compression, or eta > 0"
)
_TOGETHER = 8192  # entries that are followed together, which bounds the memory


def check_sheet(problem: Problem) -> None:
    """InputError for a track or a vehicle whose whole sheet is not known."""
    masses = all(isinstance(placed.vehicle, Mass) for placed in problem.vehicles)
    if not isinstance(problem.track, EulerBernoulli) or not masses:
        stated = 'is "sheet", which is known for an Euler–Bernoulli beam with masses'
        raise InputError("region", f'{stated}: give "unstable" or ("below", h)')


def on_sheet(entries: Entries, roots: bool) -> tuple[Truths, Integers, dict[int, Complexes]]:
    """(inside, count, roots): whether the cuts lie on their line, the number of roots (−1 where it is open), and the
    roots by entry, in the problem's units, sorted; without `roots` they are not sought."""
    inside = on_line(entries)
    count = np.full(len(entries), -1)
    found: dict[int, Any] = {}
    for group in halves_of(entries, np.flatnonzero(inside)):
        for k in range(0, len(group), _TOGETHER):
            halves = group[k : k + _TOGETHER]
            edge = count_sheet(halves)
            if not roots:
                count[halves.index] = edge.count
                continue
            search = SheetSearch(halves, edge)
            solved = search.solve()
            q = whole_sheet(halves, search.z) * halves.unit[:, None]
            count[halves.index[solved]] = edge.count[solved]
            found |= {int(halves.index[row]): q[row, : edge.count[row]] for row in np.flatnonzero(solved).tolist()}
    return inside, count, found
