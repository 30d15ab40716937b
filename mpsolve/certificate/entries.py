"""The balls of roots as a certificate names them: one entry for a pair q, −q̄, on a grid of powers of two."""

from __future__ import annotations

from fractions import Fraction

from mpsolve.certificate.spectrum_file import RootEntry
from mpsolve.numbers.rootball import RootBall, Symmetry


def root_entries(balls: tuple[RootBall, ...]) -> list[RootEntry]:
    """One entry for a pair q, −q̄, one for a root by itself, the fastest first, in whatever order they were found."""
    out = []
    for ball in sorted(balls, key=lambda ball: (-float(ball.q.real.mid()), float(ball.q.imag.mid()))):
        if ball.symmetry is Symmetry.IMAGINARY or ball.q.real.contains(0):  # a cluster about the axis, too
            out.append(_entry(ball, False))
        elif ball.q.real > 0:
            out.append(_entry(ball, any(other.q.overlaps(ball.mirrored.q) for other in balls)))
        elif not any(other.q.overlaps(ball.mirrored.q) for other in balls):
            out.append(_entry(ball, False))
    return out


def _entry(ball: RootBall, pair: bool) -> RootEntry:
    re, im, side = ball.in_units
    return RootEntry(re, im, ball.exponent, side * Fraction(3, 2), ball.multiplicity, pair)
