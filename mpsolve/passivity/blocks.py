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
from mpsolve.numbers.arrays import Integers, Reals, Truths
from mpsolve.numbers.jets import TINY, UP, U
from mpsolve.passivity.envelope import Envelope
from mpsolve.passivity.hermitian import Density, definite, positive
from mpsolve.passivity.power import value
from mpsolve.passivity.subject import Subject, cells

SIDE = 12
_CHUNK = 1 << 16  # cells that are looked at at once


def passive_on(envelope: Envelope, low: Reals, high: Reals, side: int = SIDE) -> Truths:
    """For boxes (q, parameters) of shape (boxes, 1 + parameters), scaled: whether −Im G is proved positive definite.

    q > 0. The parameters must lie in those of the envelope. side: cells on each side of a wave; more are tighter and
    take longer. False says nothing.
    """
    low, high = np.asarray(low, float), np.asarray(high, float)
    count = max(1, _CHUNK // (2 * side * (len(envelope.subject.names) + 4)))
    parts = [_passive(envelope, low[k : k + count], high[k : k + count], side) for k in range(0, len(low), count)]
    return np.concatenate(parts) if parts else np.zeros(0, bool)


def _passive(envelope: Envelope, low: Reals, high: Reals, side: int) -> Any:
    subject = envelope.subject
    with np.errstate(all="ignore"):
        middle = low / 2 + high / 2
        spread = ((high - low) / np.maximum(np.abs(high + low), 1e-300)).max(1)
        ends = cells(subject, middle[:, 0], middle[:, 1:], spread, side)
        parameters = subject.parameters(low[:, 1:], high[:, 1:])
        q, v = between(low[:, :1], high[:, :1], "q"), subject.speed(parameters)
        density = densities(subject, q, v, parameters, ends)
        fastest = np.ravel(v.high) * np.ones(len(low))
        tail = _tail(envelope, low[:, 0], fastest, ends[:, 1:])
        passed = _holds(subject, *density.ended(tail), parameters)
        rest = np.flatnonzero(~passed)
        if len(rest):  # what is given, over cells of Ω, which do not move with q and the velocity
            q, v, *parameters = (_rows(f, rest, len(low)) for f in (q, v, *parameters))
            given, end = _given(subject, q, v, parameters, ends[rest], middle[rest, 0])
            tail = given + _tail(envelope, low[rest, 0], fastest[rest], end[:, None])[:, 0]
            passed[rest] = _holds(subject, density.taking(rest), tail, parameters)
        return passed


def _rows(f: Affine, rows: Integers, count: int) -> Affine:
    whole = np.ones((count, 1))
    return Affine((f.a * whole)[rows], {name: (b * whole)[rows] for name, b in f.b.items()}, (f.e * whole)[rows])


def _holds(subject: Subject, density: Density, tail: Reals, parameters: list[Affine]) -> Any:
    if len(subject.places) == 1:
        return positive(density, tail)
    return definite(density, *subject.distances(parameters), tail)


def _given(
    subject: Subject, q: Affine, v: Affine, parameters: list[Affine], ends: Reals, middle: Any
) -> tuple[Reals, Reals]:
    """(what is given at most while −Ω is below an end, the least p beyond) for Σ|u|² = 1; ∞ where v may be 0."""
    slow = np.ravel(v.low)
    turns = np.minimum(middle[:, None] - v.a * ends[:, ::-1], 0.0)
    omega = between(turns[:, :-1], turns[:, 1:], "p")
    p = (q - omega) * v.inverse()
    at = _bounds(subject, p, omega, parameters)
    least = np.minimum(np.maximum(at.form.low, at.plain), 0)
    length = turns[:, 1:] - turns[:, :-1]
    given = -np.where(length > 0, least * length, 0.0).sum(1) / slow * len(subject.places) * (1 + 8192 * U)
    end = (np.ravel(q.low) - turns[:, 0]) / np.ravel(v.high) * (1 - 8 * U)
    return np.where((slow > 0) & np.isfinite(given), given, np.inf), np.maximum(end, TINY)


@dataclass(frozen=True)
class _Bounds:
    """Φ as a form and a lower bound of it; takes: where Ω ≥ 0."""

    form: Affine
    plain: Reals
    takes: Truths


def _bounds(subject: Subject, p: Affine, omega: Affine, parameters: list[Affine]) -> _Bounds:
    power = subject.power
    y, z = p.square(), omega.square()
    w, real, imaginary = (value(a, y, z, parameters) for a in (power.w, power.real, power.imaginary))
    bottom = real.square() + z * imaginary.square()
    form = omega * w * bottom.inverse()
    below = np.maximum(bottom.low, _least(real) ** 2 + np.maximum(z.low, 0) * _least(imaginary) ** 2) * (1 - 8 * U)
    taken = np.maximum(omega.low, 0) * np.maximum(w.low, 0) / bottom.high / UP
    given = np.where(below > 0, omega.low * np.maximum(w.high, 0) / below * UP, -np.inf)
    takes = omega.low >= 0
    return _Bounds(form, np.where(takes, np.where(np.isfinite(taken), taken, 0), given), takes)


@np.errstate(all="ignore")
def densities(subject: Subject, q: Affine, v: Affine, parameters: list[Affine], ends: Reals) -> Density:
    """The better of the two bounds on each cell."""
    p = between(ends[:, :-1], ends[:, 1:], "p")
    at = _bounds(subject, p, q - v * p, parameters)
    form, plain = at.form, at.plain * np.ones_like(p.a)
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
        at.takes & np.ones_like(p.a, bool),
    )


def _least(f: Affine) -> Any:
    """A lower bound of |f|."""
    return np.maximum(np.maximum(f.low, -f.high), 0)


def _tail(envelope: Envelope, q: Any, v: Reals, end: Any) -> Any:
    """What is given at most beyond each end (boxes, ends), for Σ|u|² = 1."""
    q, v = q[:, None], v[:, None]
    p = np.maximum(np.maximum(end, q / v * (1 - 8 * U)), TINY)
    alpha, count = envelope.subject.power.alpha, len(envelope.subject.places)
    if alpha <= 1:
        return np.where(v > 0, np.inf, 0.0) * np.ones_like(end)
    C = envelope.constants(np.minimum(p, 1e12))
    given = count * C * p ** (1.0 - alpha) / (alpha - 1) * UP
    return np.where(v > 0, np.where(np.isnan(given), np.inf, given), 0.0)
