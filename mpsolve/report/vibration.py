"""What a root means to an engineer: a vibration with a frequency, a rate, and a doubling or halving time."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from typing import TYPE_CHECKING, Any

from flint import arb

from mpsolve.errors import InputError
from mpsolve.model.parameters import PhysicalCase
from mpsolve.numbers.balls import precision
from mpsolve.numbers.decimals import working_bits
from mpsolve.numbers.rootball import RootBall, Symmetry
from mpsolve.spectrum.spectrum import Root, Spectrum

if TYPE_CHECKING:
    from mpsolve.certificate.on_sheet import AnySpectrum


class Trend(Enum):
    """What becomes of the amplitude |e^{iqτ}|."""

    GROWS = "grows"
    DECAYS = "decays"
    STEADY = "steady"
    OPEN = "open"


@dataclass(frozen=True)
class Vibration:
    """The motion e^{iqτ} of the roots q and −q̄, in balls (flint.arb) that contain the exact values.

    frequency = |Re q| ω/2π, rate = −Im q ω (positive: it grows), time = ln 2/|Im q ω| in which it doubles or
    halves, None unless the trend is proved to be one of the two; ω = √(k/m) in rad/s, so that they are in Hz,
    1/s and s, or ω = 1, so that they are in the unit of the dimensionless time τ.
    """

    root: RootBall | Root
    frequency: Any
    rate: Any
    time: Any
    trend: Trend


def vibration(root: RootBall | Root, physical: PhysicalCase | None, digits: int) -> Vibration:
    """The vibration of `root`, with no more than 10^−digits lost to rounding, relative to each value."""
    with precision(working_bits(digits)):
        omega = arb(1) if physical is None else physical.time_scale.ball()
        rate = -root.q.imag * omega
        state = trend(root)
        time = arb.const_log2() / abs(rate) if state in (Trend.GROWS, Trend.DECAYS) else None
        return Vibration(root, abs(root.q.real) * omega / (2 * arb.pi()), rate, time, state)


def vibrations(spectrum: AnySpectrum, physical: PhysicalCase | None = None) -> tuple[Vibration, ...]:
    """Every root of the spectrum once, a pair q, −q̄ by its member with Re q > 0; by ascending frequency.

    Raises InputError if `physical` is not the case of the spectrum.
    """
    from mpsolve.certificate.on_sheet import sheet_of

    spectrum = sheet_of(spectrum)
    if physical is not None and physical.dimensionless != spectrum.case:
        raise InputError("physical", "is not the case of this spectrum: give the case that was certified")
    ordered = sorted(_once(spectrum), key=lambda root: abs(float(root.q.real.mid())))
    return tuple(vibration(root, physical, spectrum.digits) for root in ordered)


def own_vibration(root: Root, digits: int) -> Vibration:
    """The vibration of a root in the units of its problem."""
    return vibration(root, None, digits)


def own_vibrations(spectrum: Spectrum) -> tuple[Vibration, ...]:
    """Every root of any spectrum once, in the units of its problem; by ascending frequency."""
    ordered = sorted(_once(spectrum), key=lambda root: abs(float(root.q.real.mid())))
    return tuple(own_vibration(root, spectrum.digits) for root in ordered)


def _once(spectrum: Any) -> list[Any]:
    """The roots without those whose mirror image with Re q > 0 is there too."""
    right = [root for root in spectrum.roots if not root.q.real < 0]
    with precision(working_bits(spectrum.digits)):
        lone = [
            root
            for root in spectrum.roots
            if root.q.real < 0 and not any((-root.q.conjugate()).overlaps(other.q) for other in right)
        ]
    return lone + right


def trend(root: RootBall | Root) -> Trend:
    """What is proved of the sign of Im q."""
    if root.symmetry is Symmetry.REAL:
        return Trend.STEADY
    if root.q.imag < 0:
        return Trend.GROWS
    return Trend.DECAYS if root.q.imag > 0 else Trend.OPEN
