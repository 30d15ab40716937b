"""Arrays of induced frequencies against `certify`, the oracle's own search, limits and symmetry."""

from __future__ import annotations

import os
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from oracle import Truth, grid

from mpsolve import Case, certify
from mpsolve.errors import InputError
from mpsolve.fast.cases import Cases
from mpsolve.fast.follow import Outcome
from mpsolve.fast.frequencies import Frequencies, frequencies
from mpsolve.fast.order import alike
from mpsolve.model.edge import edge_value
from mpsolve.stability.velocities import unstable_velocities

ALPHA = np.arange(1, 141) / 100
STUDY = {
    "alpha": ALPHA,
    "eta_b": np.r_[0, np.arange(4, 100) / 100],
    "eta_m": np.array([10.0, 40.0, 70.0]),
    "d": np.arange(1, 10) / 2,
}


def rows(result: Frequencies) -> list[list[complex]]:
    """The roots of every case, without the padding."""
    flat = result.q.reshape(result.count.size, result.q.shape[-1])
    return [q[:n].tolist() for q, n in zip(flat, np.maximum(result.count, 0).ravel(), strict=True)]


def proved(case: Case) -> list[complex]:
    spectrum = certify(case, digits=17)
    assert spectrum.proved, spectrum.reason
    return [complex(root.q.mid()) for root in spectrum.roots]


def pair(alpha: Any, eta_b: Any, eta_m: Any, d: Any, ratio: float = 1) -> Case:
    return Case(alpha=alpha, eta_b=eta_b, eta_m=(eta_m, ratio * eta_m), positions=(0, d))


def assert_same(roots: list[complex], expected: list[complex], bound: float = 1e-11) -> None:
    assert len(roots) == len(expected)
    for q in expected:
        assert min(abs(q - found) for found in roots) < bound * abs(q)


def test_a_seeded_sample_of_the_study_is_what_certify_proves() -> None:
    """Draws from the paper's grid, with neighbours along α about each, so that roots are indeed followed."""
    assert np.prod([len(values) for values in STUDY.values()]) == 366_660
    rng = np.random.default_rng(20)
    for _ in range(12):
        eta_b, eta_m, d = (float(rng.choice(STUDY[name])) for name in ("eta_b", "eta_m", "d"))
        start = int(rng.integers(0, 100))
        some = ALPHA[start : start + 40]
        line = frequencies(some, eta_b, eta_m, d)
        assert (line.outcome > Outcome.UNRESOLVED).all() or (eta_b == 0 and 1 in some)
        k = int(rng.integers(1, 40))
        assert line.outcome[k] == Outcome.TRACKED
        if eta_b or abs(some[k] - 1) > 0.005:
            assert_same(rows(line)[k], proved(pair(float(some[k]), eta_b, eta_m, d)))


@pytest.mark.slow
def test_three_hundred_cases_of_the_whole_study() -> None:
    study = np.ix_(*STUDY.values())
    result = frequencies(*study, workers=os.cpu_count() or 1)
    assert (result.outcome > Outcome.UNRESOLVED).all()
    rng = np.random.default_rng(21)
    for _ in range(300):
        at = tuple(int(rng.integers(0, n)) for n in result.count.shape)
        alpha, eta_b, eta_m, d = (float(v[k]) for v, k in zip(STUDY.values(), at, strict=True))
        if not eta_b and alpha == 1:
            continue  # the cuts just touch there
        assert_same(result.q[at][: result.count[at]].tolist(), proved(pair(alpha, eta_b, eta_m, d)))


