"""−Im G(q) is positive definite for all q ≥ X and all parameters of a box, or of one track: the tail theorem.

What the track takes outweighs what it gives: −Im u*Gu = (1/2π)∫ |Σ u_j e^{−ipξ_j}|² W/|D|² dp, W = −Im(N conj D).

At p = z q^γ, Ω = q ω with ω = 1 − v z q^{γ−1}, each part of W and of |D|² is a polynomial in z, ω, τ = q^{−1/m} and
the parameters, bounded on cells of z over 0 ≤ τ ≤ X^{−1/m}. A large sieve compares what blocks of z take with what
short waves give.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np

from mpsolve.numbers.arrays import Reals
from mpsolve.numbers.jets import UP
from mpsolve.numbers.several import evaluated
from mpsolve.passivity.decay import edges, overtakes
from mpsolve.passivity.envelope import Envelope
from mpsolve.passivity.far_chart import MARGIN, FarChart, given_from
from mpsolve.passivity.subject import Subject
from mpsolve.problem.reduced import Guide
from mpsolve.proof.effort import Effort
from mpsolve.tracks.waveguide import Polynomial, moving

_RATIO = 1.25  # of one X to the next that is tried
_STEPS = 4  # of them at once, until one holds
_LESS, _MORE = 0.9, 1.1  # of κ and of C in what a checker is told
_SHARE = 0.7  # of what is taken that must outweigh what is given, so that it does with those numbers
_FIRST = 2.0**14  # times the least X: how far a box is tried before it is halved
_DEPTH = 8  # halvings of the box of parameters at most; each part has its own X
_MOST = 2.0**127  # that a short float holds
_FARTHEST = 1e9


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


class _Box:
    """The parameters of a box, the least gap, and the charts in which power may be taken."""

    def __init__(self, envelope: Envelope, effort: Effort | None = None) -> None:
        subject, low, high = envelope.subject, np.array([envelope.low]), np.array([envelope.high])
        self.envelope, self.effort, self.alpha = envelope, effort, subject.power.alpha
        self.parameters = [f.take(0) for f in subject.parameters(low, high)]
        self.gap = least_gap(subject, low, high)
        self.charts = [FarChart.of(subject, gamma) for gamma in slopes(subject, low / 2 + high / 2)]

    def enough(self, X: float, share: float) -> Iterator[FarChart]:
        """The charts in which this share of what is taken from X on is more than what is given."""
        if self.effort is not None:
            self.effort.spend(0)
        given = given_from(self.envelope, X, self.gap)
        for chart in self.charts if np.isfinite(given) else ():
            if chart.taken(self.envelope, self.parameters, X, self.gap, self.alpha) * share > given:
                yield chart

    def first(self, least: float, most: float, share: float) -> float | None:
        """X = least·ratio^n with n as small as is found by long steps and halving; None where there is none."""

        def holds(n: int) -> bool:
            return any(True for _ in self.enough(least * _RATIO**n, share))

        low, n = -1, 0
        while least * _RATIO**n <= most and not holds(n):
            low, n = n, n + _STEPS
        if least * _RATIO**n > most:
            return None
        while n - low > 1:
            middle = (n + low) // 2
            low, n = (low, middle) if holds(middle) else (middle, n)
        return least * _RATIO**n


def _far(envelope: Envelope, least: float, most: float) -> float | None:
    """X for all parameters of the box at once."""
    return _Box(envelope).first(least, most, 1 / MARGIN)


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


def far_numbers(
    envelope: Envelope, least: float = 1.0, most: float = 1e7, effort: Effort | None = None
) -> FarNumbers | None:
    """The theorem with numbers from which something is taken off, at the least X found; None where there is none."""
    if not _may_be(envelope):
        return None
    box = _Box(envelope, effort)
    X = box.first(least, most, _SHARE)
    while X is not None and most >= X:
        given = given_from(envelope, X, box.gap)
        for chart in box.enough(X, _SHARE):
            blocks = chart.blocks(envelope, box.parameters, X, box.gap)  # which take a little less
            if chart.of_blocks(blocks, X, box.gap) * _SHARE > given:
                C = float(envelope.constants(np.array([X / envelope.fastest / UP]))[0])
                less = tuple((a, b, min(kappa * _LESS, _MOST)) for a, b, kappa in blocks)
                return FarNumbers(X, chart.gamma, chart.e, box.alpha, less, C * _MORE)
        X *= _RATIO
    return None


def prove_tail(guide: Guide, gap: Fraction | None, effort: Effort | None = None) -> FarNumbers | None:
    """The theorem for one track at one velocity, and contacts no closer than the gap; None where there is none.

    The last answer is kept: one question about several vehicles asks for it again and again. EffortError where the
    time of `effort` is over.
    """
    told = (*(frozenset(p.items()) for p in (guide.D_rest, guide.N_rest)), guide.v, gap)
    if told not in _KNOWN:
        subject = Subject.of_guide(guide, [Fraction(0)] if gap is None else [Fraction(0), gap])
        some = bool(subject.power.w) and bool(guide.v) and not overtakes(guide, guide.v)
        found = far_numbers(Envelope(subject, (), ()), most=_FARTHEST, effort=effort) if some else None
        _KNOWN.clear()
        _KNOWN[told] = found
    return _KNOWN[told]


_KNOWN: dict[Any, FarNumbers | None] = {}


def forget_tail() -> None:
    """The last answer, so that times of questions can be compared."""
    _KNOWN.clear()


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
