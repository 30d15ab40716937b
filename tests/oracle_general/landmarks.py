"""Places beside the axis where arg Δ̃ may turn by 2π within a hair: branch points of G and poles of the vehicle.

A zero just below the axis with a near-pole just above is invisible from a little way off. So every contour begins
with points that crowd towards each of these places.
"""

from __future__ import annotations

from typing import Any

import numpy as np


def branch_points(floats: Any, starts: int = 4000) -> np.ndarray:
    """q where two p-roots meet (D = D_p = 0), by Newton's method from a seeded cloud of (p, q)."""
    rng = np.random.default_rng(0)
    q = floats.scale * np.exp(rng.uniform(-7, 5, starts)) + 0j
    p = np.take_along_axis(floats.p_roots(q), rng.integers(floats.degree, size=(starts, 1)), axis=1)[:, 0]
    for _ in range(40):
        F, G, Fp, Fq, Gp, Gq = _jet(floats.D, p, q)
        with np.errstate(all="ignore"):
            det = Fp * Gq - Fq * Gp
            dp, dq = (F * Gq - Fq * G) / det, (Fp * G - F * Gp) / det
        p, q = p - dp, q - dq
    good = np.isfinite(q) & (np.abs(dq) < 1e-7 * np.abs(q)) & (np.abs(dp) < 1e-4 * np.abs(p) + 1e-9)
    return _distinct(q[good])


def _jet(D: np.ndarray, p: np.ndarray, q: np.ndarray) -> tuple[np.ndarray, ...]:
    """D, D_p and their derivatives in p and q."""
    powers = [np.arange(n) for n in D.shape]
    P, Q = p[:, None] ** powers[0], q[:, None] ** powers[1]

    def slope(base: np.ndarray, power: np.ndarray, order: int) -> np.ndarray:
        factor = power * (power - 1 if order == 2 else 1)
        return factor * base[:, None] ** np.maximum(power - order, 0)

    P1, P2, Q1 = slope(p, powers[0], 1), slope(p, powers[0], 2), slope(q, powers[1], 1)
    pairs = ((P, Q), (P1, Q), (P1, Q), (P, Q1), (P2, Q), (P1, Q1))
    return tuple(np.einsum("ni,ij,nj->n", a, D, b) for a, b in pairs)


def vehicle_poles(floats: Any) -> np.ndarray:
    """Roots of the vehicle alone: on a rigid rail, and with free contacts."""
    n, c = floats.B.shape
    rigid = np.block([[floats.K, -floats.B], [floats.B.T, np.diag(floats.h)]])
    found = []
    for K, size in ((rigid, n + c), (floats.K, n)):
        C, M = np.zeros((size, size)), np.zeros((size, size))
        C[:n, :n], M[:n, :n] = floats.C, floats.M
        found.append(_quadratic_roots(K, C, M))
    return _distinct(np.concatenate(found))


def _quadratic_roots(K: np.ndarray, C: np.ndarray, M: np.ndarray) -> np.ndarray:
    """q with det(K + iqC − q²M) = 0, infinite ones left out; scaled so that K and M are alike."""
    size = len(K)
    weight = (np.abs(np.diag(K)) + np.abs(K).sum(axis=1) + 1e-300) ** -0.5
    weight = np.where(np.isfinite(weight) & (weight < 1e100), weight, 1.0)
    K, C, M = (weight[:, None] * A * weight for A in (K, C, M))
    rate = (np.abs(M).max() or 1.0) ** -0.5
    none, one, shift = np.zeros((size, size)), np.eye(size), 0.3717 + 0.2j
    A, B = np.block([[none, one], [-K, -rate * C]]), np.block([[one, none], [none, rate**2 * M]])
    try:
        inverse = np.linalg.eigvals(np.linalg.solve(A - shift * B, B.astype(complex)))
    except np.linalg.LinAlgError:
        return np.array([], complex)
    return np.asarray(-1j * rate * (shift + 1 / inverse[np.abs(inverse) > 1e-9]))


def _distinct(q: np.ndarray) -> np.ndarray:
    q = np.abs(q.real) + 1j * q.imag
    out: list[complex] = []
    for z in q[np.argsort(np.abs(q))]:
        if abs(z) and not any(abs(z - w) < 1e-5 * abs(z) for w in out):
            out.append(complex(z))
    return np.array(out, complex)


def crowded(places: np.ndarray, level: float) -> np.ndarray:
    """Real x that crowd towards each place that lies near the line Im q = level."""
    out: list[float] = []
    for z in places:
        near = max(abs(z.imag - level), 1e-9 * abs(z)) / 4
        if near < abs(z.real):
            steps = near * 1.6 ** np.arange(0, np.log(abs(z) / near) / np.log(1.6))
            out += [z.real, *(z.real + steps), *(z.real - steps)]
    x = np.unique(np.array(out))
    return x[x > 0]
