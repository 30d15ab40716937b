"""−Im G(q) is positive definite for all real q ≥ X: what the track absorbs outweighs what it gives (SPEC, tail).

With W = −Im(N conj D) at P = ip, s = iΩ: −Im u*Gu = (1/2π)∫ |Σ u_j e^{−ipξ_j}|² W/|D|² dp. It absorbs on the block
p = z q^γ, z₁ ≤ z ≤ z₂, at least κ q^{−e} (for each of a few blocks); it gives where p ≥ q/v, at most C p^{−α}. A
large-sieve inequality bounds ∫|V|² over intervals by their lengths ± 2π/δ, δ the smallest gap between contacts.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from itertools import pairwise
from typing import Any

import numpy as np
from flint import arb

from mpsolve.characteristic.table import Table
from mpsolve.frozen import frozen
from mpsolve.numbers.balls import precision, rational_ball
from mpsolve.numbers.jets import UP
from mpsolve.numbers.several import multiply, plus
from mpsolve.passivity.absorption import Absorption, in_block, orders, overtakes
from mpsolve.passivity.decay import edges
from mpsolve.passivity.plane import negative, supremum
from mpsolve.passivity.taking import Search, ratio
from mpsolve.problem.reduced import Guide
from mpsolve.proof.effort import Effort
from mpsolve.tracks.waveguide import Polynomial, scaled

_RATIO = 1.3  # of one X to the next that is tried
_MOST = 2.0**127  # that a short float holds
_TRIES = 6  # of proofs
_SHARES = (1.0, 0.2)  # of a planned κ that are tried
_TRIMMED = 1 / 16  # of a block that is too short for halves, at each end
_HALVINGS = 4  # of a block that is not proved as it stands
_ROOM = 1.8  # between what floats sample and what is to be proved
_OMEGA = 4.0  # where the two charts of the envelope meet


@frozen
class Tail:
    """The proof: X, the blocks (z₁, z₂, κ) at γ with e, the envelope (ω₀, C, α). Floats are exact as they stand."""

    X: float
    gamma: Fraction
    blocks: tuple[tuple[float, float, float], ...]
    e: Fraction
    omega0: float
    C: float
    alpha: int


_KNOWN: dict[Any, Tail | None] = {}


def prove_tail(
    guide: Guide, gap: Fraction | None, effort: Effort | None = None, least: float = 1.0, most: float = 1e9
) -> Tail | None:
    """A tail theorem with X as small as is found quickly; None where there is none (faster than the track's waves).

    Floats propose X and the blocks; what is returned has been proved. The last answer is kept: one question about
    several vehicles asks for it again and again. EffortError where the time of `effort` is over.
    """
    told = (
        *(frozenset(p.items()) for p in (guide.D, guide.N, guide.D_rest, guide.N_rest)),
        guide.v,
        gap,
        least,
        most,
    )
    if told not in _KNOWN:
        found = _proved_tail(guide, gap, effort or Effort(), least, most)
        _KNOWN.clear()
        _KNOWN[told] = found
    return _KNOWN[told]


def forget() -> None:
    """The last answer, so that times of questions can be compared."""
    _KNOWN.clear()


def _proved_tail(guide: Guide, gap: Fraction | None, effort: Effort, least: float, most: float) -> Tail | None:
    absorption = Absorption.of(guide)
    if not absorption.W or not guide.v or overtakes(absorption, guide.v):
        return None
    slopes = [edge for edge in edges(guide.D, guide.N) if 0 <= edge.slope <= 1]
    wide, narrow = ([Search(absorption, guide, edge, width) for edge in slopes] for width in (3.0, 1.3))
    sieve = 2 * np.pi / float(gap) if gap is not None else 0.0
    X, tries, C = max(least, min((search.shortest(sieve) for search in wide), default=least)), 0, None
    most = max(most, 1e6 * X)
    while X <= most and tries < _TRIES:  # noqa: SIM300 — X is no constant
        searches = narrow if tries % 2 else wide  # wide blocks absorb more, narrow ones are proved more easily
        plan = _plan(absorption, guide, searches, gap, X, C)
        if plan is not None and C is None:
            tries += 1
            C = _envelope(absorption, guide.v, plan, effort)  # for this X and all larger ones
            plan = None if C is None else _plan(absorption, guide, searches, gap, X, C)
            X *= 1 if C is not None else _RATIO
        if plan is not None:
            tries += 1
            tail = _prove(absorption, guide.v, gap, plan, effort)
            if tail is not None:
                return tail
        X *= _RATIO if plan is None else _RATIO**2
    return None


def _plan(
    absorption: Absorption, guide: Guide, searches: list[Search], gap: Fraction | None, X: float, C: float | None
) -> Tail | None:
    """The best blocks in floats with the proved C, or one that floats sample; None where none outweighs."""
    alpha = orders(absorption)[2]
    bound = _ROOM * _sampled_envelope(absorption, guide.v, X, alpha) if C is None else 1.1 * C
    sieve = 2 * np.pi / float(gap) if gap is not None else 0.0
    best: tuple[float, Tail] | None = None
    for search in searches:
        # less than what is sampled, and less than what is proved, so that a checker need not come as near
        blocks = tuple(
            (z1, z2, float(np.float32(min(0.7 * kappa, _MOST)))) for z1, z2, kappa in search.blocks(X, sieve)
        )
        tail = Tail(X, search.gamma, blocks, search.e, _OMEGA, bound, alpha)
        if blocks and np.isfinite(bound) and outweighs(tail, guide.v, gap):
            size = sum(kappa * (z2 - z1) for z1, z2, kappa in blocks) * X ** float(search.gamma - search.e)
            if best is None or size / len(blocks) > best[0]:
                best = (size / len(blocks), tail)
    return None if best is None else best[1]


def _prove(absorption: Absorption, v: Fraction, gap: Fraction | None, plan: Tail, effort: Effort) -> Tail | None:
    """The plan with those of its blocks, or of their halves, that are proved, if they outweigh."""
    length = UP * 2 * np.pi / float(gap) / plan.X ** float(plan.gamma) if gap is not None else 0.0
    proved: list[tuple[float, float, float]] = []
    waiting = [(block, 0) for block in plan.blocks]
    while waiting:
        (z1, z2, kappa), depth = waiting.pop()
        if z2 - z1 <= length:  # it absorbs, but how much is not known
            continue
        tried = ((x, _with(plan, z1, z2, x * kappa / 0.9)) for x in _SHARES)
        held = next((x for x, tail in tried if block_holds(absorption, v, tail, effort)), None)
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


def _sampled_envelope(absorption: Absorption, v: Fraction, X: float, alpha: int) -> float:
    """The largest |W|/|D|² p^α that floats meet where p ≥ X/v."""
    plan = Tail(X, Fraction(0), (), Fraction(0), _OMEGA, 0.0, alpha)
    largest = 0.0
    for top, bottom, (x, y), product in envelope_charts(absorption, v, plan):
        a = np.concatenate([[0.0], np.geomspace(1e-3, 1, 40)])[:, None] * x[1]
        b = np.concatenate([[0.0], np.geomspace(1e-3, 1, 40)])[None, :] * y[1]
        with np.errstate(all="ignore"):
            values = np.abs(ratio(a, b, Table.of(top).d, Table.of(bottom).d))
        values = values[(a * b <= product) & np.isfinite(values)]
        largest = max(largest, float(values.max(initial=0.0)))
    return largest


def outweighs(tail: Tail, v: Fraction, gap: Fraction | None) -> bool:
    """(c): absorbed > given at X, and so for all q ≥ X, if each block absorbs; blocks must not overlap."""
    if any(b > a for (_, b, _), (a, _, _) in pairwise(sorted(tail.blocks))):
        return False
    if not (tail.alpha > 1 and tail.gamma >= 0 and tail.alpha - 1 >= tail.e - tail.gamma):
        return False
    with precision(64):
        X, speed = arb(tail.X), rational_ball(v)
        sieve = 2 * arb.pi() / rational_ball(gap) if gap is not None else arb(0)
        absorbed = arb(0)
        for z1, z2, kappa in tail.blocks:
            length = (arb(z2) - arb(z1)) * X ** rational_ball(tail.gamma) - sieve
            if length > 0:  # a shorter block absorbs too, but how much is not known
                absorbed += length * arb(kappa) * X ** -rational_ball(tail.e)
        p = X / speed
        given = arb(tail.C) * (p ** (1 - tail.alpha) / (tail.alpha - 1) + sieve * p ** (-tail.alpha))
        return bool(absorbed > given)


def block_holds(absorption: Absorption, v: Fraction, tail: Tail, effort: Effort) -> bool:
    """(a): W/|D|² ≥ κ q^{−e} for p = z q^γ, z₁ ≤ z ≤ z₂, q ≥ X, where q − vp > 0, on each block."""
    k, m = tail.gamma.numerator, tail.gamma.denominator
    with precision(64):
        last = max((z2 for _, z2, _ in tail.blocks), default=0.0)
        if not (
            tail.gamma <= 1
            and arb(max(last, 0.0)) * rational_ball(v) * arb(tail.X) ** rational_ball(tail.gamma - 1) < 1
        ):
            return False
        tau = float(((1 / arb(tail.X)) ** (arb(1) / m)).upper()) * UP
    if tail.e != absorption.exponent(tail.gamma):
        return False
    W, D2 = (in_block(a, k, m) for a in absorption.moving)
    rest = scaled(W, Fraction(-1))
    return all(
        negative(plus(scaled(D2, Fraction(kappa)), rest), ((z1, z2), (0.0, tau)), effort)
        for z1, z2, kappa in tail.blocks
    )  # κ |D|² − W < 0 on each box


def _envelope(absorption: Absorption, v: Fraction, tail: Tail, effort: Effort) -> float | None:
    """(b): C with |W| p^α ≤ C |D|² for p ≥ X/v, −vp ≤ Ω ≤ 0, on two charts; None where it is not bounded."""
    known = 0.0
    for top, bottom, box, product in envelope_charts(absorption, v, tail):
        found = supremum(top, bottom, box, product, effort, known)
        if found is None:
            return None
        known = found
    return known * UP


def envelope_charts(absorption: Absorption, v: Fraction, tail: Tail) -> tuple[tuple[Any, ...], ...]:
    """For each chart |W|·weight and |D|² as polynomials, the box, and what bounds the product of its variables.

    Near: u = 1/p ≤ v/X and −Ω ≤ ω₀ with u·(−Ω) ≤ v. Far: r = −Ω/p ≤ v and z = −1/Ω ≤ 1/ω₀ with r z ≤ v/X.
    """
    (iw, i2), (nw, n2), alpha = orders(absorption)
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
