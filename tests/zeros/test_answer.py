"""An answer has no truth value, says whether it is proved, and travels."""

from __future__ import annotations

import copy
from dataclasses import replace
from fractions import Fraction

import pytest
from flint import acb, arb

from mpsolve.numbers.result import Cost
from mpsolve.outcome import Status
from mpsolve.zeros.answer import Zero, Zeros
from mpsolve.zeros.regions import Rectangle


def answer(status: Status) -> Zeros:
    return Zeros("z", None, 15, status, count=1, roots=(Zero(acb(arb(0, 1e-20), 0), 1, True),), cost=Cost(1.0))


def test_proved_is_what_its_status_says() -> None:
    assert answer(Status.PROVED).proved
    assert answer(Status.UNVERIFIED).proved
    assert not answer(Status.UNDECIDED).proved


def test_it_says_where_in_terms_of_z() -> None:
    for region, said in (
        (Rectangle(-1, 2, 0, 1), "-1 < Re z < 2, 0 < Im z < 1"),
        ((Fraction(0), Fraction(5, 2)), "[0, 2.5]"),
    ):
        one = replace(answer(Status.PROVED), region=region)
        assert one.where == said
        assert f" of z in {said}: " in str(one)


def test_it_travels_and_has_no_truth_value() -> None:
    again = copy.deepcopy(answer(Status.PROVED))
    assert again.roots[0].q.contains(acb(0))
    with pytest.raises(TypeError):
        bool(again)
