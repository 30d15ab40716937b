"""No root of tight masses far out on the edge of a beam's cut, and how arg Δ̂ turns beyond (SPEC2, the whole sheet).

On the edge the beam is undamped, and two of its four waves travel: what they carry away is what a force puts in.
With p = λx, z = c₀λ², y = 1/λ², D̃ = 0 is (x² + bx − c)(x² − bx + d) = 0, a real pair and one that is not real, with
real b, c, d that one number s² = (c + d)² tells. Each mass reflects the waves that run between the masses as an
obstacle which gives back no more than it gets, but for the damping; evanescent waves change the determinant by less
than it is from 0. Masses of any size are allowed, so that the theorem is about the track, the gaps and the number of
masses. Far out in the half-plane below it holds anyway, so that the count closes at infinity.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction

import numpy as np

from mpsolve.errors import PrecisionError
from mpsolve.frozen import frozen
from mpsolve.numbers.balls import acb, arb, greatest, least, precision, rational_ball
from mpsolve.problem.line import Line, discriminant
from mpsolve.problem.reduced import Reduced
from mpsolve.spectrum.closing import edge_splitting

_PARTS = 16  # of the range of 1/λ²
_ROUNDS = 12
_LESS = 0.99  # than 1, for a checker with wider bounds
_BEYOND = 1.2  # how far, at least, beyond the last frequency at which p-roots meet
_STEPS, _OCTAVES = 8, 48  # of the reach: of each octave, and of them


@frozen
class Beam:
    """EI, T, k − c²/4m, m, v and η = c/2m in balls, of one beam or of all of a range; the masses' least distance."""

    EI: arb
    T: arb
    k: arb
    m: arb
    v: arb
    height: arb
    gap: arb | None

    @property
    def speed(self) -> arb:
        """c₀."""
        return (self.EI / self.m).sqrt()


@frozen
class FarLine:
    """No root lies on the edge of the cut where z ≥ reach (scaled); spread: of arg Δ̂ there by evanescent waves."""

    reach: float
    spread: arb


def prove_far(line: Line) -> FarLine:
    """The smallest reach on a ladder; PrecisionError where there is none."""
    squares = discriminant(line.lower.guide.D).coeffs()
    last = np.sqrt(np.abs(np.roots([float(x) for x in reversed(squares)])).max())  # where p-roots meet
    with precision(64):
        EI, T, k, m, v, height = map(rational_ball, (*line.beam, line.lower.guide.v, line.height))
        gap = line.lower.smallest_gap
        beam = Beam(EI, T, k, m, v, height, None if gap is None else rational_ball(gap))
        found = beyond(beam, len(line.lower.places), float(_BEYOND * last))
    if found is None:
        raise PrecisionError("no frequency is known beyond which masses have no root: they are too close together")
    return found


def beyond(beam: Beam, masses: int, first: float) -> FarLine | None:
    """From about `first` on, at the precision that is set, for all beams in the balls; None if nothing is proved."""
    octave = (found for k in range(_OCTAVES) if (found := _proved(beam, masses, first * 2.0**k)) is not None)
    best = next(octave, None)
    low, high = -_STEPS, 0  # of the last octave: nothing is proved at its low end
    while best is not None and best.reach > first * 1.01 and high - low > 1:
        middle = (low + high) // 2
        found = _proved(beam, masses, best.reach * 2.0 ** ((middle - high) / _STEPS))
        if found is None:
            low = middle
        else:
            best, high = found, middle
    return best


def _proved(beam: Beam, masses: int, reach: float) -> FarLine | None:
    short = float(np.float32(reach))
    spread = spread_beyond(beam, masses, arb(short))
    return None if spread is None else FarLine(short, spread)


def spread_beyond(beam: Beam, masses: int, z: arb) -> arb | None:
    """A bound of |Arg det(1 + T + V)/det(1 + T)| on the edge from z on; None where that is not proved."""
    active = 2 * z * beam.height / (z * z - beam.height * beam.height)
    waves = list(_waves(beam, beam.speed.upper() / z))
    if not z > beam.height or len(waves) < _PARTS:
        return None
    ratios, uneven, decays = (list(row) for row in zip(*waves, strict=True))
    low, high, skew = least(ratios).lower(), greatest(ratios).upper(), greatest(uneven).upper()
    if not 1 + low > (1 + active * active) * skew:
        return None
    r = (1 / (1 + low).sqrt()).upper()
    floor = _floor(masses, r, active)
    if floor is None or masses == 1:
        return None if floor is None else arb(0)
    n, most = masses - 1, r * (skew.sqrt() + (skew - 1).upper().max(arb(0)).sqrt())
    decay = (z / beam.speed).sqrt() * least(decays).lower() * (arb(0) if beam.gap is None else beam.gap)
    lost = r * high.sqrt() * (-decay).exp()
    rows = (1 + n * (most + lost) * (most + lost)).sqrt()
    changed = masses * arb(n).sqrt() * lost / floor
    for _ in range(n):
        changed *= rows
    return changed.upper().asin() if changed < _LESS else None


