"""The characteristic function Δ(q) = det[I − (2q²/π) K(x_i − x_j, q) η_M,j], eq. (26) over π^n, and Δ_q."""

from __future__ import annotations

from typing import Any

from mpsolve.model.branch import Track, pairing, pairing_rate
from mpsolve.model.kernel import AHEAD, BEHIND, kernel, kernel_at_contact, kernel_at_contact_rate, kernel_rate

Rows = list[list[Any]]


def characteristic(track: Track, q: Any) -> Any:
    """Δ(q) on the physical sheet, for any number of masses. Raises `PrecisionError` (balls only)."""
    return track.field.det(characteristic_matrix(track, q))


def characteristic_matrix(track: Track, q: Any) -> Rows:
    """I − (2q²/π) K M, shape (n, n)."""
    pair, n = pairing(track, q), len(track.eta_m)
    factor = 2 * q * q / track.field.pi
    contact = factor * kernel_at_contact(track, pair)
    rows: Rows = [[None] * n for _ in range(n)]
    for i in range(n):
        rows[i][i] = 1 - contact * track.eta_m[i]
        for j in range(i):
            distance = track.positions[i] - track.positions[j]
            rows[i][j] = -factor * kernel(track, pair, AHEAD, distance) * track.eta_m[j]
            rows[j][i] = -factor * kernel(track, pair, BEHIND, distance) * track.eta_m[i]
    return rows


def characteristic_rate(track: Track, q: Any) -> tuple[Any, Any]:
    """Δ(q) and Δ_q(q): the derivative of a determinant, row by row."""
    rows, rates = _matrix_rate(track, q)
    det = track.field.det
    slope = 0
    for k in range(len(rows)):
        slope = slope + det([*rows[:k], rates[k], *rows[k + 1 :]])
    return det(rows), slope


def _matrix_rate(track: Track, q: Any) -> tuple[Rows, Rows]:
    pair, n = pairing(track, q), len(track.eta_m)
    rate = pairing_rate(track, q, pair)
    factor, factor_rate = 2 * q * q / track.field.pi, 4 * q / track.field.pi
    rows: Rows = [[None] * n for _ in range(n)]
    rates: Rows = [[None] * n for _ in range(n)]

    def fill(i: int, j: int, value: Any, slope: Any) -> None:
        rows[i][j] = int(i == j) - factor * value * track.eta_m[j]
        rates[i][j] = -(factor_rate * value + factor * slope) * track.eta_m[j]

    contact = kernel_at_contact_rate(track, pair, rate)
    for i in range(n):
        fill(i, i, *contact)
        for j in range(i):
            distance = track.positions[i] - track.positions[j]
            fill(i, j, *kernel_rate(track, pair, rate, AHEAD, distance))
            fill(j, i, *kernel_rate(track, pair, rate, BEHIND, distance))
    return rows, rates
