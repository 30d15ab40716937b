"""Tables over grids of any two parameters: the onset, or all unstable ranges, of each entry, in proved digits."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from mpsolve.display import card
from mpsolve.errors import InputError
from mpsolve.numbers.model import shown, whole
from mpsolve.numbers.result import Result
from mpsolve.outcome import Reason, Status
from mpsolve.parallel.pool import run
from mpsolve.problem.cases import Given, as_problem, value_at
from mpsolve.problem.over import Over
from mpsolve.problem.problem import Problem
from mpsolve.progress import Progress
from mpsolve.ranges.entry import Axis, Entry, Job, lines_of, solve_line
from mpsolve.ranges.scope import checked_over, one_path

QUANTITIES = ("onset", "unstable ranges")
_MOST = 10_000
_MOST_DIGITS = 1000


@dataclass(frozen=True)
class Table(Result):
    """entries[i][j] belongs to rows[1][i] and columns[1][j]; an axis is (path, exact values in the model's unit)."""

    quantity: str
    over: Over
    rows: Axis
    columns: Axis
    digits: int
    entries: tuple[tuple[Entry, ...], ...]
    title: str = ""

    def _repr_html_(self) -> str:
        """What a notebook shows."""
        return card(self)

    @property
    def status(self) -> Status:
        """UNVERIFIED where no entry is undecided: tables have no certificate."""
        return Status.UNVERIFIED if self.reason is None else Status.UNDECIDED

    @property
    def reason(self) -> Reason | None:
        """That of the first entry which is undecided."""
        return next((one.reason for row in self.entries for one in row if one.status == "undecided"), None)

    def records(self) -> list[Mapping[str, Any]]:
        """One mapping for each entry."""
        (first, xs), (second, ys) = self.rows, self.columns
        return [
            {first: float(x), second: float(y), self.quantity: entry.text, "status": entry.status}
            for x, row in zip(xs, self.entries, strict=True)
            for y, entry in zip(ys, row, strict=True)
        ]


def stability_table(
    problem: Given,
    *,
    over: Mapping[str, Any] | Over,
    rows: Mapping[str, Sequence[Any]],
    columns: Mapping[str, Sequence[Any]],
    quantity: str = "onset",
    digits: int = 10,
    seconds: float | None = None,
    workers: int | None = None,
    progress: Progress | None = None,
    title: str = "",
) -> Table:
    """The onset in a range of one parameter, or all unstable ranges, over a grid of two others; every digit proved.

    over: {path: (low, high)}, or an `Over` with the unit in which numbers are printed. rows, columns: {path: values}.
    digits: of each number. seconds: of processor time that an entry may take. workers: processes, as many as there
    are processors if None; they are spawned, so that a script must call this under `if __name__ == "__main__":`.
    There are no certificates. InputError names the path or the value that cannot be.
    """
    given = as_problem(problem)
    if quantity not in QUANTITIES:
        raise InputError("quantity", f'is {quantity!r}: give "onset" or "unstable ranges"')
    digits = whole(digits, "digits", 1, _MOST_DIGITS)
    asked = over if isinstance(over, Over) else _over(problem, over)
    first, second = _axis(problem, rows, "rows"), _axis(problem, columns, "columns")
    if len({asked.path, first[0], second[0]}) < 3:
        raise InputError("columns", f"has {second[0]}, rows {first[0]}, the range {asked.path}: give three others")
    _require_none_undone(given, first, second, asked)
    jobs = [Job(_at(given, first, i, second, j), quantity, asked, digits, seconds)
            for i in range(len(first[1])) for j in range(len(second[1]))]  # fmt: skip
    lines = lines_of(given, jobs, first, second)
    found = run(solve_line, lines, workers, progress, "table")
    each = {
        k: entry
        for line, answers in zip(lines, found, strict=True)
        for k, entry in zip(line.places, answers, strict=True)
    }
    width = len(second[1])
    entries = tuple(tuple(each[k + j] for j in range(width)) for k in range(0, len(jobs), width))
    return Table(quantity, asked, first, second, digits, entries, title)


def _over(given: Given, over: Mapping[str, Any]) -> Over:
    ranges = checked_over(given, over)
    path = one_path(ranges)
    unit = as_problem(given).quantity(path).unit
    return Over(path, *ranges[path], unit, unit)


def _axis(given: Given, axis: object, key: str) -> Axis:
    if not isinstance(axis, Mapping) or len(axis) != 1:
        raise InputError(key, 'is no grid of one parameter: give {"gap[0]": [1, 2, 3]}, for example')
    path, values = next(iter(axis.items()))
    as_problem(given).quantity(path)
    if isinstance(values, str) or not 1 <= len(values) <= _MOST:
        raise InputError(key, f"gives no list of values of {path}: give 1 to {_MOST}")
    out: list[Fraction] = []
    for k, value in enumerate(values):
        number = value_at(given, path, value, f"{key}.values[{k + 1}]")
        if number in out:
            raise InputError(f"{key}.values[{k + 1}]", f"is {shown(number)}, which is there already: drop one")
        out.append(number)
    return path, tuple(out)


def _require_none_undone(problem: Problem, rows: Axis, columns: Axis, over: Over) -> None:
    """A value that a parameter which is applied later sets again would stand in the table and mean nothing."""
    x = over.low + (1 if over.high is None else (over.high - over.low) / 2)
    for key, i, j, (path, values) in (("rows", 1, 0, rows), ("columns", 0, 1, columns)):
        if len(values) > 1:
            entries = (_at(problem, rows, n * i, columns, n * j) for n in range(2))
            one, other = (entry.changed(over.path, x) for entry in entries)
            if one == other:
                stated = f"has {path}, which moves nothing, as another parameter of the table sets the same numbers"
                raise InputError(key, f"{stated} after it: drop one of them, or let rows and columns change places")


def _at(problem: Problem, rows: Axis, i: int, columns: Axis, j: int) -> Problem:
    """The problem of one entry; factors on masses and gaps are applied last."""
    both = [("rows", i, rows[0], rows[1][i]), ("columns", j, columns[0], columns[1][j])]
    for key, k, path, value in sorted(both, key=lambda one: one[2].startswith("scale.")):
        try:
            problem = problem.changed(path, value)
        except InputError as error:
            told = str(error).removeprefix(f"{error.key}: ")
            raise InputError(f"{key}.values[{k + 1}]", f"is a value of {path}, which {told}") from None
    return problem
