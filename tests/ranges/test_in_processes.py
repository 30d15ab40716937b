"""A cover that processes share: the same answer as in one, within its budget, and it goes on where it stopped."""

from __future__ import annotations

import pickle
from fractions import Fraction

import pytest
from free_cases import BEAM, PAIR

from mpsolve import Effort, InputError, Problem, prove_stable
from mpsolve.progress import silent
from mpsolve.ranges.in_processes import InProcesses
from mpsolve.ranges.scope import scope_of

PROBLEM = Problem(BEAM, PAIR, v="0.5")
OVER = {"v": (Fraction("0.3"), Fraction("0.4")), "track.k": (Fraction(1), Fraction("1.1"))}


def under_way() -> InProcesses:
    return InProcesses.of(scope_of(PROBLEM, OVER), PROBLEM, OVER)


def test_a_cover_goes_on_where_it_stopped() -> None:
    one = under_way()
    found = one.cover(Effort(evaluations=100), 1, silent)
    assert found.reason is not None
    assert found.reason.code == "effort"
    again = pickle.loads(pickle.dumps(one))
    done = again.cover(Effort(evaluations=100_000), 1, silent)
    assert done.reason is None
    assert not len(done.tree.open)
    assert again.spent > 0


@pytest.mark.slow
def test_two_processes_give_a_certificate() -> None:
    found = prove_stable(PROBLEM, over=OVER, workers=2)
    assert (found.stable, found.status.value) == (True, "proved"), found.note


def test_workers_are_checked() -> None:
    with pytest.raises(InputError, match="workers"):
        prove_stable(PROBLEM, over=OVER, workers=0)
