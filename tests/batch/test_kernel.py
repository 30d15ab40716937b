"""Receptances in batches: waves gap by gap and companion matrices say the same as sums of residues."""

from __future__ import annotations

import numpy as np
import pytest
from batch_groups import PROBLEMS, group_of, points

from mpsolve.batch import kernel, wave_sums
from mpsolve.batch.kernel import receptances


@pytest.mark.parametrize("name", PROBLEMS)
def test_waves_gap_by_gap_and_companions_say_the_same(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    group, sigma, rows = group_of(PROBLEMS[name]), points(), np.zeros(30, int)
    plain = receptances(group, rows, sigma, slope=True)
    unequal = (wave_sums, "_EQUAL", -1.0)  # all pairs, not one sum for each distance
    for changes in ((unequal,), (unequal, (wave_sums, "_REACH", 0.0)), ((kernel, "_LOST", 0.0),)):
        with monkeypatch.context() as other:
            for change in changes:
                other.setattr(*change, raising=True)
            found = receptances(group, rows, sigma, slope=True)
        size = np.abs(plain.G).max((1, 2), keepdims=True)
        assert (np.abs(found.G - plain.G) < 1e-9 * size).all()
        assert (np.abs(found.G_sigma - plain.G_sigma) < 1e-8 * np.abs(plain.G_sigma).max((1, 2), keepdims=True)).all()
