"""Random problems of every model: float counts on both sides of every proved boundary are what is claimed there.

The counts are those of `frequencies`, which shares neither boxes nor models with the proofs.
"""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise

import numpy as np
import pytest
from track_models import DAMPED
from vehicle_models import TYPICAL

from mpsolve import Effort, Problem, frequencies, vehicles
from mpsolve.batch.count import MAX_STEP
from mpsolve.ranges.crossings import crossings
from mpsolve.ranges.onset import Kind, onset
from mpsolve.ranges.unstable import unstable_ranges

# m/s up to which is asked, and kg of a typical mass; floating ice is left open by the proof
MODELS = {
    "string": (120, 10), "euler-bernoulli": (400, 3000), "rayleigh": (400, 3000), "timoshenko": (350, 3000),
    "two-layer": (1200, 3000), "three-layer": (90, 3000), "slab": (700, 3000),
}  # fmt: skip
OFFSETS = (0.02, 0.5, 0.98)


def problem_of(name: str, rng: np.random.Generator) -> Problem:
    def between(low: float, high: float) -> Fraction:
        return Fraction(round(float(rng.uniform(low, high)), 3))

    top, mass = MODELS[name]
    first = mass * between(0.3, 3)
    contacts = [vehicles.Mass(first).at(0)]
    if rng.uniform() < 0.7:
        contacts.append(vehicles.Mass(first * between(0.6, 1.5)).at(between(1.5, 4)))
    return Problem(DAMPED[name], contacts, v=top * between(0.4, 1))


def vehicle_of(kind: str, rng: np.random.Generator, path: str) -> Problem:
    """One of this kind on a rail, each of its numbers up to twice or half the typical one, and a wheel behind it."""
    track = DAMPED["euler-bernoulli" if path == "v" else "two-layer"]
    problem = Problem(track, [vehicles.Mass(1000).at(-3), TYPICAL[kind].at(0)], v=300)
    for name, value in problem.parameters.items():
        if name.startswith("vehicles[1].") and value:
            problem = problem.changed(name, value * Fraction(round(float(2 ** rng.uniform(-1, 1)), 3)))
    return problem


@pytest.mark.parametrize("path", ["v", "scale.mass"])
@pytest.mark.parametrize("kind", [kind for kind in TYPICAL if kind != "matrices"])
def test_counts_of_every_vehicle(kind: str, path: str) -> None:
    problem = vehicle_of(kind, np.random.default_rng([7, *kind.encode()]), path)
    assert_counts(problem, path, (60, 400) if path == "v" else ("0.2", 5))


@pytest.mark.parametrize("path", ["v", "scale.mass"])
@pytest.mark.parametrize("seed", [0, 1])
@pytest.mark.parametrize("name", MODELS)
def test_counts_on_both_sides_of_each_boundary(name: str, seed: int, path: str) -> None:
    problem = problem_of(name, np.random.default_rng([seed, *name.encode()]))
    top = MODELS[name][0]
    assert_counts(problem, path, (Fraction(top, 5), top) if path == "v" else ("0.2", 3))


@pytest.mark.parametrize(("name", "seed", "path"), [
    pytest.param(name, seed, path, marks=() if (k + seed) % 4 == 0 and path == "v" else pytest.mark.slow)
    for k, name in enumerate(MODELS) for seed in (2, 3, 4, 5) for path in ("v", "scale.mass")
])  # fmt: skip
def test_the_first_onset_and_every_unstable_range(name: str, seed: int, path: str) -> None:
    problem = problem_of(name, np.random.default_rng([seed, *name.encode()]))
    top = MODELS[name][0]
    assert_ranges(problem, path, (Fraction(top, 5), top) if path == "v" else ("0.2", 3))


@pytest.mark.parametrize(("kind", "path"), [
    pytest.param(kind, path, marks=() if (kind, path) == ("oscillator", "v") else pytest.mark.slow)
    for kind in TYPICAL if kind != "matrices" for path in ("v", "scale.mass")
])  # fmt: skip
def test_the_same_of_every_vehicle(kind: str, path: str) -> None:
    problem = vehicle_of(kind, np.random.default_rng([8, *kind.encode()]), path)
    assert_ranges(problem, path, (60, 400) if path == "v" else ("0.2", 5))


def assert_ranges(problem: Problem, path: str, over: tuple[object, object]) -> None:
    """Floats see roots grow inside of the unstable ranges and nowhere else, and none before the onset."""
    effort = Effort(seconds=60)
    found = unstable_ranges(problem, over={path: over}, check=False, effort=effort)
    assert found.proved
    low, high = (float(end) for end in found.over[path])
    ends = [low, *(float(end) for one in found.intervals for end in (one.start, one.end)), high]
    told = [
        (a + share * (b - a), bool(k % 2)) for k, (a, b) in enumerate(pairwise(ends)) for share in OFFSETS if a < b
    ]
    seen = frequencies(problem, {path: [Fraction(at) for at, _ in told]}, roots=False)
    known = seen.status == "ok"
    assert known.mean() > 0.6
    assert ((seen.count > 0) == np.array([grows for _, grows in told]))[known].all()
    first = onset(problem, over={path: over}, check=False, effort=effort)
    assert first.proved
    if first.kind is Kind.CROSSES:
        assert first.value.overlaps(found.intervals[0].start)
    else:
        assert (first.kind is Kind.STABLE) == (not found.intervals)


def assert_counts(problem: Problem, path: str, over: tuple[object, object]) -> None:
    """Floats count by steps of the argument of at most 0.5."""
    assert MAX_STEP <= 0.5
    found = crossings(problem, over={path: over}, check=False, effort=Effort(seconds=60))
    assert found.counts is not None
    low, high = found.over[path]
    ends = [float(low), *(float(c.value) for c in found.crossings), float(high)]
    points = [Fraction(a + share * (b - a)) for a, b in pairwise(ends) for share in OFFSETS]
    seen = frequencies(problem, {path: points}, roots=False)
    known = seen.status == "ok"
    assert known.mean() > 0.6
    claimed = np.repeat(found.counts, len(OFFSETS))
    assert (seen.count[known] == claimed[known]).all()
