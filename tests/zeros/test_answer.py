"""An answer has no truth value, says whether it is proved, and travels."""

from __future__ import annotations

import copy

import pytest
from flint import acb, arb

from mpsolve.numbers.result import Cost
from mpsolve.outcome import Status
from mpsolve.zeros.answer import Zero, Zeros


def answer(status: Status) -> Zeros:
    return Zeros("z", None, 15, status, count=1, roots=(Zero(acb(arb(0, 1e-20), 0), 1, True),), cost=Cost(1.0))


def test_proved_is_what_its_status_says() -> None:
    assert answer(Status.PROVED).proved
    assert answer(Status.UNVERIFIED).proved
    assert not answer(Status.UNDECIDED).proved


def test_it_travels_and_has_no_truth_value() -> None:
    again = copy.deepcopy(answer(Status.PROVED))
    assert again.roots[0].q.contains(acb(0))
    with pytest.raises(TypeError):
        bool(again)
