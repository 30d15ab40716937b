"""The Laplace image of the motion and its residues, (20)–(30), for any number of masses: one formula.

With S_j = F_j + 2η_Mj q² W_j the system (25) reads B S = F, B = I − (2q²/π) η_M K, and

    W̃(ξ, q) = (1/π) Σ_j S_j K(ξ − x_j, q).

S_j/4 is the image of the contact force, since 8 times that force stands on the right of (13). Cramer's rule gives
S_j = N_j/Δ everywhere and N_j/Δ_q as its residue at a simple root of Δ.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from mpsolve.model.branch import Pairing, Track
from mpsolve.model.kernel import AHEAD, BEHIND, kernel, kernel_at_contact

Rows = list[list[Any]]


def system(track: Track, pair: Pairing, q: Any) -> Rows:
    """B = I − (2q²/π) η_M K, shape (n, n)."""
    kernels = contact_kernels(track, pair)
    order, factor = range(len(track.eta_m)), 2 * q * q / track.field.pi
    return [[int(i == j) - factor * track.eta_m[i] * kernels[i][j] for j in order] for i in order]


def contact_kernels(track: Track, pair: Pairing) -> Rows:
    """K(x_i − x_j, q) over a given pairing of the p-roots, shape (n, n)."""
    order, x, contact = range(len(track.eta_m)), track.positions, kernel_at_contact(track, pair)
    return [
        [
            contact if i == j else kernel(track, pair, AHEAD if i > j else BEHIND, x[max(i, j)] - x[min(i, j)])
            for j in order
        ]
        for i in order
    ]


def numerators(track: Track, rows: Rows, F: Sequence[Any]) -> list[Any]:
    """N_j: the determinant of B with its column j replaced by F."""
    order = range(len(F))
    return [track.field.det([[F[i] if k == j else rows[i][k] for k in order] for i in order]) for j in order]


def contact_image(track: Track, pair: Pairing, q: Any, F: Sequence[Any]) -> list[Any]:
    """S_j(q), four times the image of the contact force of each mass."""
    rows = system(track, pair, q)
    delta = track.field.det(rows)
    return [value / delta for value in numerators(track, rows, F)]


def lone_image(track: Track, pair: Pairing, q: Any, F: Sequence[Any]) -> list[Any]:
    """S_j(q) of each mass as if it were alone: F_j/(1 − (2q²/π) η_Mj K(0, q))."""
    contact, factor = kernel_at_contact(track, pair), 2 * q * q / track.field.pi
    return [f / (1 - factor * eta * contact) for f, eta in zip(F, track.eta_m, strict=True)]
