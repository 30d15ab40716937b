"""A bound of what the track gives at short waves: |W|/|D|² ≤ C p^−α where p ≥ p₀, −vp ≤ Ω ≤ 0, over all parameters.

Two charts hold all these (p, Ω): u = 1/p with ω = −Ω ≤ ω₀, and r = −Ω/p with ζ = −1/Ω ≤ 1/ω₀. In each, |D|² times a
power is a polynomial that must stay positive, and |W| p^α times the same power is another (SPEC, section 6.2).
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from mpsolve.numbers.affine import Affine, between
from mpsolve.numbers.arrays import Reals
from mpsolve.numbers.jets import UP
from mpsolve.passivity.power import Quotient, Terms, moved, value
from mpsolve.passivity.subject import Subject

OMEGA = 4.0  # where the two charts meet
_MOST = 60000  # boxes that are looked at
_FEW = 256  # boxes, which are halved twice at once
_LEAST_POWER, _MOST_POWER = -3, 12  # of 2 in p₀: nothing is said below 2^−3
_NEAR = 1.5  # times the largest value met: a bound that is good enough


@dataclass(frozen=True)
class Envelope:
    """The bounds over one box of parameters; `low` and `high` are those of the scaled parameters.

    of: the quotient that is bounded, W/|D|² if left out. beside: Ω may be as far as beside·p from the load's line.
    """

    subject: Subject
    low: tuple[float, ...]
    high: tuple[float, ...]
    of: Quotient | None = None
    beside: float = 0.0
    _known: dict[int, float] = field(default_factory=dict, repr=False, compare=False)

    def constant(self, power_of_two: int) -> float:
        """C for p₀ = 2^power_of_two; ∞ where it is not found."""
        if any(k >= power_of_two and np.isinf(C) for k, C in self._known.items()):
            return float("inf")  # a smaller p₀ asks for more
        for k in range(power_of_two - 1, power_of_two - 4, -1):
            if k in self._known:
                return self._known[k]  # it holds from a smaller p₀ on
        if power_of_two not in self._known:
            found = charts(self.quotient, 2.0**power_of_two, self.fastest + self.beside)
            C = max(_supremum(self, chart) for chart in found)
            if np.isinf(C) and self.of is None:
                C = max(_supremum(self, chart, own) for chart, own in zip(found, _owns(self), strict=True))
            self._known[power_of_two] = C
        return self._known[power_of_two]

    def constants(self, p0: Reals) -> Reals:
        """A bound for each p ≥ p₀ > 0 (an array of floats); the same for all p₀ from 2^_MOST_POWER on."""
        powers = np.clip(np.floor(np.log2(np.maximum(p0, 1e-30)) - 2.0**-20), _LEAST_POWER - 1, _MOST_POWER).astype(
            int
        )
        out = np.full(powers.shape, np.inf)
        for k in np.unique(powers[powers >= _LEAST_POWER]):
            out[powers == k] = self.constant(int(k))
        return out

    @property
    def quotient(self) -> Quotient:
        """What is bounded."""
        return self.subject.power.quotient if self.of is None else self.of

    @property
    def fastest(self) -> float:
        """A bound of the velocity."""
        low, high = np.array([self.low]), np.array([self.high])
        return float(np.max(self.subject.speed(self.subject.parameters(low, high)).high))


@dataclass(frozen=True)
class Chart:
    """The top, D_r and D_i in the chart's variables x and y, the factors of the top, the box and a bound of xy.

    The quotient times p^α is x^a y^b |top|/(D_r² + y^twist D_i²)^copies.
    """

    top: Terms
    real: Terms
    imaginary: Terms
    weight: tuple[int, int]
    twist: int
    copies: int
    box: tuple[tuple[float, float], tuple[float, float]]
    product: float


def charts(quotient: Quotient, p0: float, v: float) -> tuple[Chart, Chart]:
    """(u, ω) and (r, ζ)."""
    (iw, nw), (i2, n2) = quotient.degrees
    power, odd, copies, alpha = quotient.power, quotient.odd, quotient.copies, quotient.alpha
    half, whole = i2 // 2 // copies, n2 // 2 // copies
    near = Chart(
        moved(quotient.top, lambda i, j: (iw - 2 * i, 2 * j)),
        moved(power.real, lambda i, j: (half - 2 * i, 2 * j)),
        moved(power.imaginary, lambda i, j: (half - 2 * i, 2 * j)),
        (i2 - iw - alpha, odd),
        2,
        copies,
        ((0.0, 1 / p0 * UP), (0.0, OMEGA)),
        v * UP,
    )
    far = Chart(
        moved(quotient.top, lambda i, j: (iw - 2 * i, nw - odd - 2 * i - 2 * j)),
        moved(power.real, lambda i, j: (half - 2 * i, whole - 2 * i - 2 * j)),
        moved(power.imaginary, lambda i, j: (half - 2 * i, whole - 1 - 2 * i - 2 * j)),
        (i2 - iw - alpha, n2 - nw - alpha),
        0,
        copies,
        ((0.0, v * UP), (0.0, 1 / OMEGA * UP)),
        1 / p0 * UP,
    )
    return near, far


Monomial = tuple[float, int, int]
"""(c, i, j): c x^i y^j."""


def _owns(envelope: Envelope) -> tuple[Monomial | None, Monomial | None]:
    """What bounds the quotient times p^α in each chart by the damping of the loaded field: |N/D| ≤ 1/(|Ω| c p^i)."""
    own, alpha = envelope.subject.own, envelope.quotient.alpha
    if own is None or own[1] < alpha:
        return None, None
    c, left = UP / float(own[0]), own[1] - alpha
    return (c, left, -1), (c, left, left + 1)


def _supremum(envelope: Envelope, chart: Chart, own: Monomial | None = None) -> float:
    """By branch and bound over the chart and the parameters; own: another bound, the less of the two counts."""
    low = np.array([[*(a for a, _ in chart.box), *envelope.low]])
    high = np.array([[*(b for _, b in chart.box), *envelope.high]])
    names, proved, known, tried = ("x", "y", *envelope.subject.names), 0.0, 0.0, 0
    while len(low):
        tried += len(low)
        if tried > _MOST:
            return float("inf")
        with np.errstate(all="ignore"):
            x, y, *theta = (between(low[:, k], high[:, k], name) for k, name in enumerate(names))
            top, bottom = _quotient(chart, x, y, theta)
            upper = np.maximum(np.abs(top.low), np.abs(top.high)) / bottom.low * UP
            upper = np.where(bottom.low > 0, upper, np.inf)
            if own is not None:
                upper = np.minimum(upper, _monomial(own, high[:, 0], high[:, 1] if own[2] > 0 else low[:, 1]) * UP)
            inner = low[:, 0] / 2 + high[:, 0] / 2 <= chart.product / (low[:, 1] / 2 + high[:, 1] / 2)
            middle = np.abs(top.a) / bottom.a
            if own is not None:
                middle = np.minimum(
                    middle, _monomial(own, low[:, 0] / 2 + high[:, 0] / 2, low[:, 1] / 2 + high[:, 1] / 2)
                )
            known = max(known, float(np.max(middle, initial=0.0, where=inner & (bottom.a > 0))))
        done = upper <= _NEAR * known
        proved = max(proved, float(np.max(upper, initial=0.0, where=done)))
        low, high = _halved(low[~done], high[~done], bottom.take(~done), top.take(~done), names)
        inside = low[:, 0] * low[:, 1] <= chart.product * UP
        low, high = low[inside], high[inside]
    return proved


def _monomial(one: Monomial, x: Reals, y: Reals) -> Reals:
    return one[0] * x ** one[1] * y ** float(one[2])


def _quotient(chart: Chart, x: Affine, y: Affine, theta: list[Affine]) -> tuple[Affine, Affine]:
    top = value(chart.top, x, y, theta)
    for factor, power in zip((x, y), chart.weight, strict=True):
        for _ in range(power):
            top = top * factor
    imaginary = value(chart.imaginary, x, y, theta)
    bottom = imaginary.square()
    for _ in range(chart.twist):
        bottom = bottom * y
    one = bottom + value(chart.real, x, y, theta).square()
    bottom = one
    for _ in range(chart.copies - 1):
        bottom = bottom * one
    ones = np.ones(len(x.a))
    return _full(top, ones), _full(bottom, ones)


def _full(f: Affine, ones: Reals) -> Affine:
    """With arrays of one shape."""
    return Affine(f.a * ones, {name: b * ones for name, b in f.b.items()}, f.e * ones)


def _halved(low: Reals, high: Reals, bottom: Affine, top: Affine, names: tuple[str, ...]) -> tuple[Reals, Reals]:
    """Each box in two, along the variable that moves |D|² most, and W too where |D|² > 0 is known already.

    Few boxes are halved again: a round takes as long for them as for one.
    """
    if not len(low):
        return low, high
    weight = np.zeros_like(low)
    for k, name in enumerate(names):
        for f, counts in ((bottom, 1.0), (top, (bottom.low > 0) * 1.0)):
            if name in f.b:
                weight[:, k] += counts * np.abs(f.b[name]) / (np.abs(f.a) + f.spread + f.e + 1e-300)
    rounds = high - low
    span = rounds / (np.abs(high) + np.abs(low) + 1e-300)
    weight = (np.nan_to_num(weight) + 1e-3 * span * (span > 0)) * (rounds > 0)
    for _ in range(2 if len(low) < _FEW else 1):
        low, high, weight = _once_halved(low, high, weight)
    return low, high


def _once_halved(low: Reals, high: Reals, weight: Reals) -> tuple[Reals, Reals, Reals]:
    k, rows = np.argmax(weight, axis=1), np.arange(len(low))
    middle = low[rows, k] / 2 + high[rows, k] / 2
    first, second, weight = high.copy(), low.copy(), weight.copy()
    first[rows, k] = middle
    second[rows, k] = middle
    weight[rows, k] /= 2
    return np.concatenate([low, second]), np.concatenate([first, high]), np.concatenate([weight, weight])
