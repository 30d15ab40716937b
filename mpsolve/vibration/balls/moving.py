"""p-roots over a ball of σ by nodes that move with it: z_k + c_k τ, τ = σ − middle, so that only curvature is lost.

For each σ Gershgorin's theorem (characteristic/roots.py) holds with the nodes at that σ; D at a moving node is a
polynomial in τ, whose first coefficients nearly vanish.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.characteristic.roots import float_roots
from mpsolve.characteristic.symbol import Symbols
from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, acb_poly, arb, bits_now, exact_ball, is_thin, square

_STEPS = 40


@dataclass(frozen=True)
class Moving:
    """One p-root for each σ of a ball, within radius of z + c (σ − middle). weight: the ball of N/D_P."""

    middle: Any
    z: Any
    c: Any
    radius: Any
    weight: Any

    def at(self, sigma: Any) -> Any:
        """The ball of the root at any σ of the ball, or over all of it."""
        return self.z + self.c * (sigma - self.middle) + square(self.radius)


def moving_roots(symbols: Symbols, ball: Any) -> list[Moving]:
    """All p-roots over the ball; PrecisionError where two may meet, or their discs do."""
    middle = acb(ball.mid())
    tau = ball - middle
    about = acb_poly([middle, 1])
    D, N = ([row(about) for row in symbol.balls()] for symbol in (symbols.D, symbols.N))
    first = float_roots([row[0] for row in D], symbols.degree)
    slopes = [exact_ball(c) for c in _slopes(D, first)]
    z = _refined(acb_poly([row[0] for row in D]), [exact_ball(complex(x)) for x in first], is_thin(ball))
    gaps = [[x - y + (c - d) * tau for y, d in zip(z, slopes, strict=True)] for x, c in zip(z, slopes, strict=True)]
    lead = D[-1](tau)
    n, spreads, radii = len(z), [], []
    for k, row in enumerate(gaps):
        spread = lead
        for i, gap in enumerate(row):
            spread = spread * gap if i != k else spread
        value = abs(_along(D, z[k], slopes[k])(tau))
        radius = arb((n * value / abs(spread)).upper())
        if not radius.is_finite():
            raise PrecisionError("two p-roots may meet over the ball: split the cell")
        spreads.append(row)
        radii.append(radius)
    for k in range(n):
        if not all(abs(gaps[k][i]) > radii[k] + radii[i] for i in range(k)):
            raise PrecisionError("two p-roots cannot be told apart over the ball: split the cell")
    out = []
    for k in range(n):
        slope = lead
        for i in range(n):
            slope = slope * (gaps[k][i] + square(radii[k] + radii[i])) if i != k else slope
        moved = square(radii[k])
        value = _along(N, z[k] + moved, slopes[k])(tau)
        out.append(Moving(middle, z[k], slopes[k], radii[k], value / slope))
    return out


def sharp_roots(symbols: Symbols, sigma: Any, discs: list[Moving]) -> list[Moving]:
    """The p-roots at a thin σ of the ball of these discs, in their order, by Newton's method to all digits.

    Where m − D(m)/D'(b) lies in the ball b round m there is one root in b, and it lies there; where b meets no other
    disc it is that of the disc, as each holds one.
    """
    D, N = (acb_poly([row(sigma) for row in symbol.balls()]) for symbol in (symbols.D, symbols.N))
    slope, out, all_own = D.derivative(), [], [disc.at(sigma) for disc in discs]
    for k, own in enumerate(all_own):
        m, step = own.mid(), abs(own).upper()
        for _ in range(_STEPS):
            off = D(m) / slope(m)
            m, last, step = (m - off).mid(), step, abs(off).upper()
            if not step < last / 2:
                break
        size = arb((4 * (step + abs(D(m) / slope(m)))).upper())
        ball = m + square(size)
        root = m - D(m) / slope(ball)
        if not ball.contains(root) or any(ball.overlaps(other) for i, other in enumerate(all_own) if i != k):
            raise PrecisionError("two p-roots cannot be told apart: move the path")
        out.append(Moving(sigma, root, acb(0), arb(0), N(root) / slope(root)))
    return out


def _slopes(D: Any, z: np.ndarray[Any, Any]) -> list[complex]:
    """dP/dσ at the nodes, about; nothing is proved by it."""
    value, rate = ([complex(row[j]) for row in D] for j in (0, 1))
    slope = np.polynomial.polynomial.polyder(np.array(value))
    with np.errstate(all="ignore"):
        at = -np.polynomial.polynomial.polyval(z, rate) / np.polynomial.polynomial.polyval(z, slope)
    return [complex(x) if np.isfinite(x) else 0j for x in at]


def _refined(D: Any, z: list[Any], thin: bool) -> list[Any]:
    """Nodes nearer to the roots, by Weierstrass's steps: to all digits where σ is thin."""
    bits = 24
    while True:
        z = [(x - D(x) / _product(D[D.degree()], x, z, k)).mid() for k, x in enumerate(z)]
        bits *= 2
        if not all(x.is_finite() for x in z):
            raise PrecisionError("two p-roots meet: move the path")
        if not thin or bits > 2 * bits_now():
            return z


def _product(lead: Any, x: Any, z: list[Any], k: int) -> Any:
    for i, other in enumerate(z):
        lead = lead * (x - other) if i != k else lead
    return lead


def _along(rows: Any, z: Any, c: Any) -> Any:
    """The polynomial in τ that the symbol is at z + cτ."""
    step, total = acb_poly([z, c]), acb_poly([0])
    for row in reversed(rows):
        total = total * step + row
    return total
