"""The Laplace image of a motion in balls of σ̂, on the physical sheet and on what continues it across the cuts.

Over a cell, a ball of σ̂, each p-root has a disc of its own. Which of them are upper ones is proved at one point of
the cell in the physical region, and then holds in the whole cell: no p-root changes its disc there.

`PreciseImage` has the middles as mpmath numbers.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, arb, arb_mat, precision
from mpsolve.numbers.multiprecision import middle
from mpsolve.vehicles.loads import Term
from mpsolve.vibration.balls.equations import Equations
from mpsolve.vibration.balls.moving import Moving, moving_roots, sharp_roots
from mpsolve.vibration.balls.solved import Disc, Waves, solved
from mpsolve.vibration.image import Image

_TOGETHER = "p-roots of a cell cannot be told apart: split the cell"

_NEARER = 12


@dataclass(frozen=True)
class Cell:
    """A ball of σ̂ with its upper and lower p-roots and their weights."""

    ball: Any
    upper: tuple[Moving, ...]
    lower: tuple[Moving, ...]

    def roots(self, sigma: Any) -> list[acb]:
        """The upper p-roots at a σ̂ of the ball."""
        return [one.at(sigma) for one in self.upper]


class BallImage(Equations):
    """û and its cells, at the precision of the image."""

    def physical(self, sigma: Any) -> tuple[list[acb], list[acb]]:
        """Upper and lower p-roots at a thin σ̂ to the right of the cuts."""
        cell = self.start(sigma)
        return cell.roots(sigma), [one.at(sigma) for one in cell.lower]

    def start(self, sigma: Any) -> Cell:
        """The cell of a thin σ̂ to the right of the cuts, where the sides are proved by their signs."""
        roots = [(one.at(sigma).real, one) for one in moving_roots(self.symbols, sigma)]
        upper, lower = tuple(one for x, one in roots if x < 0), tuple(one for x, one in roots if x > 0)
        if len(upper) != self.image.receptance.upper or len(upper) + len(lower) < len(roots):
            raise PrecisionError("p-roots cannot be told from real ones on the path: move it")
        return Cell(sigma, upper, lower)

    def on_axis(self, sigma: Any) -> Cell:
        """The cell of a thin σ̂ of the axis; where waves do not decay there, as it continues what is right of it."""
        try:
            return self.start(sigma)
        except PrecisionError as error:
            found = error
        for k in range(_NEARER):
            aside = sigma + arb(2) ** (-1 - 2 * k)
            try:
                return self.within(self.cell(hull(sigma, aside), aside), sigma)
            except PrecisionError:
                continue
        raise found

    def cell(self, ball: Any, inside: Any) -> Cell:
        """The cell of a ball that holds the thin σ̂ `inside`, which lies to the right of the cuts."""
        return self.named(ball, inside, self.physical(inside)[0])

    def clear(self, ball: Any, inside: Any) -> Cell:
        """The same, where no wave has a real p over the ball: no cut meets it."""
        cell = self.cell(ball, inside)
        if not all(z.at(ball).real < 0 for z in cell.upper) or not all(z.at(ball).real > 0 for z in cell.lower):
            raise PrecisionError("a cut may meet the ball: make it smaller")
        return cell

    def beside(self, ball: Any, sigma: Any, cell: Cell) -> Cell:
        """The cell of a ball that shares the thin σ̂ with another cell."""
        return self.named(ball, sigma, self.within(cell, sigma).roots(sigma))

    def named(self, ball: Any, sigma: Any, upper: Sequence[acb]) -> Cell:
        """The cell of a ball where the upper p-roots at its thin σ̂ are known: each disc there holds one root."""
        found = moving_roots(self.symbols, ball)
        there = [one.at(sigma) for one in found]
        named = {_holder(there, z) for z in upper}
        if len(named) < len(upper):
            raise PrecisionError(_TOGETHER)
        sides = ([one for k, one in enumerate(found) if (k in named) == first] for first in (True, False))
        return Cell(ball, *(tuple(side) for side in sides))

    def within(self, cell: Cell, sigma: Any) -> Cell:
        """The same at a thin σ̂ of the cell."""
        found = sharp_roots(self.symbols, sigma, [*cell.upper, *cell.lower])
        up = len(cell.upper)
        return Cell(sigma, tuple(found[:up]), tuple(found[up:]))

    def values(self, cell: Cell) -> list[Any]:
        """û over the cell: bodies, contact forces, rail; finite, so that û is analytic there."""
        with precision(self.bits):
            G = self._received(cell)
            try:
                found = self._solved(cell.ball, G, self._forces(cell.ball))
            except ZeroDivisionError:
                raise PrecisionError("the equations may be singular over a cell: split it") from None
            return self._finite(found)

    def sizes(self, cell: Cell) -> list[arb]:
        """Bounds of |û| over the cell, analytic there; PrecisionError where the equations may be singular."""
        with precision(self.bits):
            G, force = self._received(cell), self._forces(cell.ball)
            right = [abs(x) for x in force] + [arb(0)] * self.image.contacts
            try:
                x = solved(self._discs(cell, G), right)
            except PrecisionError:
                if self.image.contacts == 1:
                    raise
                x = solved(*self._without_phases(cell, right, G))
            n = self.image.size
            rail = [
                self.touching(at, x, sum((abs(G[at - y]) * x[n + j] for j, y in enumerate(self.at)), arb(0)))
                for at in self.seen
            ]
            return [arb(size.upper()) for size in self._finite([*x, *rail])]

    def touching(self, at: Fraction, x: list[Any], rail: arb) -> arb:
        """A bound of the rail, or under a contact of what the vehicle has there, w = Bᵀy − hf, where that is less."""
        n = self.image.size
        for j, y in enumerate(self.at):
            if y == at:
                own = sum((abs(self.B[k][j]) * x[k] for k in range(n)), abs(self.h[j]) * x[n + j])
                rail = rail.min(own)
        return rail

    def _discs(self, cell: Cell, G: dict[Fraction, acb]) -> list[list[Disc]]:
        return [[_disc(x) for x in row] for row in self._rows(cell.ball, G)]

    def _without_phases(self, cell: Cell, right: list[Any], G: dict[Fraction, acb]) -> tuple[Any, list[arb], Waves]:
        """The equations where of the waves between contacts the slowest to decay has any phase, and these waves."""
        n, m, at = self.image.size, self.image.contacts, self.at
        ahead = max(cell.upper, key=lambda one: float(one.z.real))
        behind = min(cell.lower, key=lambda one: float(one.z.real))
        a, b = self.scale * ahead.weight, -self.scale * behind.weight
        sizes, rows, gone = arb_mat(n + m, n + m), self._discs(cell, G), [arb(1)]
        for i in range(m):
            gone += [self._gone(ahead, cell, at[i] - at[i - 1]) * self._gone(behind, cell, at[i - 1] - at[i])] * bool(
                i
            )
            for j in range(m):
                if at[i] != at[j]:
                    wave, size = (ahead, abs(a)) if at[i] > at[j] else (behind, abs(b))
                    sizes[n + i, n + j] = size * self._gone(wave, cell, at[i] - at[j])
                    others = [one for one in (cell.upper if at[i] > at[j] else cell.lower) if one is not wave]
                    rest = [abs(self.scale * one.weight) * self._gone(one, cell, at[i] - at[j]) for one in others]
                    rows[n + i][n + j] = acb(0), sum(rest, arb(0))
        return rows, right, Waves(tuple(range(n, n + m)), a, b, tuple(gone[1:]), sizes)

    def _gone(self, wave: Moving, cell: Cell, xi: Fraction) -> Any:
        """|e^{Pξ}| over the cell, at most."""
        return (wave.at(cell.ball) * self.away[xi]).real.exp()

    def response(self, cell: Cell, force: list[acb]) -> list[acb]:
        """The channels for forces on the coordinates instead of û's own."""
        with precision(self.bits):
            try:
                return self._finite(self._solved(cell.ball, self._received(cell), force))
            except ZeroDivisionError:
                raise PrecisionError("the equations are singular at the frequency of a load") from None

    def _finite(self, values: list[Any]) -> list[Any]:
        if not all(x.is_finite() for x in values):
            raise PrecisionError("the motion may be infinite over a cell: split it")
        return values

    def _received(self, cell: Cell) -> dict[Fraction, acb]:
        """G at all distances, by residues."""
        out = {}
        for xi in self.distances:
            waves, sign = (cell.upper, 1) if xi >= 0 else (cell.lower, -1)
            parts = [one.weight * (one.at(cell.ball) * self.away[xi]).exp() if xi else one.weight for one in waves]
            out[xi] = self.scale * sign * sum(parts, acb(0))
        return out


