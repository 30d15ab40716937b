"""Random charts of every model: float counts in its areas and on both sides of every curve are what is claimed there.

The default run takes one chart of each model, seeded; `-m slow` takes more pairs of parameters and seeds.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from test_both_sides import MODELS, problem_of, vehicle_of
from track_models import DAMPED
from vehicle_models import TYPICAL

from mpsolve import Problem, frequencies
from mpsolve.ranges.chart import Chart, stability_chart

ASIDE = 2e-3  # of the chart
SECOND = ("scale.mass", "track.c", "track.k")
OF_VEHICLES = {
    "mass": "vehicles[1].M", "oscillator": "vehicles[1].k", "bogie": "vehicles[1].k2", "coach": "vehicles[1].k2",
}  # fmt: skip


RICH = {"two-layer", "three-layer", "slab", "coach"}
"""Whose charts take long: the default run has smaller ones."""


def ranges(problem: Problem, path: str, top: float, small: bool) -> dict[str, Any]:
    """The velocity, and half to twice the other parameter's value."""
    own = problem.parameters[path]
    low, high = (own * 9 / 10, own * 11 / 10) if small else (own / 2, own * 2)
    return {"v": (top * 3 / 5, top * 4 / 5) if small else (top * 2 / 5, top), path: (low, high)}


def other_of(name: str, index: int) -> str:
    """A parameter of the track, or the factor of all masses."""
    known = Problem(DAMPED[name], problem_of(name, np.random.default_rng(0)).vehicles, v=1).parameters
    paths = [path for path in (*SECOND, "track.k_ballast", "track.c_pad", "track.k_ground") if path in known]
    return paths[index % len(paths)]


def cases(slow: bool) -> list[Any]:
    """(name, other parameter, seed)."""
    tracks = list(enumerate(MODELS))
    if not slow:
        return [(name, other_of(name, k), 2 if name == "slab" else 0) for k, name in tracks]
    return [(name, other_of(name, k + more), seed) for k, name in tracks for more in (0, 1, 2) for seed in (1, 2)]


@pytest.mark.parametrize(("name", "path", "seed"), cases(False))
def test_charts_of_every_track(name: str, path: str, seed: int) -> None:
    on_track(name, path, seed, name in RICH)


@pytest.mark.slow
@pytest.mark.parametrize(("name", "path", "seed"), cases(True))
def test_more_charts_of_every_track(name: str, path: str, seed: int) -> None:
    on_track(name, path, seed)


@pytest.mark.parametrize("kind", OF_VEHICLES)
def test_charts_of_every_vehicle(kind: str) -> None:
    with_vehicle(kind, 0, kind in RICH)


@pytest.mark.slow
@pytest.mark.parametrize("seed", [1, 2, 3])
@pytest.mark.parametrize("kind", OF_VEHICLES)
def test_more_charts_of_every_vehicle(kind: str, seed: int) -> None:
    with_vehicle(kind, seed)


def test_no_model_is_left_out() -> None:
    assert set(DAMPED) - set(MODELS) == {"floating-ice"}
    assert set(TYPICAL) - set(OF_VEHICLES) == {"matrices"}  # of which test_meeting has charts


def on_track(name: str, path: str, seed: int, small: bool = False) -> None:
    problem = problem_of(name, np.random.default_rng([seed, *name.encode()]))
    assert_chart(problem, ranges(problem, path, MODELS[name][0], small), seed)


def with_vehicle(kind: str, seed: int, small: bool = False) -> None:
    problem = vehicle_of(kind, np.random.default_rng([seed, *kind.encode()]), "v")
    assert_chart(problem, ranges(problem, OF_VEHICLES[kind], 400, small), seed)


def assert_chart(problem: Problem, over: dict[str, Any], seed: int) -> None:
    found = stability_chart(problem, over=over, depth=3, check=False)
    if found.reason is not None and found.reason.code == "passivity":  # a string of which far too much is asked
        assert not found.share
        return
    assert found.share > 0.5
    rng = np.random.default_rng(seed)
    cells = rng.permutation(np.argwhere(found.detail >= 0))[:60]
    share = (cells + rng.uniform(size=cells.shape)) / found.detail.shape
    counts, known = floats(found, share.T)
    assert known.mean() > 0.6
    assert (counts[known] == found.detail[tuple(cells.T)][known]).all()
    told = [assert_sides(found, curve, rng) for curve in found.boundaries]
    assert sum(told) > 0 or not told or not found.traced


def assert_sides(found: Chart, curve: Any, rng: np.random.Generator) -> int:
    """At points of a curve: one root more on one side, if it has q = 0, else two."""
    place = np.stack([
        (v - float(edges[0])) / float(edges[-1] - edges[0])
        for v, edges in zip((curve.x, curve.y), (found.x, found.y), strict=True)
    ])  # fmt: skip
    inside = np.flatnonzero(((place > 2 * ASIDE) & (place < 1 - 2 * ASIDE)).all(0)[1:-1]) + 1
    chosen = rng.permutation(inside)[:6]
    way = place[:, chosen + 1] - place[:, chosen - 1]
    aside = np.stack([way[1], -way[0]]) / np.hypot(*way) * ASIDE
    (one, first), (other, second) = (floats(found, place[:, chosen] + sign * aside) for sign in (1, -1))
    known = first & second & alone(found, curve, place[:, chosen])
    assert (np.abs(one - other)[known] == (1 if curve.divergence else 2)).all()
    return int(known.sum())


def alone(found: Chart, curve: Any, points: Any) -> Any:
    """Points that no other curve, and no other part of this one, passes within four times the distance."""
    out = np.ones(points.shape[1], bool)
    for one in found.boundaries:
        line = np.stack([
            (v - float(edges[0])) / float(edges[-1] - edges[0])
            for v, edges in zip((one.x, one.y), (found.x, found.y), strict=True)
        ])  # fmt: skip
        apart = np.hypot(*(line[:, None, :] - points[:, :, None]))
        near = apart < 4 * ASIDE
        if one is curve:  # the part next to the point is one stretch
            near = np.diff(np.pad(near, ((0, 0), (1, 1))).astype(int), axis=1) > 0
            out &= near.sum(1) <= 1
        else:
            out &= ~near.any(1)
    return out


def floats(found: Chart, share: Any) -> tuple[Any, Any]:
    """(Counts in floats at shares of the chart, which are told)."""
    points = [float(e[0]) + s * float(e[-1] - e[0]) for s, e in zip(share, (found.x, found.y), strict=True)]
    seen = frequencies(found.problem, dict(zip(found.over, points, strict=True)), roots=False)
    return seen.count, seen.status == "ok"
