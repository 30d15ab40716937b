"""What a list of critical velocities says of itself, proved or not."""

from __future__ import annotations

from dataclasses import replace

import pytest

from mpsolve import critical_velocities
from mpsolve.numbers.balls import arb
from mpsolve.outcome import Status
from mpsolve.tracks import EulerBernoulli


def test_what_is_undecided_is_named_and_the_rest_is_claimed() -> None:
    found = critical_velocities(EulerBernoulli(EI="1/4", m=1, k=1), over={"v": (0, 5)})
    assert found.sentence.startswith("proved, without certificate: the list is complete for 0 ≤ v ≤ 5")
    open_ = replace(found, undecided=(arb(3),), status=Status.UNDECIDED, always=("p = 0 is a root",))
    assert open_.sentence.startswith("undecided at v = 3; at every other v in 0 ≤ v ≤ 5 that is not listed")
    assert open_.sentence.endswith("but for what holds always")
    assert open_.to_dict()["undecided"] == ["3"]
    assert [float(one.value) for one in open_] == [pytest.approx(1)]
    assert len(open_) == 1
