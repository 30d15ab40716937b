"""Stable over boxes of parameters: proved, refuted by a certified point, or open with what is left."""

import pytest
from free_cases import BEAM, PAIR

from mpsolve import Problem, certify
from mpsolve.outcome import Status
from mpsolve.proof.effort import Effort
from mpsolve.ranges.robust import prove_stable

PROBLEM = Problem(BEAM, PAIR, v="0.5")
SOFT = {"track.k": ("0.5", "1.5"), "track.c": ("0.05", "0.15")}


def test_a_pair_is_stable_over_three_parameters() -> None:
    found = prove_stable(PROBLEM, over={"v": (0, "0.5"), **SOFT})
    assert found.status is Status.PROVED
    assert found.stable is True
    tree = found.proofs[0].cover.tree
    assert not len(tree.open)
    assert found.proofs[0].base.proved


def test_a_counterexample_is_a_point_with_its_proof() -> None:
    found = prove_stable(PROBLEM, over={"v": (0, "0.8"), **SOFT})
    assert found.stable is False
    assert found.counterexample is not None
    there = PROBLEM
    for path, value in found.counterexample.items():
        low, high = found.over[path]
        assert low <= value <= high
        there = there.changed(path, value)
    assert certify(there, region="unstable").unstable == found.spectrum.unstable > 0


@pytest.mark.parametrize("boxes", [20, 400])
def test_little_effort_leaves_boxes_open(boxes: int) -> None:
    found = prove_stable(PROBLEM, over={"v": (0, "0.5"), **SOFT}, effort=Effort(evaluations=boxes))
    assert found.stable is None
    assert found.status is Status.UNDECIDED
    assert found.reason is not None
    assert found.reason.code == "effort"
    if boxes > 100:
        assert found.open
        assert next(iter(found.rows())).keys() >= {"v low", "track.c high"}
