"""Answers say what is proved, travel, and refuse a truth value."""

from __future__ import annotations

import json
import pickle
from fractions import Fraction

import pytest
from flint import arb

from mpsolve.outcome import Reason, Status
from mpsolve.passivity.answer import Kind, PassivityVelocity


def answer(kind: Kind, value: object, status: Status, reason: Reason | None = None) -> PassivityVelocity:
    return PassivityVelocity(kind, value, Fraction(0), Fraction(5), value, (arb(2).sqrt(),), status, reason)


def test_sentences() -> None:
    lost = answer(Kind.LOST, arb("1.25"), Status.UNVERIFIED)
    assert lost.sentence.endswith("from 0 to v = 1.25")
    assert lost.proved
    whole = answer(Kind.WHOLE, None, Status.UNVERIFIED)
    assert "at any velocity in 0 ≤ v ≤ 5" in whole.sentence
    start = answer(Kind.FROM_START, None, Status.UNVERIFIED)
    assert "not passive for one contact at v = 0" in start.sentence
    reason = Reason("boxes", "too close", {}, "ask for less")
    open_ = answer(Kind.UNDECIDED, arb("0.5"), Status.UNDECIDED, reason)
    assert open_.sentence.startswith("undecided: too close: ask for less; no passive vehicle")
    assert not open_.proved


def test_data() -> None:
    lost = answer(Kind.LOST, arb("1.25"), Status.UNVERIFIED)
    again = pickle.loads(pickle.dumps(lost))
    assert json.loads(json.dumps(again.to_dict()))["value"] == "1.25"
    with pytest.raises(TypeError):
        bool(lost)
