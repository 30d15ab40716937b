"""An undamped beam up to its critical velocity: never unstable, which certified points confirm; faster it is."""

from fractions import Fraction

import pytest
from flint import arb
from free_cases import PAIR

from mpsolve import Case, Problem, certify, prove_stable, tracks
from mpsolve.numbers.balls import precision
from mpsolve.ranges.onset import Kind, onset
from mpsolve.ranges.undamped import NOTE, never_unstable
from mpsolve.ranges.unstable import unstable_ranges

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


@pytest.mark.parametrize(
    ("over", "holds"),
    [
        ({"gap[0]": (1, 2), "scale.mass": (1, 9)}, True),
        ({"track.k": (1, 2), "v": (0, 1), "track.EI": ("0.25", 1)}, True),
        ({"track.k": ("0.07", 2)}, True),  # the cuts of the softest join at 0.514
        ({"track.k": ("0.06", 2)}, False),  # at 0.495
        ({"v": (0, "1.001")}, False),
        ({"track.c": (0, 1)}, False),
        ({"track.N": ("-0.1", "0.1")}, True),
    ],
)
def test_where_the_theorem_holds(over: dict[str, tuple[object, object]], holds: bool) -> None:
    exact = {path: (Fraction(str(a)), Fraction(str(b))) for path, (a, b) in over.items()}
    assert never_unstable(PROBLEM, exact) is holds


def test_a_range_that_goes_beyond_says_up_to_where_it_is_stable() -> None:
    found = onset(Case(alpha="0.5", eta_b=0, eta_m=(70, 70), positions=(0, "1.5")), over={"alpha": (0, 2)})
    assert (found.kind, found.reason and found.reason.code) == (Kind.UNDECIDED, "undamped")
    assert found.known["stable up to"].overlaps(arb(1))
    stiff = PROBLEM.changed("track.kp", "0.21")
    with precision(80):
        assert onset(stiff, over={"v": (0, 2)}).known["stable up to"].overlaps(arb("1.21").sqrt())


def test_damping_is_not_its_matter() -> None:
    assert not never_unstable(PROBLEM.changed("track.c", "0.1"), {"v": (Fraction(0), Fraction(1, 2))})
