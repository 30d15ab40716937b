"""Which p-roots are upper ones along the cut: against mpmath, just off it on both sides."""

import numpy as np
import pytest
from oracle import Truth

from mpsolve import Case
from mpsolve.cuts.edge import sides


@pytest.mark.parametrize("alpha", ["0.6", "1.2"])
@pytest.mark.parametrize("side", [-1, 1])
def test_sides_are_those_just_off_the_cut(alpha: str, side: int) -> None:
    v, eta = float(alpha), 0.05
    truth = Truth(Case(alpha=alpha, eta_b="0.05", eta_m=1), 30)
    p = np.linspace(-3, 3, 41)
    S = np.sqrt(p**4 / 4 + 1 - eta**2)
    z = v * p + S
    lean = v + p**3 / (2 * S)
    A, B = -v * v, 2 * v * z
    cubic = np.stack([p**3 / 4 + A * p + B, p**2 / 4 + A, p / 4, np.full(len(p), 0.25)], 1)
    r, _ = sides(cubic, p, z, np.full(len(p), v), side)
    seen = 0
    for k in np.flatnonzero((side * lean > 0.05) & (z > 0.01)):
        upper, lower = truth.p_roots(complex(z[k], eta + side * 1e-7))
        for found, group in (((p[k], r[k, 1]), upper), ((r[k, 0], r[k, 2]), lower)):
            for root in found:
                assert min(abs(complex(other) - root) for other in group) < 1e-4
        seen += 1
    assert seen > 4
