"""Strings without boxes: the formula, its sign at random points, and counts, certified and in floats."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from mpsolve import Problem, certify, crossings, prove_stable, tracks, vehicles
from mpsolve.ranges.on_string import FASTER, SLOWER, quiet
from mpsolve.ranges.parted import COMPLETE

WIRE = tracks.String(T=27000, m="1.07", k=500, c=2)  # waves run at 158.85
SPRUNG = vehicles.Oscillator(wheel=9, body=15, k=7000, c=30)
ONE = Problem(WIRE, [SPRUNG.at(0)], v=100)
TWO = Problem(WIRE, [SPRUNG.at(0), vehicles.Mass(20).at(30)], v=100)
BOGIE = Problem(WIRE, [vehicles.Bogie(wheel=9, frame=30, inertia=15, wheelbase=2, k=5000, c=9).at(0)], v=100)


def over(low: object, high: object, **more: tuple[int, int]) -> dict[str, tuple[Fraction, Fraction]]:
    free = {f"track.{name}": (Fraction(a), Fraction(b)) for name, (a, b) in more.items()}
    return {"v": (Fraction(low), Fraction(high))} | free  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("problem", "ranges", "why"),
    [
        (ONE, over(0, 158), SLOWER), (ONE, over(159, 400), FASTER), (ONE, over(150, 160), None),
        (TWO, over(0, 158), None), (TWO, over(159, 400), FASTER), (BOGIE, over(159, 400), None),
        (ONE, over(0, 140, T=(22000, 27000)), SLOWER), (ONE, over(0, 150, T=(22000, 27000)), None),
        (TWO, over(160, 170, T=(22000, 27000)), FASTER), (ONE, over(0, 100, c=(0, 2)), None),
    ],
)  # fmt: skip
def test_where_a_theorem_tells(
    problem: Problem, ranges: dict[str, tuple[Fraction, Fraction]], why: str | None
) -> None:
    assert quiet(problem, ranges) == why


def test_the_mobility_is_positive_real() -> None:
    """Against the p-roots of the dispersion themselves, at random strings and frequencies."""
    rng = np.random.default_rng(3)
    for n in range(600):
        T, m, k, c = rng.uniform(0.1, 4, 4)
        k, c = (0, c) if n % 3 == 0 else (k, 10 * c) if n % 3 == 1 else (k, 0.01 * c)
        v = rng.uniform(0, 0.999) * np.sqrt(T / m)
        sigma = rng.uniform(0.01, 2) * np.exp(1j * rng.uniform(-1.57, 1.57))
        ahead, behind, G = waves(T, m, k, c, v, sigma)
        assert (len(ahead), len(behind)) == (1, 1)
        disc = 4 * T * (m * sigma**2 + c * sigma + k) + v**2 * (c**2 - 4 * m * k)
        assert abs(G**2 * disc - 1) < 1e-8
        assert (sigma * G).real > 1e-9 * abs(sigma * G)


def test_faster_than_its_waves_none_run_ahead() -> None:
    rng = np.random.default_rng(4)
    for _ in range(300):
        T, m, k, c = rng.uniform(0.1, 4, 4)
        v = rng.uniform(1.001, 3) * np.sqrt(T / m)
        sigma = rng.uniform(0.01, 2) * np.exp(1j * rng.uniform(-1.57, 1.57))
        ahead, behind, _ = waves(T, m, k, c, v, sigma)
        assert (len(ahead), len(behind)) == (0, 2)


def waves(T: float, m: float, k: float, c: float, v: float, sigma: complex) -> tuple[Any, Any, complex]:
    """(The p-roots that decay ahead, those that decay behind, G(0) as the sum over the first.)"""
    D = np.array([-(T - m * v**2), -v * (2 * m * sigma + c), m * sigma**2 + c * sigma + k])
    roots = np.roots(D)
    ahead = roots[roots.real < 0]
    return ahead, roots[roots.real > 0], sum(1 / np.polyval(np.polyder(D), P) for P in ahead)


COUNTED = [(ONE, 120), (ONE, 158), (ONE, 160), (ONE, 250), (TWO, 170), (TWO, 300)]


@pytest.mark.parametrize(("problem", "v"), COUNTED)
def test_float_counts_agree(problem: Problem, v: int) -> None:
    """By the turns of the determinant round the right half-plane up to 300 rad/s."""
    assert quiet(problem, {"v": (Fraction(v), Fraction(v))}) is not None
    assert growing(problem, v) == 0


def test_faster_joined_bodies_grow() -> None:
    """A bogie, of which no theorem tells: its front wheel hands on what the rear one feels."""
    assert quiet(BOGIE, over(190, 210)) is None
    assert growing(BOGIE, 200) == 2


def growing(problem: Problem, v: float, reach: float = 300.0) -> float:
    """Roots with Re σ > 0.001 in a square, by floats and the p-roots one by one."""
    track, own = problem.track, problem.pencil
    T, m, k, c = (float(getattr(track, name)) for name in "Tmkc")
    M, C, K, B = (np.array(getattr(own, name), float) for name in "MCKB")
    x, h = np.array(own.places, float), np.array(own.h, float)
    xi = x[:, None] - x

    def determinant(s: complex) -> complex:
        D = np.array([-(T - m * v * v), -v * (2 * m * s + c), m * s * s + c * s + k])
        G = np.zeros(xi.shape, complex)
        for P in np.roots(D):
            there = xi >= 0 if P.real < 0 else xi < 0
            G += np.where(there, np.sign(-P.real) * np.exp(np.where(there, P * xi, 0)), 0) / np.polyval(
                np.polyder(D), P
            )
        return complex(np.linalg.det(np.block([[K + s * C + s * s * M, -B], [B.T, G + np.diag(h)]])))

    corners = np.array([0.001 - 1j * reach, reach - 1j * reach, reach + 1j * reach, 0.001 + 1j * reach])
    ends = zip(corners, np.roll(corners, -1), strict=True)
    way = np.concatenate([a + (b - a) * np.linspace(0, 1, 2000) for a, b in ends])
    steps = np.diff(np.unwrap(np.angle([determinant(s) for s in way])))
    assert np.abs(steps).max() < 1.5
    return round(float(steps.sum()) / (2 * np.pi), 6)


@pytest.mark.parametrize(("problem", "v"), COUNTED)
def test_certified_points_agree(problem: Problem, v: int) -> None:
    found = certify(problem.changed("v", v), region="unstable", digits=15, check=False)
    assert found.unstable == 0


def test_robust_in_the_whole_track() -> None:
    found = prove_stable(TWO, over={"v": (170, 300), "track.k": (400, 600), "gap[0]": (5, 50)})
    assert (found.stable, found.proved, found.note) == (True, True, FASTER)


def test_faster_crossings_are_listed_up_to_a_frequency() -> None:
    """The whole stays open, as nothing bounds the frequencies; floats count the same up to 300 rad/s."""
    found = crossings(BOGIE, over={"v": (222, 233)}, check=False)
    assert found.reason is not None
    assert found.reason.code == "passivity"
    assert found.counts is None
    assert found.known[COMPLETE] > 100
    (one,) = found.crossings
    assert one.direction == -2
    v = float(one.value)
    assert (growing(BOGIE, v - 20), growing(BOGIE, v + 40)) == (2, 0)
