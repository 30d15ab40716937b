"""Blocks that absorb most: of a function with two plateaus, and with a loss for each block."""

import numpy as np

from mpsolve.passivity.taking import best_blocks


def blocks(sieve: float) -> list[tuple[float, float, float]]:
    z = np.linspace(-4, 4, 81)
    height = lambda x: np.where((x > -3.05) & (x < -0.95), 1.0, np.where((x > 1.95) & (x < 2.45), 3.0, 0.0))  # noqa: E731
    return list(best_blocks(z, height(z), height((z[1:] + z[:-1]) / 2), 10.0, sieve))


def test_both_plateaus_are_taken_where_nothing_is_lost() -> None:
    found = blocks(0.0)
    assert np.allclose(found, [(-3, -1, 1), (2, 2.4, 3)])


def test_a_block_shorter_than_the_loss_is_left() -> None:
    assert np.allclose(blocks(6.0), [(-3, -1, 1)])
    assert blocks(30.0) == []
