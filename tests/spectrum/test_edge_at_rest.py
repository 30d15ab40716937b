"""The way past the branch points at rest: counts against residues in floats, and what discs must hold."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise
from typing import Any

import numpy as np
import pytest

from mpsolve import Case
from mpsolve.problem.cases import as_problem
from mpsolve.problem.line import Line, on_line
from mpsolve.problem.reduced import reduce_problem
from mpsolve.proof.effort import Effort
from mpsolve.spectrum.edge_at_rest import Edge, past_branch_points
from mpsolve.spectrum.sheet import count_sheet

CASES = [  # η_b, N, η_M, places: close together, heavy beside light, compressed, under tension, far apart
    ("0.2477", "0", ("1.987", "19.36"), ("0", "0.25051")),
    ("0.1676", "0", ("1.269", "0.3745", "7.436", "1.69"), ("0", "3.60709", "9.13979", "9.61286")),
    ("0.5", "0.1509", ("5.907", "0.4525"), ("0", "0.44419")),
    ("0.2", "0.85", ("2", "3", "5"), ("0", "1", "1.7")),
    ("0.4823", "-0.2646", ("0.1843", "25.22", "1.704"), ("0", "0.20418", "2.18766")),
    ("0.3", "-2", ("5",), ("0",)),
]


def made(eta_b: str, eta_n: str, eta_m: tuple[str, ...], places: tuple[str, ...]) -> Line:
    found = on_line(
        reduce_problem(as_problem(Case(alpha=0, eta_b=eta_b, eta_n=eta_n, eta_m=eta_m, positions=places)))
    )
    assert found is not None
    return found


def delta(z: Any, eta_b: float, N: float, masses: Any, places: Any) -> Any:
    """Δ of the paper's beam at rest by residues: p⁴/4 + … in P² is a quadratic; z = q − iη_b."""
    q = z + 1j * eta_b
    root = np.sqrt(16 * N**2 - 16 * (1 - eta_b**2 - z**2) + 0j)  # of P⁴ + 4N P² + 4(1 − η_b² − z²)
    P = np.sqrt(np.stack([(-4 * N + root) / 2, (-4 * N - root) / 2]))
    P = -P * np.sign(P.real)
    gap = np.abs(np.subtract.outer(places, places))
    G = (np.exp(P[..., None, None] * gap) / (P**3 + 2 * N * P)[..., None, None]).sum(0)
    return np.linalg.det(np.eye(len(masses)) - (q**2)[:, None, None] * G * np.array(masses))


def by_contour(eta_b: str, eta_n: str, masses: tuple[str, ...], places: tuple[str, ...]) -> float:
    """Roots below the line by a rectangle in floats, its upper side 10⁻⁷ below the edge; above it there is none."""
    given = (float(eta_b), float(eta_n), [float(x) for x in masses], np.array([float(x) for x in places]))
    edge = np.unique(np.concatenate([np.linspace(0, 40, 20_000), *(b + s * np.geomspace(1e-9, 2, 6_000)
        for s in (-1, 1) for b in np.sqrt(1 - given[0] ** 2 - np.array([0, max(given[1], 0) ** 2])))]))  # fmt: skip
    edge = edge[(edge >= 0) & (edge <= 40)]
    top = np.concatenate([-edge[::-1], edge]) - 1e-7j
    sides = [np.linspace(a, b, 8_000) for a, b in pairwise([40 - 1e-7j, 40 - 40j, -40 - 40j, -40 - 1e-7j])]
    value = delta(np.concatenate([top, *sides]), *given)
    steps = np.angle(value[1:] / value[:-1])
    assert np.abs(steps).max() < 0.6  # far below π
    return float(-steps.sum() / (2 * np.pi))


@pytest.mark.parametrize("row", CASES)
def test_the_count_against_a_contour_in_floats(row: tuple[Any, ...]) -> None:
    found = count_sheet(made(*row), Effort(evaluations=10**5))
    assert found.rest is not None
    assert found.total == pytest.approx(by_contour(*row), abs=0.02)


def test_undamped_masses_at_rest_vibrate_each_in_one_way() -> None:
    """Beside the cut, which begins at q = 1: as many pairs of real frequencies as heavy masses (Rayleigh)."""
    line = made("0", "0", ("8.056", "9.745", "23.8"), ("0", "0.53033", "3.639"))
    z = np.concatenate([np.geomspace(1e-3, 0.5, 4000), 1 - np.geomspace(0.5, 1e-12, 12_000)])
    value = delta(z + 0j, 0.0, 0.0, [8.056, 9.745, 23.8], np.array([0, 0.53033, 3.639])).real
    changes = int((value[1:] * value[:-1] < 0).sum())
    assert changes == 3
    assert count_sheet(line, Effort(evaluations=10**5)).total == 2 * changes


def test_roots_closer_to_a_branch_point_than_the_contour_are_counted_too() -> None:
    """A pair at 1.5·10⁻⁶ below the line and one at 1.7·10⁻¹³ (a half-disc of 10⁻³ in 40 digits holds both): 2 + 2."""
    row = ("0.3", "0.2", ("0.0001", "0.00002", "0.001"), ("0", "0.05", "0.1"))
    assert by_contour(*row) == pytest.approx(2, abs=0.02)
    assert count_sheet(made(*row), Effort(evaluations=10**5)).total == 4


@pytest.mark.parametrize("row", CASES)
def test_discs_hold_the_image_of_their_pieces(row: tuple[Any, ...]) -> None:
    line = made(*row)
    rest = past_branch_points(line, Effort(evaluations=10**5))
    edge = Edge(rest.halves, 1.0)
    EI, A, k, m = edge.beam
    assert list(rest.z) == sorted(rest.z)
    assert line.in_gap(rest.z[0])
    for (a, b), (u, w) in zip(pairwise(rest.z), pairwise(rest.u), strict=True):
        (middle,), (r,) = edge.discs(np.array([u]), np.array([w]))
        for part in range(21):
            z = a + (b - a) * Fraction(part, 20)
            pi = np.sqrt(complex((k - m * z * z) / EI))  # the limits from below have Im π² ≥ 0
            s = np.sqrt(2 * pi - float(A) + 0j)
            assert abs(s - middle) <= r * (1 + 1e-6)