@pytest.mark.parametrize(
    ("alpha", "eta_b", "eta_m", "d", "ratio", "axial"),
    [
        (0.4, 0.05, 8.0, 1.2, 0.3, 0.0),
        (1.3, 0.1, 25.0, 3.0, 2.0, 0.0),
        (0.5, 0.2, 30.0, 0.7, 1.0, 0.6),
        (0.8, 0.0, 5.0, 2.0, 1.0, -0.8),
        (1.1, 0.7, 0.5, 1.0, 1.0, 0.4),
        (0.0, 0.1, 12.0, 1.5, 1.0, 0.0),
    ],
)
def test_roots_are_those_of_the_residue_sums(
    alpha: float, eta_b: float, eta_m: float, d: float, ratio: float, axial: float
) -> None:
    """Tracked roots against an oracle that knows neither resolvent nor winding number."""
    result = frequencies(alpha, eta_b, eta_m, d - np.array([0.02, 0.01, 0.0]), axial, 0, ratio)
    case = Case(alpha=alpha, eta_b=eta_b, eta_m=(eta_m, ratio * eta_m), positions=(0, d), eta_n=axial)
    truth = Truth(case, 30)
    k = 2
    assert result.outcome[k] == Outcome.TRACKED
    half = [q for q in rows(result)[k] if q.real >= 0]
    assert len(rows(result)[k]) == certify(case, digits=15).count
    assert all(min(abs(q - found) for found in half) < 1e-8 * abs(q) for q in truth.search(40.0))
    assert_same(half, [complex(truth.root(q)) for q in half])


def test_a_single_number_is_certified() -> None:
    result = frequencies(0.67, 0.05, 70, 1.5)
    assert result.count.shape == ()
    assert result.q.shape == (4,)
    assert result.status == "certified"
    assert result.unstable == 2