def _waves(beam: Beam, top: arb) -> Iterator[tuple[arb, arb, arb]]:
    """Over the parts of 0 ≤ y ≤ top: |w_e|²/αβ, ((α + β)/2)²/αβ, the rate of decay over λ; fewer where one is open.

    w_e: the weight N/D_P of an evanescent wave; α, β: moduli of those of the travelling waves.
    """
    steep, stiff = beam.v * beam.v / (beam.speed * beam.speed), beam.k / beam.EI
    pull = beam.T / beam.EI + steep
    for k in range(_PARTS):
        y = (top * k / _PARTS).union(top * (k + 1) / _PARTS)
        square = _square(steep, pull, stiff, y)
        if square is None:
            return
        s, b = square.sqrt(), 4 * steep * y / square  # b²
        x = b - 2 * pull * y
        if not (2 * s - x > 0 and 2 * s + x > 0):
            return
        yield (2 * s - x) / (2 * s + x), (s + b) * (s + b) / (square + 2 * b * (b - pull * y)), (2 * s + x).sqrt() / 2


def _square(steep: arb, pull: arb, stiff: arb, y: arb) -> arb | None:
    """A ball of s² > 0 for each y, from one that its equation maps into itself (Brouwer)."""
    square = arb(4)
    for _ in range(_ROUNDS):
        wide = arb(square.mid(), (2 * square.rad() + arb(2) ** -40).upper())
        step = y * (4 * steep / wide - pull)
        square = step * step + 4 * (1 - stiff * y * y)
        if not square.is_finite() or not square > 0:
            return None
        if wide.contains(square):
            return square
    return None


def _floor(masses: int, r: arb, active: arb) -> arb | None:
    """A lower bound of |det(1 + T)| = Π|1 + g z|, from the last mass to the first; None where there is none."""
    floor, Z = arb(1), r
    for _ in range(masses - 1):
        if not r * Z < 1:
            return None
        left = 1 - r * Z
        floor *= left
        if Z <= 1:
            passive = (Z + r) / (1 + r * Z)
        elif Z > 1:
            passive = (1 + (1 - r * r) * (Z * Z - 1) / (left * left)).sqrt()
        else:
            return None
        Z = (passive + 2 * active * Z / left).upper()
    return arb(floor.lower())


def turn_beyond(line: Line, up: int, far: FarLine) -> arb:
    """How arg Δ̂ changes from the reach along the edge to infinity, and on below to −i∞; PrecisionError if open."""
    for bits in (64, 256, 1024):
        with precision(bits):
            try:
                return arb(0, far.spread.upper()) - _argument(line, up, far.reach)
            except PrecisionError:
                continue
    raise PrecisionError("the waves far out on the line of the cuts are not told apart")


def _argument(line: Line, up: int, reach: float) -> arb:
    """Of det(1 + T) and of what Δ̂ has beside it: σ² and d = G(0) + 1/(Mσ²) of each place; Re d < 0."""
    reduced, found = line.lower, edge_splitting(line.lower, up, reach)
    waves = list(zip(found.roots or (), found.weights, strict=True))
    (a, ahead), (c, behind) = (
        travelling(waves[side], sign) for side, sign in ((slice(up), 1), (slice(up, None), -1))
    )
    at_contact = sum((w for _, w in waves[:up]), acb(0))
    sigma, places = acb(-rational_ball(line.height), arb(reach)), [rational_ball(x) for x in reduced.places]
    total, arriving = arb(0), acb(0)
    for k in reversed(range(len(places))):
        d = at_contact + 1 / (rational_ball(_mass(reduced, k)) * sigma * sigma)
        total += 2 * sigma.arg() + (-d).arg() - arb.pi()
        factor = 1 + behind / d * arriving
        total += factor.arg()
        reflected = (arriving * (1 - (ahead + behind) / d) - ahead / d) / factor
        arriving = ((a - c) * (places[k] - places[k - 1])).exp() * reflected if k else reflected
    if not (total.is_finite() and total.rad() < 0.1):
        raise PrecisionError("the masses far out are not told to reflect less than they get")
    return total


def travelling(waves: Sequence[tuple[acb, acb]], sign: int) -> tuple[acb, acb]:
    """P and ±N/D_P of the one wave of a side that is not proved to decay; the sign of its weight proves its side."""
    found = [(P, sign * w) for P, w in waves if not sign * P.real < 0]
    if len(found) != 1 or not found[0][1].imag < 0:
        raise PrecisionError("the waves far out are not told apart")
    return found[0]


def _mass(reduced: Reduced, place: int) -> Fraction:
    """Of all bodies at a place: each has one tight contact."""
    M, B = reduced.S[2], reduced.B
    contacts = [j for j, at in enumerate(reduced.index) if at == place]
    return sum((M[i][i] / row[j] ** 2 for j in contacts for i, row in enumerate(B) if row[j]), Fraction(0))
