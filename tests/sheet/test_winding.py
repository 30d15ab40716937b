"""Counts of induced frequencies: as many as (26), (37) have by a search of their own, and they add up."""

from __future__ import annotations

from typing import Any

import pytest
from oracle import Truth

from mpsolve import Case, Rectangle
from mpsolve.errors import PrecisionError
from mpsolve.fields import ball_arithmetic
from mpsolve.model.branch import track
from mpsolve.sheet.count import count_roots
from mpsolve.sheet.far import far_radius
from mpsolve.sheet.winding import count_rectangle, count_sheet, count_unstable

LIMIT = 100_000
PAIR = {"eta_m": (70, 70), "positions": (0, "1.5")}
CASES = {
    "one mass": {"alpha": "0.5", "eta_b": "0.05", "eta_m": 70},
    "one mass, supercritical": {"alpha": "1.2", "eta_b": "0.05", "eta_m": 10},
    "subcritical": {"alpha": "0.67", "eta_b": "0.05", **PAIR},
    "subcritical, undamped": {"alpha": "0.5", "eta_b": 0, **PAIR},
    "close, slow": {"alpha": "0.1", "eta_b": 0, "eta_m": (10, 10), "positions": (0, "0.5")},
    "supercritical": {"alpha": "1.2", "eta_b": "0.05", **PAIR},
    "supercritical, undamped": {"alpha": "1.4", "eta_b": 0, "eta_m": (40, 40), "positions": (0, "4.5")},
    "unequal, compressed": {"alpha": "0.4", "eta_b": "0.1", "eta_n": "0.3", "eta_m": (70, 7), "positions": (0, 2)},
    "on a Pasternak layer": {"alpha": "1.1", "eta_b": "0.2", "eta_s": "0.5", "eta_m": (70, 20), "positions": (0, 3)},
    "one mass, supercritical, undamped": {"alpha": "1.2", "eta_b": 0, "eta_m": 70},
}
named = pytest.mark.parametrize("name", CASES)


def both(roots: list[complex]) -> list[complex]:
    """With the mirror images −q̄, once where q is imaginary."""
    return [w for z in roots for w in ({z, -z.conjugate()} if abs(z.real) > 1e-9 else {z})]


@named
def test_the_sheet_holds_what_a_search_finds(name: str) -> None:
    case = Case(**CASES[name])
    count = count_roots(case, "sheet", LIMIT, lambda *_: None)
    assert count.contour == "edge"
    assert count.radius is not None
    found = both(Truth(case, 15).search(count.radius))
    assert count.total == len(found)


@pytest.mark.parametrize("name", ["one mass", "one mass, supercritical", "subcritical", "unequal, compressed"])
def test_the_unstable_ones_are_counted_on_the_real_line(name: str) -> None:
    case = Case(**CASES[name])
    found = both(Truth(case, 15).search(60.0))
    with ball_arithmetic(64) as field:
        model = track(case, field)
        total, path = count_unstable(model, far_radius(model), LIMIT)
    assert total == sum(z.imag < 0 for z in found)
    assert path.evaluations >= len(path.middles)


def test_joined_cuts_are_counted_below_and_above() -> None:
    case = Case(**CASES["supercritical"])
    found = both(Truth(case, 15).search(100.0))
    with ball_arithmetic(64) as field:
        model = track(case, field)
        total, _ = count_sheet(model, 0.0, far_radius(model), LIMIT)
    assert {z.imag < 0.05 for z in found} == {True, False}
    assert total == len(found)


def test_a_single_start_point_does_not_matter() -> None:
    """Any point of the gap |r| < q_lm, and any radius beyond ρ, gives the same number."""
    case = Case(**CASES["subcritical"])
    with ball_arithmetic(64) as field:
        model = track(case, field)
        radius = far_radius(model)
        counts = {count_sheet(model, start, radius * more, LIMIT)[0] for start in (0.125, 0.25) for more in (1, 2)}
    assert counts == {4}


def rectangle(case: Case, *bounds: Any) -> int:
    with ball_arithmetic(64) as field:
        return count_rectangle(track(case, field), Rectangle(*bounds), LIMIT)[0]


@pytest.mark.parametrize("name", ["subcritical", "one mass, supercritical, undamped"])
def test_rectangles_add_up(name: str) -> None:
    """Four tiles below the cut line hold what the whole does, and what the search finds in it."""
    case = Case(**CASES[name])
    left, right, bottom, middle, top = (
        ("0.05", "0.5", "-0.5", "-0.0001", "0.02") if case.eta_b else ("0.05", "0.5", "-0.5", "-0.1", "-0.04")
    )
    whole = rectangle(case, left, right, bottom, top)
    columns, rows = ((left, "0.145"), ("0.145", right)), ((bottom, middle), (middle, top))
    tiles = [rectangle(case, *x, *y) for x in columns for y in rows]
    found = [z for z in both(Truth(case, 15).search(60.0)) if 0.05 < z.real < 0.5 and -0.5 < z.imag < float(top)]
    assert whole == sum(tiles) == len(found) > 0


def test_a_root_on_a_side_is_not_guessed() -> None:
    """Undamped subcritical roots are real."""
    case = Case(**CASES["subcritical, undamped"])
    with pytest.raises(PrecisionError):
        rectangle(case, "0.1", "0.2", 0, "0.1")
