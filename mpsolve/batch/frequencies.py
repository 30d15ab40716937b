"""Counts and roots of a problem over arrays of its parameters, in float64, each entry with its own status."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

import numpy as np

from mpsolve.batch.count import count_group
from mpsolve.batch.entries import Entries, entries_of
from mpsolve.batch.groups import Group, groups_of
from mpsolve.batch.passive import first_passive, outrun
from mpsolve.batch.premises import OVERTAKES, premises
from mpsolve.batch.result import STATUSES, Frequencies
from mpsolve.batch.roots import Search, weight, whole
from mpsolve.batch.sheet import OFF_LINE, UNKNOWN, check_sheet, on_sheet
from mpsolve.errors import InputError
from mpsolve.numbers.arrays import Integers, Reals
from mpsolve.parallel.pool import run
from mpsolve.parallel.threads import one_thread
from mpsolve.problem.cases import Given, as_problem
from mpsolve.problem.problem import Problem
from mpsolve.progress import Progress
from mpsolve.spectrum.regions import Below, Rectangle, checked_region
from mpsolve.tracks.at_rest import lowest_cut

_CHUNK = 4096  # entries of a piece of work, which bounds the memory
_SHEETS = 16_384  # the same of whole sheets, whose neighbours are followed
_PART = 2048  # contacts of the entries that are counted together: enough to make few calls, few enough for memory
_LEAST = 2.0  # scaled: how far at least a count above the real axis goes
_AT_REST = "at rest the track is not known to be passive"


@dataclass
class _Answer:
    """Flat arrays over the entries of a piece of work."""

    size: int
    width: int = 0
    count: Any = field(init=False)
    status: Any = field(init=False)
    reason: Any = field(init=False)
    roots: dict[int, Any] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.count = np.full(self.size, -1)
        self.status = np.ones(self.size, np.int8)
        self.reason = np.full(self.size, "", object)

    def open(self, rows: Any, reason: str, status: int = 1) -> None:
        self.reason[rows], self.status[rows] = reason, status

    def ok(self, rows: Integers, count: Any) -> None:
        self.count[rows], self.status[rows], self.reason[rows] = count, 0, ""


def frequencies(
    problem: Given,
    over: Mapping[str, Any] | None = None,
    region: object = "unstable",
    *,
    roots: bool = True,
    workers: int = 1,
    progress: Progress | None = None,
) -> Frequencies:
    """Counts and roots of q in a region for arrays of parameters that broadcast, any track and vehicles.

    over: arrays by path, such as {"v": [50, 60], "track.k": …, "vehicles.M": …, "gap[0]": …}, with the paths and
    units of `problem.parameters`. region: "unstable" (Im q < 0); ("below", h) with h below every cut (Im q < h as far
    as |Re q| is below a frequency from which on nothing can grow); or "sheet", the whole physical sheet of an
    Euler–Bernoulli beam with masses, damped or not.
    Each count comes from the turn of Δ along half of a contour that passivity closes; roots are then sought until as
    many are found. Where that does not work out the entry is "unresolved", with a reason; only `certify` proves.
    workers: processes, spawned, so that a script with more than one must call this under
    `if __name__ == "__main__":`. progress(stage, fraction) hears of the work.

    InputError names the path or argument that cannot be used.

    >>> from mpsolve import tracks, vehicles
    >>> beam = tracks.EulerBernoulli(EI="0.25", m=1, k=1, c="0.1")
    >>> pair = Problem(beam, vehicles.train(vehicles.Mass(70), 2, "1.5"), v="0.66")
    >>> frequencies(pair, {"v": [0.66, 0.67]}).count.tolist()
    [0, 2]
    """
    plain = as_problem(problem)
    flat = entries_of(problem, over or {})
    height = None if region == "sheet" else _height(region, problem)
    if height is None:
        check_sheet(plain)
    order = alike(flat.over, len(flat))
    size = _SHEETS if height is None else _CHUNK
    jobs = [
        _Job(plain, {path: values[order[k : k + size]] for path, values in flat.over.items()}, height, roots)
        for k in range(0, max(len(order), 1), size)
    ]
    parts = run(_answer, jobs, workers, progress, "counting")
    width = max((part.width for part in parts), default=0)
    answer, q = _Answer(len(flat)), np.full((len(flat), width), np.nan, complex)
    for k, part in enumerate(parts):
        place = order[k * size : (k + 1) * size]
        answer.count[place], answer.status[place], answer.reason[place] = part.count, part.status, part.reason
        for row, values in part.roots.items():
            q[place[row], : len(values)] = values
    shape = flat.shape
    return Frequencies(
        problem,
        "sheet" if height is None else f"below {float(height):.6g}" if height else "unstable",
        {path: values.reshape(shape) for path, values in flat.over.items()},
        answer.count.reshape(shape),
        np.array(STATUSES)[answer.status].reshape(shape),
        answer.reason.astype(str).reshape(shape),
        q.reshape(*shape, width) if roots else None,
    )


def _height(region: object, problem: Given) -> Fraction:
    given = checked_region(region, problem)
    if isinstance(given, Below):
        return given.height
    if isinstance(given, Rectangle):
        raise InputError("region", 'is a Rectangle: give "unstable" or ("below", h), or ask certify')
    return Fraction(0)


@dataclass(frozen=True)
class _Job:
    problem: Problem
    over: dict[str, Reals]
    height: Fraction | None  # None: the whole sheet
    roots: bool


def _answer(job: _Job) -> _Answer:
    with one_thread(), np.errstate(all="ignore"):
        return _answered(job)


def _answered(job: _Job) -> _Answer:
    entries = entries_of(job.problem, job.over)
    answer = _Answer(len(entries))
    if job.height is None:
        _whole(entries, job, answer)
        return answer
    for group in groups_of(entries, _usable(entries, job.height, answer))[0]:
        size = max(64, _PART // group.contacts)
        for k in range(0, len(group), size):
            _count(group[k : k + size], job.height, job.roots, answer)
    open_ = np.flatnonzero((answer.status == 1) & (answer.reason == ""))
    answer.open(open_, "the track's waves cannot be told apart in float64, or the velocity is that of a wave")
    return answer


def _whole(entries: Entries, job: _Job, answer: _Answer) -> None:
    inside, answer.count, answer.roots = on_sheet(entries, job.roots)
    answer.status = np.where(answer.count >= 0, 0, np.where(inside, 1, 2)).astype(np.int8)
    answer.reason = np.array(["", UNKNOWN, OFF_LINE], object)[answer.status]
    answer.width = max(map(len, answer.roots.values()), default=0)


def _usable(entries: Entries, height: Fraction, answer: _Answer) -> Integers:
    """The entries that are to be counted; the others are answered."""
    known, which = premises(entries)
    left = np.ones(len(entries), bool)
    many = len(entries.formations[0].places) > 1

    def settle(rows: Integers, reason: str, status: int = 1) -> None:
        answer.open(rows[left[rows]], reason, status)
        left[rows] = False

    for k, one in enumerate(known):
        mine = np.flatnonzero(which == k)
        if one.refused:
            settle(mine, one.refused, 2)
            continue
        if height and height > lowest_cut(one.track)[0]:
            settle(mine, "the region reaches above the lowest cut of the track: give a smaller height", 2)
        rest = mine[entries.v[mine] == 0]
        if one.passive and not height:
            rest = rest[left[rest]]
            answer.ok(rest, 0)
            left[rest] = False
        elif not one.passive:
            settle(rest, _AT_REST)
        moving = mine[entries.v[mine] > 0]
        if not one.vanishes:
            settle(moving, "the receptance is not known to vanish at infinity")
        if many:
            answer.open(moving[entries.v[moving] >= one.speed], OVERTAKES)
    return np.flatnonzero(left)


def _count(group: Group, height: Fraction, roots: bool, answer: _Answer) -> None:
    if not height and outrun(group):
        answer.ok(group.index, 0)
        return
    group = group[answer.reason[group.index] == ""]
    if not len(group):
        return
    rho = first_passive(group)
    lost, reach = ~np.isfinite(rho), float(height) / group.unit
    answer.open(group.index[lost], "no frequency is found from which on the contacts cannot give energy")
    group, rho, reach = group[~lost], rho[~lost], reach[~lost]
    if not len(group):
        return
    rho = np.where(reach > 0, np.maximum(rho, _LEAST), rho)
    counted = count_group(group, rho, reach)
    for row, reason in counted.why.items():
        answer.open(group.index[row], reason)
    fine = counted.count >= 0
    answer.ok(group.index[fine], counted.count[fine])
    some = counted.count > 0
    if not roots or not some.any():
        return
    search = Search(group, counted, rho, reach)
    solved = search.solve()
    bad = fine & ~solved
    numbers = weight(search.q)
    for row in np.flatnonzero(bad).tolist():
        found = f"{counted.count[row]} roots are counted, but {numbers[row]} are found"
        answer.open(group.index[row], found)
        answer.count[group.index[row]] = -1
    q = whole(search.q) * group.unit[:, None]
    for row in np.flatnonzero(solved & some).tolist():
        answer.roots[int(group.index[row])] = q[row, : counted.count[row]]
    answer.width = max(answer.width, int(counted.count[solved & some].max(initial=0)))


def alike(over: Mapping[str, Reals], size: int) -> Integers:
    """The permutation that sorts the entries. Parameters with few values change least often."""
    ranks = []
    for column in over.values():
        values, rank = np.unique(column, return_inverse=True)
        if len(values) > 1:
            ranks.append(rank.reshape(-1) / (len(values) - 1))
    if not ranks:
        return np.arange(size)
    bits = max(1, min(31, 62 // len(ranks)))  # of each rank
    key = np.zeros(size, np.uint64)
    levels = [np.minimum((share * 2**bits).astype(np.uint64), np.uint64(2**bits - 1)) for share in ranks]
    for bit in range(bits - 1, -1, -1):
        for level in levels:
            key = (key << np.uint64(1)) | ((level >> np.uint64(bit)) & np.uint64(1))
    return np.argsort(key, kind="stable")
