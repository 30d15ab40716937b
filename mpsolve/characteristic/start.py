"""Where the splitting starts: at q = −i y no p-root of a stable track is real, and the two kinds are told apart."""

from __future__ import annotations

from dataclasses import field
from fractions import Fraction

import numpy as np
from flint import acb, acb_poly, arb, fmpq_poly

from mpsolve.characteristic.discs import Splittings, split
from mpsolve.characteristic.symbol import Symbol
from mpsolve.characteristic.table import Table
from mpsolve.errors import PrecisionError
from mpsolve.frozen import frozen
from mpsolve.numbers.balls import precision
from mpsolve.numbers.realroots import as_fmpq
from mpsolve.problem.reduced import Guide

APART = (
    "decaying and growing p-roots far below the real axis cannot be told apart, as where v is far beyond all waves",
    "check v and its unit",
)
REPEATED = (
    "the track has some of its waves twice, as where parts of it are equal and feel each other through others alone",
    "make one of the equal parts a little different, or put them together as one",
)
"""Why there is no start, and what helps."""


class NoStartError(PrecisionError):
    """No depth serves; `words`: why, and what helps."""

    def __init__(self, words: tuple[str, str]) -> None:
        super().__init__(": ".join(words))
        self.words = words


@frozen
class Start:
    """At σ̂ = depth the number of roots with Re P < 0 is `up`, and `splitting` is a thin one of just these roots."""

    depth: float
    up: int
    splitting: Splittings = field(repr=False, compare=False)


def start(guide: Guide, depths: tuple[float, ...] = (1.0, 0.5, 2.0, 4.0)) -> Start:
    """The number of decaying roots; NoStartError where no depth serves."""
    for depth in depths:
        found = _tell_apart(guide, depth)
        if found is not None:
            return found
    raise NoStartError(REPEATED if all(_repeats(guide, Fraction(depth)) for depth in depths) else APART)


def _repeats(guide: Guide, depth: Fraction) -> bool:
    """Whether p-roots at σ̂ = depth are equal, exactly."""
    rows: dict[int, Fraction] = {}
    for (i, j), c in guide.D.items():
        rows[i] = rows.get(i, Fraction(0)) + c * depth**j
    line = fmpq_poly([as_fmpq(rows.get(i, Fraction(0))) for i in range(max(rows) + 1)])
    return bool(line.gcd(line.derivative()).degree() > 0)


def _tell_apart(guide: Guide, depth: float) -> Start | None:
    """All n roots isolated, each on a side; U of the splitting is not 0 at the growing ones, L not at the others."""
    with precision(96):
        try:
            roots = acb_poly([row(depth) for row in Symbol.of(guide.D).balls()]).roots()
        except ValueError:  # a multiple root
            return None
        if not all(root.real < 0 or root.real > 0 for root in roots):
            return None
        up = sum(1 for root in roots if root.real < 0)
        s = split(Table.of(guide.D), np.array([depth + 0j]), np.zeros(1), up)
        if not s.good[0]:
            return None
        growing = [root for root in roots if root.real > 0]
        decaying = [root for root in roots if root.real < 0]
        mine, other = factors(s, 0)
        apart = all(not mine(z).contains(0) for z in growing) and all(not other(z).contains(0) for z in decaying)
        return Start(depth, up, s) if apart else None


def factors(s: Splittings, row: int) -> tuple[acb_poly, acb_poly]:
    """U and L of one disc as polynomials with ball coefficients."""
    out = []
    for part in (slice(0, s.up), slice(s.up, None)):
        nodes = [acb(complex(z)) for z in s.z[row, part]]
        full = acb_poly.from_roots(nodes)
        for k, size in enumerate(s.tight[row, part]):
            ball = arb(0, float(size))
            full += acb_poly([acb(ball, ball)]) * acb_poly.from_roots(nodes[:k] + nodes[k + 1 :])
        out.append(full)
    return out[0], out[1]
