"""−Im G(q) is positive definite for all q ≥ X and all parameters of a box: the tail theorem over a box (SPEC, 6.2).

At p = z q^γ, Ω = q ω with ω = 1 − v z q^{γ−1}, each part of W and of |D|² is a polynomial in z, ω, τ = q^{−1/m} and
the parameters, bounded on cells of z over 0 ≤ τ ≤ X^{−1/m}. A large sieve compares what blocks of z take with what
short waves give.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, TypeVar

import numpy as np

from mpsolve.numbers.affine import Affine
from mpsolve.numbers.arrays import Reals
from mpsolve.numbers.jets import UP
from mpsolve.numbers.several import evaluated
from mpsolve.passivity.decay import edges
from mpsolve.passivity.envelope import Envelope
from mpsolve.passivity.far_chart import MARGIN, FarChart, given_from
from mpsolve.passivity.subject import Subject
from mpsolve.tracks.waveguide import Polynomial, moving

_RATIO = 1.25  # of one X to the next that is tried
_STEPS = 4  # of them at once, until one holds
_LESS, _MORE = 0.9, 1.1  # of κ and of C in what a checker is told
_SHARE = 0.7  # of what is taken that must outweigh what is given, so that it does with those numbers
_FIRST = 2.0**14  # times the least X: how far a box is tried before it is halved
_DEPTH = 8  # halvings of the box of parameters at most; each part has its own X
Found = TypeVar("Found")


def far(envelope: Envelope, least: float = 1.0, most: float = 1e7) -> float | None:
    """X for the whole box of parameters of the envelope, scaled; None where none is found below `most`.

    Where the waves of the track move too much over the box for one X, it is halved: X is the largest of its parts.
    """
    waiting, X, whole = [(envelope, 0)], least, np.array(envelope.high) - np.array(envelope.low)
    while waiting:
        part, depth = waiting.pop()
        if not _may_be(part):
            return None
        last = depth == _DEPTH or not whole.any()
        found = _far(part, X, most if last else min(most, max(X, _FIRST * least)))
        if found is not None:
            X = found
        elif last or (depth == 0 and not all(_far(point, least, most) for point in _corners(part))):
            return None
        else:
            waiting += [(half, depth + 1) for half in _halves(part, whole)]
    return X


def _part(envelope: Envelope, low: Reals, high: Reals) -> Envelope:
    return Envelope(envelope.subject, tuple(low.tolist()), tuple(high.tolist()), envelope.of, envelope.beside)


def _corners(envelope: Envelope) -> list[Envelope]:
    """The least and the greatest parameters, each alone: where they fail, halving does not help."""
    low, high = np.array(envelope.low), np.array(envelope.high)
    least = low + (high - low) * 2.0**-20
    return [_part(envelope, least, least), _part(envelope, high, high)]


def _halves(part: Envelope, whole: Any) -> list[Envelope]:
    """Two boxes of parameters, along the side that is longest beside the whole."""
    low, high = np.array(part.low), np.array(part.high)
    k = int(np.argmax((high - low) / np.where(whole > 0, whole, np.inf)))
    middle = low[k] / 2 + high[k] / 2
    first, second = high.copy(), low.copy()
    first[k] = second[k] = middle
    return [_part(part, low, first), _part(part, second, high)]


def _may_be(envelope: Envelope) -> bool:
    low, high = np.array([envelope.low]), np.array([envelope.high])
    gap = least_gap(envelope.subject, low, high)
    return envelope.fastest > 0 and envelope.subject.power.alpha > 1 and (gap is None or gap > 0)


def _looked_at(envelope: Envelope) -> tuple[list[Affine], float | None, list[FarChart]]:
    """The parameters of the box, the least gap, and the charts in which power may be taken."""
    subject, low, high = envelope.subject, np.array([envelope.low]), np.array([envelope.high])
    charts = [FarChart.of(subject, gamma) for gamma in slopes(subject, low / 2 + high / 2)]
    return [f.take(0) for f in subject.parameters(low, high)], least_gap(subject, low, high), charts


def _far(envelope: Envelope, least: float, most: float) -> float | None:
    """X for all parameters of the box at once."""
    parameters, gap, charts = _looked_at(envelope)

    def holds(X: float) -> float | None:
        given = given_from(envelope, X, gap)
        taken = (chart.taken(envelope, parameters, X, gap, envelope.subject.power.alpha) for chart in charts)
        return X if np.isfinite(given) and any(x > given * MARGIN for x in taken) else None

    return _first(least, most, holds)


def _first(least: float, most: float, holds: Callable[[float], Found | None]) -> Found | None:
    """What holds at least·ratio^n with n as small as is found by long steps and halving; None where nothing does."""
    low, n, found = -1, 0, None
    while least * _RATIO**n <= most and (found := holds(least * _RATIO**n)) is None:
        low, n = n, n + _STEPS
    if found is None:
        return None
    while n - low > 1:
        middle = (n + low) // 2
        nearer = holds(least * _RATIO**middle)
        if nearer is None:
            low = middle
        else:
            n, found = middle, nearer
    return found


@dataclass(frozen=True)
class FarNumbers:
    """What a checker needs for the tail theorem over the box from X on, with room; all scaled.

    blocks: (z₁, z₂, κ), q^e W/|D|² ≥ κ at p = z q^γ. constant: C, |W|/|D|² ≤ C p^−α where p ≥ X/(greatest v).
    """

    X: float
    gamma: Fraction
    e: Fraction
    alpha: int
    blocks: tuple[tuple[float, float, float], ...]
    constant: float


def far_numbers(envelope: Envelope, least: float = 1.0, most: float = 1e7) -> FarNumbers | None:
    """The theorem with numbers from which something is taken off, at the least X found; None where there is none."""
    if not _may_be(envelope):
        return None
    parameters, gap, charts = _looked_at(envelope)
    alpha = envelope.subject.power.alpha

    def holds(X: float) -> FarNumbers | None:
        given = given_from(envelope, X, gap)
        for chart in charts:
            if not np.isfinite(given) or not chart.taken(envelope, parameters, X, gap, alpha) * _SHARE > given:
                continue
            blocks = chart.blocks(envelope, parameters, X, gap)
            if chart.of_blocks(blocks, X, gap) * _SHARE > given:
                C = float(envelope.constants(np.array([X / envelope.fastest / UP]))[0])
                less = tuple((a, b, kappa * _LESS) for a, b, kappa in blocks)
                return FarNumbers(X, chart.gamma, chart.e, alpha, less, C * _MORE)
        return None

    return _first(least, most, holds)


def least_gap(subject: Subject, low: Reals, high: Reals) -> float | None:
    """A lower bound of the distance of neighbouring places over the box; None for one place."""
    distances, _ = subject.distances(subject.parameters(low, high))
    return min((float(np.min(d.low)) for d in distances), default=None)


def slopes(subject: Subject, x: Reals) -> list[Fraction]:
    """Exponents γ with 0 ≤ γ ≤ 1 of the track at a point of the box."""
    point = [Fraction(float(t)) for t in x[0]]

    D: Polynomial = {key: c for key, terms in subject.rows.items() if (c := evaluated(terms, point))}
    found = {edge.slope for edge in edges(moving(D, evaluated(subject.v.items(), point)), {(0, 0): Fraction(1)})}
    return sorted(gamma for gamma in found if 0 <= gamma <= 1)
