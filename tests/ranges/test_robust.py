"""Stable over boxes of parameters: proved, refuted by a certified point, or open with what is left."""

import pytest
from free_cases import BEAM, BOGIE, LAYERS, PAIR

from mpsolve import Problem, certify, prove_stable
from mpsolve.certificate.verify_ranges import verify_bytes
from mpsolve.outcome import Status
from mpsolve.proof.effort import Effort

PROBLEM = Problem(BEAM, PAIR, v="0.5")
SOFT = {"track.k": ("0.5", "1.5"), "track.c": ("0.05", "0.15")}


def test_a_pair_is_stable_over_three_parameters() -> None:
    # the verifier passes this too, in half a minute: it is not asked here
    found = prove_stable(PROBLEM, over={"v": (0, "0.5"), **SOFT}, check=False)
    assert found.status is Status.UNVERIFIED
    assert found.certificate is None
    assert found.stable is True
    tree = found.proofs[0].cover.tree
    assert not len(tree.open)
    assert found.proofs[0].base.proved


@pytest.mark.parametrize("more", [{"scale.mass": ("0.9", "1.1"), "gap[0]": ("1.4", "1.6")}])
def test_five_parameters_at_once(more: dict[str, tuple[object, object]]) -> None:
    soft = {"v": (0, "0.5"), "track.k": ("0.8", "1.2"), "track.c": ("0.08", "0.12")}
    found = prove_stable(PROBLEM, over=soft | more, check=False)
    assert found.stable is True
    assert found.cost.boxes < 30_000


def test_a_bogie_on_two_layers_over_its_ballast() -> None:
    """Up to 0.9 of the least onset over the box, 432.3 m/s where the ballast is softest and least damped."""
    over = {"v": (1, 389), "track.k_ballast": ("50e6", "150e6"), "track.c_ballast": ("40e3", "120e3")}
    found = prove_stable(Problem(LAYERS, BOGIE, v=100), over=over, check=False)
    assert found.stable is True
    assert found.cost.boxes < 40_000


def test_a_box_of_two_parameters_has_a_certificate() -> None:
    found = prove_stable(PROBLEM, over={"v": (0, "0.3"), "track.c": ("0.08", "0.12")})
    assert (found.status, found.stable) == (Status.PROVED, True)
    assert verify_bytes(found.certificate.text.encode("ascii")).valid


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
    assert str(found).startswith(
        "Robust over v from 0 to 0.8, track.k from 0.5 to 1.5, track.c from 0.05 to 0.15: not stable, roots "
    )


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
