"""What a track absorbs at real frequencies, as exact polynomials: W = −Im(N conj D) and |D|² at P = ip, s = iΩ."""

from __future__ import annotations

from fractions import Fraction
from functools import cached_property

import numpy as np

from mpsolve.frozen import frozen
from mpsolve.numbers.several import multiply, plus
from mpsolve.problem.reduced import Guide
from mpsolve.tracks.waveguide import Polynomial, halves, moving, power


@frozen
class Absorption:
    """W and |D|² as exact real polynomials {(i, j): c} in p and Ω, and with Ω = q − vp in p and q."""

    W: Polynomial
    D2: Polynomial
    v: Fraction

    @cached_property
    def moving(self) -> tuple[Polynomial, Polynomial]:
        return moving(self.W, self.v), moving(self.D2, self.v)

    def exponent(self, gamma: Fraction) -> Fraction:
        """e with W/|D|² of order q^{−e} for p of order q^γ."""
        tops = [top_power(a, gamma.numerator, gamma.denominator) for a in self.moving]
        return Fraction(tops[1] - tops[0], gamma.denominator)

    @classmethod
    def of(cls, guide: Guide) -> Absorption:
        (even, odd), w = halves(guide.D_rest), power(guide.D_rest, guide.N_rest)
        D2 = {(2 * i, 2 * j): c for (i, j), c in multiply(even, even).items()}
        D2 = plus(D2, {(2 * i, 2 * j + 2): c for (i, j), c in multiply(odd, odd).items()})
        return cls({(2 * i, 2 * j + 1): c for (i, j), c in w.items()}, D2, guide.v)


def overtakes(absorption: Absorption, v: Fraction) -> bool:
    """In floats: some short wave of the track runs at a speed up to v, so that no envelope exists."""
    return slowest_short_wave(absorption) <= float(v)


def slowest_short_wave(absorption: Absorption) -> float:
    """In floats: the least speed of the waves of the track as they become short; infinite where there is none."""
    (_, i2), (_, n2), _ = orders(absorption)
    speeds = np.zeros(i2 + 1)
    for (i, j), c in absorption.D2.items():
        if i + j == n2:
            speeds[i] = float(c * (-1) ** j)  # of r^(i2 − i), descending
    roots = np.roots(speeds)
    real = roots[(np.abs(roots.imag) < 1e-6 * np.abs(roots)) & (roots.real > 0)].real
    return float(real.min(initial=np.inf))


def orders(absorption: Absorption) -> tuple[tuple[int, int], tuple[int, int], int]:
    """Degrees in p, total degrees of (W, |D|²), and the exponent α of the envelope."""
    W, D2 = absorption.W, absorption.D2
    by_p = max(i for i, _ in W), max(i for i, _ in D2)
    total = max(i + j for i, j in W), max(i + j for i, j in D2)
    return by_p, total, min(by_p[1] - by_p[0], total[1] - total[0])


def in_block(polynomial: Polynomial, k: int, m: int) -> Polynomial:
    """A polynomial in p and q at p = z τ^{−k}, q = τ^{−m}, times τ^top, in z and τ."""
    top = top_power(polynomial, k, m)
    return {(a, top - k * a - m * b): c for (a, b), c in polynomial.items()}


def top_power(polynomial: Polynomial, k: int, m: int) -> int:
    return max(k * a + m * b for a, b in polynomial)
