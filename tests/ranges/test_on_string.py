"""Strings without boxes: the formula, its sign at random points, and counts that are certified on both sides."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest

from mpsolve import Problem, certify, tracks, vehicles
from mpsolve.ranges.on_string import FASTER, SLOWER, quiet
from mpsolve.ranges.robust import prove_stable

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
    for _ in range(500):
        T, m, k, c = rng.uniform(0.1, 4, 4)
        v = rng.uniform(0, 0.999) * np.sqrt(T / m)
        sigma = rng.uniform(0, 2) * np.exp(1j * rng.uniform(-1.57, 1.57))
        D = np.array([-(T - m * v**2), -v * (2 * m * sigma + c), m * sigma**2 + c * sigma + k])
        upper = min(np.roots(D), key=lambda P: P.real)  # decays ahead
        G = -1 / np.polyval(np.polyder(D), upper)
        disc = 4 * T * (m * sigma**2 + c * sigma + k) + v**2 * (c**2 - 4 * m * k)
        assert abs(abs(G) - abs(disc) ** -0.5) < 1e-9 * abs(G)
        assert (sigma * abs(G) * np.exp(1j * np.angle(-G))).real > -1e-12 or (sigma * G).real > -1e-12


@pytest.mark.parametrize(("problem", "v"), [(ONE, 120), (ONE, 158), (ONE, 160), (ONE, 250), (TWO, 170), (TWO, 300)])
def test_certified_points_agree(problem: Problem, v: int) -> None:
    found = certify(problem.changed("v", v), region="unstable", digits=15, check=False)
    assert found.unstable in (0, None)


def test_robust_in_the_whole_track() -> None:
    found = prove_stable(TWO, over={"v": (170, 300), "track.k": (400, 600), "gap[0]": (5, 50)})
    assert (found.stable, found.proved, found.note) == (True, True, FASTER)
