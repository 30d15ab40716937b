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

from mpsolve.characteristic.table import Table
from mpsolve.numbers.balls import precision
from mpsolve.numbers.float64 import distinct, value_at
from mpsolve.numbers.jets import UP, U
from mpsolve.passivity.decay import Edge, edges
from mpsolve.problem.reduced import Guide
from mpsolve.tracks.waveguide import Polynomial, add, moving, multiply, scaled

_RATIO = 1.3  # of one X to the next that is tried
_SPLIT = 80  # halvings of a box at most
_MOST_BOXES = 6000  # in the search for a block
_MOST_ENVELOPE = 40000  # and for the envelope
_TRIES = 6  # of proofs
_SHARES = (1.0, 0.2)  # of a planned κ that are tried
_TRIMMED = 1 / 16  # of a block that is too short for halves, at each end
_HALVINGS = 4  # of a block that is not proved as it stands
_PRICE = 0.03  # of a further block, of all that is absorbed
_ROOM = 1.8  # between what floats sample and what is to be proved
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
    if not absorption.W or not guide.v or overtakes(absorption, guide.v):
        return None
    slopes = [edge for edge in edges(guide.D, guide.N) if 0 <= edge.slope <= 1]
    wide, narrow = ([_Search(absorption, guide, edge, width) for edge in slopes] for width in (3.0, 1.3))
    sieve = 2 * np.pi / float(gap) if gap is not None else 0.0
    X, tries, C = max(least, min((search.shortest(sieve) for search in wide), default=least)), 0, None
    most = max(most, 1e6 * X)
    while X <= most and tries < _TRIES:  # noqa: SIM300 — X is no constant
        searches = narrow if tries % 2 else wide  # wide blocks absorb more, narrow ones are proved more easily
        plan = _plan(absorption, guide, searches, gap, X, C)
        if plan is not None and C is None:
            tries += 1
            C = _envelope(absorption, guide.v, plan)  # for this X and all larger ones
            plan = None if C is None else _plan(absorption, guide, searches, gap, X, C)
            X *= 1 if C is not None else _RATIO
        if plan is not None:
            tries += 1
            tail = _prove(absorption, guide.v, gap, plan)
            if tail is not None:
                return tail
        X *= _RATIO if plan is None else _RATIO**2
    return None


def overtakes(absorption: Absorption, v: Fraction) -> bool:
    """In floats: some short wave of the track runs at a speed up to v, so that no envelope exists."""
    return slowest_short_wave(absorption) <= float(v)


def slowest_short_wave(absorption: Absorption) -> float:
    """In floats: the least speed of the waves of the track as they become short; infinite where there is none."""
    (_, i2), (_, n2), _ = _orders(absorption)
    speeds = np.zeros(i2 + 1)
    for (i, j), c in absorption.D2.items():
        if i + j == n2:
            speeds[i] = float(c * (-1) ** j)  # of r^(i2 − i), descending
    roots = np.roots(speeds)
    real = roots[(np.abs(roots.imag) < 1e-6 * np.abs(roots)) & (roots.real > 0)].real
    return float(real.min(initial=np.inf))


class _Search:
    """W/|D|² · q^e in floats at p = z q^γ on a grid of z, for one γ."""

    def __init__(self, absorption: Absorption, guide: Guide, edge: Edge, width: float) -> None:
        self.gamma, self.v = edge.slope, float(guide.v)
        self.e = absorption.exponent(edge.slope)
        k, self.m = edge.slope.numerator, edge.slope.denominator
        self.W, self.D2 = (Table.of(in_block(a, k, self.m)).d for a in absorption.moving)
        roots = np.roots([float(c) for c in reversed(edge.roots)])
        scale = float(np.abs(roots).max()) if len(roots) else 1.0
        real = [float(root.real) for root in roots if abs(root.imag) < 1e-9 * scale]
        steps = 2.0 ** (-np.arange(1, 40) / 2)
        near = np.concatenate([steps, [0.0], -steps])
        z = np.concatenate([np.linspace(-width, width, 61) * scale, *(root * (1 + near) for root in real)])
        self.z = distinct(z.astype(np.float32).astype(float))

    def shortest(self, sieve: float) -> float:
        """The X below which no block is as long as the sieve's loss."""
        if not self.gamma:
            return 1.0 if sieve < self.z[-1] - self.z[0] else np.inf
        return float((sieve / (self.z[-1] - self.z[0])) ** (1 / float(self.gamma)))

    def blocks(self, X: float, sieve: float) -> tuple[tuple[float, float, float], ...]:
        """Intervals between points of the grid, with the least value sampled there, that absorb most for X."""
        growth = X ** float(self.gamma)
        z = self.z[self.z * self.v * growth < 0.97 * X]
        if len(z) < 2:
            return ()
        tau = X ** (-1 / self.m) * np.concatenate([np.geomspace(1, 1e-3, 40), [0.0]])
        with np.errstate(all="ignore"):
            inner = np.concatenate([z, (z[1:] + z[:-1]) / 2])[:, None]
            f = _ratio(inner, tau[None, :], self.W, self.D2)
        least = np.where(np.isfinite(f), f, 0.0).min(1)
        return best_blocks(z, least[: len(z)], least[len(z) :], growth, sieve)


