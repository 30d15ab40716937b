"""The transformed equations of a motion in balls: bodies and contact forces, loads in exact numbers, distances."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, acb_mat, arb, precision, rational_ball, square
from mpsolve.numbers.exact import Exact
from mpsolve.vehicles.load import Load
from mpsolve.vehicles.loads import Term
from mpsolve.vibration.image import Image

if TYPE_CHECKING:
    from mpsolve.characteristic.symbol import Symbols


class Equations:
    """Of a problem whose rail is watched at some places, with what acts on it; to so many digits.

    In balls of `bits`: S (K, C, M), B, h; scale, G = scale · Ĝ; rate_ball, σ = rate · σ̂. at, seen: contacts and
    places, scaled; distances: of both from contacts, scaled, and `away` their balls.
    """

    def __init__(self, image: Image, terms: list[Term], digits: int, exact: Sequence[Exact] = ()) -> None:
        """exact: the places of the image, where some are irrational and the image has them in float64."""
        self.image, self.exact = image, terms
        self.bits = int(digits * 3.33) + 40
        guide, pencil = image.guide, image.pencil
        unit = Fraction(2) ** guide.length
        self.at = [x / unit for x in pencil.places]
        self.seen = [x / unit for x in image.places]
        self.distances = sorted({x - y for x in (*self.at, *self.seen) for y in self.at})
        with precision(self.bits):
            self.scale, self.rate_ball = rational_ball(guide.g), rational_ball(Fraction(2) ** -guide.time)
            self._terms = [([rational_ball(x) for x in direction], self._waves(one)) for direction, one in terms]
            self.S = [[[rational_ball(x) for x in row] for row in rows] for rows in (pencil.K, pencil.C, pencil.M)]
            self.B = [[rational_ball(x) for x in row] for row in pencil.B]
            self.h = [rational_ball(x) for x in pencil.h]
            self.away = {x: rational_ball(x) for x in self.distances}
            for place, x in zip(self.seen, exact, strict=False):
                if not x.is_rational:
                    self._moved(place, x.ball() / rational_ball(unit))

    def _moved(self, place: Fraction, x: Any) -> None:
        """A place is not quite where the image has it, but at x, on the same side of each contact."""
        for y in self.at:
            ball, key = x - rational_ball(y), place - y
            if not (ball > 0 if key > 0 else ball < 0) or not key:
                raise PrecisionError("a place is too close to a contact: move it, or give it at the contact")
            self.away[key] = ball.union(self.away[key])

    @property
    def symbols(self) -> Symbols:
        """D and N."""
        return self.image.receptance.symbols

    def _waves(self, one: Load) -> tuple[arb, arb, arb, arb]:
        given = (one.constant, one.amplitude, one.frequency, one.phase)
        c, a, omega, phase = (x.ball() for x in given)
        return c, a, omega / self.rate_ball, phase

    def _solved(self, sigma: Any, G: dict[Fraction, acb], force: list[acb]) -> list[acb]:
        """Coordinates, contact forces, rail, under forces on the coordinates."""
        n = self.image.size
        right = [[x] for x in [*force, *[acb(0)] * self.image.contacts]]
        x = [row[0] for row in acb_mat(self._rows(sigma, G)).solve(acb_mat(right)).tolist()]
        rail = [sum((G[at - y] * x[n + j] for j, y in enumerate(self.at)), acb(0)) for at in self.seen]
        return [*x, *rail]

    def _rows(self, sigma: Any, G: dict[Fraction, acb]) -> list[list[Any]]:
        """The equations."""
        n, m = self.image.size, self.image.contacts
        s = sigma * self.rate_ball
        rows = []
        for i in range(n):
            own = [self.S[0][i][j] + s * (self.S[1][i][j] + s * self.S[2][i][j]) for j in range(n)]
            rows.append([*own, *self.B[i]])
        for i in range(m):
            own = [-G[self.at[i] - self.at[j]] - (self.h[i] if i == j else 0) for j in range(m)]
            rows.append([*(self.B[j][i] for j in range(n)), *own])
        return rows

    def _forces(self, sigma: Any) -> list[acb]:
        total = [acb(0)] * self.image.size
        for direction, (c, a, omega, phase) in self._terms:
            wave = c / sigma
            if a != 0:
                wave += a * (omega * phase.cos() + sigma * phase.sin()) / (sigma * sigma + omega * omega)
            total = [x + d * wave for x, d in zip(total, direction, strict=True)]
        return total

    def far_forces(self, radius: arb) -> list[acb]:
        """σ̂ times the forces on the coordinates, for all |σ̂| ≥ radius."""
        total = [acb(0)] * self.image.size
        for direction, (c, a, omega, phase) in self._terms:
            wave = acb(c)
            if a != 0:
                ratio = abs(omega) / radius
                if not ratio < 1:
                    raise PrecisionError("a load acts at a high frequency: go further")
                size = abs(a) * (ratio * abs(phase.cos()) + abs(phase.sin())) / (1 - ratio**2)
                wave += square(arb(size.upper()))
            total = [x + d * wave for x, d in zip(total, direction, strict=True)]
        return total

    def tones(self) -> list[tuple[acb, list[acb]]]:
        """(ω̂, forces on the coordinates) of constant and harmonic loads: Re(force e^{iω̂t̂}); ω̂ ≥ 0 in balls."""
        out: dict[Any, list[Any]] = {}
        rates: dict[Any, Any] = {}

        def add(key: Any, rate: acb, factor: Any, direction: list[arb]) -> None:
            rates[key] = rate
            zero = out.get(key, [acb(0)] * len(direction))
            out[key] = [x + d * factor for x, d in zip(zero, direction, strict=True)]

        with precision(self.bits):
            for (direction, (c, a, omega, phase)), (_, load) in zip(self._terms, self.exact, strict=True):
                if load.constant:
                    add(Fraction(0), acb(0), c, direction)
                if load.amplitude and load.frequency:
                    wave = acb(0, -1) * a * (acb(0, 1) * phase).exp()
                    wave = wave if load.frequency.sign > 0 else wave.conjugate()
                    add(abs(load.frequency), acb(abs(omega)), wave, direction)
                elif load.amplitude:
                    add(Fraction(0), acb(0), a * phase.sin(), direction)
        return [(rates[key], force) for key, force in out.items()]
