"""The paper's stability numbers, each held against a ball: Sections 4.2 to 4.4, Figures 10b and 12."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest

from mpsolve import crossing_masses, cut_points
from mpsolve.stability.velocities import onset_velocity, unstable_velocities

# Section 4.2, undamped: the last velocity ratio of the grid 0.01 with both frequency pairs, printed
LAST_WITH_BOTH_PAIRS = {
    (40, "0.5"): "0.74",
    (40, "1"): "0.86",
    (40, "1.5"): "0.87",
    (40, "2"): "0.87",
    (40, "2.5"): "0.88",
    (40, "3"): "0.89",
    (40, "3.5"): "0.90",
    (40, "4"): "0.90",
    (40, "4.5"): "0.90",
    (10, "0.5"): "0.37",
    (10, "1"): "0.66",
    (10, "1.5"): "0.72",
}


@pytest.mark.parametrize(("eta_m", "d"), LAST_WITH_BOTH_PAIRS)
def test_the_last_velocity_with_both_pairs(eta_m: int, d: str) -> None:
    """All twelve are right: the line ends at one cut point, whose ball lies between two values of the grid."""
    found = cut_points(0, (eta_m, eta_m), (0, d), alpha=("0.01", "0.99"), digits=15)
    assert found.proved, found.reason
    (end,) = found
    assert (end.side, end.appears) == ("gap", False)
    low, high = float(end.alpha.lower()), float(end.alpha.upper())
    assert math.floor(100 * low) == math.floor(100 * high) == 100 * Fraction(LAST_WITH_BOTH_PAIRS[eta_m, d])


def test_the_ends_are_not_monotone_in_the_distance() -> None:
    """Against conclusion (vi), "the lower the distance, the lower the velocity": d = 1.5 lies above d = 2."""
    ends = [cut_points(0, (40, 40), (0, d), alpha=("0.8", "0.95"), digits=15)[0].alpha for d in ("1.5", "2")]
    assert ends[0] > ends[1]


@pytest.mark.parametrize(("d", "printed"), [("1", "0.97"), ("1.5", "0.67")])
def test_the_first_unstable_grid_velocity(d: str, printed: str) -> None:
    """Section 4.3, η_M = 70, η_b = 0.05."""
    found = onset_velocity("0.05", (70, 70), (0, d), digits=15)
    assert found.proved
    assert math.ceil(100 * float(found.alpha.lower())) == math.ceil(100 * float(found.alpha.upper()))
    assert math.ceil(100 * float(found.alpha.upper())) == 100 * Fraction(printed)


def test_the_window_between_two_unstable_ranges() -> None:
    found = unstable_velocities("0.05", (50, 50), (0, "1.5"), alpha=("0.5", "1.05"), digits=18)
    assert found.proved
    ends = [float(end.mid()) for interval in found for end in (interval.start, interval.end)]
    assert ends == pytest.approx([0.695843859249966725, 0.886090895755563193, 0.967198482398974872, 1.05])


@pytest.mark.parametrize(
    ("eta_b", "d", "eta"),
    [  # (η_b, distance that is critical for η_M = 70, limiting mass there): α = 0.99
        ("0.05", "1.239426", 33.1234),
        ("0.1", "1.219279", 20.7266),
        ("0.2", "1.190543", 13.7165),
        ("0.5", "1.123289", 9.2406),
        ("0.1", "1.1", 21.8854),
    ],
)
def test_the_limiting_masses_of_figure_10b(eta_b: str, d: str, eta: float) -> None:
    """The printed 21.9 for η_b = 0.1 is that of d = 1.1; at the critical distance 20.7 is enough."""
    found = crossing_masses("0.99", eta_b, (0, d), digits=15)
    assert found.proved
    assert found.counts[:2] == (0, 2)
    assert float(found[0].eta.mid()) == pytest.approx(eta, abs=1e-3)


FIGURE_12 = [  # η_b = 0.05: distance (None: one mass), η_M, onset; found by float64 search and Newton in mpmath
    (None, 10, 1.22846080),
    (None, 70, 1.07490046),
    ("0.5", 10, 1.14528110),
    ("0.5", 100, 1.02975358),
    ("1", 40, 0.99688378),
    ("1.25", 50, 0.93182219),
    ("1.25", 60, 0.80796861),
    ("1.5", 40, 0.73787694),
    ("1.75", 40, 1.03525133),
    ("1.75", 50, 0.60688284),
    ("2", 70, 1.04085421),
    ("2", 80, 0.47879923),
]


@pytest.mark.parametrize(
    ("d", "eta_m", "alpha"),
    [pytest.param(*row, marks=[] if k % 4 == 0 else pytest.mark.slow) for k, row in enumerate(FIGURE_12)],
)
def test_the_curves_of_figure_12(d: str | None, eta_m: int, alpha: float) -> None:
    """One mass and d = 0.5 never reach below 1; the curves of d = 1.25 to 2 jump where a tongue begins."""
    masses, places = ((eta_m,), (0,)) if d is None else ((eta_m, eta_m), (0, d))
    found = onset_velocity("0.05", masses, places, digits=15)
    assert found.proved
    assert float(found.alpha.mid()) == pytest.approx(alpha, abs=2e-8)
