"""Beyond which frequency the contacts are passive, for all parameters of a box: the far theorem, then cells of q."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.passivity.blocks import passive_on
from mpsolve.passivity.envelope import Envelope
from mpsolve.passivity.far import far
from mpsolve.passivity.subject import Subject

_RATIO = 1.15  # of one frequency to the next where cells begin
_HALVINGS = 7  # of a cell, in q and the parameters, before it is left open
_MOST = 4000  # boxes that are looked at


@dataclass(frozen=True)
class PassiveBeyond:
    """−Im G(q) is positive definite for all real q ≥ X and all parameters of the box; all scaled."""

    X: float
    far: float
    boxes: int


def passive_beyond(envelope: Envelope, box: tuple[Any, Any] | None = None, ceiling: float | None = None) -> Any:
    """The least X that is found for the box (low, high) of parameters, that of the envelope if left out.

    ceiling: an X that is known for the whole envelope (`far`), so that many boxes share it. None where the track
    gives at high frequencies: contacts faster than short waves.
    """
    low, high = (np.array(envelope.low), np.array(envelope.high)) if box is None else map(np.asarray, box)
    top = far(envelope) if ceiling is None else ceiling
    if top is None:
        return None
    X, tried, lowest = top, 0, top * 1e-6
    width = 8
    while X > lowest and tried < _MOST:
        ends = X * _RATIO ** -np.arange(width + 1.0)
        found, spent = _covered(envelope, low, high, ends, _MOST - tried)
        tried += spent
        if not found:
            break
        X, width = float(ends[found]), 2 * width
        if found < len(ends) - 1:
            break
    return PassiveBeyond(X, top, tried)


def _covered(envelope: Envelope, low: Any, high: Any, ends: Any, most: int) -> tuple[int, int]:
    """(how many of the cells below ends[0] in a row are proved, how many boxes were looked at)."""
    n, k = len(ends) - 1, len(low)
    lows = np.concatenate([ends[1:, None], np.broadcast_to(low, (n, k))], 1)
    highs = np.concatenate([ends[:-1, None], np.broadcast_to(high, (n, k))], 1)
    cell, failed, tried = np.arange(n), n, 0
    for depth in range(_HALVINGS + 1):
        if not len(cell):
            break
        tried += len(cell)
        passed = passive_on(envelope, lows, highs)
        lows, highs, cell = lows[~passed], highs[~passed], cell[~passed]
        if tried > most or depth == _HALVINGS:
            failed = min(failed, int(cell.min(initial=failed)))
            break
        if not len(cell):
            break
        keep = cell <= cell.min() + 2  # only the first cells that fail matter
        failed = min(failed, int(cell[~keep].min(initial=failed)))
        lows, highs, cell = halved(lows[keep], highs[keep], cell[keep])
    return failed, tried


def halved(low: Any, high: Any, cell: Any) -> tuple[Any, Any, Any]:
    """Each box in two along its relatively longest side."""
    size = (high - low) / np.maximum(np.abs(high + low), 1e-300)
    k, rows = size.argmax(1) if len(low) else np.zeros(0, int), np.arange(len(low))
    middle = low[rows, k] / 2 + high[rows, k] / 2
    first, second = high.copy(), low.copy()
    first[rows, k], second[rows, k] = middle, middle
    return np.concatenate([low, second]), np.concatenate([first, high]), np.concatenate([cell, cell])


def passive_subject(subject: Subject, low: Any, high: Any) -> Any:
    """`passive_beyond` for a subject over one box."""
    return passive_beyond(Envelope(subject, tuple(map(float, low)), tuple(map(float, high))))
