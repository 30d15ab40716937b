"""What a root means to an engineer: a vibration with a frequency, a rate, and a doubling or halving time."""

from __future__ import annotations

from enum import Enum

from flint import arb

from mpsolve.frozen import frozen
from mpsolve.numbers.balls import precision
from mpsolve.numbers.decimals import working_bits
from mpsolve.numbers.rootball import Symmetry
from mpsolve.spectrum.spectrum import Root, Spectrum


class Trend(Enum):
    """What becomes of the amplitude |e^{iqt}|."""

    GROWS = "grows"
    DECAYS = "decays"
    STEADY = "steady"
    OPEN = "open"


@frozen
class Vibration:
    """The motion e^{iqt} of the roots q and −q̄, in balls (flint.arb) that contain the exact values.

    frequency = |Re q|/2π, rate = −Im q (positive: it grows), time = ln 2/|Im q| in which it doubles or halves, None
    unless the trend is proved to be one of the two; in the units of the problem.
    """

    root: Root
    frequency: arb
    rate: arb
    time: arb | None
    trend: Trend


def vibration(root: Root, digits: int) -> Vibration:
    """The vibration of `root`, with no more than 10^−digits lost to rounding, relative to each value."""
    with precision(working_bits(digits)):
        rate = -root.q.imag
        state = trend(root)
        time = arb.const_log2() / abs(rate) if state in (Trend.GROWS, Trend.DECAYS) else None
        return Vibration(root, abs(root.q.real) / (2 * arb.pi()), rate, time, state)


def vibrations(spectrum: Spectrum) -> tuple[Vibration, ...]:
    """Every root once, a pair q, −q̄ by its member with Re q > 0; by ascending frequency."""
    return tuple(vibration(root, spectrum.digits) for root in once(spectrum))


def once(spectrum: Spectrum) -> list[Root]:
    """The roots without those whose mirror image with Re q > 0 is there too; by ascending frequency."""
    right = [root for root in spectrum.roots if not root.q.real < 0]
    with precision(working_bits(spectrum.digits)):
        lone = [
            root
            for root in spectrum.roots
            if root.q.real < 0 and not any((-root.q.conjugate()).overlaps(other.q) for other in right)
        ]
    return sorted(lone + right, key=lambda root: abs(float(root.q.real.mid())))


def trend(root: Root) -> Trend:
    """What is proved of the sign of Im q."""
    if root.symmetry is Symmetry.REAL:
        return Trend.STEADY
    if root.q.imag < 0:
        return Trend.GROWS
    return Trend.DECAYS if root.q.imag > 0 else Trend.OPEN
