"""A box with a zero is never said to be free of one, boxes cover all they came from, slopes hold the truth."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from oracle import Truth

from mpsolve import Case
from mpsolve.discs import DiscField
from mpsolve.stability.exclude import Job, _halved, _tested, exclude, exclude_all, grid, inside, local
from mpsolve.stability.family import Family
from mpsolve.stability.zero import approach

NONE = np.zeros((0, 4))
PAIR = {"eta_m": (30, 30), "positions": (0, 1)}
FAMILIES = {
    "one mass, alpha": (Family(Case(alpha=0, eta_b="0.05", eta_m=70), "alpha"), 0.13736, 1.0749),
    "two masses, alpha": (Family(Case(alpha=0, eta_b="0.1", **PAIR), "alpha"), 0.20246, 0.97393),
    "distance": (Family(Case(alpha="0.99", eta_b="0.1", **PAIR), "distance"), 0.20107, 0.92911),
    "distance, back": (Family(Case(alpha="0.99", eta_b="0.1", **PAIR), "distance"), 0.19938, 1.59569),
    "eta_b": (Family(Case(alpha="0.99", eta_b="0.1", **PAIR), "eta_b"), 0.19469, 0.08005),
    "three masses, alpha": (
        Family(Case(alpha=0, eta_b="0.1", eta_m=(30, 30, 30), positions=(0, 1, 2)), "alpha"),
        0.18,
        0.95,
    ),
    "level, one mass": (Family(Case(alpha="1.05", eta_b="0.05", eta_m=1), "level"), 0.0911, 0.444),
    "level, two masses": (
        Family(Case(alpha="0.99", eta_b="0.1", eta_m=(70, 30), positions=(0, "1.1")), "level"),
        0.16518,
        0.01426,
    ),
}
families = pytest.mark.parametrize("name", FAMILIES)


def zero_of(name: str) -> tuple[Family, float, float]:
    """A family and one of its zeros, in floats, by the truth's own Newton steps where it has them."""
    family, x, t = FAMILIES[name]
    point = approach(family, x, t)
    assert point is not None
    x, t = (float(v) for v in point)
    return family, abs(x), t


@families
def test_the_zeros_are_those_of_the_truth(name: str) -> None:
    """Δ of (26) vanishes there, with the masses that the level stands for."""
    family, x, t = zero_of(name)
    truth = truth_at(family, x, t)
    scale = abs(truth.delta(x * 1.01))
    assert abs(truth.delta(x)) < 1e-9 * (1 + scale)


def truth_at(family: Family, x: float, t: float, digits: int = 40) -> Truth:
    truth = Truth(family.case, digits)
    if family.parameter == "level":
        level = truth.mp.pi * (1 + truth.mp.mpf(x) ** 2) * t / (1 - truth.mp.mpf(t)) / (2 * truth.mp.mpf(x) ** 2)
        truth.eta_m = [level * eta for eta in truth.eta_m]
    elif family.parameter == "distance":
        truth.x = [k * truth.mp.mpf(t) for k in range(len(truth.x))]
    else:
        setattr(truth, family.parameter, truth.mp.mpf(t))
    return truth


@families
def test_no_box_with_a_zero_is_free(name: str) -> None:
    """Of any shape and size, the zero anywhere in it, beyond the roundings of the zero itself."""
    family, x, t = zero_of(name)
    rng = np.random.default_rng(4)
    widths = 10.0 ** rng.uniform(-10, 0, (4, 3000))
    low_t, high_t = np.maximum(t - widths[2], t / 2), np.minimum(t + widths[3], t + (1 - t) / 2 if t < 1 else t + 1)
    boxes = np.stack([np.maximum(x - widths[0], 0), x + widths[1], low_t, high_t], axis=1)
    boxes[:300, 0] = 0
    free, _ = _tested([family], np.zeros(len(boxes), dtype=int), DiscField(), boxes)
    assert not free.any()


@families
def test_most_boxes_off_the_zeros_are_free(name: str) -> None:
    """The test is worth something: small boxes away from the zero are freed."""
    family, x, t = zero_of(name)
    rng = np.random.default_rng(6)
    turn = rng.uniform(0, 2 * np.pi, 400)
    dx, dt = 0.3 * x * np.cos(turn), 0.3 * min(t, abs(1 - t)) * np.sin(turn)
    boxes = np.stack([x + dx, x + dx + 1e-4, t + dt, t + dt + 1e-4], axis=1)
    free, _ = _tested([family], np.zeros(len(boxes), dtype=int), DiscField(), boxes)
    assert free.mean() > 0.9


