"""What is looked at, and the way back; and what was typed but cannot stand alone, as a body without its spring."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Generic, TypeVar

from mpsolve.errors import InputError
from mpsolve.problem.left_out import put_in
from mpsolve.problem.problem import Problem

T = TypeVar("T")
MOST = 500


@dataclass
class History(Generic[T]):
    """States in order; `now` is the present one. A change after an undo forgets what was undone."""

    now: T
    _before: list[T] = field(default_factory=list)
    _after: list[T] = field(default_factory=list)

    def change(self, state: T) -> None:
        """Go on to another state; the same one again is no step."""
        if state == self.now:
            return
        self._before = [*self._before[-MOST + 1 :], self.now]
        self._after, self.now = [], state

    def replace(self, state: T) -> None:
        """The present state, corrected: a step of a movement that has not ended."""
        self.now = state

    def undo(self) -> None:
        if self._before:
            self._after.append(self.now)
            self.now = self._before.pop()

    def redo(self) -> None:
        if self._after:
            self._before.append(self.now)
            self.now = self._after.pop()


@dataclass
class Waiting:
    """Values by path, None for a parameter to be left out, each of them possible by itself."""

    values: dict[str, object] = field(default_factory=dict)

    def taken(self, problem: Problem, path: str, value: object) -> Problem:
        """The problem with this value and with all that waits, or with this value alone.

        An empty text leaves an optional parameter out. InputError says why the value cannot be; one that others
        exclude waits.
        """
        quantity = problem.quantity(path)
        empty = isinstance(value, str) and not value.strip()
        if empty and quantity.optional:
            value = None
        else:
            quantity.checked(value, path)
        others = {one: kept for one, kept in self.values.items() if one != path}
        try:
            changed = put_in(problem, {**others, path: value})
        except InputError as error:
            self.values = others
            if others:
                return self._alone(problem, path, value)
            self.values = {path: value}
            raise _waits(error) from None
        self.values = {}
        return changed

    def _alone(self, problem: Problem, path: str, value: object) -> Problem:
        try:
            return put_in(problem, {path: value})
        except InputError as error:
            self.values[path] = value
            raise _waits(error) from None


def _waits(error: InputError) -> InputError:
    return InputError(error.key, f"{error.said} (what was typed waits for that)")
