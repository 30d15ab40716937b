"""Cut points: the known ones, all of them and no others; what is not proved is said."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from flint import arb

from mpsolve import Case, Effort, InputError, Problem, certify, cut_points, frequencies, tracks, vehicles

GAP = [
    (40, "0.5", 0.7404667534244332),
    (40, "1.0", 0.8613973457309659),
    (40, "1.5", 0.8779598896530904),
    (40, "2.0", 0.8767027102481949),
    (40, "2.5", 0.8815965440490775),
    (40, "3.0", 0.8930651540437504),
    (40, "3.5", 0.9018714001934055),
    (40, "4.0", 0.9058656917635258),
    (40, "4.5", 0.9086376448631609),
    (10, "0.5", 0.3726617837720695),
    (10, "1.0", 0.6612147919610002),
    (10, "1.5", 0.7233633054232281),
]
DAMPED = {70: (0.97909502330842, 0.050671551546303), 10: (0.96401964508021, 0.04998450905392)}


def twins(eta_m: object, d: str, eta_b: str = "0") -> Case:
    return Case(alpha="0.5", eta_b=eta_b, eta_m=(eta_m, eta_m), positions=(0, d))  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("eta", "d", "alpha"), [pytest.param(*row, marks=() if row[1] == "0.5" else pytest.mark.slow) for row in GAP]
)
def test_the_twelve_ends_of_the_gap(eta: int, d: str, alpha: float) -> None:
    """Section 4.2 of the paper, without damping: one each, all of them, as another program had them."""
    found = cut_points(twins(eta, d), over={"v": ("0.01", "0.99")}, digits=30)
    assert (found.proved, found.reach) == (True, None)
    (point,) = found.points
    assert (point.side, point.appears) == ("gap", False)
    assert abs(point.value - alpha) < 1e-15
    assert point.value.rad() < 1e-30
    assert point.lower <= alpha <= point.upper or abs(point.lower - alpha) < 1e-15


@pytest.mark.parametrize("eta", [10, 70])
def test_with_damping_a_line_ends_below_the_cut(eta: int) -> None:
    found = cut_points(twins(eta, "1.5", "0.05"), over={"v": ("0.5", "0.99")}, digits=20)
    assert found.proved
    (point,) = found.points
    alpha, re = DAMPED[eta]
    assert (point.side, point.appears) == ("below", False)
    assert abs(point.value - alpha) < 1e-12
    assert abs(point.q.real - re) < 1e-12
    assert point.q.imag.overlaps(arb("0.05"))


JOINED = [(0.97909502330842, "below", False), (1.04165166476, "above", True), (1.2030725666739, "below", True)]
THREE = Case(alpha="0.5", eta_b="0.05", eta_m=(40, 20, 30), positions=(0, 1, "2.5"))


@pytest.mark.parametrize(
    ("case", "low", "high", "known"),
    [
        (twins(70, "1.5", "0.05"), "0.97", "1.06", JOINED[:2]),
        pytest.param(twins(70, "1.5", "0.05"), "0.9", "1.3", JOINED, marks=pytest.mark.slow),
        pytest.param(THREE, "0.9", "1.3", [(0.97095633604, "below", False), (1.034932782, "above", True)],
                     marks=pytest.mark.slow),
        pytest.param(twins(70, "1.5"), "1.01", "1.3", [], marks=pytest.mark.slow),
    ],
)  # fmt: skip
def test_the_list_is_complete_where_the_cuts_have_joined(
    case: Case, low: str, high: str, known: list[tuple[float, str, bool]]
) -> None:
    """Through the velocity at which they join, with damping, and beyond it: floats count as many roots as it says."""
    found = cut_points(case, over={"v": (low, high)})
    assert found.proved, found.reason
    assert [(point.side, point.appears) for point in found.points] == [row[1:] for row in known]
    assert all(abs(point.value - value) < 1e-9 for point, (value, *_) in zip(found.points, known, strict=True))
    values = np.random.default_rng(7).uniform(float(low), float(high), 24)
    roots = frequencies(case, {"v": values}, region="sheet").roots
    start = np.isfinite(frequencies(case, {"v": [float(low)]}, region="sheet").roots).sum()
    for value, row in zip(values, roots, strict=True):
        steps = sum(2 if point.appears else -2 for point in found.points if float(point.value) < value)
        assert np.isfinite(row).sum() == start + steps


def test_a_range_from_rest_begins_a_little_above_it() -> None:
    """At rest all four p-roots meet where the cut begins."""
    found = cut_points(twins(40, "1"), over={"alpha": (0, "0.9")})
    assert (found.proved, len(found.points)) == (True, 1), found.reason
    low, high = found.over["alpha"]
    assert 0 < low < high / 1000


def test_in_another_parameter_and_in_physical_units() -> None:
    """Over the mass of both: at α = 0.861397… it is 40, as the velocities say; and on a rail, scaled."""
    case = Case(alpha="0.8613973457309659", eta_b=0, eta_m=(40, 40), positions=(0, 1))
    found = cut_points(case, over={"scale.mass": ("0.5", "1.5")})
    assert found.proved
    (point,) = found.points
    assert abs(point.value - 1) < 1e-13
    rail = tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6")
    # lengths 1/χ, χ⁴ = k/4EI; η_M = Mχ/m; α = v/√(4 k EI/m²)^½
    chi, speed = (1e6 / (4 * 6.4e6)) ** 0.25, (4 * 1e6 * 6.4e6 / 60**2) ** 0.25
    masses = [vehicles.Mass(40 * 60 / chi).at(0), vehicles.Mass(40 * 60 / chi).at(1 / chi)]
    scaled = cut_points(Problem(rail, masses, v=1), over={"v": (0.8 * speed, 0.95 * speed)})
    assert scaled.proved
    (one,) = scaled.points
    assert abs(float(one.value) / speed - 0.8613973457309659) < 1e-12


@pytest.mark.slow
def test_counts_fall_by_two_where_a_line_ends() -> None:
    case = Case(alpha="0.5", eta_b=0, eta_m=(40, 20, 30), positions=(0, 1, "2.5"))
    found = cut_points(case, over={"v": ("0.7", "0.9")}, effort=Effort(evaluations=40_000))
    assert [(p.side, p.appears) for p in found.points] == [("gap", False)] * 2
    first, second = (float(p.value) for p in found.points)
    counts = [certify(_three(a), digits=15, check=False).count for a in ("0.77", "0.83", "0.9")]
    assert 0.77 < first < 0.83 < second < 0.9
    assert [a - b for a, b in pairwise(counts)] == [2, 2]  # type: ignore[operator]


def _three(alpha: str) -> Case:
    return Case(alpha=alpha, eta_b=0, eta_m=(40, 20, 30), positions=(0, 1, "2.5"))


def test_another_vehicle_is_told_up_to_a_frequency() -> None:
    """Two sprung masses: no theorem far out, so that the list speaks of lower frequencies."""
    beam = tracks.EulerBernoulli(EI="1/4", m=1, k=1, c="0.1")
    pair = [vehicles.Oscillator(wheel=5, body=20, k=2, c="0.1").at(x) for x in (0, "1.5")]
    found = cut_points(Problem(beam, pair, v="0.9"), over={"v": ("0.9", "0.95")})
    assert not found.proved
    assert found.reason is not None
    assert found.reason.code == "far"
    assert found.reach is not None


@pytest.mark.parametrize(
    ("problem", "over", "key"),
    [
        (Problem(tracks.String(T=1, m=1, k=1, c="0.1"), [vehicles.Mass(1)], v="0.1"), {"v": ("0.1", "0.2")}, "track"),
        (twins(40, "1", "1.5"), {"v": ("0.1", "0.2")}, "track"),
        (twins(40, "1"), {"speed": ("0.1", "0.2")}, "speed"),
        (twins(40, "1"), {"v": ("0.2", "0.1")}, "v"),
    ],
)
def test_what_cannot_be_is_refused(problem: object, over: dict[str, object], key: str) -> None:
    with pytest.raises(InputError, match=key):
        cut_points(problem, over=over)  # type: ignore[arg-type]
