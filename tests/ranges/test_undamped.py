"""An undamped beam up to its critical velocity: never unstable, which certified points confirm; faster it is."""

from fractions import Fraction

import pytest
from free_cases import PAIR

from mpsolve import InputError, Problem, certify, tracks
from mpsolve.ranges.onset import Kind, onset, unstable_ranges
from mpsolve.ranges.robust import prove_stable
from mpsolve.ranges.undamped import NOTE, never_unstable

BEAM = tracks.EulerBernoulli(EI="1/4", m=1, k=1)  # cuts join at v = 1
PROBLEM = Problem(BEAM, PAIR, v="0.5")


def test_never_unstable_up_to_the_critical_velocity() -> None:
    found = onset(PROBLEM, over={"v": (0, 1)})
    assert found.kind is Kind.STABLE
    assert found.proved
    assert found.note == NOTE
    assert unstable_ranges(PROBLEM, over={"scale.mass": ("0.1", 10)}).intervals == ()
    assert prove_stable(PROBLEM, over={"v": (0, "0.99"), "scale.mass": ("0.1", 10)}).stable is True
    for v in ("0.3", "0.9"):
        assert certify(PROBLEM.changed("v", v), region="unstable").unstable == 0


@pytest.mark.parametrize("over", [{"v": (0, "1.001")}, {"track.N": (0, "0.1")}])
def test_elsewhere_the_theorem_does_not_tell(over: dict[str, tuple[object, object]]) -> None:
    exact = {path: (Fraction(str(a)), Fraction(str(b))) for path, (a, b) in over.items()}
    assert not never_unstable(PROBLEM, exact)
    with pytest.raises(InputError, match="without damping"):
        onset(PROBLEM, over=over)


def test_damping_is_not_its_matter() -> None:
    assert not never_unstable(PROBLEM.changed("track.c", "0.1"), {"v": (Fraction(0), Fraction(1, 2))})
