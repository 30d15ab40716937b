"""The integral along the line of a path, faded out towards high |Im σ|.

Fading by erfc averages the motion over times about 1/Ω with a weight whose moments vanish, so that it is felt only
where the motion has a corner: at the start of the loads, and where a wave front passes. Half of Ω tells how far.

The function is kept as Legendre series on panels. ∫ over a panel of e^{σt} P_n is known in closed form (spherical
Bessel functions), so that the number of panels follows the structure of the function and not the times: next to a
pole at the distance δ there are log(1/δ) of them.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise
from typing import Any

import numpy as np

from mpsolve.errors import PrecisionError
from mpsolve.numbers.arrays import Complexes, Reals
from mpsolve.vibration.path import Path

ORDER = 16
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(ORDER)
_P = np.polynomial.legendre.legvander(_NODES, ORDER - 1)
_TO_SERIES = (_P * _WEIGHTS[:, None]).T * (np.arange(ORDER) + 0.5)[:, None]
_UPWARD = 30.0
_RULES = ((2.5, 16), (10.0, 24), (_UPWARD, 40))
"""Up to which z so many Gauss points give the moments to 1e-13."""
_ROUNDS = 60
_CHUNK = 4_000_000
CLEAR = 80.0
"""Ω t from which on the start at t = 0 is not felt through the fading."""
_SHARPNESS = 0.11
"""Of Ω: the width of the fading."""
_TOLERANCE = 3e-12
_MOST_PANELS = 4000
_OCTAVES = 10
_WIDEST = 1 / 24


@dataclass(frozen=True)
class Panels:
    """Panels [middle − half, middle + half] of ω, and values at their nodes, (panels, ORDER, channels)."""

    middle: Any
    half: Reals
    values: Any

    @property
    def nodes(self) -> Any:
        return self.middle[:, None] + self.half[:, None] * _NODES

    @property
    def series(self) -> Any:
        return _TO_SERIES @ self.values

    def integral(self) -> Any:
        """∫|values| dω by channels: the size of the function."""
        return ((np.abs(self.values) * _WEIGHTS[:, None]).sum(1) * self.half[:, None]).sum(0)


def sampled(
    function: Callable[[Any], Any], breaks: Any, tolerance: Callable[[Any], Any], most: int, widest: float = np.inf
) -> tuple[Panels, Any, bool]:
    """Panels on which the last terms of the series are below the tolerance, and by channels what they leave open.

    function: of an array of ω, (len(ω), channels). tolerance: of the size of all by channels, for one panel. Panels
    that fail are halved, up to `most`; the last value says whether all were settled.
    """
    left, right = _shorter(np.asarray(breaks, float), widest)
    done: list[Panels] = []
    open_error, size = 0.0, 0.0
    for _ in range(_ROUNDS):
        now = Panels((left + right) / 2, (right - left) / 2, np.empty((0, ORDER, 0)))
        nodes = now.nodes
        values = function(nodes.ravel()).reshape(*nodes.shape, -1)
        now = Panels(now.middle, now.half, values)
        series = now.series
        left_out = 2 * now.half[:, None] * np.abs(series[:, -2:]).max(1)
        whole = size + now.integral()
        fine = (left_out <= tolerance(whole)).all(1)
        fine |= now.half < 1e-13 * np.abs(now.middle)
        number = sum(len(one.middle) for one in done) + len(left)
        last = number + int((~fine).sum()) > most
        keep = np.ones(len(fine), bool) if last else fine
        done.append(Panels(now.middle[keep], now.half[keep], values[keep]))
        size = size + done[-1].integral()
        open_error = open_error + left_out[keep].sum(0)
        if last or fine.all():
            break
        left, middle, right = left[~fine], now.middle[~fine], right[~fine]
        left, right = np.concatenate([left, middle]), np.concatenate([middle, right])
    return joined(done), open_error, bool(fine.all())


def joined(parts: list[Panels]) -> Panels:
    """All panels of several."""
    return Panels(*(np.concatenate([getattr(one, key) for one in parts]) for key in ("middle", "half", "values")))


def _shorter(breaks: Reals, widest: float) -> tuple[Reals, Reals]:
    counts = np.maximum(1, np.ceil(np.diff(breaks) / widest)).astype(int)
    cells = [np.linspace(a, b, 1 + n) for (a, b), n in zip(pairwise(breaks), counts, strict=True)]
    return np.concatenate([c[:-1] for c in cells]), np.concatenate([c[1:] for c in cells])


def inverse(panels: Panels, weight: Any, alpha: float, times: Any) -> Reals:
    """(1/π) Re ∫ weight(ω) F(ω) e^{(α + iω)t} dω over the panels, (channels, times): both halves of a real motion."""
    values = panels.values * weight(panels.nodes)[..., None]
    used = np.abs(values).max((1, 2)) > 0
    middle, half = panels.middle[used], panels.half[used]
    series = _TO_SERIES @ values[used]
    channels = series.shape[-1]
    out = np.zeros((len(times), channels))
    step = max(1, _CHUNK // max(1, len(middle) * channels))
    for k in range(0, len(times), step):
        some = times[k : k + step]
        total = np.zeros((len(some), channels), complex)
        for width in np.unique(half):
            mine = half == width
            moments = spherical(width * some) * width
            flat = np.moveaxis(series[mine], 1, 0).reshape(ORDER, -1)
            inner = (moments @ flat).reshape(len(some), -1, channels)
            total += np.einsum("tp,tpc->tc", np.exp(1j * np.multiply.outer(some, middle[mine])), inner)
        out[k : k + step] = total.real * np.exp(alpha * some)[:, None] / np.pi
    return out.T


def spherical(z: Any) -> Complexes:
    """∫_{−1}^{1} P_n(x) e^{izx} dx = 2 iⁿ j_n(z) for n < ORDER, (len(z), ORDER)."""
    out = np.empty((len(z), ORDER), complex)
    size, least = np.abs(z), -1.0
    for most, points in _RULES:
        some = (size > least) & (size <= most)
        nodes, weighted = _rule(points)
        turn = np.multiply.outer(z[some], nodes)
        out[some] = np.cos(turn) @ weighted + 1j * (np.sin(turn) @ weighted)
        least = most
    far = size > _UPWARD
    x = z[far]
    if len(x):
        j = [np.sin(x) / x, np.sin(x) / x**2 - np.cos(x) / x]
        for n in range(1, ORDER - 1):
            j.append((2 * n + 1) / x * j[n] - j[n - 1])
        out[far] = np.stack(j, 1) * (2 * 1j ** np.arange(ORDER))
    return out


@lru_cache(maxsize=4)
def _rule(points: int) -> tuple[Reals, Reals]:
    nodes, weights = np.polynomial.legendre.leggauss(points)
    return nodes, np.polynomial.legendre.legvander(nodes, ORDER - 1) * weights[:, None]


_erfc = np.vectorize(math.erfc, otypes=[float])


@dataclass(frozen=True)
class Line:
    """The image sampled on the path's line, 0 ≤ ω ≤ Ω; left_open: by channels, of the integral over ω."""

    path: Path
    omega: float
    panels: Panels
    left_open: Reals
    settled: bool

    def motion(self, times: Any) -> Reals:
        """(channels, times)."""
        return inverse(self.panels, lambda w: faded(w, self.omega), self.path.alpha, times)

    def rate(self, times: Any) -> Reals:
        """d/dt of the motion, (channels, times)."""
        sigma = self.path.line(self.panels.nodes)
        turned = Panels(self.panels.middle, self.panels.half, self.panels.values * sigma[..., None])
        return inverse(turned, lambda w: faded(w, self.omega), self.path.alpha, times)

    def change(self, times: Any) -> Reals:
        """How much half of Ω would change it: more than its error where the image has decayed as powers do."""
        return inverse(self.panels, lambda w: faded(w, self.omega) - faded(w, self.omega / 2), self.path.alpha, times)

    def only(self, channels: Any) -> Line:
        """Some of the channels."""
        panels = Panels(self.panels.middle, self.panels.half, self.panels.values[..., channels])
        return Line(self.path, self.omega, panels, self.left_open[channels], self.settled)


