"""The Laplace image of a motion in many digits: the equations of image.py at one σ̂, with exact loads."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from mpsolve.errors import InputError, PrecisionError
from mpsolve.numbers.balls import acb, acb_mat, acb_poly, arb, precision, rational_ball
from mpsolve.vehicles.bounce import rigid_bounce
from mpsolve.vehicles.load import GRAVITY, Load
from mpsolve.vehicles.vehicle import Pencil
from mpsolve.vibration.image import Image

Term = tuple[tuple[Fraction, ...], Load]
"""A load and the direction in which it acts on the coordinates."""


def exact_terms(pencil: Pencil, loads: Any) -> list[Term]:
    """The outer forces as `outer_forces` has them, which has checked them, in exact numbers."""
    if loads is None:
        bounce = rigid_bounce(pencil) or ()
        g = GRAVITY.as_fraction()
        masses = [sum((m * r for m, r in zip(row, bounce, strict=True)), Fraction(0)) for row in pencil.M]
        return [(tuple(g * m for m in masses), Load(1))]
    if isinstance(loads, Mapping):
        return [(tuple(Fraction(int(name == other)) for other in pencil.names), one) for name, one in loads.items()]
    return [(tuple(row[j] for row in pencil.B), one) for j, one in enumerate(loads)]


class PreciseImage:
    """û at one σ̂ as mpmath numbers: coordinates, contact forces, rail at the places, in the problem's units.

    FLINT computes, in balls whose radii only tell that the digits are there.
    """

    def __init__(self, mp: Any, image: Image, terms: list[Term], digits: int) -> None:
        self.mp, self.image, self.exact = mp, image, terms
        self._bits = int(digits * 3.33) + 40
        guide, pencil = image.guide, image.pencil
        unit = Fraction(2) ** guide.length
        self._at = [x / unit for x in pencil.places]
        self._seen = [x / unit for x in image.places]
        self._distances = sorted({x - y for x in (*self._at, *self._seen) for y in self._at})
        with precision(self._bits):
            self._g, self._rate = rational_ball(guide.g), rational_ball(Fraction(2) ** -guide.time)
            self._terms = [([rational_ball(x) for x in direction], self._waves(one)) for direction, one in terms]
            self._S = [[[rational_ball(x) for x in row] for row in rows] for rows in (pencil.K, pencil.C, pencil.M)]
            self._B = [[rational_ball(x) for x in row] for row in pencil.B]
            self._h = [rational_ball(x) for x in pencil.h]
            self._D, self._N = (
                [acb_poly([rational_ball(c) for c in row]) for row in rows.rows]
                for rows in (image.receptance.symbols.D, image.receptance.symbols.N)
            )
            self._xi = {x: rational_ball(x) for x in self._distances}

    def _waves(self, one: Load) -> tuple[Any, Any, Any, Any]:
        given = (one.constant, one.amplitude, one.frequency, one.phase)
        c, a, omega, phase = (x.ball() for x in given)
        return c, a, omega / self._rate, phase

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
        with precision(self._bits):
            try:
                values = self._values(acb(*(self._ball(part) for part in (sigma.real, sigma.imag))))
            except (ValueError, ZeroDivisionError):
                stated = "act where the equations are singular, or where p-roots meet"
                raise InputError("loads", f"{stated}: change a frequency or the velocity a little") from None
        if not all(x.is_finite() for x in values):
            raise PrecisionError("the image of the motion is out of reach of the digits: change a parameter a little")
        return [number(self.mp, x) for x in values]

    def _ball(self, x: Any) -> Any:
        sign, mantissa, exponent, _ = x._mpf_
        return arb((-int(mantissa) if sign else int(mantissa), int(exponent)))

    def _values(self, sigma: Any) -> list[Any]:
        return self._solved(sigma, self._green(sigma), self._forces(sigma))

    def _solved(self, sigma: Any, G: dict[Fraction, Any], force: list[Any]) -> list[Any]:
        """Coordinates, contact forces, rail, under forces on the coordinates."""
        n = self.image.size
        right = [[x] for x in [*force, *[acb(0)] * self.image.contacts]]
        x = [row[0] for row in acb_mat(self._rows(sigma, G)).solve(acb_mat(right)).tolist()]
        rail = [sum((G[at - y] * x[n + j] for j, y in enumerate(self._at)), acb(0)) for at in self._seen]
        return [*x, *rail]

    def _rows(self, sigma: Any, G: dict[Fraction, Any]) -> list[list[Any]]:
        """The equations."""
        n, m = self.image.size, self.image.contacts
        s = sigma * self._rate
        rows = []
        for i in range(n):
            own = [self._S[0][i][j] + s * (self._S[1][i][j] + s * self._S[2][i][j]) for j in range(n)]
            rows.append([*own, *self._B[i]])
        for i in range(m):
            own = [-G[self._at[i] - self._at[j]] - (self._h[i] if i == j else 0) for j in range(m)]
            rows.append([*(self._B[j][i] for j in range(n)), *own])
        return rows

    def _green(self, sigma: Any) -> dict[Fraction, Any]:
        """G at all distances, from residues: close p-roots cost digits of the guard."""
        D, N = (acb_poly([row(sigma) for row in rows]) for rows in (self._D, self._N))
        slope, up = D.derivative(), self.image.receptance.upper
        roots = sorted((self._sharp(D, slope, z) for z in D.roots()), key=lambda z: float(z.real))
        waves = [(z, self._g * N(z) / slope(z)) for z in roots]
        out: dict[Fraction, Any] = {}
        for xi in self._distances:
            some, sign = (waves[:up], 1) if xi >= 0 else (waves[up:], -1)
            out[xi] = sign * sum((w * (z * self._xi[xi]).exp() for z, w in some), acb(0))
        return out

    def _sharp(self, D: Any, slope: Any, root: Any) -> Any:
        """A root that FLINT has isolated, by Newton's method to all digits."""
        z, bits = root.mid(), 20
        while bits < 2 * self._bits:
            z, bits = (z - D(z) / slope(z)).mid(), 2 * bits
        return z

    def _forces(self, sigma: Any) -> list[Any]:
        total = [acb(0)] * self.image.size
        for direction, (c, a, omega, phase) in self._terms:
            wave = c / sigma
            if a != 0:
                wave += a * (omega * phase.cos() + sigma * phase.sin()) / (sigma * sigma + omega * omega)
            total = [x + d * wave for x, d in zip(total, direction, strict=True)]
        return total


def number(mp: Any, ball: Any) -> Any:
    """The middle of a ball as an mpmath number, exactly as far as the context's digits go."""
    parts = []
    for part in (ball.real, ball.imag):
        mantissa, exponent = part.mid().man_exp()
        parts.append(mp.ldexp(mp.mpf(int(mantissa)), int(exponent)))
    return mp.mpc(*parts)
