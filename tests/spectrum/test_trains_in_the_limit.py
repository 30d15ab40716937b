"""Trains whose answer is known: turned round, with wheels that merge, with wheels far apart."""

from __future__ import annotations

import numpy as np
import pytest

from mpsolve import Problem, certify, tracks, vehicles

BEAM = tracks.EulerBernoulli(EI="0.25", m=1, k=1, c="0.4")


def frequencies(masses: list[tuple[object, object]], v: str) -> np.ndarray:
    """All frequencies below 0.15, certified; masses: (M, place)."""
    placed = [vehicles.Mass(M).at(x) for M, x in masses]
    found = certify(Problem(BEAM, placed, v=v), region=("below", "0.15"), digits=15, check=False)
    assert found.proved, found.reason
    return np.array([complex(root.q) for root in found.roots])


@pytest.mark.parametrize("v", ["0", "0.5", "0.9"])
def test_a_train_may_be_turned_round(v: str) -> None:
    """G(−ξ) at v is G(ξ) at −v, and turning the train transposes the matrix of the receptances: Δ is the same."""
    one = frequencies([(20, 0), (30, 1), (50, "2.5")], v)
    other = frequencies([(50, 0), (30, "1.5"), (20, "2.5")], v)
    assert len(one) == 6
    assert np.allclose(one, other, rtol=0, atol=1e-13)
    assert not np.allclose(one, frequencies([(20, 0), (50, 1), (30, "2.5")], v), rtol=0, atol=1e-4)


def test_masses_that_merge_move_as_one() -> None:
    single = frequencies([(40, 0)], "0.5")
    off = []
    for gap in ("0.1", "0.01"):
        pair = frequencies([(20, 0), (20, gap)], "0.5")
        off.append(np.abs(pair[:, None] - single[None, :]).min(0).max())
    assert len(single) >= 2
    assert off[0] < 0.02
    assert off[1] < 0.2 * off[0]


def test_masses_far_apart_move_each_by_itself() -> None:
    single = frequencies([(40, 0)], "0.5")
    off = []
    for gap in (8, 16):
        pair = frequencies([(40, 0), (40, gap)], "0.5")
        assert len(pair) == 2 * len(single)
        off.append(np.abs(pair[:, None] - single[None, :]).min(1).max())
    assert off[1] < 0.3 * off[0]