def best_blocks(
    z: Any, ends: Any, middles: Any, growth: float, sieve: float
) -> tuple[tuple[float, float, float], ...]:
    """Disjoint intervals with ends in z for which Σ (length·growth − sieve)·least value is largest; few of them."""
    cells = np.minimum(np.minimum(ends[1:], ends[:-1]), middles)
    n = len(z)
    kappa = np.zeros((n, n))
    for i in range(n - 1):
        kappa[i, i + 1 :] = np.minimum.accumulate(cells[i:])
    length = (z[None, :] - z[:, None]) * growth - sieve
    value = np.where((kappa > 0) & (length > 0), length * kappa, 0.0)
    price = 0.0
    for _ in range(2):
        best, before = np.zeros(n), np.full(n, -1)
        for j in range(1, n):
            sums = best[:j] + np.maximum(value[:j, j] - price, 0.0)
            before[j] = int(np.argmax(sums))
            best[j] = sums[before[j]]
        price = _PRICE * float(best[-1])  # of a block, so that few are taken
    blocks, j = [], n - 1
    while j > 0:
        i = int(before[j])
        if value[i, j] > price:
            blocks.append((float(z[i]), float(z[j]), float(kappa[i, j])))
        j = i
    return tuple(reversed(blocks))


def _plan(
    absorption: Absorption, guide: Guide, searches: list[_Search], gap: Fraction | None, X: float, C: float | None
) -> Tail | None:
    """The best blocks in floats with the proved C, or one that floats sample; None where none outweighs."""
    alpha = _orders(absorption)[2]
    bound = _ROOM * _sampled_envelope(absorption, guide.v, X, alpha) if C is None else 1.1 * C
    sieve = 2 * np.pi / float(gap) if gap is not None else 0.0
    best: tuple[float, Tail] | None = None
    for search in searches:
        # less than what is sampled, and less than what is proved, so that a checker need not come as near
        blocks = tuple((z1, z2, float(np.float32(0.7 * kappa))) for z1, z2, kappa in search.blocks(X, sieve))
        tail = Tail(X, search.gamma, blocks, search.e, _OMEGA, bound, alpha)
        if blocks and np.isfinite(bound) and outweighs(tail, guide.v, gap):
            size = sum(kappa * (z2 - z1) for z1, z2, kappa in blocks) * X ** float(search.gamma - search.e)
            if best is None or size / len(blocks) > best[0]:
                best = (size / len(blocks), tail)
    return None if best is None else best[1]


def _prove(absorption: Absorption, v: Fraction, gap: Fraction | None, plan: Tail) -> Tail | None:
    """The plan with those of its blocks, or of their halves, that are proved, if they outweigh."""
    length = 2 * np.pi / float(gap) / plan.X ** float(plan.gamma) if gap is not None else 0.0
    proved: list[tuple[float, float, float]] = []
    waiting = [(block, 0) for block in plan.blocks]
    while waiting:
        (z1, z2, kappa), depth = waiting.pop()
        held = next((x for x in _SHARES if block_holds(absorption, v, _with(plan, z1, z2, x * kappa / 0.9))), None)
        if held is not None:
            proved.append((z1, z2, held * kappa))
        elif depth < _HALVINGS:
            middle, rim = float(np.float32((z1 + z2) / 2)), float(np.float32((z2 - z1) * _TRIMMED))
            halves = ((z1, middle, kappa), (middle, z2, kappa))
            long = [half for half in halves if half[1] - half[0] > length]
            # where two waves are nearly one, W and |D|² vanish together at an end: leave the ends out
            trimmed = (float(np.float32(z1 + rim)), float(np.float32(z2 - rim)), kappa)
            waiting += [(part, depth + 1) for part in long or [trimmed]]
    tail = replace(plan, blocks=tuple(sorted(proved)))
    return tail if outweighs(tail, v, gap) else None


def _with(plan: Tail, z1: float, z2: float, kappa: float) -> Tail:
    """The plan with this block alone."""
    return replace(plan, blocks=((z1, z2, kappa),))


def _ratio(x: Any, y: Any, top: Any, bottom: Any) -> Any:
    x, y = np.broadcast_arrays(x, y)
    return value_at(x, y, top) / value_at(x, y, bottom)


