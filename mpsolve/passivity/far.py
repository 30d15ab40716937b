"""−Im G(q) is positive definite for all q ≥ X and all parameters of a box: the tail theorem over a box (SPEC, 6.2).

At p = z q^γ, Ω = q ω with ω = 1 − v z q^{γ−1}, each part of W and of |D|² is a polynomial in z, ω, τ = q^{−1/m} and
the parameters, bounded on cells of z over 0 ≤ τ ≤ X^{−1/m}. A large sieve compares what blocks of z take with what
short waves give.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np

from mpsolve.numbers.affine import Affine, between, constant
from mpsolve.numbers.jets import UP
from mpsolve.passivity.decay import edges
from mpsolve.passivity.envelope import Envelope
from mpsolve.passivity.mesh import cells
from mpsolve.passivity.power import Terms, value
from mpsolve.passivity.subject import Subject
from mpsolve.passivity.tail import best_blocks
from mpsolve.tracks.waveguide import Polynomial, moving

_RATIO = 1.25  # of one X to the next that is tried
_SIDE = 9  # of the mesh
_FINE = 4  # parts of each cell of the mesh
_LESS, _MORE = 0.9, 1.1  # of κ and of C in what a checker is told
_SHARE = 0.7  # of what is taken that must outweigh what is given, so that it does with those numbers
_FIRST = 2.0**14  # times the least X: how far a box is tried before it is halved
_DEPTH = 8  # halvings of the box of parameters at most; each part has its own X
_MARGIN = 1 + 2.0**-20  # of what is taken over what is given: for the rounding of the sums


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


def _part(envelope: Envelope, low: Any, high: Any) -> Envelope:
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


def _far(envelope: Envelope, least: float, most: float) -> float | None:
    """X for all parameters of the box at once."""
    subject = envelope.subject
    low, high = np.array([envelope.low]), np.array([envelope.high])
    parameters = [f.take(0) for f in subject.parameters(low, high)]
    gap = least_gap(subject, low, high)
    charts = [_Chart.of(subject, gamma) for gamma in slopes(subject, low / 2 + high / 2)]
    X = least
    while X <= most:  # noqa: SIM300 — X is no constant
        given = _given(envelope, X, gap)
        for chart in charts:
            if (
                np.isfinite(given)
                and chart.taken(envelope, parameters, X, gap, subject.power.alpha) > given * _MARGIN
            ):
                return X
        X *= _RATIO
    return None


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
    subject = envelope.subject
    low, high = np.array([envelope.low]), np.array([envelope.high])
    parameters = [f.take(0) for f in subject.parameters(low, high)]
    gap = least_gap(subject, low, high)
    if envelope.fastest <= 0 or subject.power.alpha <= 1 or (gap is not None and not gap > 0):
        return None
    charts = [_Chart.of(subject, gamma) for gamma in slopes(subject, low / 2 + high / 2)]
    X = least
    while X <= most:  # noqa: SIM300 — X is no constant
        given = _given(envelope, X, gap)
        for chart in charts:
            taken = chart.taken(envelope, parameters, X, gap, subject.power.alpha)
            if np.isfinite(given) and taken * _SHARE > given:
                blocks = tuple((a, b, kappa * _LESS) for a, b, kappa in chart.blocks(envelope, parameters, X, gap))
                C = float(envelope.constants(np.array([X / envelope.fastest / UP]))[0])
                return FarNumbers(X, chart.gamma, chart.e, subject.power.alpha, blocks, C * _MORE)
        X *= _RATIO
    return None


def least_gap(subject: Subject, low: Any, high: Any) -> float | None:
    """A lower bound of the distance of neighbouring places over the box; None for one place."""
    distances, _ = subject.distances(subject.parameters(low, high))
    return min((float(np.min(d.low)) for d in distances), default=None)


def slopes(subject: Subject, x: Any) -> list[Fraction]:
    """Exponents γ with 0 ≤ γ ≤ 1 of the track at a point of the box."""
    point = [Fraction(float(t)) for t in x[0]]

    def at(terms: Any) -> Fraction:
        total = Fraction(0)
        for powers, c in terms:
            for t, k in zip(point, powers, strict=True):
                c *= t**k
            total += c
        return total

    rows: dict[tuple[int, int], list[Any]] = {}
    for (i, j, *powers), c in subject.D.items():
        rows.setdefault((i, j), []).append((tuple(powers), c))
    D: Polynomial = {key: c for key, terms in rows.items() if (c := at(terms))}
    found = {edge.slope for edge in edges(moving(D, at(subject.v.items())), {(0, 0): Fraction(1)})}
    return sorted(gamma for gamma in found if 0 <= gamma <= 1)


def _given(envelope: Envelope, X: float, gap: float | None) -> float:
    """What short waves give at most at q = X."""
    p, alpha = X / envelope.fastest / UP, envelope.subject.power.alpha
    C = float(envelope.constants(np.array([p]))[0])
    sieve = 2 * np.pi / gap if gap is not None else 0.0
    return C * (p ** (1 - alpha) / (alpha - 1) + sieve * p**-alpha) * _MARGIN


@dataclass(frozen=True)
class _Chart:
    """w, D_r, D_i in z², ω² and (τ, parameters), each times a power of τ; e with W/|D|² of order q^−e."""

    gamma: Fraction
    w: Terms
    real: Terms
    imaginary: Terms
    e: Fraction

    @staticmethod
    def of(subject: Subject, gamma: Fraction) -> _Chart:
        k, m = gamma.numerator, gamma.denominator
        power = subject.power

        def top(terms: Terms) -> int:
            return max((2 * k * key[0] + 2 * m * key[1] for key in terms), default=0)

        whole = max(top(power.real), top(power.imaginary) + m)

        def lifted(terms: Terms, to: int) -> Terms:
            return {(i, j, to - 2 * k * i - 2 * m * j, *rest): c for (i, j, *rest), c in terms.items()}

        own = top(power.w)
        return _Chart(
            gamma,
            lifted(power.w, own),
            lifted(power.real, whole),
            lifted(power.imaginary, whole - m),
            Fraction(2 * whole - own - m, m),
        )

    def taken(self, envelope: Envelope, parameters: list[Affine], X: float, gap: float | None, alpha: int) -> float:
        """A lower bound of what blocks take at q = X, if its quotient by what is given does not fall; else 0."""
        if not alpha - 1 >= self.e - self.gamma:
            return 0.0
        growth, sieve = X ** float(self.gamma), 2 * np.pi / gap if gap is not None else 0.0
        blocks = self.blocks(envelope, parameters, X, gap)
        total = sum(max((z2 - z1) * growth - sieve, 0.0) * kappa for z1, z2, kappa in blocks)
        return float(total * X ** -float(self.e) / _MARGIN)

    def blocks(self, envelope: Envelope, parameters: list[Affine], X: float, gap: float | None) -> Any:
        """Intervals of z with a lower bound κ of what they take."""
        growth, sieve = X ** float(self.gamma), 2 * np.pi / gap if gap is not None else 0.0
        z = self._ends(envelope, X, growth)
        least = self._least(envelope, parameters, z, X)
        return best_blocks(z, np.full(len(z), np.inf), least, growth, sieve)

    def _ends(self, envelope: Envelope, X: float, growth: float) -> Any:
        low, high = np.array([envelope.low]), np.array([envelope.high])
        own = ((high - low) / np.maximum(np.abs(high + low), 1e-300)).max(1, initial=0.0)
        ends = np.unique(
            [cells(envelope.subject, np.array([X]), (low + high) / 2, spread, _SIDE)[0] / growth
             for spread in (np.array([0.2]), np.clip(own, 1e-4, 0.1))]
        )  # fmt: skip
        parts = np.arange(_FINE) / _FINE
        fine = ends[:-1, None] + (ends[1:] - ends[:-1])[:, None] * parts
        return np.unique(np.append(fine.ravel(), ends[-1]))

    def _least(self, envelope: Envelope, parameters: list[Affine], z: Any, X: float) -> Any:
        """Lower bounds of q^e W/|D|² on the cells of z, for all q ≥ X; 0 where it may give."""
        k, m = self.gamma.numerator, self.gamma.denominator
        with np.errstate(all="ignore"):
            at = between(z[:-1], z[1:], "p")
            tau = between(np.zeros(1), np.full(1, X ** (-1 / m) * _MARGIN), "q")
            omega = at * envelope.subject.speed(parameters)
            for _ in range(m - k):
                omega = omega * tau
            omega = constant(Fraction(1)) - omega
            y, square = at.square(), omega.square()
            w, real, imaginary = (
                value(a, y, square, [tau, *parameters]) for a in (self.w, self.real, self.imaginary)
            )
            bottom = real.square() + square * imaginary.square()
            kappa = np.maximum(omega.low, 0) * np.maximum(w.low, 0) / bottom.high / UP
        return np.where(np.isfinite(kappa), kappa, 0.0) * np.ones(len(z) - 1)
