"""Tips of cuts against a search over wavenumbers in mpmath; the two halves against the damped problem itself."""

from __future__ import annotations

from typing import Any

import mpmath
import numpy as np
from sheet_cases import drawn, halves

from mpsolve.batch.halves import largest_real_root, on_line


def test_largest_real_root_of_cubics_with_known_roots() -> None:
    x, y, z = np.random.default_rng(1).normal(size=(3, 200))
    real = largest_real_root(-(x + y + z), x * y + y * z + z * x, -x * y * z)
    assert np.allclose(real, np.max([x, y, z], axis=0), rtol=1e-7, atol=1e-7)
    one = largest_real_root(-(x + 2 * y), 2 * x * y + y * y + z * z, -x * (y * y + z * z))  # x, y ± iz
    assert np.allclose(one, x, rtol=1e-9, atol=1e-9)


def test_the_tip_of_the_cut_is_the_least_frequency() -> None:
    """min over p of √((EI p⁴ + (kp − N) p² + k − c²/4m)/m) − vp, on a dense grid and then by golden section."""
    entries, over = drawn(30, 4)
    for part in halves(entries):
        for row, k in enumerate(part.index.tolist()):
            beam = {name: float(np.broadcast_to(value, 30)[k]) for name, value in entries.track.items()}
            v = float(over["v"][k])

            def frequency(p: Any, beam: dict[str, float] = beam, v: float = v) -> Any:
                rest = beam["k"] - beam["c"] ** 2 / (4 * beam["m"])
                return ((beam["EI"] * p**4 + (beam["kp"] - beam["N"]) * p**2 + rest) / beam["m"]) ** 0.5 - v * p

            grid = np.linspace(0, 20, 20_001)
            near = float(grid[np.argmin(frequency(grid))])
            best = min(frequency(mpmath.mpf(near + s)) for s in np.linspace(-1e-3, 1e-3, 2001))
            assert abs(part.limit[row] * part.unit[row] - best) < 1e-6


def test_rows_are_chosen_in_both_halves() -> None:
    entries, _ = drawn(20, 6)
    (part,) = [one for one in halves(entries) if len(one) > 3][:1]
    some = part[1:3]
    assert len(some) == 2
    assert np.array_equal(some.index, part.index[1:3])
    assert np.array_equal(some.group.S1[2:], part.group.S1[len(part) + 1 : len(part) + 3])
    assert np.array_equal(some.limit, part.limit[1:3])


def test_what_has_no_line_is_left_out() -> None:
    entries, _ = drawn(4, 7, {"track.c": np.array([0.1, 1.99, 2.0, 3.0]), "track.N": 0.0, "track.kp": 0.0})
    assert on_line(entries).tolist() == [True, True, False, False]
    entries, _ = drawn(2, 7, {"track.c": 0.0, "track.N": np.array([0.999, 1.001]), "track.kp": 0.0})
    assert on_line(entries).tolist() == [True, False]
