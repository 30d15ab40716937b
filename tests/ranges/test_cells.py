"""Cells, their parts, and what is handed on to finer ones."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from mpsolve.ranges.cells import BOUNDARY, finer, grown, inmost, marked, met, next_to, parts_of


@dataclass
class Curve:
    x: tuple[float, ...]
    y: tuple[float, ...]


def test_boxes_mark_what_they_touch() -> None:
    counts = marked(np.array([[0.3], [0.0]]), np.array([[0.5], [0.1]]), (4, 4))
    assert (np.argwhere(counts == BOUNDARY) == [[1, 0], [2, 0]]).all()


def test_connected_parts_share_sides() -> None:
    free = np.array([[1, 1, 0], [0, 0, 0], [1, 0, 1]], bool)
    labels = parts_of(free)
    assert labels.max() == 3
    assert labels[0, 0] == labels[0, 1]
    assert (labels[~free] == 0).all()


def test_finer_cells_get_the_label_of_what_they_hang_together_with() -> None:
    """A wall one fine cell thick in a column of cells: each side belongs to its neighbour, a pocket to none."""
    free = np.ones((8, 8), bool)
    free[4] = False
    free[4:7, 0:2] = False
    free[5, 0] = True
    coarse = parts_of(free.reshape(4, 2, 4, 2).all((1, 3)))
    labels = finer(coarse, free)
    assert set(np.unique(coarse)) == {0, 1, 2}
    assert (labels[:4] == 1).all()
    assert (labels[5:, 2:] == 2).all()
    assert labels[5, 0] == 3
    assert (labels[~free] == 0).all()


def test_the_inmost_cell() -> None:
    where = np.zeros((9, 9), bool)
    where[2:7, 2:7] = True
    assert all(3 <= k <= 5 for k in inmost(where))


def test_what_a_curve_meets_and_what_is_next_to_it() -> None:
    curve = ((8, 8), ((0, 1), (0, 1)), [Curve((0.55, 0.55), (0.0, 1.0))])
    assert (np.flatnonzero(met(*curve).any(1)) == [4]).all()
    found = next_to(*curve)
    assert found[2:7].all()
    assert not found[:2].any()
    assert not found[7:].any()


def test_neighbours() -> None:
    cells = np.zeros((4, 4), bool)
    cells[0, 1] = True
    assert np.argwhere(grown(cells, 0, 1)).tolist() == [[0, 0], [0, 1], [0, 2], [1, 1]]
    assert np.argwhere(grown(cells, 1)).tolist() == [[0, 0], [0, 1], [0, 2]]
