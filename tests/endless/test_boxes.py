"""Boxes hold the row's receptance at each of their points; what they prove floats do not contradict."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from endless_rows import bogies, masses

from mpsolve.characteristic.discs import split
from mpsolve.characteristic.start import start
from mpsolve.endless.bloch import Bloch
from mpsolve.endless.boxes import ROUND, Boxes, LatticeArrays, covered
from mpsolve.endless.lattice import Lattice
from mpsolve.endless.row import Row
from mpsolve.errors import EffortError, PrecisionError
from mpsolve.proof.effort import Effort


@pytest.mark.parametrize("make", [masses, bogies])
def test_a_box_holds_the_sums_at_its_points(make: Callable[[str], Row]) -> None:
    row, rng = make("0.4"), np.random.default_rng(5)
    arrays, bloch = LatticeArrays.of(row), Bloch(row)
    m, r, off = np.array([0.2 + 0.3j, 0.6j, 0.05 + 0.25j]), np.full(3, 1e-3), np.full(3, 2e-2)
    theta = np.array([0.5, -2.0, 3.0])
    jet, good, told = arrays.on_arcs(split(arrays.D, m, r, bloch.upper), np.exp(1j * theta), off)
    assert good.all()
    assert told.all()
    places = row.reduced.places
    pairs = [(i, j, a - b) for i, a in enumerate(places) for j, b in enumerate(places)]
    lattice = Lattice(tuple(a for _, _, a in pairs), row.step)
    for _ in range(60):
        t = r * np.sqrt(rng.uniform(size=3)) * np.exp(2j * np.pi * rng.uniform(size=3))
        z = np.exp(1j * (theta + off * rng.uniform(-1, 1, size=3)))
        truth, _ = lattice.sums(bloch.terms(m + t), bloch.upper, z, float, np.exp)
        for (i, j, _), value in zip(pairs, truth, strict=True):
            assert (np.abs(jet.a[:, i, j] + jet.b[:, i, j] * t - value) <= jet.e[:, i, j] + 1e-12).all()
    assert (jet.e < 0.2 * np.abs(jet.a) + 0.2).all()


def test_a_regular_box_has_no_root_on_the_circle_and_a_box_with_one_does_not_pass() -> None:
    row = masses("0.3")
    boxes = Boxes(LatticeArrays.of(row), start(row.reduced.guide).up)
    z = Bloch(row).multipliers(1j * np.linspace(0.18, 0.26, 4001))[:, 2]
    k = int(np.argmin(np.abs(np.abs(z) - 1)))  # a root that crosses the circle
    q, theta = np.linspace(0.18, 0.26, 4001)[k], float(np.angle(z[k]))
    low, high = np.array([[q - 1e-4], [theta - 1e-3]]), np.array([[q + 1e-4], [theta + 1e-3]])
    test = boxes.regular(0j, 1 + 0j)
    assert not test(low, high)[0][0]
    assert test(low + np.array([[0], [1.0]]), high + np.array([[0], [1.0]]))[0][0]


def test_the_mean_over_all_bloch_numbers_is_the_track_alone() -> None:
    """(1/n) Σ over z of Ĝ(0, z) keeps G(kd) with k a multiple of n: for long steps it is G(0) alone."""
    row = masses("0.4")
    bloch, sigma, n = Bloch(row), np.array([0.4 + 0.3j]), 64
    lattice = Lattice((Fraction(0),), row.step)
    z = np.exp(2j * np.pi * np.arange(n) / n)
    mean = sum(lattice.sums(bloch.terms(sigma), bloch.upper, x, float, np.exp)[0][0] for x in z) / n
    alone = bloch.receptance(sigma, [Fraction(0)], slope=False)[0][0]
    assert abs(mean - alone)[0] < 1e-12


class Recorder:
    """Passes boxes whose longest side is short enough at their distance from a point."""

    def __init__(self, point: tuple[float, float]) -> None:
        self.point, self.passed = np.array(point)[:, None], list[Any]()

    def __call__(self, low: Any, high: Any) -> tuple[Any, Any]:
        near = np.abs(np.clip(self.point, low, high) - self.point).max(0)
        fine = (high - low).max(0) < near
        self.passed.append(np.concatenate([low[:, fine], high[:, fine]]).T)
        return fine, (high - low).argmax(0)


def test_the_boxes_that_passed_are_the_whole_without_overlap() -> None:
    test = Recorder((1.3, 9.0))
    count = covered(test, Effort(evaluations=10_000))
    boxes = np.concatenate(test.passed)
    assert count == len(boxes)
    assert abs(((boxes[:, 2:] - boxes[:, :2]).prod(1)).sum() - 2 * ROUND) < 1e-12
    points = np.random.default_rng(1).uniform((0, -ROUND), (1, ROUND), size=(400, 2))
    inside = (points[:, None] >= boxes[None, :, :2]) & (points[:, None] <= boxes[None, :, 2:])
    assert inside.all(2).any(1).all()


def test_a_place_where_no_box_passes_is_named() -> None:
    with pytest.raises(PrecisionError, match=r"do not pass near τ = 0\.(29999|3).*, θ = 0\.(69999|7)"):
        covered(Recorder((0.3, 0.7)), Effort(evaluations=10**6))


def test_the_effort_ends_the_work() -> None:
    with pytest.raises(EffortError, match="the effort of 20 evaluations is spent"):
        covered(Recorder((0.3, 0.7)), Effort(evaluations=20))
