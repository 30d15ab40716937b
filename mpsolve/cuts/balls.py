"""The characteristic matrix along the edge of the cut in balls, with its slopes in p and in the parameter."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from mpsolve.characteristic.bordering import Bordering, vector
from mpsolve.characteristic.free_proved import slope_of, value_at
from mpsolve.cuts.edge import Edge, beam, edge, sides
from mpsolve.cuts.entries import Parts, of_one
from mpsolve.cuts.sloped import Sloped
from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, acb_mat, acb_poly, arb, bits_now
from mpsolve.numbers.reduction import Reduction
from mpsolve.numbers.several import Several
from mpsolve.problem.family import Family

_TRIES = 12


@dataclass(frozen=True)
class EdgeBalls:
    """A(p, x̂) of one side of the cut, for real balls p and x̂, at the precision that is set."""

    family: Family
    side: int

    @cached_property
    def border(self) -> Bordering:
        return Bordering.of(self.family, waves=1)

    def edge(self, p: Any, x: Any) -> Edge:
        """z and what goes with it."""
        one = Sloped(acb(p), (acb(1), acb(0)))
        return edge(one, [_free(c, x) for c in beam(self.family)[:-1]], _root)

    def partner(self, p: arb, x: arb) -> Any:
        """The p-root ir that p meets where the cut begins: a ball of r."""
        return self._others(self.edge(p, x), p, x)[0].value

    def _others(self, at: Edge, p: arb, x: arb) -> list[Sloped]:
        """r of b, a′ and b′."""
        middle = np.array([[float(c.value.real.mid()) for c in at.cubic]])
        v = value_at(self.family.v, [acb(x)]).real
        wave, z, speed = (np.array([float(y)]) for y in (arb(p).mid(), at.z.value.real.mid(), v.mid()))
        guesses, real = sides(middle, wave, z, speed, self.side)
        found = [_root_of(at.cubic, complex(r), bool(real[0]) or k == 0) for k, r in enumerate(guesses[0])]
        _require_sides(at, v, found[1], found[2], bool(real[0]))
        return found

    def parts(self, p: arb, x: arb) -> Parts:
        """What A is made of, with slopes; `PrecisionError` where balls cannot decide."""
        at, family = self.edge(p, x), self.family
        EI, N = (_free(beam(family)[k], x) for k in (0, -1))
        b, a2, b2 = (r.times(1j) for r in self._others(at, p, x))
        own = ([family.places[k] for k in family.index], self.border.distances)
        places, apart = ([_free(c, x) for c in some] for some in own)
        a = Sloped(acb(p), (acb(1), acb(0))).times(1j)
        return Parts(a, b, a2, b2, EI, N, at.sigma, places, apart, self.border.signs, _constant(1), _constant(0))

    def matrices(self, p: arb, x: arb) -> tuple[acb_mat, list[acb_mat]]:
        """(A, [∂A/∂p, ∂A/∂x̂]); `PrecisionError` where balls cannot decide."""
        parts = self.parts(p, x)
        rows = filled(self.border, parts.sigma, x, of_one(parts))
        if not all(x.value.is_finite() and all(d.is_finite() for d in x.slopes) for row in rows for x in row):
            raise PrecisionError("the receptance may be infinite over the ball: split the piece")
        slopes = [acb_mat([[x.slopes[k] for x in row] for row in rows]) for k in (0, 1)]
        return acb_mat([[x.value for x in row] for row in rows]), slopes


@dataclass(frozen=True)
class InPlane:
    """The scalar whose zeros are the roots on the cut, as a function of (p, x̂)."""

    balls: EdgeBalls
    reduction: Reduction

    def value(self, p: arb, x: Any) -> acb:
        return self.reduction.scalar(self.balls.matrices(p, x)[0])

    def slopes(self, p: arb, x: arb) -> tuple[acb, acb]:
        A, (A_p, A_x) = self.balls.matrices(p, x)
        return self.reduction.scalar_slope(A, A_p), self.reduction.scalar_slope(A, A_x)


def filled(border: Bordering, sigma: Sloped, x: Any, g: list[Sloped]) -> Any:
    """The matrix, an array, from what stands in the place of receptances."""
    f = []
    for coefficients in border.polynomials:
        total = _constant(0)
        for c in reversed(coefficients):
            total = total * sigma + _free(c, x)
        f.append(total)
    return border.matrix(vector(f), vector(g))


def _constant(value: int) -> Sloped:
    return Sloped(acb(value), (acb(0), acb(0)))


def _free(c: Several, x: arb) -> Sloped:
    return Sloped(value_at(c, [acb(x)]), (acb(0), value_at(slope_of(c, 0), [acb(x)])))


def _root(f: Sloped, m: Sloped) -> Sloped:
    ratio = f * m.inverse()
    value = ratio.value.sqrt()
    if not (ratio.value.real > 0 and value.is_finite()):
        raise PrecisionError("the wave that is real on the cut cannot be told: split the piece")
    return Sloped(value, tuple(d / (2 * value) for d in ratio.slopes))


def _root_of(cubic: Any, guess: complex, real: bool) -> Sloped:
    """The root near a float, with its slopes; real where it is known to be so."""
    polynomial = acb_poly([c.value for c in cubic])
    thin = acb_poly([c.value.mid() for c in cubic])
    rate, thin_rate = polynomial.derivative(), thin.derivative()
    r = acb(guess.real, guess.imag)
    for _ in range(4 + bits_now().bit_length()):
        r = (r - thin(r) / thin_rate(r)).mid()
        if real:
            r = acb(r.real)
    value = polynomial(r)
    size = arb((value / rate(r)).abs_upper()) * 2 + arb(2) ** (8 - bits_now()) * (1 + arb(r.abs_upper()))
    for _ in range(_TRIES):
        box = r + acb(arb(0, size.upper()), arb(0, size.upper()))
        image = r - value / rate(box)
        if image.is_finite() and box.contains_interior(image):
            found = acb(image.real) if real else image
            slopes = []
            for k in range(len(cubic[0].slopes)):
                moved = acb_poly([c.slopes[k] for c in cubic])(found)
                slopes.append(-moved / rate(found))
            return Sloped(found, tuple(slopes))
        size = size * 2
    raise PrecisionError("two p-roots cannot be told apart at the cut: split the piece")


def _require_sides(at: Edge, v: Any, a2: Sloped, b2: Sloped, real: bool) -> None:
    """That a′ and b′ are apart, and not real unless they are told by their order."""
    if real:
        apart = not (a2.value.real - b2.value.real).contains(0)
        behind = all(at.z.value.real - v * r.value.real < 0 for r in (a2, b2))
        if apart and behind:
            return
    elif a2.value.imag > 0 and b2.value.imag < 0:
        return
    raise PrecisionError("which p-roots are upper ones cannot be told at the cut: split the piece")