@families
def test_subdivision_keeps_the_zero_and_little_else(name: str) -> None:
    family, x, t = zero_of(name)
    region = np.array([[0.7 * x, 1.3 * x, 0.99 * t, 1.005 * t]])
    cover = exclude(Job(family, region, NONE, 0, 9))
    held = cover.open
    near = np.abs(held[:, 0] - x) + np.abs(held[:, 2] - t)
    assert ((held[:, 0] <= x) & (x <= held[:, 1]) & (held[:, 2] <= t) & (t <= held[:, 3])).any()
    assert len(held) < 200
    assert np.min(near) < 0.05
    hole = np.array([[0.5 * x, 1.5 * x, 0.9 * t, 1.1 * t]])
    assert len(exclude(Job(family, region, hole, 0, 9)).open) == 0


def test_a_region_without_a_zero_is_freed_and_budget_and_levels_end_the_search() -> None:
    family, _, _ = FAMILIES["one mass, alpha"]
    region = grid(3.0, 0.2, 0.9)
    cover = exclude(Job(family, region, NONE, 0))
    assert len(cover.open) == 0
    assert cover.evaluations >= len(region)
    assert len(exclude(Job(family, region, NONE, 0, budget=-1)).open) == len(region)
    assert len(exclude(Job(family, region, NONE, 0, levels=0)).open) == len(region)


# --- covering ---------------------------------------------------------------------------------------------------


@settings(max_examples=60)
@given(st.floats(0.01, 1e5), st.floats(0, 3), st.floats(1e-6, 3), st.integers(0, 10**6))
def test_the_grid_covers_its_region_without_gaps(x1: float, t0: float, width: float, seed: int) -> None:
    t1 = t0 + width
    boxes = grid(x1, t0, t1)
    assert boxes[:, 0].min() == 0
    assert (boxes[:, 1].max(), boxes[:, 2].min(), boxes[:, 3].max()) == (x1, t0, t1)
    rng = np.random.default_rng(seed)
    edges = np.concatenate([boxes[:, 0], boxes[:, 1], np.nextafter(boxes[:, 1], 0), rng.uniform(0, x1, 50)])
    levels = np.concatenate([boxes[:, 2], np.nextafter(boxes[:, 3], 0), rng.uniform(t0, t1, 50)])
    for x, t in zip(rng.choice(edges, 100), np.clip(rng.choice(levels, 100), t0, t1), strict=True):
        assert ((boxes[:, 0] <= x) & (x <= boxes[:, 1]) & (boxes[:, 2] <= t) & (t <= boxes[:, 3])).any()


boxes_of = st.tuples(st.floats(0, 1e4), st.floats(1e-12, 1e4), st.floats(0, 3), st.floats(1e-12, 3), st.booleans())


@settings(max_examples=60)
@given(st.lists(boxes_of, min_size=1, max_size=5))
def test_halves_share_an_edge_and_make_up_the_box(data: list[Any]) -> None:
    boxes = np.array([(x, x + dx, t, t + dt) for x, dx, t, dt, _ in data])
    across = np.array([along for *_, along in data])
    halves = _halved(boxes, np.where(across, 0, 1))
    assert halves.shape == (2 * len(boxes), 4)
    for box, along, one, two in zip(boxes, across, halves[: len(boxes)], halves[len(boxes) :], strict=True):
        low, high = (0, 1) if along else (2, 3)
        others = [2, 3] if along else [0, 1]
        assert one[low] == box[low]
        assert two[high] == box[high]
        assert one[high] == two[low]
        assert box[low] <= one[high] <= box[high]
        assert np.all(one[others] == box[others])
        assert np.all(two[others] == box[others])


def test_a_box_lies_in_a_hole_only_with_all_its_points() -> None:
    holes = np.array([[0.0, 1, 0, 1], [2, 3, 2, 3]])
    boxes = np.array([[0, 1, 0, 1], [0.5, 1.1, 0.2, 0.3], [2.1, 2.2, 2.9, 3.0], [0, 0.1, -1e-9, 0.1], [1, 2, 1, 2.0]])
    assert inside(boxes, holes).tolist() == [True, False, True, False, False]
    assert not inside(boxes, NONE).any()


# --- slopes -----------------------------------------------------------------------------------------------------


