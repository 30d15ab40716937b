"""The independent oracle holds itself: known numbers, floats against 40 digits, its table against new contours."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from oracle_general import Floats, Precise, count_below, growing
from oracle_general.count import count_inside
from oracle_general.named import BOGIE, FAST, NAMED, RAIL, TIMOSHENKO, TWO_LAYER, WIRE, masses, problem
from oracle_general.problems import problems, stands

TABLE = json.loads((Path(__file__).parent / "data" / "general_counts.json").read_text())

ONSETS = {
    "timoshenko": (TIMOSHENKO, masses("10000", "0"), 309.4456866772),
    "two-layer": (TWO_LAYER, masses("900", "0"), 1413.8178654271),
    "kelvin-voigt": ({**RAIL, "eta": "1e-4"}, masses("10000", "0", "3.4"), 197.8780953512),
    "bogie": (RAIL, [BOGIE], 334.5908073733),
}


@pytest.mark.parametrize("name", ONSETS)
def test_onset(name: str) -> None:
    track, vehicles, v = ONSETS[name]
    near = [problem(track, vehicles, f"{v * (1 + t):.12f}") for t in (-0.5, -1e-7, 1e-5)]
    assert [count_below(Floats(at)).number for at in near] == [0, 0, 2]


def test_contact_wire() -> None:
    root = Precise(problem(WIRE, masses("8.5", "0"), "100")).root(15 + 1j)
    assert abs(complex(root) - (15.641876611743 + 0.715988110564j)) < 1e-12


@pytest.mark.parametrize(
    ("name", "f0", "q"),
    [("divergence, strong damping", -0.69903, -0.0851741452j), ("divergence, weak damping", -0.18824, -0.04217684j)],
)
def test_divergence(name: str, f0: float, q: complex) -> None:
    """f(0) < 0: one root alone has passed q = 0."""
    floats = Floats(NAMED[name])
    assert abs(floats.f(1e-4).real - f0) < 1e-4
    count, roots = growing(floats)
    assert count.number == 1
    assert abs(complex(roots[0]) - q) < 1e-9


def test_roots_without_number() -> None:
    """Timoshenko faster than its shear waves: the count of two tight masses doubles with the radius."""
    floats = Floats(problem(FAST, masses("10", "0", "3"), "2.2"))
    assert [count_inside(floats, radius).number for radius in (20, 40, 80)] == [12, 26, 52]


@given(problems())
@settings(max_examples=25)
def test_floats_against_forty_digits(random: dict[str, Any]) -> None:
    if not stands(random):
        return
    floats, precise = Floats(random), Precise(random, 40)
    q = (0.61 - 0.27j) * floats.scale
    assert abs(floats.delta(q) / complex(precise.delta(q)) - 1) < 1e-6


def test_mirror() -> None:
    """Δ̃(−q̄) is the conjugate of Δ̃(q): half of the contour is enough."""
    floats = Floats(problem(TWO_LAYER, [BOGIE], "500"))
    q = np.array([300 - 20j, 5 - 900j])
    assert np.allclose(np.exp(floats.log_delta(-q.conj()) - floats.log_delta(q).conj()), 1)


@pytest.mark.parametrize(
    "row", TABLE[:: len(TABLE) // 16], ids=lambda row: row.get("name", f"seed {row.get('seed')}")
)
def test_table_again(row: dict[str, Any]) -> None:
    """The stored counts, by contours of a third kind; each stored root is a zero of Δ̃ at 30 digits."""
    floats = Floats(row)
    level, within = -5e-9 * floats.scale, row.get("within")
    first = 100 * floats.scale
    count = (
        count_inside(floats, float(within), level, start=91)
        if within
        else count_below(floats, level, first, start=91, step=0.3)
    )
    assert count.number == row["count"]
    assert sum(1 if re == "0" else 2 for re, _ in row["roots"]) == row["count"]
    precise = Precise(row, 30)
    for re, im in row["roots"][:4]:
        q = complex(float(re), float(im))
        assert abs(complex(precise.root(q)) - q) < 1e-9 * abs(q)
