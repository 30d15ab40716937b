"""Beyond which frequency the contacts are passive, for all parameters of a box: the far theorem, then cells of q."""

from __future__ import annotations

import numpy as np

from mpsolve.numbers.arrays import Integers, Reals
from mpsolve.passivity.blocks import SIDE, passive_on
from mpsolve.passivity.envelope import Envelope
from mpsolve.passivity.far import far

_RATIO = 1.15  # of one frequency to the next where cells begin
_HALVINGS = 7  # of a cell, in q and the parameters, before it is left open
_COARSE, _FINE = 2, 36  # halvings after which the mesh is finer, and how fine
_LOWEST = 1e-4  # of the far frequency
_MOST = 4000  # boxes, about


def passive_beyond(envelope: Envelope, halvings: int = _HALVINGS) -> float | None:
    """The least X that is found: −Im G(q) is positive definite for all real q ≥ X and all parameters; scaled.

    halvings: of a cell of frequencies, before it is left open: fewer take less time, and X is greater. None where
    the track gives at high frequencies: contacts faster than short waves.
    """
    top = far(envelope)
    if top is None:
        return None
    X, tried, open_ = top, 0, False
    width = 16
    while not open_ and top * _LOWEST < X and tried < _MOST:
        ends = X * _RATIO ** -np.arange(width + 1.0)
        found, open_, spent = _covered(envelope, ends, halvings)
        tried += spent
        X, width = float(ends[found]), min(2 * width, 64)
    return X


def _covered(envelope: Envelope, ends: Reals, halvings: int) -> tuple[int, bool, int]:
    """(how many cells in a row below ends[0] are proved, whether the next one failed, how many boxes were looked at).

    Cells far below one that is hard are left for another time.
    """
    n, k = len(ends) - 1, len(envelope.low)
    lows = np.concatenate([ends[1:, None], np.broadcast_to(envelope.low, (n, k))], 1)
    highs = np.concatenate([ends[:-1, None], np.broadcast_to(envelope.high, (n, k))], 1)
    cell, left, tried = np.arange(n), n, 0
    for depth in range(halvings + 1):
        tried += len(cell)
        passed = passive_on(envelope, lows, highs, SIDE if depth < _COARSE else _FINE)
        lows, highs, cell = lows[~passed], highs[~passed], cell[~passed]
        if not len(cell):
            return left, False, tried
        keep = cell <= cell.min() + 2
        left = min(left, int(cell[~keep].min(initial=left)))
        lows, highs, cell = halved(lows[keep], highs[keep], cell[keep])
    return int(cell.min()), True, tried


def halved(low: Reals, high: Reals, cell: Integers) -> tuple[Reals, Reals, Integers]:
    """Each box in two along its relatively longest side."""
    size = (high - low) / np.maximum(np.abs(high + low), 1e-300)
    k, rows = size.argmax(1) if len(low) else np.zeros(0, int), np.arange(len(low))
    middle = low[rows, k] / 2 + high[rows, k] / 2
    first, second = high.copy(), low.copy()
    first[rows, k], second[rows, k] = middle, middle
    return np.concatenate([low, second]), np.concatenate([first, high]), np.concatenate([cell, cell])
