"""−Im G(q) is positive definite for all real q ≥ X: what the track absorbs outweighs what it gives (SPEC, tail).

With W = −Im(N conj D) at P = ip, s = iΩ: −Im u*Gu = (1/2π)∫ |Σ u_j e^{−ipξ_j}|² W/|D|² dp. It absorbs on the block
p = z q^γ, z₁ ≤ z ≤ z₂, at least κ q^{−e} (for each of a few blocks); it gives where p ≥ q/v, at most C p^{−α}. A
large-sieve inequality bounds ∫|V|² over intervals by their lengths ± 2π/δ, δ the smallest gap between contacts.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from itertools import pairwise
from typing import Any

import numpy as np
from flint import arb, fmpq
from numpy.polynomial.polynomial import polyval2d

from mpsolve.characteristic.table import Table
from mpsolve.numbers.balls import precision
from mpsolve.numbers.jets import UP, U
from mpsolve.passivity.decay import edges
from mpsolve.problem.reduced import Guide
from mpsolve.tracks.waveguide import Polynomial, add, moving, multiply, scaled

_RATIO = 1.3  # of one X to the next that is tried
_SPLIT = 80  # halvings of a box at most
_MOST_BOXES = 6000  # in one search
_ROOM = 1.25  # between what floats sample and what is to be proved
_OMEGA = 4.0  # where the two charts of the envelope meet
_UNDERFLOW = 1e-280  # more than powers that underflow can add up to


@dataclass(frozen=True)
class Tail:
    """The proof: X, the blocks (z₁, z₂, κ) at γ with e, the envelope (ω₀, C, α). Floats are exact as they stand."""

    X: float
    gamma: Fraction
    blocks: tuple[tuple[float, float, float], ...]
    e: Fraction
    omega0: float
    C: float
    alpha: int


@dataclass(frozen=True)
class Absorption:
    """W and |D|² as exact real polynomials {(i, j): c} in p and Ω, and with Ω = q − vp in p and q."""

    W: Polynomial
    D2: Polynomial
    v: Fraction

    @cached_property
    def moving(self) -> tuple[Polynomial, Polynomial]:
        return moving(self.W, self.v), moving(self.D2, self.v)

    def exponent(self, gamma: Fraction) -> Fraction:
        """e with W/|D|² of order q^{−e} for p of order q^γ."""
        tops = [_top(a, gamma.numerator, gamma.denominator) for a in self.moving]
        return Fraction(tops[1] - tops[0], gamma.denominator)

    @classmethod
    def of(cls, guide: Guide) -> Absorption:
        (dr, di), (nr, ni) = _parts(guide.D_rest), _parts(guide.N_rest)
        W = add(multiply(nr, di), scaled(multiply(ni, dr), Fraction(-1)))
        return cls(W, add(multiply(dr, dr), multiply(di, di)), guide.v)


def _parts(polynomial: Polynomial) -> tuple[Polynomial, Polynomial]:
    """Real and imaginary part at P = ip, s = iΩ; P occurs in even powers."""
    real: Polynomial = {}
    imaginary: Polynomial = {}
    for (i, j), c in polynomial.items():
        turn = (i + j) % 4
        (imaginary if j % 2 else real)[i, j] = c if turn in (0, 1) else -c
    return real, imaginary


def prove_tail(guide: Guide, gap: Fraction | None, least: float = 1.0, most: float = 1e9) -> Tail | None:
    """A tail theorem with X as small as is found quickly; None where there is none (faster than the track's waves).

    Floats propose X and the blocks; what is returned has been proved.
    """
    absorption = Absorption.of(guide)
    if not absorption.W or not guide.v:
        return None
    X, tries = least, 0
    while X <= most and tries < 8:  # noqa: SIM300 — X is no constant
        plan = _plan(absorption, guide, gap, X)
        if plan is not None:
            tries += 1
            tail = _prove(absorption, guide, plan)
            if tail is not None and outweighs(tail, guide.v, gap):
                return tail
        X *= _RATIO if tries == 0 else _RATIO**2
    return None


def _plan(absorption: Absorption, guide: Guide, gap: Fraction | None, X: float) -> Tail | None:
    """The best blocks in floats, with bounds that leave room, or None where none outweighs."""
    alpha = _orders(absorption)[2]
    C = _ROOM * _sampled_envelope(guide, X, alpha)
    best: tuple[float, Tail] | None = None
    floats = _floats(guide)
    for gamma, intervals in _blocks(guide):
        if max(z2 for _, z2 in intervals) * float(guide.v) * X ** float(gamma - 1) >= 0.99:
            continue
        e = absorption.exponent(gamma)
        kappas = [
            0.8 * _sampled_block(floats, float(guide.v), X, float(gamma), z1, z2, float(e)) for z1, z2 in intervals
        ]
        blocks = tuple(
            (*z, float(np.float32(kappa))) for z, kappa in zip(intervals, kappas, strict=True) if kappa > 0
        )
        tail = Tail(X, gamma, blocks, e, _OMEGA, float(np.float32(C)), alpha)
        if blocks and np.isfinite(C) and outweighs(tail, guide.v, gap):
            size = sum(kappa * (z2 - z1) for z1, z2, kappa in blocks) * X ** float(gamma - e)
            size = size if len(blocks) == 1 else size * 1e-6  # one block makes the shorter proof
            if best is None or size > best[0]:
                best = (size, tail)
    return None if best is None else best[1]


def _prove(absorption: Absorption, guide: Guide, plan: Tail) -> Tail | None:
    """The plan with a proved C, and κ as planned or half of it, if they are proved."""
    C = _envelope(absorption, guide.v, plan)
    if C is None:
        return None
    for factor in (1.0, 0.5, 0.1):
        tail = replace(plan, blocks=tuple((z1, z2, kappa * factor) for z1, z2, kappa in plan.blocks))
        if block_holds(absorption, guide.v, tail):
            # less than what is proved, so that a checker need not come as near
            blocks = tuple((z1, z2, kappa * 0.9) for z1, z2, kappa in tail.blocks)
            return replace(tail, C=1.1 * max(C, plan.C / _ROOM), blocks=blocks)
    return None


def _power(absorbing: Any, p: Any, omega: Any) -> Any:
    """W/|D|² in floats."""
    D, N = absorbing
    p, omega = np.broadcast_arrays(p, omega)
    with np.errstate(all="ignore"):
        return -(polyval2d(1j * p, 1j * omega, N) / polyval2d(1j * p, 1j * omega, D)).imag


def _floats(guide: Guide) -> tuple[Any, Any]:
    return Table.of(guide.D_rest).d, Table.of(guide.N_rest).d


def _sampled_envelope(guide: Guide, X: float, alpha: int) -> float:
    v = float(guide.v)
    p = np.geomspace(X / v, 1e4 * X / v, 60)[:, None]
    omega = -v * p * np.concatenate([[0.0], np.geomspace(1e-7, 1, 120)])[None, :]
    return float(np.max(np.abs(_power(_floats(guide), p, omega)) * p**alpha))


def _sampled_block(floats: Any, v: float, X: float, gamma: float, z1: float, z2: float, e: float) -> float:
    q = X * np.geomspace(1, 1e6, 13)[None, :]
    p = np.linspace(z1, z2, 31)[:, None] * q**gamma
    return float(np.min(_power(floats, p, q - v * p) * q**e))


def _orders(absorption: Absorption) -> tuple[tuple[int, int], tuple[int, int], int]:
    """Degrees in p, total degrees of (W, |D|²), and the exponent α of the envelope."""
    W, D2 = absorption.W, absorption.D2
    by_p = max(i for i, _ in W), max(i for i, _ in D2)
    total = max(i + j for i, j in W), max(i + j for i, j in D2)
    return by_p, total, min(by_p[1] - by_p[0], total[1] - total[0])


def outweighs(tail: Tail, v: Fraction, gap: Fraction | None) -> bool:
    """(c): absorbed > given at X, and so for all q ≥ X."""
    if not (tail.alpha > 1 and tail.gamma >= 0 and tail.alpha - 1 >= tail.e - tail.gamma):
        return False
    with precision(64):
        X, speed = arb(tail.X), _ball(v)
        sieve = 2 * arb.pi() / _ball(gap) if gap is not None else arb(0)
        absorbed = arb(0)
        for z1, z2, kappa in tail.blocks:
            length = (arb(z2) - arb(z1)) * X ** _ball(tail.gamma) - sieve
            if length > 0:  # a shorter block absorbs too, but how much is not known
                absorbed += length * arb(kappa) * X ** -_ball(tail.e)
        p = X / speed
        given = arb(tail.C) * (p ** (1 - tail.alpha) / (tail.alpha - 1) + sieve * p ** (-tail.alpha))
        return bool(absorbed > given)


def _blocks(guide: Guide) -> list[tuple[Fraction, list[tuple[float, float]]]]:
    """Blocks that may absorb: round 0, beside it, or several side by side, as wide as the p-roots run at infinity."""
    out: list[tuple[Fraction, list[tuple[float, float]]]] = []
    for edge in edges(guide.D, guide.N):
        if not 0 <= edge.slope <= 1:
            continue
        roots = np.roots([float(c) for c in reversed(edge.roots)])
        scale = float(np.abs(roots).max()) if len(roots) else 1.0
        ends = [(-1.4, 1.4), (-0.9, 0.9), (-0.5, 0.5), (-1.4, -0.6), (-0.8, -0.2), (0.1, 0.4), (-3.0, -2.0)]
        choices = [[end] for end in ends] + [_side_by_side(-2.0, 1.2, 8), _side_by_side(-2.0, 0.5, 16)]
        if edge.slope == 1:
            choices += [_round(root.real / scale, n) for root in roots if abs(root.imag) < 1e-9 * scale for n in (3, 6)]
        for choice in choices:
            z = [(float(np.float32(a * scale)), float(np.float32(b * scale))) for a, b in choice]
            if edge.slope == 1:
                z = [(a, b) for a, b in z if b * float(guide.v) < 0.95]
            if z:
                out.append((edge.slope, z))
    return out


def _side_by_side(low: float, high: float, n: int) -> list[tuple[float, float]]:
    ends = np.linspace(low, high, n + 1).tolist()
    return list(pairwise(ends))


def _round(z: float, levels: int) -> list[tuple[float, float]]:
    """Blocks that grow away from z on both sides: next to a wave that runs along, absorption is strongest."""
    steps = [2.0**-k for k in range(levels + 1)]
    sides = [[z * (1 + sign * step) for step in steps] for sign in (-1.0, 1.0)]
    return [(min(a, b), max(a, b)) for side in sides for a, b in pairwise(side)]


def block_holds(absorption: Absorption, v: Fraction, tail: Tail) -> bool:
    """(a): W/|D|² ≥ κ q^{−e} for p = z q^γ, z₁ ≤ z ≤ z₂, q ≥ X, where q − vp > 0, on disjoint blocks."""
    k, m = tail.gamma.numerator, tail.gamma.denominator
    with precision(64):
        last = max((z2 for _, z2, _ in tail.blocks), default=0.0)
        if not (tail.gamma <= 1 and arb(max(last, 0.0)) * _ball(v) * arb(tail.X) ** _ball(tail.gamma - 1) < 1):
            return False
        tau = float(((1 / arb(tail.X)) ** (arb(1) / m)).upper()) * UP
    if tail.e != absorption.exponent(tail.gamma):
        return False
    W, D2 = (in_block(a, k, m) for a in absorption.moving)
    if any(b > a for (_, b, _), (a, _, _) in pairwise(sorted(tail.blocks))):
        return False
    rest = scaled(W, Fraction(-1))
    return all(
        _negative(add(scaled(D2, Fraction(kappa)), rest), ((z1, z2), (0.0, tau))) for z1, z2, kappa in tail.blocks
    )  # κ |D|² − W < 0 on each box


def in_block(polynomial: Polynomial, k: int, m: int) -> Polynomial:
    """A polynomial in p and q at p = z τ^{−k}, q = τ^{−m}, times τ^top, in z and τ."""
    top = _top(polynomial, k, m)
    return {(a, top - k * a - m * b): c for (a, b), c in polynomial.items()}


def _top(polynomial: Polynomial, k: int, m: int) -> int:
    return max(k * a + m * b for a, b in polynomial)


def _envelope(absorption: Absorption, v: Fraction, tail: Tail) -> float | None:
    """(b): C with |W| p^α ≤ C |D|² for p ≥ X/v, −vp ≤ Ω ≤ 0, on two charts; None where it is not bounded."""
    parts = [_supremum(*chart) for chart in envelope_charts(absorption, v, tail)]
    bounds_ = [part for part in parts if part is not None]
    return max(bounds_) * UP if len(bounds_) == len(parts) else None


def envelope_charts(absorption: Absorption, v: Fraction, tail: Tail) -> tuple[tuple[Any, ...], ...]:
    """For each chart |W|·weight and |D|² as polynomials, the box, and what bounds the product of its variables.

    Near: u = 1/p ≤ v/X and −Ω ≤ ω₀ with u·(−Ω) ≤ v. Far: r = −Ω/p ≤ v and z = −1/Ω ≤ 1/ω₀ with r z ≤ v/X.
    """
    (iw, i2), (nw, n2), alpha = _orders(absorption)
    speed = float(v) * UP
    u0 = speed / tail.X * UP

    def near(a: Polynomial, top: int) -> Polynomial:
        return {(top - i, j): c * (-1) ** j for (i, j), c in a.items()}

    def far(a: Polynomial, top: int, whole: int) -> Polynomial:
        return {(top - i, whole - i - j): c * (-1) ** j for (i, j), c in a.items()}

    lift: Polynomial = {(i2 - iw - alpha, 0): Fraction(1)}
    weight: Polynomial = {(i2 - iw - alpha, n2 - nw - alpha): Fraction(1)}
    return (
        (multiply(near(absorption.W, iw), lift), near(absorption.D2, i2), ((0.0, u0), (0.0, tail.omega0)), speed),
        (
            multiply(far(absorption.W, iw, nw), weight),
            far(absorption.D2, i2, n2),
            ((0.0, speed), (0.0, 1 / tail.omega0 * UP)),
            u0,
        ),
    )


def _supremum(
    top: Polynomial, bottom: Polynomial, box: tuple[tuple[float, float], tuple[float, float]], product: float
) -> float | None:
    """A bound of |top|/bottom on the box where x y ≤ product, by branch and bound; None if bottom may vanish."""
    above, below = Table.of(top), Table.of(bottom)
    boxes, tried = _grid(*box, 8, 4), 0
    known, proved = 0.0, 0.0
    for _ in range(_SPLIT):
        x, rx, y, ry = boxes
        inside = (x - rx) * (y - ry) <= product * UP
        boxes = tuple(part[inside] for part in boxes)
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
        if tried > _MOST_BOXES:
            return None
        boxes = _halved(boxes, by_x)
    return None


def _negative(
    polynomial: Polynomial, box: tuple[tuple[float, float], tuple[float, float]], product: float | None = None
) -> bool:
    """True if the polynomial is proved negative on the box (only where x y ≤ product), by halving boxes."""
    table = Table.of(polynomial)
    boxes, tried = _grid(*box, 8, 4), 0
    for _ in range(_SPLIT):
        if product is not None:
            x, rx, y, ry = boxes
            inside = (x - rx) * (y - ry) <= product * UP
            boxes = tuple(part[inside] for part in boxes)
        _, high, by_x = bounds(table, boxes)
        open_ = ~(high < 0)
        boxes, by_x = tuple(part[open_] for part in boxes), by_x[open_]
        tried += len(open_)
        if not len(by_x):
            return True
        if tried > _MOST_BOXES:
            return False
        boxes = _halved(boxes, by_x)
    return False


def bounds(table: Table, boxes: tuple[Any, ...]) -> tuple[Any, Any, Any]:
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


def _grid(x: tuple[float, float], y: tuple[float, float], nx: int, ny: int) -> tuple[Any, ...]:
    def cells(ends: tuple[float, float], n: int) -> tuple[Any, Any]:
        edges_ = np.linspace(*ends, n + 1)
        middle = (edges_[1:] + edges_[:-1]) / 2
        return middle, np.maximum(edges_[1:] - middle, middle - edges_[:-1]) * UP

    (a, ra), (b, rb) = cells(x, nx), cells(y, ny)
    parts = np.meshgrid(a, b, indexing="ij"), np.meshgrid(ra, rb, indexing="ij")
    return parts[0][0].ravel(), parts[1][0].ravel(), parts[0][1].ravel(), parts[1][1].ravel()


def _halved(boxes: tuple[Any, ...], by_x: Any) -> tuple[Any, ...]:
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


def _ball(x: Fraction) -> arb:
    return arb(fmpq(x.numerator, x.denominator))
