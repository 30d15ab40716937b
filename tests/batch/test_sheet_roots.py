"""Roots on the whole sheet against the oracle's residue sums, and their symmetry."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from oracle import Truth
from sheet_cases import case, drawn, halves

from mpsolve.batch.sheet_count import count_sheet
from mpsolve.batch.sheet_roots import SheetSearch, distinct, edge_guesses, grid_guesses, polish, whole_sheet

PLAIN = {"track.N": 0.0, "track.kp": 0.0}


def solved(change: dict[str, Any], size: int) -> tuple[list[Any], dict[str, Any]]:
    """The roots of each entry, and what was asked."""
    entries, over = drawn(size, 1, PLAIN | change)
    out: list[Any] = [None] * size
    with np.errstate(all="ignore"):
        for part in halves(entries):
            search = SheetSearch(part, count_sheet(part))
            good = search.solve()
            q = whole_sheet(part, search.z) * part.unit[:, None]
            for row, k in enumerate(part.index.tolist()):
                out[k] = q[row, : search.edge.count[row]] if good[row] else None
    return out, over


def assert_true(roots: Any, over: dict[str, Any], k: int, bound: float, digits: int = 30) -> None:
    truth = Truth(case(over, k), digits)
    exact = [complex(truth.root(q)) for q in roots]
    for q, root in zip(roots, exact, strict=True):
        separation = min([abs(root - other) for other in exact if other != root]) / abs(root)
        assert abs(q - root) < bound * abs(root) / min(separation, 1)


@pytest.mark.parametrize(
    ("alpha", "eta_b", "mass", "d", "axial"),
    [
        (1.3, 0.1, 25.0, 3.0, 0.0),
        (0.5, 0.2, 30.0, 0.7, 0.6),
        (0.8, 0.0, 5.0, 2.0, -0.8),
        (1.1, 0.7, 0.5, 1.0, 0.4),
        (0.0, 0.1, 12.0, 1.5, 0.0),
    ],
)
def test_roots_are_those_of_the_residue_sums(alpha: float, eta_b: float, mass: float, d: float, axial: float) -> None:
    """As many as the oracle's own search finds, and at the same places."""
    change = {"v": alpha, "track.c": 2 * eta_b, "vehicles.M": mass, "gap[0]": d - np.array([0.02, 0.01, 0.0])}
    found, over = solved(change | {"track.N": max(axial, 0), "track.kp": max(-axial, 0)}, 3)
    roots = found[2]
    assert all(min(abs(q - one) for one in roots) < 1e-8 * abs(q) for q in Truth(case(over, 2), 30).search(40.0))
    assert_true(roots, over, 2, 1e-12)


@pytest.mark.parametrize("tension", [1e2, 1e4, 1e5])
def test_strong_tension_costs_no_digits(tension: float) -> None:
    """Two p-roots are small beside the other two, and are not what is left of them in a difference."""
    change = {"v": 0.7, "track.c": 0.4, "vehicles.M": 40.0, "gap[0]": 2.0, "track.kp": tension}
    (roots,), over = solved(change, 1)
    assert len(roots) >= 2
    assert_true(roots, over, 0, 1e-13, 40)


def test_roots_that_nearly_meet_are_all_found() -> None:
    """Masses far apart on a damped beam: pairs 6e-5 apart, and cavity roots along the cut, as many as counted."""
    found, over = solved({"v": np.array([0.3, 0.31, 0.32]), "track.c": 0.8, "vehicles.M": 3.0, "gap[0]": 15.0}, 3)
    assert [len(roots) for roots in found] == [10, 10, 10]
    assert_true(found[1], over, 1, 1e-13)


@pytest.mark.parametrize("eta_b", [0.0, 0.25, 0.7])
def test_symmetry_of_the_sheet(eta_b: float) -> None:
    """Roots in pairs q, −q̄, and for η_b = 0 in pairs q, q̄; a real root there is exactly real."""
    found, _ = solved({"v": np.linspace(0.1, 1.4, 9) + 0.003, "track.c": 2 * eta_b}, 9)
    assert sum(roots is not None and len(roots) > 0 for roots in found) > 5
    for roots in (one for one in found if one is not None):
        images = [-q.conjugate() for q in roots] + ([q.conjugate() for q in roots] if eta_b == 0 else [])
        assert all(q in roots for q in images)
        assert roots.tolist() == sorted(roots.tolist(), key=lambda q: (q.real, q.imag))


def test_steps_from_near_a_root_and_what_is_divided_out() -> None:
    entries, _ = drawn(1, 1, PLAIN | {"v": 0.67, "track.c": 0.1, "vehicles.M": 70.0, "gap[0]": 1.5})
    (part,) = halves(entries)
    search = SheetSearch(part, count_sheet(part))
    assert search.solve().all()
    root = search.z[0, 0]
    rows = np.zeros(1, int)
    again = polish(part, rows, np.array([root * 1.001]))
    assert abs(again[0] - root) < 1e-12 * abs(root)
    elsewhere = polish(part, rows, np.array([root * 1.001]), np.array([[root]]), 40)
    assert not abs(elsewhere[0] - root) < 1e-6
    assert np.isnan(polish(part, rows, np.array([np.nan + 0j]))).all()


def test_guesses_are_in_the_right_half_plane_and_one_root_is_one() -> None:
    entries, _ = drawn(6, 3)
    for part in halves(entries):
        rows = np.arange(len(part))
        assert (grid_guesses(part, rows).real > -1e-12).all()
        near = edge_guesses(part, rows, count_sheet(part), 12)
        assert near.shape[0] == len(part)
        twice = np.array([[0.3 - 0.1j, 0.3 - 0.1j + 1e-12, np.nan, 0.5 + 0.1j]] * len(part))
        assert np.isfinite(distinct(part, rows, twice, 4)).sum(1).tolist() == [2] * len(part)
