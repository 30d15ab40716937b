"""A budget ends the work when it is spent, says what helps, and starts anew for each question."""

from __future__ import annotations

from typing import Any

import pytest

from mpsolve.errors import EffortError, InputError
from mpsolve.proof.effort import Effort, begun


def test_evaluations_are_counted() -> None:
    effort = Effort(evaluations=10)
    effort.spend(10)
    with pytest.raises(EffortError, match="10 evaluations is spent: allow more effort") as caught:
        effort.spend(1)
    assert caught.value.reason.code == "effort"
    assert caught.value.reason.numbers == {"evaluations": "10"}
    again = effort.anew()
    assert (again, again.spent) == (effort, 0)
    again.spend(10)


def test_seconds_are_those_of_the_processor(monkeypatch: pytest.MonkeyPatch) -> None:
    clock = [100.0]
    monkeypatch.setattr("mpsolve.proof.effort.process_time", lambda: clock[0])
    effort = Effort(seconds=2)
    effort.started = 100.0
    clock[0] = 101.9
    effort.spend(10**9)
    clock[0] = 102.1
    with pytest.raises(EffortError, match="2 s of processor time is spent"):
        effort.spend(0)


def test_what_is_left_of_the_seconds(monkeypatch: pytest.MonkeyPatch) -> None:
    clock = [100.0]
    monkeypatch.setattr("mpsolve.proof.effort.process_time", lambda: clock[0])
    effort = Effort(seconds=20, evaluations=7)
    effort.started = 100.0
    clock[0] = 105.0
    assert effort.left() == Effort(seconds=15, evaluations=7)
    assert effort.rest() == Effort(seconds=15)
    assert effort.left().whole is effort
    clock[0] = 150.0
    assert effort.left() == Effort(seconds=2, evaluations=7)  # some in any case
    assert (Effort(evaluations=7).left(), Effort(evaluations=7).rest()) == (Effort(evaluations=7), None)


def test_no_limit() -> None:
    Effort().spend(10**12)


@pytest.mark.parametrize(
    ("given", "key"),
    [
        ({"seconds": 0}, "effort.seconds"),
        ({"seconds": -1.5}, "effort.seconds"),
        ({"seconds": float("nan")}, "effort.seconds"),
        ({"seconds": float("inf")}, "effort.seconds"),
        ({"seconds": "3"}, "effort.seconds"),
        ({"seconds": True}, "effort.seconds"),
        ({"evaluations": 0}, "effort.evaluations"),
        ({"evaluations": 2.5}, "effort.evaluations"),
    ],
)
def test_limits_that_are_none(given: dict[str, Any], key: str) -> None:
    with pytest.raises(InputError) as caught:
        Effort(**given)
    assert caught.value.key == key


def test_work_begins_with_nothing_spent() -> None:
    given = Effort(evaluations=2)
    given.spend(2)
    assert (begun(given).spent, begun(given).evaluations, begun(None)) == (0, 2, Effort())
    with pytest.raises(InputError, match="effort: is of type float"):
        begun(3.0)  # type: ignore[arg-type]


def test_a_share_has_the_time_of_the_whole() -> None:
    whole = Effort(seconds=100)
    whole.started -= 200
    with pytest.raises(EffortError, match="100 s"):
        whole.share(5).spend(1)
    part = Effort(seconds=100, evaluations=9).share(5)
    part.spend(5)
    with pytest.raises(EffortError, match="5 evaluations"):
        part.spend(1)


def test_a_part_tells_the_limits_that_were_asked_for() -> None:
    """`certify --effort 1` told "0.5 s", the share of its first region."""
    for part in (Effort(seconds=1).half(), Effort(seconds=1).half().half().anew()):
        part.started -= 2
        with pytest.raises(EffortError, match="the effort of 1 s of") as caught:
            part.spend(0)
        assert caught.value.reason.numbers == {"seconds": "1"}
    with pytest.raises(EffortError, match="the effort of 40 evaluations"):
        Effort(evaluations=40).half().half().spend(11)


def test_the_rest_is_what_is_left_and_never_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    clock = [100.0]
    monkeypatch.setattr("mpsolve.proof.effort.process_time", lambda: clock[0])
    whole = Effort(seconds=10)
    whole.started = 100.0
    clock[0] = 104.0
    rest = whole.rest()
    assert rest is not None
    assert (rest.seconds, rest.evaluations) == (6.0, None)
    clock[0] = 150.0
    least = whole.rest()
    assert least is not None
    assert least.seconds == 1.0
    least.started = 150.0
    clock[0] = 152.0
    with pytest.raises(EffortError, match="the effort of 10 s of"):
        least.spend(0)
    assert Effort(evaluations=3).rest() is None
