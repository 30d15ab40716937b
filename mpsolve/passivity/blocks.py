"""−Im G(q) is positive definite on boxes of q and parameters: an integral over wavenumber, enclosed cell by cell.

−Im u*Gu = (1/2π) ∫ |Σ u_j e^{−ipξ_j}|² Φ dp with Φ = W/|D|² at Ω = q − vp. On each cell of p either Φ is enclosed to
first order in p, q and the parameters, or bounded from below; ∫ e^{ipΔ} over a cell is known in closed form. Beyond
the cells Φ ≥ 0 where p is negative, and |Φ| ≤ C p^−α where it is positive (SPEC, section 6.5).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.numbers.affine import Affine, between
from mpsolve.numbers.jets import TINY, UP, U, exponential
from mpsolve.passivity.envelope import Envelope
from mpsolve.passivity.mesh import cells
from mpsolve.passivity.power import value
from mpsolve.passivity.subject import Subject

_CHUNK = 1 << 16  # cells that are looked at at once
_DEFINITE = 0.98
_SERIES = 9


@dataclass(frozen=True)
class Density:
    """On each cell Φ ≥ a + b_p ε_p + Σ b_k ε_k; middle, half: of the cells."""

    middle: Any
    half: Any
    a: Any
    b: dict[str, Any]
    turn: Any


def passive_on(envelope: Envelope, low: Any, high: Any) -> Any:
    """For boxes (q, parameters) of shape (boxes, 1 + parameters), scaled: whether −Im G is proved positive definite.

    q > 0. The parameters must lie in those of the envelope. False says nothing.
    """
    low, high = np.asarray(low, float), np.asarray(high, float)
    count = max(1, _CHUNK // (20 * (len(envelope.subject.names) + 4)))
    parts = [_passive(envelope, low[k : k + count], high[k : k + count]) for k in range(0, len(low), count)]
    return np.concatenate(parts) if parts else np.zeros(0, bool)


def _passive(envelope: Envelope, low: Any, high: Any) -> Any:
    subject = envelope.subject
    with np.errstate(all="ignore"):
        middle = low / 2 + high / 2
        spread = ((high - low) / np.maximum(np.abs(high + low), 1e-300)).max(1)
        ends = cells(subject, middle[:, 0], middle[:, 1:], spread)
        parameters = subject.parameters(low[:, 1:], high[:, 1:])
        q, v = between(low[:, :1], high[:, :1], "q"), subject.speed(parameters)
        density = densities(subject, q, v, parameters, ends)
        tail = _tail(envelope, low[:, 0], np.ravel(v.high) * np.ones(len(low)), ends[:, -1])
        if len(subject.places) == 1:
            return _positive(density, tail)
        return _definite(subject, density, parameters, tail)


def densities(subject: Subject, q: Affine, v: Affine, parameters: list[Affine], ends: Any) -> Density:
    """The better of the two bounds on each cell."""
    power = subject.power
    p = between(ends[:, :-1], ends[:, 1:], "p")
    omega = q - v * p
    y, z = p.square(), omega.square()
    w, real, imaginary = (value(a, y, z, parameters) for a in (power.w, power.real, power.imaginary))
    bottom = real.square() + z * imaginary.square()
    form = omega * w * bottom.inverse()
    below = np.maximum(bottom.low, _least(real) ** 2 + np.maximum(z.low, 0) * _least(imaginary) ** 2) * (1 - 8 * U)
    takes = np.maximum(omega.low, 0) * np.maximum(w.low, 0) / bottom.high / UP
    gives = np.where(below > 0, omega.low * np.maximum(w.high, 0) / below * UP, -np.inf)
    plain = np.where(omega.low >= 0, np.where(np.isfinite(takes), takes, 0), gives) * np.ones_like(p.a)
    others = {name: b * np.ones_like(p.a) for name, b in form.b.items() if name != "p"}
    turn = form.b.get("p", np.zeros_like(p.a)) * np.ones_like(p.a)
    # ε_p runs over the cell from −1 to 1 but for the rounding of its middle and half
    radius = p.b.get("p", np.zeros_like(p.a))
    off = 8 * U * np.abs(p.a) / np.maximum(radius, TINY) + 8 * (UP - 1)
    a = form.a - form.e - np.abs(turn) * off * UP
    a = a - 8 * U * np.abs(a)
    least = a - sum((np.abs(b) for b in others.values()), np.zeros_like(a)) * UP
    affine = np.isfinite(least) & (least > plain)
    half = (ends[:, 1:] - ends[:, :-1]) / 2
    return Density(
        p.a,
        half,
        np.where(half > 0, np.where(affine, a, plain), 0.0),
        {name: np.where(affine, b, 0.0) for name, b in others.items()},
        np.where(affine & (half > 0), turn, 0.0),
    )


def _least(f: Affine) -> Any:
    """A lower bound of |f|."""
    return np.maximum(np.maximum(f.low, -f.high), 0)


def _tail(envelope: Envelope, q: Any, v: Any, end: Any) -> Any:
    """What is given at most beyond the cells, for Σ|u|² = 1."""
    p = np.maximum(end, q / v * (1 - 8 * U))
    alpha, count = envelope.subject.power.alpha, len(envelope.subject.places)
    if alpha <= 1:
        return np.where(v > 0, np.inf, 0.0)
    C = envelope.constants(np.minimum(p, 1e12))
    given = count * C * p ** (1 - alpha) / (alpha - 1) * UP
    return np.where(v > 0, np.where(np.isnan(given), np.inf, given), 0.0)


def _positive(density: Density, tail: Any) -> Any:
    """One contact: the integral itself; what is linear over a cell adds nothing."""
    length = 2 * density.half
    total = (density.a * length).sum(1)
    lost = (np.abs(density.a) * length).sum(1) * 4096 * U
    moved = sum((np.abs((b * length).sum(1)) for b in density.b.values()), np.zeros_like(total))
    lost = lost + sum(((np.abs(b) * length).sum(1) for b in density.b.values()), np.zeros_like(total)) * 4096 * U
    return total - (moved + lost + tail) * UP > 0


def _definite(subject: Subject, density: Density, parameters: list[Affine], tail: Any) -> Any:
    """Several contacts: the Hermitian matrix H₀ + Σ ε_k H_k + E, cell by cell."""
    distances, number = subject.distances(parameters)
    n, boxes = len(number), len(tail)
    names = sorted({*density.b, *(name for d in distances for name in d.b)})
    H = np.zeros((boxes, 1 + len(names), n, n), complex)
    E = np.zeros((boxes, n, n))
    parts = [_diagonal(density, names), *(_entry(density, d, names) for d in distances)]
    for i in range(n):
        H[:, :, i, i], E[:, i, i] = parts[0]
        for j in range(i):
            values, lost = parts[1 + number[i, j]]
            H[:, :, i, j], H[:, :, j, i] = values, values.conj()
            E[:, i, j] = E[:, j, i] = lost
    H[:, 0] -= tail[:, None, None] * UP * np.eye(n)
    return positive_definite(H, E)


def _diagonal(density: Density, names: list[str]) -> tuple[Any, Any]:
    length = 2 * density.half
    rows = [density.a, *(density.b.get(name, np.zeros_like(density.a)) for name in names)]
    values = np.stack([(row * length).sum(1) for row in rows], 1)
    lost = sum((np.abs(row) * length).sum(1) for row in rows) * 4096 * U
    return values, lost * UP + TINY


def _entry(density: Density, distance: Affine, names: list[str]) -> tuple[Any, Any]:
    """The entry of a pair of places at this distance: its middle and slopes over the boxes, and a bound of the rest."""
    ones = np.ones((len(density.a), 1))
    D = distance.a * ones
    x = density.half * np.abs(D)
    phase, lost = exponential(1j * density.middle * D)
    flat, flat_lost = _sinc(x)
    bend, bend_lost = _bend(x)
    cell = phase * (2 * density.half * flat)
    skew = phase * (2j * density.half * bend * np.sign(D))
    rows = {name: density.b.get(name, np.zeros_like(density.a)) for name in names}
    values = [(density.a * cell + density.turn * skew).sum(1)]
    for name, row in rows.items():
        grown = (row * cell).sum(1)
        if name in distance.b:
            grown = grown + 1j * np.ravel(distance.b[name] * ones) * (density.a * density.middle * cell).sum(1)
        values.append(grown)
    slopes = sum((np.abs(row) for row in rows.values()), np.abs(density.turn))
    size = np.abs(density.a) + slopes
    delta = (distance.spread + distance.e) * ones
    far = np.abs(density.middle) + density.half
    error = size * (lost + flat_lost + bend_lost + (64 + density.a.shape[1]) * 16 * U * (1 + far * delta))
    error = error + delta * (np.abs(density.a) * density.half + slopes * far) + size * (far * delta) ** 2 / 2
    error = error + np.abs(density.a) * far * distance.e * ones
    return np.stack(values, 1), (error * 2 * density.half).sum(1) * UP + TINY


def _sinc(x: Any) -> tuple[Any, Any]:
    """sin(x)/x for x ≥ 0, and a bound of its error."""
    small = x < 1
    y = np.where(small, x * x, 0)
    series, term = np.ones_like(x), np.ones_like(x)
    for k in range(1, _SERIES):
        term = -term * y / (2 * k * (2 * k + 1))
        series = series + term
    with np.errstate(all="ignore"):
        e, lost = exponential(1j * np.where(small, 1.0, x))
        far = e.imag / x
    return np.where(small, series, far), np.where(small, 64 * U, lost * 2 + 64 * U)


def _bend(x: Any) -> tuple[Any, Any]:
    """(sin x − x cos x)/x² for x ≥ 0, and a bound of its error."""
    small = x < 1
    y = np.where(small, x * x, 0)
    term = np.where(small, x, 0) / 3
    series = term
    for k in range(1, _SERIES):
        term = -term * y / (2 * k * (2 * k + 3))
        series = series + term
    with np.errstate(all="ignore"):
        e, lost = exponential(1j * np.where(small, 1.0, x))
        far = (e.imag - x * e.real) / (x * x)
    return np.where(small, series, far), np.where(small, 64 * U, lost * 4 + 64 * U)


def positive_definite(H: Any, E: Any) -> Any:
    """Whether H₀ + Σ ε_k H_k + R is positive definite for all |ε_k| ≤ 1 and Hermitian |R| ≤ E, entry by entry.

    H: (boxes, 1 + k, n, n), E: (boxes, n, n). X H X* = 1 + F with |F| x ≤ θ x, θ < 1, for some regular X and x > 0.
    """
    n = H.shape[2]
    finite = np.isfinite(H).all((1, 2, 3)) & np.isfinite(E).all((1, 2))
    H0 = np.where(finite[:, None, None], H[:, 0], -np.eye(n))
    sane = np.linalg.eigvalsh(H0)[:, 0] > 0
    X = np.zeros_like(H0)
    X[:] = np.eye(n)
    for k in np.flatnonzero(sane):
        try:
            X[k] = np.linalg.inv(np.linalg.cholesky(H0[k]))
        except np.linalg.LinAlgError:
            sane[k] = False
    size, Xh = np.abs(X), np.swapaxes(X.conj(), 1, 2)
    whole = np.abs(H).sum(1)
    lost = 64 * (n + 4) * U
    F = np.abs(X @ H0 @ Xh - np.eye(n)) + lost * np.eye(n)
    for k in range(1, H.shape[1]):
        F = F + np.abs(X @ H[:, k] @ Xh)
    F = (F + size @ (E + lost * whole) @ np.swapaxes(size, 1, 2)) * UP
    F = np.where(sane[:, None, None], F, 1.0)
    x = np.ones((len(F), n))
    for _ in range(12):
        y = np.einsum("bij,bj->bi", F, x) + 0.02 * x
        x = y / y.max(1, keepdims=True)
    return finite & sane & (np.max(np.einsum("bij,bj->bi", F, x) / x, axis=1) * UP < _DEFINITE)
