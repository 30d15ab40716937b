"""Errors carry their key and their reason, and survive python -O."""

from __future__ import annotations

import pickle

import pytest

from mpsolve.errors import ContradictionError, EffortError, InputError, MpsolveError, PrecisionError, known
from mpsolve.outcome import Reason


def test_an_input_error_names_its_key_and_is_a_value_error() -> None:
    error = InputError("track.k", "is 0: give a stiffness")
    assert (error.key, str(error)) == ("track.k", "track.k: is 0: give a stiffness")
    assert isinstance(error, (MpsolveError, ValueError))
    assert str(error.under("k")) == "k: is 0: give a stiffness"


def test_an_input_error_travels_between_processes() -> None:
    back = pickle.loads(pickle.dumps(InputError("track.k", "is 0: give a stiffness")))
    assert (back.key, back.said, str(back)) == (
        "track.k",
        "is 0: give a stiffness",
        "track.k: is 0: give a stiffness",
    )


def test_a_reason_in_parts_is_kept_and_a_sentence_becomes_one() -> None:
    reason = Reason("effort", "spent", {"n": "3"}, "more")
    assert EffortError(reason).reason is reason
    assert str(EffortError(reason)) == "spent: more"
    assert PrecisionError("too wide").reason == Reason("unspecified", "too wide")
    assert PrecisionError().reason.message == ""


def test_more_effort_is_no_question_of_precision_alone() -> None:
    assert issubclass(EffortError, PrecisionError)
    assert not issubclass(PrecisionError, EffortError)


def test_what_has_to_be_there() -> None:
    assert known(0, "zero") == 0
    with pytest.raises(ContradictionError, match="the radius is missing where it was proved to be"):
        known(None, "the radius")
