"""The characteristic function Δ(q) = det[I − (2q²/π) K(x_i − x_j, q) η_M,j], eq. (26) over π^n, and its slopes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from mpsolve.model.branch import ALONG_Q, Motion, Track, pairing, pairing_rate
from mpsolve.model.kernel import AHEAD, BEHIND, kernel, kernel_at_contact, kernel_at_contact_rate, kernel_rates

Rows = list[list[Any]]


def characteristic(track: Track, q: Any) -> Any:
    """Δ(q) on the physical sheet, for any number of masses. Raises `PrecisionError` (balls only)."""
    return track.field.det(characteristic_matrix(track, q))


def characteristic_matrix(track: Track, q: Any) -> Rows:
    """I − (2q²/π) K M, shape (n, n)."""
    factor, eta = 2 * q * q / track.field.pi, track.eta_m
    return [
        [int(i == j) - factor * value * eta[j] for j, value in enumerate(row)]
        for i, row in enumerate(kernel_matrix(track, q))
    ]


def kernel_matrix(track: Track, q: Any) -> Rows:
    """K(x_i − x_j, q), shape (n, n)."""
    pair, n = pairing(track, q), len(track.eta_m)
    contact = kernel_at_contact(track, pair)
    rows: Rows = [[contact] * n for _ in range(n)]
    for i in range(n):
        for j in range(i):
            distance = track.positions[i] - track.positions[j]
            rows[i][j] = kernel(track, pair, AHEAD, distance)
            rows[j][i] = kernel(track, pair, BEHIND, distance)
    return rows


def characteristic_rate(track: Track, q: Any) -> tuple[Any, Any]:
    """Δ(q) and Δ_q(q)."""
    value, (slope,) = characteristic_rates(track, q, (ALONG_Q,))
    return value, slope


def characteristic_rates(track: Track, q: Any, motions: Sequence[Motion]) -> tuple[Any, list[Any]]:
    """Δ(q) and its derivatives along the motions. Raises `PrecisionError` (balls only)."""
    kernels, kernels_rates = kernel_matrix_rates(track, q, motions)
    factor, factor_rate, eta = 2 * q * q / track.field.pi, 4 * q / track.field.pi, track.eta_m
    order = range(len(eta))
    rows = [[int(i == j) - factor * kernels[i][j] * eta[j] for j in order] for i in order]
    slopes = []
    for motion, kernel_slopes in zip(motions, kernels_rates, strict=True):
        rates = [[-factor * kernel_slopes[i][j] * eta[j] for j in order] for i in order]
        if motion.q:
            gain = factor_rate * motion.q
            rates = [[rates[i][j] - gain * kernels[i][j] * eta[j] for j in order] for i in order]
        if motion.eta_m is not None:
            rates = [[rates[i][j] - factor * kernels[i][j] * motion.eta_m[j] for j in order] for i in order]
        slopes.append(determinant_rate(track, rows, rates))
    return track.field.det(rows), slopes


def determinant_rate(track: Track, rows: Rows, rates: Rows) -> Any:
    """The derivative of a determinant, row by row."""
    return sum(track.field.det([*rows[:k], rates[k], *rows[k + 1 :]]) for k in range(len(rows)))


def kernel_matrix_rates(track: Track, q: Any, motions: Sequence[Motion]) -> tuple[Rows, list[Rows]]:
    """K(x_i − x_j, q), shape (n, n), and its derivatives along the motions."""
    pair, n, x = pairing(track, q), len(track.eta_m), track.positions
    rates = [pairing_rate(track, q, pair, motion) for motion in motions]
    contacts = [kernel_at_contact_rate(track, pair, rate) for rate in rates]
    contact = contacts[0][0] if contacts else kernel_at_contact(track, pair)
    rows: Rows = [[contact] * n for _ in range(n)]
    slopes: list[Rows] = [[[slope] * n for _ in range(n)] for _, slope in contacts]
    for i in range(n):
        for j in range(i):
            moves = [(rate, _speed(motion, i, j)) for rate, motion in zip(rates, motions, strict=True)]
            for row, column, side in ((i, j, AHEAD), (j, i, BEHIND)):
                rows[row][column], values = kernel_rates(track, pair, moves, side, x[i] - x[j])
                for slope, value in zip(slopes, values, strict=True):
                    slope[row][column] = value
    return rows, slopes


def _speed(motion: Motion, i: int, j: int) -> Any:
    return 0 if motion.positions is None else motion.positions[i] - motion.positions[j]
