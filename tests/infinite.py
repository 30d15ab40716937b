"""The infinite beam by the plainest way: (25)–(29) with the residue sums (37), and a trapezoidal inverse transform.

Nothing of the package's formulas is used: p-roots are eigenvalues of companion matrices of (18), in float64.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from laplace import Line

from mpsolve import Case
from mpsolve.vehicles.load import Load

LINE = Line(periods=4.0)


def kernels(case: Case, q: Any, distances: Any) -> Any:
    """K(g, q) for g of any sign, (*distances.shape, *q.shape); Im q below every cut."""
    alpha, eta_b, axial = float(case.alpha), float(case.eta_b), float(case.axial)
    quadratic, linear = -4 * (axial + alpha**2), 8 * alpha * (q - 1j * eta_b)
    companion = np.zeros((*q.shape, 4, 4), complex)
    companion[..., 0, 1:] = np.stack([0 * q - quadratic, -linear, -(4 - 4 * q**2 + 8j * eta_b * q)], -1)
    companion[..., [1, 2, 3], [0, 1, 2]] = 1
    p = np.linalg.eigvals(companion)
    p = np.take_along_axis(p, np.argsort(-p.imag, axis=-1), -1)
    residue = 1 / (4 * p**3 + 2 * quadratic * p + linear[..., None])
    g = np.asarray(distances)[(...,) + (None,) * (q.ndim + 1)]
    wave = np.exp(1j * p * np.where(np.arange(4) < 2, np.maximum(g, 0), np.minimum(g, 0))) * residue
    return 2j * np.pi * np.where(g[..., 0] >= 0, wave[..., :2].sum(-1), -wave[..., 2:].sum(-1))


def response(
    case: Case,
    loads: Sequence[Load],
    tau: Any,
    xi: Any = (),
    *,
    line: float = 0.03,
    last: float = 60.0,
    accelerations: bool = False,
) -> Any:
    """w at the masses and then at xi, (n + m, t): the inverse of (14) along Im q = −line, up to |Re q| = last.

    With `accelerations`: w_ττ of the moving frame instead, for τ well above 0.

    `line` must lie below every root. The transform of the free mass, which decays like q⁻³, is inverted exactly.
    """
    step = line / 6  # an aliasing error of e^{−2π·6}
    q = np.arange(0, last, step) + step / 2 - 1j * line
    s, n = 1j * q, case.count
    every = images(case, loads, q, [*(float(v) for v in case.positions), *xi])
    eta = np.array([float(v) for v in case.eta_m])
    first = np.array([2 * (float(v.constant) + float(v.amplitude) * np.sin(float(v.phase))) for v in loads]) / eta
    every[:n] -= first[:, None] / (s * (s + 1) ** 2)
    tau = np.asarray(tau, float)
    out = ((every * s**2 if accelerations else every) @ np.exp(np.multiply.outer(s, tau))).real * step / np.pi
    free = np.exp(-tau) * (1 - tau) if accelerations else 1 - np.exp(-tau) * (1 + tau)
    out[:n] += first[:, None] * free
    return out


def images(case: Case, loads: Sequence[Load], q: Any, points: Any) -> Any:
    """W̃ of (20), (25) at the points, (n, *q.shape); Im q below every cut."""
    s, x = 1j * q, np.array([float(v) for v in case.positions])
    eta = np.array([float(v) for v in case.eta_m])
    F = np.zeros((len(x), len(q)), complex)
    for j, load in enumerate(loads):
        c, a, w, phi = (float(v) for v in (load.constant, load.amplitude, load.frequency, load.phase))
        F[j] = 4 * c / s + 4 * a * (s * np.sin(phi) + w * np.cos(phi)) / (s * s + w * w)
    K = kernels(case, q, x[:, None] - x)
    matrix = np.pi * np.eye(len(x))[..., None] - 2 * q * q * K * eta[:, None]
    W = np.linalg.solve(matrix.transpose(2, 0, 1), np.einsum("ijq,jq->qi", K, F)[..., None])[..., 0].T
    away = kernels(case, q, np.asarray(points, float)[:, None] - x)
    return np.einsum("ijq,jq->iq", away, F + 2 * eta[:, None] * q * q * W) / np.pi


def inverted(case: Case, loads: Sequence[Load], xi: Sequence[float], tau: float, growth: float = 0.0) -> Any:
    """w(ξ, τ) as by `Inversion`, in float64: good to e^{aτ} roundings, which is 1e-12 unless the motion grows."""
    total = np.zeros(len(xi))
    q, fading, step = LINE.nodes(case, loads, xi, tau, growth)
    for k in range(0, len(q), 2000):
        some, share = q[k : k + 2000], fading[k : k + 2000]
        total += (images(case, loads, some, xi) @ (np.exp(1j * some * tau) * share)).real
    return total * step / (2 * np.pi)
