"""A budget: parts in order, what does not fit is named, and no part ends the page."""

from __future__ import annotations

import os
import signal
import time
from collections.abc import Callable
from typing import Any

import pytest

from mpsolve.errors import InputError
from mpsolve.page.budget import Budget, Part
from mpsolve.proof.stopping import stoppable


class Clock:
    def __init__(self) -> None:
        self.now = 0.0

    def __call__(self) -> float:
        return self.now


def spending(clock: Clock, seconds: float) -> Callable[[float], float]:
    def make(left: float) -> float:
        clock.now += seconds
        return left

    return make


def test_parts_come_until_time_is_up() -> None:
    clock, told = Clock(), []
    budget = Budget(10.0, lambda stage, fraction: told.append((stage, fraction)), clock)
    first = budget.part("first", spending(clock, 6.0), share=0.5)
    second = budget.part("second", spending(clock, 3.0))
    third = budget.part("third", spending(clock, 1.0), least=2.0)
    assert (first.value, first.seconds) == (5.0, 6.0)
    assert second.value == 4.0
    assert third.late
    assert not third.there
    assert "--effort" in third.reason
    assert [stage for stage, _ in told] == ["first", "second"]


def test_ctrl_c_ends_the_part_that_is_made_and_begins_no_other() -> None:
    budget = Budget(100.0, lambda *_: None)

    def pressed(_left: float) -> None:
        os.kill(os.getpid(), signal.SIGINT)
        time.sleep(5)

    @stoppable
    def parts() -> list[Part[Any]]:
        return [budget.part("a", pressed), budget.part("b", lambda _: 1)]

    assert [(part.there, part.late) for part in parts()] == [(False, True)] * 2
    assert budget.part("c", lambda _: 1).there
    with pytest.raises(KeyboardInterrupt):
        budget.part("d", pressed)


def test_an_error_of_a_part_is_its_reason() -> None:
    def fails(_left: float) -> None:
        raise InputError("k", "is wrong")

    part = Budget(1.0, lambda *_: None, Clock()).part("x", fails)
    assert "is wrong" in part.reason
    assert not part.late


def test_a_failure_of_floats_does_not_end_the_page() -> None:
    part = Budget(1.0, lambda *_: None, Clock()).part("x", lambda _: 1 / 0)
    assert "division" in part.reason
    assert not part.there
