"""Boxes that lie along the curve where waves meet: few with little damping, and what they prove is so."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest

from mpsolve import Case, certify, crossings
from mpsolve.characteristic.boxes import Boxes
from mpsolve.numbers.quadratic import pairs
from mpsolve.outcome import Status
from mpsolve.problem.cases import as_problem
from mpsolve.progress import silent
from mpsolve.proof.effort import Effort
from mpsolve.proof.sheared import SLOPED, upright
from mpsolve.ranges.judge import KNOWN, NONZERO, OUTSIDE
from mpsolve.ranges.scope import Scope, scope_of
from mpsolve.ranges.search import Search

RANGE = {"alpha": (Fraction("1.02"), Fraction("1.03"))}


def pair(alpha: object = "0.5", eta_b: str = "0.0001") -> Case:
    return Case(alpha=alpha, eta_b=eta_b, eta_m=(70, 70), positions=(0, "1.5"))


@pytest.fixture(scope="module")
def scope() -> Scope:
    return scope_of(as_problem(pair()), RANGE)


def test_all_of_the_plane_is_covered_by_leaves_that_lie_along(scope: Scope) -> None:
    cover = Search(scope, 15).cover(Effort(evaluations=4000), silent)  # upright boxes: 8,300
    assert cover.reason is None
    tree = cover.tree
    leaf = tree.axis < 0
    kind, slope = tree.kind[leaf], tree.low[2, leaf]
    low, high = tree.low[:, leaf], tree.high[:, leaf]
    assert (tree.axis == SLOPED).any()
    assert (kind[slope != 0] == NONZERO).any()
    a, b = scope.corners
    for q, x in np.random.default_rng(1).uniform(a, b, (400, 2)):
        t = q - slope * x
        inside = (low[0] <= t) & (t <= high[0]) & (low[1] <= x) & (x <= high[1])
        assert set(kind[inside]) - {OUTSIDE}
    flat = upright(low, high)
    assert ((flat[1][0] < 0) | (flat[0][0] > b[0]))[kind == OUTSIDE].all()
    assert (kind == KNOWN).any()


def test_the_receptance_over_a_parallelogram_is_that_of_its_points(scope: Scope) -> None:
    """Against thin upright boxes, at random points; next to the curve too."""
    rng, boxes = np.random.default_rng(2), 60
    x = rng.uniform(0.511, 0.514, boxes)
    slope = rng.uniform(-4, 4, boxes)
    m = np.stack([rng.uniform(0.01, 0.3, boxes) - slope * x, x])
    r = np.stack([10.0 ** rng.uniform(-6, -4, boxes), 10.0 ** rng.uniform(-6, -4, boxes)])
    receptance = scope.matrix.receptance
    found = receptance(Boxes(m, r, slope=slope))
    assert found.good.sum() > 30
    for _ in range(10):
        u = rng.uniform(-1, 1, (2, boxes))
        t, at = m + r * u
        thin = receptance(Boxes(np.stack([t + slope * at, at]), np.zeros((2, boxes))))
        weights = np.stack([np.ones(boxes), *u, *(u[i] * u[j] for i, j in pairs(2))])
        value = np.einsum("kb,kb...->b...", weights, found.G.k)
        off = np.abs(value - thin.G.k[0]) - found.G.e - thin.G.e
        both = found.good & thin.good
        assert (off[both] <= 1e-9 * np.abs(thin.G.k[0][both])).all()


@pytest.mark.parametrize(
    ("eta_b", "most"), [("0.001", 12_000), pytest.param("0.0001", 40_000, marks=pytest.mark.slow)]
)
def test_little_damping_is_decided_and_the_counts_are_those_of_points(eta_b: str, most: int) -> None:
    """90,000 and more than 1,500,000 boxes, if all stand upright."""
    found = crossings(pair(eta_b=eta_b), over={"alpha": (0, 2)}, check=False)
    assert (found.proved, found.counts) == (True, (0, 2, 0, 2, 4)), found.reason
    assert found.cost.boxes < most
    ends = [0.5, 0.8, 0.95, 1.5, 1.95]
    assert all(a < float(one.value) < b for one, a, b in zip(found.crossings, ends, ends[1:], strict=False))
    for at, number in ((0.95, 0), (1.5, 2)):
        assert certify(pair(at, eta_b), region="unstable", check=False).unstable == number


@pytest.mark.parametrize(("eta_b", "low", "high"), [("0.001", "1.02", "1.06"), ("0.0001", "1.02", "1.03")])
def test_the_answer_has_a_certificate_that_holds(eta_b: str, low: str, high: str) -> None:
    """A bound of what short waves give that begins too low tells nothing, and is left out of it."""
    found = crossings(pair(eta_b=eta_b), over={"alpha": (low, high)})
    assert (found.status, found.counts) == (Status.PROVED, (0, 2)), found.note
    assert "s" in found.certificate.content["tree"]
