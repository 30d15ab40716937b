"""The Laplace image of a motion as mpmath numbers: the middles of balls that are sharp enough."""

from __future__ import annotations

from typing import Any

from mpsolve.numbers.balls import acb, arb, precision
from mpsolve.vibration.balls.equations import Term
from mpsolve.vibration.balls.image import BallImage
from mpsolve.vibration.image import Image


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

    def _ball(self, x: Any) -> Any:
        sign, mantissa, exponent, _ = x._mpf_
        return arb((-int(mantissa) if sign else int(mantissa), int(exponent)))


def number(mp: Any, ball: Any) -> Any:
    """The middle of a ball as an mpmath number, exactly as far as the context's digits go."""
    parts = []
    for part in (ball.real, ball.imag):
        mantissa, exponent = part.mid().man_exp()
        parts.append(mp.ldexp(mp.mpf(int(mantissa)), int(exponent)))
    return mp.mpc(*parts)
