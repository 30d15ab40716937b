"""The terms that tracks share, over plain numbers."""

from __future__ import annotations

from types import SimpleNamespace

from mpsolve.tracks.rail import layer, rail


def test_the_beam() -> None:
    x = SimpleNamespace(EI=2, eta=3, N=5, kp=7, m=11, P=2, s=3)
    assert rail(x) == 2 * (1 + 9) * 16 + (5 - 7) * 4 + 11 * 9


def test_springs_and_dampers_side_by_side() -> None:
    assert layer(SimpleNamespace(s=5), 2, 3) == 17