def scaled_truth(family: Family, x: float, t: float) -> Callable[[Any, Any], Any]:
    """(h, k) ↦ R·F at x + h, t + k, F the function of the family, by the residue sums."""

    def at(h: Any, k: Any) -> Any:
        truth = truth_at(family, 1, 0.5, 50)
        mp = truth.mp
        q, place = mp.mpf(x) + h, mp.mpf(t) + k
        truth = truth_at(family, x, place, 50) if family.parameter != "level" else Truth(family.case, 50)
        if family.parameter != "level":
            return truth.resultant(q) * truth.delta(q)
        order, roots = range(len(truth.x)), truth.p_roots(q)
        kernels = [[truth._residue_sum(truth.x[i] - truth.x[j], q, roots) for j in order] for i in order]
        kappa = place * (1 + q * q)
        rows = [[(i == j) * (1 - place) - kappa * kernels[i][j] * truth.eta_m[j] for j in order] for i in order]
        return truth.resultant(q) * truth.mp.det(truth.mp.matrix(rows))

    return at


@families
def test_local_values_and_slopes_hold_the_truth(name: str) -> None:
    family, x, t = zero_of(name)
    rng = np.random.default_rng(9)
    x, t = x * 1.02, t * 0.99
    reaches = 2.0 ** -np.array([6.0, 10, 20])
    value, (along_x, along_t), good = local(family, (x, t), reaches)
    assert good.any()
    step = 1e-12
    for k in np.flatnonzero(good):
        u, v = rng.uniform(-1, 1, 2) * float(reaches[k])
        at = scaled_truth(family, x, t)
        slopes = (at(u + step, v) - at(u - step, v)) / (2 * step), (at(u, v + step) - at(u, v - step)) / (2 * step)
        for disc, exact in ((value, at(0, 0)), (along_x, slopes[0]), (along_t, slopes[1])):
            assert abs(exact - complex(disc.m[k])) <= float(disc.r[k]) + 1e-9 * (1 + abs(exact))


# --- many jobs, and a second parameter ----------------------------------------------------------------------------


def test_jobs_that_share_a_sweep_keep_their_zeros_and_leave_what_they_leave_alone() -> None:
    jobs = []
    for eta, alpha in ((20, 1.0), (30, 0.97), (60, 0.96)):
        family = Family(Case(alpha=0, eta_b="0.1", eta_m=(eta, eta), positions=(0, 1)), "alpha")
        x, t = (float(v) for v in approach(family, 0.2, alpha) or ())
        jobs.append((x, t, Job(family, np.array([[0.7 * x, 1.3 * x, 0.99 * t, 1.005 * t]]), NONE, 0, 9)))
    for (x, t, job), cover in zip(jobs, exclude_all([job for *_, job in jobs]), strict=True):
        held = cover.open
        assert ((held[:, 0] <= x) & (x <= held[:, 1]) & (held[:, 2] <= t) & (t <= held[:, 3])).any()
        assert np.allclose(held, exclude(job).open)


def test_no_box_in_three_dimensions_with_a_zero_is_free() -> None:
    """Masses t·20 at the distance d: the zero at each d of a row of distances, in boxes of any shape about it."""
    rng = np.random.default_rng(5)
    family = Family(Case(alpha="0.99", eta_b="0.1", eta_m=(20, 20), positions=(0, 1)), "mass", second="distance")
    for d in (0.9, 1.1, 1.3):
        alone = Family(Case(alpha="0.99", eta_b="0.1", eta_m=(20, 20), positions=(0, str(d))), "level")
        point = approach(alone, 0.2, 0.3)
        assert point is not None
        x, u = (float(v) for v in point)
        t = np.pi * (1 + x * x) * u / (1 - u) / (2 * x * x)
        widths = 10.0 ** rng.uniform(-9, -0.3, (6, 1500))
        sides = [(v - widths[2 * k] * v, v + widths[2 * k + 1] * v) for k, v in enumerate((x, t, d))]
        boxes = np.stack([side for pair in sides for side in pair], axis=1)
        free, axis = _tested([family], np.zeros(len(boxes), dtype=int), DiscField(), boxes)
        assert not free.any()
        assert set(np.unique(axis)) <= {0, 1, 2}
        beside = boxes + np.array([0, 0, 0.2 * t, 0.2 * t, 0, 0])
        small = (widths < 1e-3).all(axis=0)
        assert _tested([family], np.zeros(int(small.sum()), dtype=int), DiscField(), beside[small])[0].all()
