"""The edge in arrays against the sheet next to it, and float64 counts against proved ones."""

from __future__ import annotations

from typing import Any

import mpmath
import numpy as np
import pytest
from oracle import Truth

from mpsolve import Case
from mpsolve.fast import count as count_module
from mpsolve.fast.cases import Cases, largest_real_root
from mpsolve.fast.count import _halved, count_roots
from mpsolve.fast.edge import edge_values
from mpsolve.fields import Float64
from mpsolve.model.limits import limiting_frequency
from mpsolve.sheet.count import count_roots as proved_count


def random_cases(n: int, seed: int) -> Cases:
    rng = np.random.default_rng(seed)
    eta_b = rng.uniform(0, 0.95, n).round(3)
    axial = np.where(rng.random(n) < 0.5, 0, rng.uniform(-2, 0.95, n) * np.sqrt(1 - eta_b**2)).round(3)
    eta = (10 ** rng.uniform(-1, 2, (2, n))).round(3)
    return Cases(rng.uniform(0, 1.5, n).round(3), axial, eta_b, *eta, (10 ** rng.uniform(-1.3, 0.7, n)).round(3))


def test_largest_real_root_of_cubics_with_known_roots() -> None:
    rng = np.random.default_rng(1)
    x, y, z = rng.normal(size=(3, 200))
    real = largest_real_root(-(x + y + z), x * y + y * z + z * x, -x * y * z)
    assert np.allclose(real, np.max([x, y, z], axis=0), rtol=1e-7, atol=1e-7)
    one = largest_real_root(-(x + 2 * y), 2 * x * y + y * y + z * z, -x * (y * y + z * z))  # x, y ± iz
    assert np.allclose(one, x, rtol=1e-9, atol=1e-9)


def test_values_on_the_edge_are_limits_from_the_sheet() -> None:
    """R·Δ by the residue sums in mpmath, at a distance of 1e-12 on either side of the cut."""
    cases = random_cases(40, 2)
    r = np.maximum(cases.limit, 0) + np.random.default_rng(3).uniform(0.05, 3, 40)
    plus, minus = edge_values(cases, r)
    for k in range(40):
        truth = Truth(cases.exact(k), 40)
        for side, value in ((-1, plus[k]), (1, minus[k].conj())):
            q = truth.mp.mpc(r[k], truth.eta_b + side * truth.mp.mpf(10) ** -12)
            expected = complex(truth.delta(q) * truth.resultant(q))
            assert abs(value - expected) < 1e-8 * abs(expected)


def test_the_limit_is_that_of_the_exact_case() -> None:
    cases = random_cases(60, 4)
    for k in range(60):
        expected = float(limiting_frequency(cases.exact(k), Float64()))
        assert abs(cases.limit[k] - expected) < 1e-9


def test_counts_are_the_proved_ones() -> None:
    cases = random_cases(25, 5)
    counts = count_roots(cases).count
    for k in range(25):
        assert counts[k] == proved_count(cases.exact(k), "sheet", 200_000, lambda *_: None).total


@pytest.mark.parametrize("eta_m", [1e-3, 0.01, 0.1])
def test_a_light_mass_keeps_its_roots_next_to_the_branch_point(eta_m: float) -> None:
    """Without damping a light mass has one pair, at a distance like η_M² from q_lm."""
    one = np.ones(1)
    assert count_roots(Cases(0.5 * one, 0 * one, 0 * one, eta_m * one, 0 * one, one)).count[0] == 2


def test_a_root_on_the_edge_is_no_count() -> None:
    """A cut point: at η_b = 0 a line ends where R·Δ(q_lm) = 0; both sides of it differ by a pair of roots."""
    low, high = 0.6, 0.99
    eta, d = np.full(1, 10.0), np.full(1, 2.0)

    def count(alpha: float) -> int:
        at = np.full(1, alpha)
        return int(count_roots(Cases(at, 0 * at, 0 * at, eta, eta, d)).count[0])

    assert count(low) == 4
    assert count(high) == 2
    while high - low > 1e-15:
        middle = (low + high) / 2
        if not low < middle < high:
            break
        found = count(middle)
        assert found in (4, 2, -1)
        if found == -1:
            return
        low, high = (middle, high) if found == 4 else (low, middle)
    case = Case(alpha=low, eta_b=0, eta_m=(10, 10), positions=(0, 2))
    assert proved_count(case, "sheet", 200_000, lambda *_: None).total in (2, 4)


@pytest.mark.parametrize("z", [0.3 + 0.2j, -2 + 0.5j, 1e-3j, 9e-4, 2e-5 - 1e-6j, 0.0])
def test_one_minus_exp_by_its_series_and_apart(z: complex) -> None:
    """(1 − e^{izx})/z, alone and in an array with a point next to 0."""
    x = 1.1
    exact = -1j * x if z == 0 else complex(-mpmath.expm1(1j * mpmath.mpc(z) * x) / z)
    assert abs(Float64().one_minus_exp(np.array([z]), x)[0] - exact) < 1e-12 * abs(exact)
    assert abs(Float64().one_minus_exp(np.array([z, 0.0]), x)[0] - exact) < 1e-12 * abs(exact)


@pytest.mark.parametrize(
    ("alpha", "d"), [(1e5, 1.0), (1e12, 1.0), (0.5, 1e-30), (0.5, 1e12)], ids=["fast", "faster", "near", "far"]
)
def test_a_case_far_out_of_use_takes_few_pieces(alpha: float, d: float, monkeypatch: pytest.MonkeyPatch) -> None:
    """It gets no count, soon; one beside it keeps its own."""
    made = [0]

    def halved(cases: Cases, pieces: Any) -> Any:
        made[0] += len(pieces.which)
        return _halved(cases, pieces)

    monkeypatch.setattr(count_module, "_halved", halved)
    one = np.ones(2)
    with np.errstate(all="ignore"):
        counts = count_roots(
            Cases(one * [alpha, 0.67], 0 * one, 0.05 * one, 70 * one, 70 * one, one * [d, 1.5])
        ).count
    assert counts.tolist() == [-1, 4]
    assert made[0] < 10_000


def test_pieces_are_halved_a_part_at_a_time(monkeypatch: pytest.MonkeyPatch) -> None:
    cases = random_cases(25, 5)
    expected = count_roots(cases).count
    monkeypatch.setattr(count_module, "_MANY", 7)
    assert np.array_equal(count_roots(cases).count, expected)
