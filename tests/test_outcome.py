"""Tests of mpsolve/outcome.py."""

import json
import pickle

import pytest

from mpsolve.outcome import Reason, Status

REASON = Reason("contour-root", "a root lies on the contour near q = 0.5", {"q": "0.5"}, "move the rectangle")


def test_the_sentence_names_the_remedy():
    assert str(REASON) == "a root lies on the contour near q = 0.5: move the rectangle"
    assert str(Reason("no-idea", "nothing is known to help")) == "nothing is known to help"


def test_the_parts_survive_pickling_and_json():
    assert pickle.loads(pickle.dumps(REASON)) == REASON
    assert Reason(**json.loads(json.dumps(REASON.data()))) == REASON
    assert hash(REASON) == hash(Reason(**REASON.data()))


def test_the_numbers_cannot_be_changed_from_outside():
    numbers = {"q": "0.5"}
    reason = Reason("x", "y", numbers)
    numbers["q"] = "1"
    assert reason.numbers["q"] == "0.5"
    with pytest.raises(TypeError):
        reason.numbers["q"] = "1"


def test_only_proofs_hold():
    assert [s for s in Status if s.holds] == [Status.PROVED, Status.UNVERIFIED]
