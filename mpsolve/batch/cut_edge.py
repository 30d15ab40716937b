"""R·Δ on both sides of the cut of a beam, for z ≥ 0 on its line: R, the product of all differences of an upper and a
lower p-root, takes away the pole of Δ at the branch point.

D is real in p; the largest real root of its resolvent pairs the p-roots by their order, and the right one of two real
roots is an upper root, seen from below the cut, exactly where vp > z.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from mpsolve.batch.halves import Halves, largest_real_root
from mpsolve.batch.kernel import at_roots, chunks
from mpsolve.batch.matrix import log_det, matrices
from mpsolve.numbers.arrays import Complexes, Integers, Reals


def edge_roots(halves: Halves, rows: Integers, z: Any) -> Complexes:
    """The roots P = ip seen from below the cut, upper ones first: shape (points, 4)."""
    EI, c2, k, m, v = (part[rows] for part in halves.beam)
    c2, c1, c0 = c2 / EI, 2 * m * v * z / EI, (k - m * z * z) / EI
    y = np.maximum(largest_real_root(2 * c2, c2 * c2 - 4 * c0, -c1 * c1), 0)
    s = np.sqrt(y)
    wide = np.sqrt(np.maximum((y + c2) ** 2 - 4 * c0, 0))
    beyond = wide > s  # s and h share the product c1: the larger one is the better known
    h = np.where(beyond, wide, c1 / np.where(s > 0, s, 1))
    s = np.where(beyond, c1 / np.where(wide > 0, wide, 1), s)
    a, c = _split(v, z, s / 2, -s * s / 4 - (c2 + h) / 2)
    b, e = _split(v, z, -s / 2, -s * s / 4 - (c2 - h) / 2)
    return 1j * np.stack([a, b, c, e], 1)


def _split(v: Reals, z: Any, centre: Reals, delta2: Reals) -> tuple[Any, Any]:
    """The upper and the lower one of the roots centre ± √δ²."""
    size = np.sqrt(np.abs(delta2))
    offset = np.where(delta2 < 0, 1j * size, np.where(v * (centre + size) > z, size, -size))
    return centre + offset, centre - offset


def edge_logs(halves: Halves, rows: Integers, z: Any) -> Complexes:
    """log R·Δ for the lower half and the upper one, mirrored; shape (2, points)."""
    out = np.empty((2, len(rows)), complex)
    for part in chunks(halves.group, len(rows)):
        log_R, both = _parts(halves, rows[part], z[part])
        for side, A in enumerate(both):
            out[side, part] = log_R + log_det(A)
    return out


def far_arguments(halves: Halves, rows: Integers, z: Any) -> Reals:
    """arg R·Δ at a far z, both halves together, of det B = 1 and no mass at z = 0; nan where it is not told.

    R/z² is near a negative number, Δ of each mass alone is near what a rigid end makes of it, and so is the rest.
    """
    total = np.zeros(len(rows))
    log_R, both = _parts(halves, rows, z)
    for A in both:
        total = total + _principal(-np.exp(1j * log_R.imag))
        rest = log_det(A)
        for body, contact in halves.group.direct:
            own = A[:, body, contact]
            total = total + _principal(own / -halves.group.B[rows, body, contact])
            rest = rest - np.log(own)
        total = total + _principal(np.exp(rest) * _sign(halves))
    return total


def _sign(halves: Halves) -> float:
    """Of the permutation that brings each body to its contact."""
    bodies = np.argsort([contact for _, contact in halves.group.direct])
    order = np.array([body for body, _ in halves.group.direct])[bodies]
    return float(np.linalg.det(np.eye(len(order))[order]))


def _parts(halves: Halves, rows: Integers, z: Any) -> tuple[Complexes, list[Complexes]]:
    """log R, and the characteristic matrices of both halves."""
    group, sigma = halves.group, 1j * z
    with np.errstate(all="ignore"):
        P = edge_roots(halves, rows, z)
        values = at_roots(group, rows, sigma, P)
        a, b, c, e = P.T
        log_R = np.log((a - c) * (a - e) * (b - c) * (b - e))
    return log_R, [matrices(group, rows + side * len(halves), sigma, values)[0] for side in (0, 1)]


def _principal(value: Any) -> Reals:
    with np.errstate(all="ignore"):
        return np.where(value.real > 0, np.angle(value), np.nan)
