"""A coach with its wheels held: what the field says of a body on two stiff bogies."""

from __future__ import annotations

import numpy as np
import pytest

from mpsolve.vehicles import Bogie, Coach

BOGIE = Bogie(wheel=1813, frame=2615, inertia=1476, wheelbase="2.56", k="2.4e12")


def test_on_stiff_bogies_the_body_bounces_and_pitches_on_its_own() -> None:
    """ω² = 2 k2/body and 2 k2 (pivots/2)²/inertia are the two lowest."""
    pencil = Coach(body=32000, inertia="1.97e6", bogie=BOGIE, pivots=19, k2="4.3e5").pencil
    free = [i for i, name in enumerate(pencil.names) if "wheel" not in name]
    M, K = (np.array(rows, float)[np.ix_(free, free)] for rows in (pencil.M, pencil.K))
    lowest = sorted(np.linalg.eigvals(np.linalg.solve(M, K)).real)[:2]
    assert lowest == pytest.approx(sorted([8.6e5 / 32000, 8.6e5 * 9.5**2 / 1.97e6]), rel=1e-5)