def _sampled_envelope(absorption: Absorption, v: Fraction, X: float, alpha: int) -> float:
    """The largest |W|/|D|² p^α that floats meet where p ≥ X/v."""
    plan = Tail(X, Fraction(0), (), Fraction(0), _OMEGA, 0.0, alpha)
    largest = 0.0
    for top, bottom, (x, y), product in envelope_charts(absorption, v, plan):
        a = np.concatenate([[0.0], np.geomspace(1e-3, 1, 40)])[:, None] * x[1]
        b = np.concatenate([[0.0], np.geomspace(1e-3, 1, 40)])[None, :] * y[1]
        with np.errstate(all="ignore"):
            values = np.abs(_ratio(a, b, Table.of(top).d, Table.of(bottom).d))
        values = values[(a * b <= product) & np.isfinite(values)]
        largest = max(largest, float(values.max(initial=0.0)))
    return largest


def _orders(absorption: Absorption) -> tuple[tuple[int, int], tuple[int, int], int]:
    """Degrees in p, total degrees of (W, |D|²), and the exponent α of the envelope."""
    W, D2 = absorption.W, absorption.D2
    by_p = max(i for i, _ in W), max(i for i, _ in D2)
    total = max(i + j for i, j in W), max(i + j for i, j in D2)
    return by_p, total, min(by_p[1] - by_p[0], total[1] - total[0])


def outweighs(tail: Tail, v: Fraction, gap: Fraction | None) -> bool:
    """(c): absorbed > given at X, and so for all q ≥ X, if each block absorbs; blocks must not overlap."""
    if any(b > a for (_, b, _), (a, _, _) in pairwise(sorted(tail.blocks))):
        return False
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


def block_holds(absorption: Absorption, v: Fraction, tail: Tail) -> bool:
    """(a): W/|D|² ≥ κ q^{−e} for p = z q^γ, z₁ ≤ z ≤ z₂, q ≥ X, where q − vp > 0, on each block."""
    k, m = tail.gamma.numerator, tail.gamma.denominator
    with precision(64):
        last = max((z2 for _, z2, _ in tail.blocks), default=0.0)
        if not (tail.gamma <= 1 and arb(max(last, 0.0)) * _ball(v) * arb(tail.X) ** _ball(tail.gamma - 1) < 1):
            return False
        tau = float(((1 / arb(tail.X)) ** (arb(1) / m)).upper()) * UP
    if tail.e != absorption.exponent(tail.gamma):
        return False
    W, D2 = (in_block(a, k, m) for a in absorption.moving)
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
    known = 0.0
    for top, bottom, box, product in envelope_charts(absorption, v, tail):
        found = _supremum(top, bottom, box, product, known)
        if found is None:
            return None
        known = found
    return known * UP


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
    top: Polynomial,
    bottom: Polynomial,
    box: tuple[tuple[float, float], tuple[float, float]],
    product: float,
    least_bound: float = 0.0,
) -> float | None:
    """A bound ≥ least_bound of |top|/bottom on the box where x y ≤ product, by branch and bound.

    None if bottom may vanish.
    """
    above, below = Table.of(top), Table.of(bottom)
    boxes, tried = _grid(*box, 8, 4), 0
    known, proved = least_bound / 1.5, least_bound
    for _ in range(_SPLIT):
        boxes = _clipped(boxes, product)
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
        if tried > _MOST_ENVELOPE:
            return None
        boxes = _halved(boxes, by_x)
    return None


def _negative(polynomial: Polynomial, box: tuple[tuple[float, float], tuple[float, float]]) -> bool:
    """True if the polynomial is proved negative on the box, by halving boxes."""
    table = Table.of(polynomial)
    boxes, tried = _grid(*box, 8, 4), 0
    for _ in range(_SPLIT):
        low, high, by_x = bounds(table, boxes)
        if (low > 0).any():
            return False
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


def _clipped(boxes: tuple[Any, ...], product: float) -> tuple[Any, ...]:
    """Boxes in x, y ≥ 0 that hold all points of the given ones with x y ≤ product."""
    x, rx, y, ry = boxes
    low, high = np.maximum(x - rx - 4 * U * x, 0.0), (x + rx) * UP
    below, above = np.maximum(y - ry - 4 * U * y, 0.0), (y + ry) * UP
    inside = low * below <= product * UP
    low, high, below, above = (part[inside] for part in (low, high, below, above))
    with np.errstate(all="ignore"):
        high = np.minimum(high, np.where(below > 0, product / below * UP, np.inf))
        above = np.minimum(above, np.where(low > 0, product / low * UP, np.inf))
    high, above = np.maximum(high, low), np.maximum(above, below)
    x, y = (low + high) / 2, (below + above) / 2
    return x, np.maximum(high - x, x - low) * UP + 4 * U * x, y, np.maximum(above - y, y - below) * UP + 4 * U * y


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
