"""Polynomials in two variables on a rectangle: negative all over, or a bound of a quotient, by halves."""

from __future__ import annotations

import numpy as np

from mpsolve.characteristic.table import Table
from mpsolve.numbers.arrays import Reals, Truths
from mpsolve.numbers.jets import UP, U
from mpsolve.proof.effort import Effort
from mpsolve.tracks.waveguide import Polynomial

_SPLIT = 80  # halvings of a box at most
_MOST_BOXES = 6000  # in the search for a block
_MOST_ENVELOPE = 40000  # and for the envelope
_UNDERFLOW = 1e-280  # more than powers that underflow can add up to


def supremum(
    top: Polynomial,
    bottom: Polynomial,
    box: tuple[tuple[float, float], tuple[float, float]],
    product: float,
    effort: Effort,
    least_bound: float = 0.0,
) -> float | None:
    """A bound ≥ least_bound of |top|/bottom on the box where x y ≤ product, by branch and bound.

    None if bottom may vanish. effort: its time ends the search.
    """
    above, below = Table.of(top), Table.of(bottom)
    boxes, tried = _grid(*box, 8, 4), 0
    known, proved = least_bound / 1.5, least_bound
    for _ in range(_SPLIT):
        effort.spend(0)
        boxes = clipped(boxes, product)
        low, high, _ = bounds(above, boxes)
        least, most, by_x = bounds(below, boxes)
        with np.errstate(all="ignore"):
            middle = np.abs(low + high) / np.maximum(least + most, 1e-300)
            inner = boxes[0] * boxes[2] <= product
            known = max(known, float(middle[inner & (least + most > 0)].max(initial=0.0)))
            upper = np.where(least > 0, np.maximum(np.abs(low), np.abs(high)) / least * UP, np.inf)
        done = upper <= 1.5 * known
        proved = max(proved, float(upper[done].max(initial=0.0)))
        boxes, by_x = tuple(part[~done] for part in boxes), by_x[~done]
        tried += len(done)
        if not len(by_x):
            return proved
        if tried > _MOST_ENVELOPE:
            return None
        boxes = _halved(boxes, by_x)
    return None


def negative(polynomial: Polynomial, box: tuple[tuple[float, float], tuple[float, float]], effort: Effort) -> bool:
    """True if the polynomial is proved negative on the box, by halving boxes. effort: its time ends the search."""
    table = Table.of(polynomial)
    boxes, tried = _grid(*box, 8, 4), 0
    for _ in range(_SPLIT):
        effort.spend(0)
        low, high, by_x = bounds(table, boxes)
        if (low > 0).any():
            return False
        open_ = ~(high < 0)
        boxes, by_x = tuple(part[open_] for part in boxes), by_x[open_]
        tried += len(open_)
        if not len(by_x):
            return True
        if tried > _MOST_BOXES:
            return False
        boxes = _halved(boxes, by_x)
    return False


def bounds(table: Table, boxes: tuple[Reals, ...]) -> tuple[Reals, Reals, Truths]:
    """Lower and upper bounds of a real polynomial on boxes (x ± rx) × (y ± ry), by its expansion at the middle.

    Third: whether it varies more along x than along y, which is a hint only.
    """
    x, rx, y, ry = boxes
    T, error = table.in_time(y)
    c, lost = table.at(x[:, None], T, error)
    size = np.abs(c[:, 0]) + lost[:, 0]
    across, along = rx[:, None] ** np.arange(size.shape[1]), ry[:, None] ** np.arange(size.shape[2])
    spread = ((size @ along[:, :, None])[:, :, 0] * across).sum(1)
    middle = c[:, 0, 0, 0]
    radius = (spread - np.abs(c[:, 0, 0, 0]) + 256 * U * spread) * UP + _UNDERFLOW
    by_x = (size[:, 1:, 0] * across[:, 1:]).sum(1) > (size[:, 0, 1:] * along[:, 1:]).sum(1)
    return middle - radius - 8 * U * np.abs(middle), middle + radius + 8 * U * np.abs(middle), by_x


def _grid(x: tuple[float, float], y: tuple[float, float], nx: int, ny: int) -> tuple[Reals, ...]:
    def cells(ends: tuple[float, float], n: int) -> tuple[Reals, Reals]:
        edges_ = np.linspace(*ends, n + 1)
        middle = (edges_[1:] + edges_[:-1]) / 2
        return middle, np.maximum(edges_[1:] - middle, middle - edges_[:-1]) * UP

    (a, ra), (b, rb) = cells(x, nx), cells(y, ny)
    parts = np.meshgrid(a, b, indexing="ij"), np.meshgrid(ra, rb, indexing="ij")
    return parts[0][0].ravel(), parts[1][0].ravel(), parts[0][1].ravel(), parts[1][1].ravel()


def clipped(boxes: tuple[Reals, ...], product: float) -> tuple[Reals, ...]:
    """Boxes in x, y ≥ 0 that hold all points of the given ones with x y ≤ product."""
    x, rx, y, ry = boxes
    low, high = np.maximum(x - rx - 4 * U * x, 0.0), (x + rx) * UP
    below, above = np.maximum(y - ry - 4 * U * y, 0.0), (y + ry) * UP
    inside = low * below <= product * UP
    low, high, below, above = (part[inside] for part in (low, high, below, above))
    with np.errstate(all="ignore"):
        high = np.minimum(high, np.where(below > 0, product / below * UP, np.inf))
        above = np.minimum(above, np.where(low > 0, product / low * UP, np.inf))
    high, above = np.maximum(high, low), np.maximum(above, below)
    x, y = (low + high) / 2, (below + above) / 2
    return x, np.maximum(high - x, x - low) * UP + 4 * U * x, y, np.maximum(above - y, y - below) * UP + 4 * U * y


def _halved(boxes: tuple[Reals, ...], by_x: Truths) -> tuple[Reals, ...]:
    """Each box in two, along x or along y."""
    x, rx, y, ry = boxes
    dx, dy = np.where(by_x, rx / 2, 0.0), np.where(by_x, 0.0, ry / 2)
    h, k = np.where(by_x, rx / 2 * UP, rx), np.where(by_x, ry, ry / 2 * UP)
    return (
        np.concatenate([x - dx, x + dx]),
        np.concatenate([h, h]),
        np.concatenate([y - dy, y + dy]),
        np.concatenate([k, k]),
    )
