"""A budget is spent by evaluations and by processor time."""

from __future__ import annotations

import pytest

from mpsolve.errors import EffortError
from mpsolve.proof import effort as module
from mpsolve.proof.effort import Effort


def test_evaluations_are_counted_up_to_the_limit() -> None:
    effort = Effort(evaluations=10)
    effort.spend(4)
    effort.spend(6)
    with pytest.raises(EffortError, match="10 evaluations"):
        effort.spend(1)


def test_seconds_are_counted_from_the_start(monkeypatch: pytest.MonkeyPatch) -> None:
    now = [5.0]
    monkeypatch.setattr(module, "process_time", lambda: now[0])
    effort = Effort(seconds=2.0, started=5.0)
    now[0] = 6.9
    effort.spend(10**9)
    now[0] = 7.1
    with pytest.raises(EffortError, match="2 s"):
        effort.spend(1)


def test_no_limit_is_no_limit() -> None:
    effort = Effort()
    effort.spend(10**12)
    assert effort.spent == 10**12
