"""Counts against an independent table and contour; regions keep their exact sides, and arcs their roots."""

from __future__ import annotations

import json
import random
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from oracle_general.package import as_problem

from mpsolve.certificate.solve import certify_problem
from mpsolve.errors import EffortError, PrecisionError
from mpsolve.outcome import Status
from mpsolve.problem.problem import Problem
from mpsolve.problem.reduced import reduce_problem
from mpsolve.proof.effort import Effort
from mpsolve.spectrum.count import Count, count_roots
from mpsolve.spectrum.regions import Below, HalfPlane, Rectangle, Region
from mpsolve.tracks import EulerBernoulli, TwoLayer
from mpsolve.vehicles import Mass

TABLE = json.loads((Path(__file__).parents[1] / "data" / "general_counts.json").read_text())
ROWS = {str(row.get("seed", row.get("name"))): row for row in TABLE if "within" not in row}
SAMPLE = random.Random(5).sample(sorted(ROWS), 25)
PAPER = EulerBernoulli(EI="0.25", m=1, k=1, c="0.1")


def counted(problem: Problem, region: Region = HalfPlane(), seconds: float = 6) -> Count:  # noqa: B008 — frozen
    return count_roots(reduce_problem(problem), region, Effort(seconds=seconds), lambda *_: None)


def inside(row: dict[str, Any], radius: Fraction | None) -> int:
    """How many roots of the table have Im q < 0, and |q| < radius."""
    roots = [(float(re), float(im)) for re, im in row["roots"]]
    kept = [re for re, im in roots if im < 0 and (radius is None or abs(complex(re, im)) < float(radius))]
    return sum(1 if abs(re) < 1e-9 else 2 for re in kept)


def agrees(row: dict[str, Any]) -> bool | None:
    """Whether the count is the table's, None where it stays open."""
    try:
        count = counted(as_problem(row))
    except (PrecisionError, EffortError):
        return None
    assert isinstance(count.region, HalfPlane)
    return count.total == (row["count"] if count.region.radius is None else inside(row, count.region.radius))


@pytest.mark.parametrize("name", sorted({*SAMPLE, "78", "123"}))  # 78, 123: p-roots nearly meet
def test_the_count_is_that_of_the_table(name: str) -> None:
    may_stay_open = name in ("31", "111")  # see test_ice.py
    assert agrees(ROWS[name]) in ((True, None) if may_stay_open else (True,))


@pytest.mark.slow
@pytest.mark.parametrize("name", sorted(ROWS))
def test_no_count_contradicts_the_table(name: str) -> None:
    assert agrees(ROWS[name]) is not False


def pair(M: str, v: str, gap: str = "1") -> Problem:
    return Problem(PAPER, [Mass(M).at(0), Mass(M).at(gap)], v=v)


def unstable_root() -> complex:
    """The root with Im q < 0 of the pair below, from the whole half-plane."""
    found = certify_problem(pair("110", "1"), region="unstable", check=False)
    assert found.status is Status.UNVERIFIED
    assert found.unstable == 2
    return complex(found.roots[-1].q.mid())


@pytest.mark.parametrize("side", [-1, 1])
@pytest.mark.parametrize("share", ["1e-4", "1e-7"])
def test_a_disc_is_the_disc_and_no_polygon(side: int, share: str) -> None:
    """A radius a little above or below |q| of the root, where chords would cut it off."""
    radius = Fraction(abs(unstable_root())) * (1 + side * Fraction(share))
    count = counted(pair("110", "1"), HalfPlane(radius))
    assert count.region == HalfPlane(radius)
    assert count.total == (2 if side > 0 else 0)


@pytest.mark.parametrize("share", ["1e-5", "-1e-5"])
def test_a_height_and_sides_are_exact(share: str) -> None:
    q = unstable_root()
    edge = Fraction(q.imag) * (1 + Fraction(share))
    box = Rectangle(Fraction(q.real) / 3, Fraction(q.real) * 3, -2, edge)
    assert counted(pair("110", "1"), box).total == (0 if share[0] == "1" else 1)


@pytest.mark.parametrize("region", ["unstable", ("below", "0.01"), HalfPlane(Fraction(13, 10)),
                                    Rectangle("-1.7", "2.3", "-0.7", "0.01")])  # fmt: skip
