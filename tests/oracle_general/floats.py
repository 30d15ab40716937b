"""Receptance and characteristic determinant by residue sums in float64, for whole arrays of q at once."""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np

from oracle_general.landmarks import branch_points, vehicle_poles
from oracle_general.tracks import moving, track
from oracle_general.vehicles import together

I_POWERS = np.array([1, 1j, -1, -1j])


class Floats:
    """The functions of one problem at complex arrays q. G at real q is the continuation from Im q < 0."""

    def __init__(self, problem: dict[str, Any]) -> None:
        self.problem = problem
        D, N = track(problem["track"])
        v = type(next(iter(D.values())))(problem["v"])
        self.D, self.N = _table(moving(D, v)), _table(moving(N, v))
        self.degree = len(self.D) - 1
        self.scale = _time_scale(D)
        parts = together(problem["vehicles"])
        self.M, self.C, self.K, self.B = (np.array(rows, float) for rows in (parts.M, parts.C, parts.K, parts.B))
        self.x, self.h = np.array(parts.x, float), np.array(parts.h, float)
        self.places, self.index = np.unique(self.x, return_inverse=True)
        self.upper = self._upper()
        self.evaluations, self.defect = 0, 0.0

    def _upper(self) -> int:
        """n₊: upper roots at q = −i·large; no root is real for Im q < 0, so every such q tells the same."""
        q = -1j * self.scale * np.geomspace(0.3, 3e4, 12)
        found = np.unique((self.p_roots(q).imag > 0).sum(axis=1))
        if len(found) != 1:
            raise ArithmeticError(f"the number of upper p-roots is not clear: {found}")
        return int(found[0])

    @cached_property
    def landmarks(self) -> np.ndarray:
        """Branch points of G and poles of the vehicle."""
        return np.concatenate([branch_points(self), vehicle_poles(self)])

    def p_roots(self, q: np.ndarray) -> np.ndarray:
        """All p-roots, the largest imaginary part first."""
        D = _at(self.D, q)
        companion = np.zeros((len(q), self.degree, self.degree), complex)
        companion[:, np.arange(self.degree - 1), np.arange(1, self.degree)] = 1
        companion[:, -1, :] = -D[:, :-1] / D[:, -1:]
        p = np.linalg.eigvals(companion)
        for _ in range(2):
            value, slope = _horner(D, p)
            with np.errstate(all="ignore"):
                step = value / slope
            p = np.where(np.abs(step) < 1e-3 * np.abs(p), p - step, p)
        return np.take_along_axis(p, np.argsort(-p.imag, axis=1), axis=1)

    def kernel(self, distances: np.ndarray, q: np.ndarray) -> np.ndarray:
        """G(ξ, q): shape (len(q), len(distances))."""
        p = self.p_roots(q)
        _, slope = _horner(_at(self.D, q), p)
        weight = _horner(_at(self.N, q), p)[0] / slope
        total = np.abs(weight.sum(axis=1)) / np.abs(weight).sum(axis=1)
        self.defect, self.evaluations = max(self.defect, float(total.max())), self.evaluations + len(q)
        n = self.upper
        out = np.empty((len(q), len(distances)), complex)
        for k, xi in enumerate(distances):
            side, sign = (slice(0, n), 1j) if xi >= 0 else (slice(n, None), -1j)
            out[:, k] = sign * (weight[:, side] * np.exp(1j * xi * p[:, side])).sum(axis=1)
        return out

    def receptance(self, q: np.ndarray) -> np.ndarray:
        """G_ij = G(x_i − x_j, q): shape (len(q), contacts, contacts)."""
        differences = np.subtract.outer(self.x, self.x)
        distances, where = np.unique(differences, return_inverse=True)
        return self.kernel(distances, np.asarray(q, complex))[:, where.reshape(differences.shape)]

    def stiffness(self, q: np.ndarray) -> np.ndarray:
        q = np.asarray(q, complex)[:, None, None]
        return self.K + 1j * q * self.C - q * q * self.M

    def bordered(self, q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """The matrix of Δ̃ with rows and columns scaled by positive numbers, and the log of what they took out."""
        q = np.asarray(q, complex)
        bodies, contacts = self.B.shape
        G = self.receptance(q) + np.diag(self.h)
        A = np.zeros((len(q), bodies + contacts, bodies + contacts), complex)
        A[:, :bodies, :bodies], A[:, bodies:, bodies:] = self.stiffness(q), G
        A[:, :bodies, bodies:], A[:, bodies:, :bodies] = -self.B, self.B.T
        size = np.abs(q)[:, None]
        heavy = np.abs(np.diag(self.K)) + size * np.abs(np.diag(self.C)) + size**2 * np.abs(np.diag(self.M))
        soft = np.abs(np.diagonal(G, axis1=1, axis2=2))
        d = np.concatenate([heavy, np.where(soft > 0, soft, 1)], axis=1) ** -0.5
        return A * d[:, :, None] * d[:, None, :], -2 * np.log(d).sum(axis=1)

    def log_delta(self, q: np.ndarray) -> np.ndarray:
        """log Δ̃ (imaginary part principal)."""
        A, taken = self.bordered(q)
        sign, size = np.linalg.slogdet(A)
        return size + taken + 1j * np.angle(sign)

    def delta(self, q: complex) -> complex:
        """Δ̃ = det [[S, −B], [Bᵀ, G + h]]."""
        return complex(np.exp(self.log_delta(np.array([q]))[0]))

    def f(self, q: complex) -> complex:
        """det(I + G Y), Y the vehicle's dynamic stiffness at its contacts."""
        at = np.array([q], complex)
        C = self.B.T @ np.linalg.solve(self.stiffness(at)[0], self.B) + np.diag(self.h)
        return complex(np.linalg.det(np.eye(len(self.x)) + self.receptance(at)[0] @ np.linalg.inv(C)))


def _table(a: dict[tuple[int, int], Any]) -> np.ndarray:
    """[power of p, power of q] with the factors i^(k+j)."""
    out = np.zeros((max(k for k, _ in a) + 1, max(j for _, j in a) + 1), complex)
    for (k, j), value in a.items():
        out[k, j] = float(value) * I_POWERS[(k + j) % 4]
    return out


def _at(table: np.ndarray, q: np.ndarray) -> np.ndarray:
    return np.asarray(q, complex)[:, None] ** np.arange(table.shape[1]) @ table.T


def _horner(D: np.ndarray, p: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    value, slope = np.zeros_like(p), np.zeros_like(p)
    for k in range(D.shape[1] - 1, -1, -1):
        slope = slope * p + value
        value = value * p + D[:, k : k + 1]
    return value, slope


def _time_scale(D: dict[tuple[int, int], Any]) -> float:
    """A frequency at which terms of D are of one size."""
    rows = np.array([[1.0, i, j] for i, j in D])
    logs = np.array([np.log(abs(float(value))) for value in D.values()])
    return float(np.exp(-np.linalg.lstsq(rows, logs, rcond=None)[0][2]))
