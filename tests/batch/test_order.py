"""Neighbours in the order of a batch are alike."""

from __future__ import annotations

import numpy as np

from mpsolve.batch.order import alike


def test_one_parameter_is_sorted() -> None:
    values = np.random.default_rng(1).permutation(20_000) / 20_000
    assert (np.diff(values[alike({"v": values, "track.k": np.ones(20_000)}, 20_000)]) > 0).all()


def test_two_parameters_leap_seldom() -> None:
    x, y = (part.ravel() for part in np.meshgrid(np.arange(64), np.arange(64)))
    order = alike({"x": x, "y": y}, 4096)
    leaps = np.abs(np.diff(x[order])) + np.abs(np.diff(y[order]))
    assert sorted(order.tolist()) == list(range(4096))
    assert leaps.mean() < 2.5


def test_nothing_to_sort() -> None:
    assert alike({}, 1).tolist() == [0]
    assert alike({"v": np.array([])}, 0).tolist() == []