@pytest.mark.parametrize("v", ["0", "0.3"])
def test_points_of_the_file_lie_on_the_sides(region: Any, v: str) -> None:
    found = certify_problem(pair("1", v), region=region, check=False)
    content = found.certificate.content
    points = [read(point) for path in content["paths"] for point in path["points"]]
    if isinstance(region, Rectangle):
        assert {(Fraction("-1.7"), Fraction("-0.7")), (Fraction("2.3"), Fraction("0.01"))} <= set(points)
    if isinstance(region, tuple):
        assert (Fraction(0), Fraction("0.01")) in points
    if isinstance(region, HalfPlane):
        assert {(Fraction(13, 10), Fraction(0)), (Fraction(0), -Fraction(13, 10))} <= set(points)
        arc = [complex(*map(float, p)) for p in points if p[0] and p[1]]
        assert max(abs(abs(z) - 1.3) for z in arc) < 1e-14


def read(point: list[Any]) -> tuple[Fraction, Fraction]:
    if len(point) == 2:
        return Fraction(point[0]), Fraction(point[1])
    m, n, e = point
    return Fraction(m) * Fraction(2) ** e, Fraction(n) * Fraction(2) ** e


def test_at_rest_below_a_height() -> None:
    """A pair at v = 0 against the strip counted by a rectangle."""
    height = Fraction(1, 25)
    count = counted(pair("40", "0"), Below(height))
    reach = count.region.reach
    box = counted(pair("40", "0"), Rectangle(-reach, reach, -1, height))
    assert count.total == box.total > 0


def test_a_radius_that_is_asked_for_is_kept() -> None:
    assert counted(pair("1", "0.3"), HalfPlane(Fraction(3))).region == HalfPlane(Fraction(3))


RATIO = st.fractions(Fraction(1, 30), 30, max_denominator=30)


@settings(max_examples=12, deadline=None)
@given(RATIO, RATIO, RATIO, st.permutations(range(3)))
def test_units_and_order_leave_the_count(length: Fraction, time: Fraction, mass: Fraction, order: list[int]) -> None:
    """Other units of length, time and mass, and vehicles given in any order."""
    line = mass / length  # of mass per length
    track = EulerBernoulli(
        EI=Fraction(1, 4) * mass * length**3 / time**2, m=line, k=line / time**2, c=Fraction(1, 10) * line / time
    )
    parts = [(Fraction(110), Fraction(0)), (Fraction(90), Fraction(1)), (Fraction(2), Fraction(5, 2))]
    vehicles = [Mass(parts[k][0] * mass).at(parts[k][1] * length) for k in order]
    count = counted(Problem(track, vehicles, v=length / time))
    assert count.beyond is not None
    assert count.total == 2


def test_a_train_run_backwards_has_other_roots_but_the_conjugate_symmetry_stays() -> None:
    """Roots come as q and −q̄: every root of the list has its mirror in it."""
    found = certify_problem(pair("110", "1"), region="unstable", check=False)
    roots = np.array([complex(root.q.mid()) for root in found.roots])
    assert np.abs(np.sort_complex(roots) - np.sort_complex(-roots.conj())).max() < 1e-12


@pytest.mark.parametrize(("v", "number"), [(0.6, 0), (1.6, 2)])
def test_sleepers_on_a_rail_that_alone_is_damped(v: float, number: int) -> None:
    """The whole half-plane, against the turn of det(1 − q²GM) by residues, from D as in books, to |q| = 12."""
    masses, eta = (10.0, 20.0), 0.1
    p = np.polynomial.Polynomial([0, 1])

    def delta(q: complex) -> complex:
        Omega = q - v * p
        sleepers = 3 - Omega**2
        D = (p**4 * (1 + 1j * eta * Omega) - Omega**2 + 2) * sleepers - 4
        roots = D.roots()
        weights = sleepers(roots) / D.deriv()(roots)
        up = roots.imag > 0
        here, ahead = (1j * np.sum(weights[up] * np.exp(1j * roots[up] * x)) for x in (0, 1))
        back = -1j * np.sum(weights[~up] * np.exp(-1j * roots[~up]))
        a, b = (1 - q**2 * m * here for m in masses)
        return complex(a * b - q**4 * masses[0] * masses[1] * ahead * back)

    arc = 12 * np.exp(-1j * np.linspace(np.pi / 2, 1e-7, 400))
    path = np.concatenate([np.linspace(12, 1e-3, 2000) - 1e-6j, -1j * np.geomspace(1e-3, 12, 300), arc])
    turns = np.array([delta(q) for q in path])
    steps = np.angle(turns[1:] / turns[:-1])
    assert np.abs(steps).max() < 2
    track = TwoLayer(EI=1, m=1, k_pad=2, m_sleeper=1, k_ballast=1, eta="0.1")
    problem = Problem(track, [Mass(10).at(0), Mass(20).at(1)], v=repr(v))
    found = certify_problem(problem, region="unstable", digits=15)
    assert (found.status, found.region, found.count) == (Status.PROVED, HalfPlane(), number)
    assert 2 * steps.sum() / (2 * np.pi) == pytest.approx(number, abs=0.05)
