"""A step that looks at no effort ends with it, and says why it gave nothing; what is ready in time is given."""

from __future__ import annotations

import signal
from time import process_time

import pytest

from mpsolve.proof.deadline import TimeUpError, deadline
from mpsolve.proof.effort import Effort
from mpsolve.proof.in_time import in_time

pytestmark = pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="there is no such timer here")


def busy(seconds: float) -> None:
    """Works for so many seconds of processor time."""
    end = process_time() + seconds
    while process_time() < end:
        sum(range(1000))


def test_what_is_ready_is_given() -> None:
    for budget in (Effort(), Effort(seconds=5.0), Effort(evaluations=1)):
        found, why, seconds = in_time(lambda: 7, budget)
        assert (found, why) == (7, "")
        assert 0 <= seconds < 1


def test_it_has_what_is_left_of_the_effort() -> None:
    budget = Effort(seconds=0.6)
    busy(0.4)
    found, why, seconds = in_time(lambda: busy(5.0), budget, "all was said")
    assert found is None
    assert why.startswith("the effort of 0.6 s of processor time was spent before all was said: allow more")
    assert 0.1 < seconds < 0.4


def test_a_part_tells_the_effort_that_was_asked_for() -> None:
    part = Effort(seconds=0.4).half()
    assert "the effort of 0.4 s" in in_time(lambda: busy(5.0), part)[1]


def test_a_deadline_round_it_ends_it_too() -> None:
    with deadline(0.2):
        found, why, seconds = in_time(lambda: busy(5.0), Effort())
    assert found is None
    assert "all the time was spent" in why
    assert seconds < 0.5


def test_errors_pass() -> None:
    with pytest.raises(ZeroDivisionError):
        in_time(lambda: 1 // 0, Effort(seconds=1.0))
    with pytest.raises(TimeUpError), deadline(0.1):
        busy(5.0)