def faded(w: Reals, omega: float) -> Any:
    """1 below Ω/4, 0 above 3Ω/4, to 1e-9."""
    return 0.5 * _erfc((w - omega / 2) / (_SHARPNESS * omega))


def sampled_line(image: Callable[[Any], Any], path: Path, omega: float) -> Line:
    """The image, (len(σ), channels), on the line up to Ω."""
    breaks = np.concatenate([[0.0], omega * 2.0 ** np.arange(-_OCTAVES, 1)])
    return Line(path, omega, *_sampled(image, path, breaks, omega, 0.0))


def extended(image: Callable[[Any], Any], line: Line) -> Line:
    """The same up to 2Ω."""
    low, high = line.omega, 2 * line.omega
    more = _sampled(image, line.path, np.array([low, high]), high, line.panels.integral())
    panels = joined([line.panels, more[0]])
    return Line(line.path, high, panels, line.left_open + more[1], line.settled and more[2])


def _sampled(image: Any, path: Path, breaks: Reals, omega: float, size: Any) -> tuple[Panels, Reals, bool]:
    def tolerance(more: Reals) -> Any:
        whole = size + more
        return _TOLERANCE * np.maximum(whole, 1e-6 * np.max(whole))

    try:
        return sampled(lambda w: image(path.line(w)), breaks, tolerance, _MOST_PANELS, omega * _WIDEST)
    except np.linalg.LinAlgError:
        stated = "the equations are singular on the path, as a root lies there"
        raise PrecisionError(f"{stated}: change a parameter a little") from None