def _disc(x: Any) -> Disc:
    middle = acb(x.mid())
    return middle, abs(x - middle)


def _holder(balls: Sequence[acb], z: Any) -> int:
    """The number of the one ball that z can lie in: as each holds one root, that root is z."""
    near = [k for k, ball in enumerate(balls) if ball.overlaps(z)]
    if len(near) != 1:
        raise PrecisionError(_TOGETHER)
    return near[0]


def hull(*points: Any) -> Any:
    """The square ball that holds all balls."""
    total = points[0]
    for other in points[1:]:
        total = acb(total.real.union(other.real), total.imag.union(other.imag))
    return total


class PreciseImage(BallImage):
    """û at one σ̂: coordinates, contact forces, rail at the places, in the problem's units."""

    def __init__(self, mp: Any, image: Image, terms: list[Term], digits: int) -> None:
        super().__init__(image, terms, digits)
        self.mp = mp

    @property
    def rate(self) -> Any:
        """σ = rate · σ̂."""
        return self.mp.mpf(2) ** -self.image.guide.time

    @property
    def frequencies(self) -> list[Any]:
        """ω̂ > 0 of the loads, each once."""
        given = [(one.amplitude, one.frequency) for _, one in self.exact]
        return sorted({abs(w.mpf(self.mp)) / self.rate for a, w in given if a and w})

    def __call__(self, sigma: Any) -> list[Any]:
        """û(σ̂)."""
        with precision(self.bits):
            ball = acb(*(self._ball(part) for part in (sigma.real, sigma.imag)))
            return [number(self.mp, x) for x in self.values(self.start(ball))]

    def _ball(self, x: Any) -> arb:
        sign, mantissa, exponent, _ = x._mpf_
        return arb((-int(mantissa) if sign else int(mantissa), int(exponent)))


def number(mp: Any, ball: Any) -> Any:
    """The middle of a ball as an mpmath number, exactly as far as the context's digits go."""
    return mp.mpc(middle(mp, ball.real), middle(mp, ball.imag))