@pytest.mark.parametrize(
    ("given", "count"),
    [
        ((0.5, 0.9999999999999999, 10, 1), 4),
        ((0.5, 0, 10, 1, 0.9999999999999999), 4),
        ((100, 0.1, 10, 1), -1),
        ((1e12, 0.1, 10, 1), -1),
    ],
)
def test_a_case_that_is_hard_to_prove_ends_soon(
    given: tuple[float, ...], count: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A proof has a limit; beyond it float64 tells the roots, or nothing does."""
    pieces = [0]

    def value(track: Any, r: Any) -> Any:
        pieces[0] += 1
        assert pieces[0] < 5_000
        return edge_value(track, r)

    monkeypatch.setattr("mpsolve.sheet.winding.edge_value", value)
    result = frequencies(*given)
    assert result.count == count
    assert result.status == ("tracked" if count > 0 else "unresolved")


def test_work_is_cut_into_parts_that_change_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    alpha = np.linspace(0.2, 1.3, 60)
    whole = frequencies(alpha, 0.3, 40, 12)
    monkeypatch.setattr("mpsolve.fast.follow._WORK", 100)
    assert np.array_equal(frequencies(alpha, 0.3, 40, 12).q, whole.q, equal_nan=True)


def test_broadcasting_and_padding() -> None:
    result = frequencies(np.array([[0.5], [1.2]]), [0.05, 0.2, 0.4], 70, 4.5)
    assert result.count.shape == result.outcome.shape == result.status.shape == (2, 3)
    assert result.q.shape == (2, 3, result.count.max())
    for q, n in zip(result.q.reshape(6, -1), result.count.ravel(), strict=True):
        assert np.isfinite(q[:n]).all()
        assert np.isnan(q[n:]).all()
        assert q[:n].tolist() == sorted(q[:n].tolist(), key=lambda z: (z.real, z.imag))
    assert frequencies([], 0.1, 10, 1).q.shape == (0, 0)


def test_the_order_of_the_cases_does_not_matter() -> None:
    rng = np.random.default_rng(3)
    alpha, eta_b, d = rng.uniform(0.1, 1.3, 200), rng.uniform(0.02, 0.6, 200), rng.uniform(0.3, 4, 200)
    shuffle = rng.permutation(200)
    first = frequencies(alpha, eta_b, 20, d)
    second = frequencies(alpha[shuffle], eta_b[shuffle], 20, d[shuffle])
    assert np.array_equal(first.count[shuffle], second.count)
    assert np.array_equal(first.q[shuffle], second.q, equal_nan=True)


def test_masses_at_one_place_and_no_second_mass() -> None:
    alpha = np.linspace(0.3, 1.2, 10)
    merged, doubled = frequencies(alpha, 0.1, 20, 0), frequencies(alpha, 0.1, 40, 1.7, mass_ratio=0)
    assert np.array_equal(merged.q, doubled.q, equal_nan=True)
    for k in (3, 7):
        assert_same(rows(merged)[k], proved(Case(alpha=float(alpha[k]), eta_b="0.1", eta_m=40)))


def test_masses_far_apart_move_as_one_alone() -> None:
    """Damping uncouples them: every root of the single mass is double in the limit, here within e^{−…d}."""
    alpha = np.array([0.3, 0.31, 0.32])
    far, single = frequencies(alpha, 0.4, 3, 15), frequencies(alpha, 0.4, 3, 1, mass_ratio=0)
    near = [q for q in rows(single)[1] if q.real > 0]
    assert rows(far)[1]
    assert all(min(abs(q - n) for q in rows(far)[1]) < 1e-3 for n in near)


@given(st.data())
@settings(max_examples=15)
def test_symmetry_of_the_sheet(data: st.DataObject) -> None:
    """Roots in pairs q, −q̄, and for η_b = 0 in pairs q, q̄; a real root there is exactly real."""
    eta_b = data.draw(st.sampled_from([0.0, 0.25, 0.7]))
    alpha = data.draw(grid(0.05, 1.4))
    if abs(alpha - (1 - eta_b**2) ** 0.25) < 0.01:
        return
    result = frequencies(alpha + np.arange(3) / 500, eta_b, data.draw(grid(1, 80)), data.draw(grid(0.2, 4)))
    for roots, n in zip(rows(result), result.count, strict=True):
        assert n == len(roots)
        images = [-q.conjugate() for q in roots] + ([q.conjugate() for q in roots] if eta_b == 0 else [])
        assert all(q in roots for q in images)


def test_stability_agrees_with_the_proof() -> None:
    """The paper's onset for η_b = 0.05, η_M = 70, d = 1.5 lies between 0.66 and 0.67."""
    line = frequencies(np.arange(60, 75) / 100, 0.05, 70, 1.5)
    assert line.unstable.tolist() == [0] * 7 + [2] * 8


def test_cuts_that_touch_are_counted_and_not_certified() -> None:
    """α = α_C = 1 without damping: the pair of real roots has gone into q = 0, and nothing else is there."""
    result = frequencies([0.99, 1.0], 0, 10, 0.5)
    assert result.count.tolist() == [2, 0]
    assert result.outcome[1] == Outcome.TRACKED


def test_two_processes_give_the_same() -> None:
    alpha = np.linspace(0.1, 1.4, 40)
    one, two = (frequencies(alpha, 0.3, 40, 2, workers=workers) for workers in (1, 2))
    assert np.array_equal(one.q, two.q, equal_nan=True)


@pytest.mark.parametrize(
    ("change", "key"),
    [
        ({"alpha": -0.1}, "alpha"),
        ({"alpha": [0.5, float("nan")]}, "alpha"),
        ({"eta_b": 1.0}, "eta_b"),
        ({"eta_b": "much"}, "eta_b"),
        ({"eta_m": 0}, "eta_m"),
        ({"d": -1}, "d"),
        ({"eta_n": 1.0}, "eta_n"),
        ({"eta_n": 0.8, "eta_b": 0.7}, "eta_n"),
        ({"eta_s": -1}, "eta_s"),
        ({"mass_ratio": -1}, "mass_ratio"),
        ({"d": [True]}, "d"),
        ({"d": np.ma.masked_array([1.0, 2.0], [False, True])}, "d"),
        ({"alpha": [0.1, 0.2], "d": [1, 2, 3]}, "alpha"),
        ({"workers": 0}, "workers"),
    ],
)
def test_bad_arguments(change: dict[str, Any], key: str) -> None:
    with pytest.raises(InputError) as caught:
        frequencies(**{"alpha": 0.5, "eta_b": 0.1, "eta_m": 10, "d": 1, **change})
    assert caught.value.key == key


def test_the_unstable_set_is_the_proved_one() -> None:
    """A column of a chart against `unstable_velocities`: inside each proved interval, and nowhere else."""
    alpha = np.linspace(0.01, 1.39, 300)
    column = frequencies(alpha, 0.05, 70, 1.5).unstable
    proved_ranges = unstable_velocities("0.05", (70, 70), (0, "1.5"))
    assert proved_ranges.proved
    inside = np.zeros(len(alpha), bool)
    for interval in proved_ranges:
        inside |= (alpha > float(interval.start.mid())) & (alpha < float(interval.end.mid()))
    assert np.array_equal(column > 0, inside)


def test_roots_that_nearly_meet_are_all_found() -> None:
    """Masses far apart on a damped beam: pairs 6e-5 apart, and cavity roots along the cut, as many as counted."""
    result = frequencies([0.3, 0.31, 0.32], 0.4, 3, 15)
    assert result.count.tolist() == [10, 10, 10]
    truth = Truth(pair(0.31, 0.4, 3, 15), 30)
    for q in rows(result)[1]:
        assert abs(complex(truth.root(q)) - q) < 1e-10 * abs(q)


@pytest.mark.parametrize(
    ("alpha", "eta_b", "eta_m", "d", "tension"),
    [
        (1.3835269629673326, 0.3028796550773879, 56.942191830801036, 1.9509126551937963, 1e4),
        (0.7, 0.2, 40.0, 2.0, 1e2),
        (0.7, 0.2, 40.0, 2.0, 1e5),
    ],
)
def test_strong_tension_costs_no_digits(alpha: float, eta_b: float, eta_m: float, d: float, tension: float) -> None:
    """Two p-roots are small beside the other two, and are not what is left of them in a difference."""
    result = frequencies(alpha * np.array([0.999, 1, 1.001]), eta_b, eta_m, d, -tension)
    assert result.outcome[1] == Outcome.TRACKED
    case = Case(alpha=alpha, eta_b=eta_b, eta_m=(eta_m, eta_m), positions=(0, d), eta_n=-tension)
    truth = Truth(case, 40)
    expected = [complex(truth.root(q)) for q in rows(result)[1]]
    for q, root in zip(rows(result)[1], expected, strict=True):
        separation = min([abs(root - other) for other in expected if other != root]) / abs(root)
        assert abs(q - root) < 3e-14 * abs(root) / min(separation, 1)


@pytest.mark.parametrize(
    "change",
    [
        {"eta_m": 1e300},
        {"d": 1e-300},
        {"alpha": [1e300]},
        {"eta_m": 1e300, "mass_ratio": 1e300},
        {"eta_n": -1.7e308, "eta_s": 1.7e308},
    ],
)
def test_what_float64_does_not_hold_is_unresolved_without_a_warning(change: dict[str, Any]) -> None:
    result = frequencies(**{"alpha": [0.5, 0.6], "eta_b": 0.1, "eta_m": 10, "d": 1, **change})
    assert (result.status == "unresolved").all()
    assert (result.count == -1).all()


def test_neighbours_stay_neighbours_among_very_many_values() -> None:
    values = np.random.default_rng(1).permutation(20_000) / 20_000
    one = np.ones(len(values))
    assert (np.diff(values[alike(Cases(values, 0 * one, 0.1 * one, one, one, one))]) > 0).all()


def test_masses_far_apart_are_certified_where_float64_does_not_tell_their_roots_apart() -> None:
    """Pairs of roots nearer than 1e-8 to one another, in more cases than one in 512."""
    rng = np.random.default_rng(3)
    alpha, eta_b, eta_m, d = rng.uniform([0.05, 0.2, 1, 24], [0.9, 0.95, 70, 32], (30, 4)).T
    result = frequencies(alpha, eta_b, eta_m, d)
    assert (result.outcome == Outcome.CERTIFIED).sum() > 17
    assert (result.outcome > Outcome.UNRESOLVED).all()


def test_one_process_gives_up_proofs_that_fail_again_and_again(monkeypatch: pytest.MonkeyPatch) -> None:
    tried = [0]

    def fails(_cases: Cases, _place: int) -> None:
        tried[0] += 1

    monkeypatch.setattr("mpsolve.fast.follow.certified", fails)
    touching = 1 + np.linspace(-1e-9, 1e-9, 60)
    assert (frequencies(touching, 0, 20, 1.5).outcome == Outcome.UNRESOLVED).any()
    assert 0 < tried[0] <= 16
