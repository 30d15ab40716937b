"""Undo leads back through every state, redo forward again."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from mpsolve.explorer.history import MOST, History


@given(st.integers(), st.lists(st.integers(), max_size=40))
def test_undo_and_redo_walk_the_states(first: int, states: list[int]) -> None:
    history = History(first)
    seen = [first]
    for state in states:
        history.change(state)
        if state != seen[-1]:
            seen.append(state)
    for state in reversed(seen):
        assert history.now == state
        history.undo()
    assert not history.can_undo
    for state in seen[1:]:
        history.redo()
        assert history.now == state
    assert not history.can_redo


def test_a_change_forgets_what_was_undone() -> None:
    history = History("a")
    history.change("b")
    history.undo()
    history.change("c")
    history.redo()
    assert history.now == "c"
    history.undo()
    assert history.now == "a"


def test_the_oldest_states_are_dropped() -> None:
    history = History(0)
    for k in range(1, MOST + 10):
        history.change(k)
    while history.can_undo:
        history.undo()
    assert history.now == 9
