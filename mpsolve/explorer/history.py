"""What is looked at, and the way back: states in order, with undo and redo."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Generic, TypeVar

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

    @property
    def can_undo(self) -> bool:
        return bool(self._before)

    @property
    def can_redo(self) -> bool:
        return bool(self._after)

    def undo(self) -> None:
        if self._before:
            self._after.append(self.now)
            self.now = self._before.pop()

    def redo(self) -> None:
        if self._after:
            self._before.append(self.now)
            self.now = self._after.pop()
