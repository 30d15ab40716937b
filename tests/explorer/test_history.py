"""Undo leads back through every state, redo forward again."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from mpsolve import InputError, Problem, tracks, vehicles
from mpsolve.explorer.history import MOST, History, Waiting


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
    assert history.now == first
    for state in seen[1:]:
        history.redo()
        assert history.now == state
    history.redo()
    assert history.now == seen[-1]


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
    for _ in range(2 * MOST):
        history.undo()
    assert history.now == 9


BOGIE = vehicles.Bogie(wheel=1500, frame=3000, inertia=155, wheelbase="2.5", k="4.8e6", c=250)
PROBLEM = Problem(tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c=770), BOGIE, v=20)
BODY, SPRING = "vehicles[0].body", "vehicles[0].k2"


def test_a_body_waits_for_its_spring_while_others_change() -> None:
    waiting = Waiting()
    with pytest.raises(InputError, match=r"k2.*waits"):
        waiting.taken(PROBLEM, BODY, "5 t")
    moved = waiting.taken(PROBLEM, "v", "30")
    assert moved == PROBLEM.changed("v", 30)
    assert waiting.values == {BODY: "5 t"}
    both = waiting.taken(moved, SPRING, "1e6")
    assert (both.parameters[BODY], both.parameters[SPRING]) == (5000, 1_000_000)
    assert waiting.values == {}
    with pytest.raises(InputError, match="waits"):
        waiting.taken(both, BODY, " ")
    assert waiting.taken(both, SPRING, "0") == moved


def test_what_cannot_be_at_all_does_not_wait() -> None:
    waiting = Waiting()
    for path, value in (("v", "12 kg"), ("v", ""), (BODY, "-1"), ("vehicles[0].nothing", "1")):
        with pytest.raises(InputError):
            waiting.taken(PROBLEM, path, value)
    assert waiting.values == {}


def test_an_optional_one_comes_and_goes() -> None:
    put = Waiting().taken(PROBLEM, "vehicles[0].k_contact", "1.4e9 N/m")
    assert put.parameters["vehicles[0].k_contact"] == 1_400_000_000
    assert Waiting().taken(put, "vehicles[0].k_contact", "") == PROBLEM
