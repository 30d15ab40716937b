"""Steady and unsteady harmonic parts in balls: residues of W̃ at the frequencies of the forces and of the motion."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import flint

from mpsolve.certificate.sheet import SheetSpectrum
from mpsolve.errors import PrecisionError
from mpsolve.model.branch import Pairing, Track, pairing
from mpsolve.model.characteristic import characteristic_rate
from mpsolve.model.edge import edge_roots
from mpsolve.model.kernel import AHEAD, BEHIND, kernel, kernel_at_contact
from mpsolve.motion.rigorous_forces import Setting
from mpsolve.motion.transform import contact_image, numerators, system
from mpsolve.numbers.rootball import Symmetry

acb, arb = flint.acb, flint.arb


@dataclass(frozen=True)
class BallWave:
    """Re(A(ξ) e^{iqτ}): the pole q in a ball, Re q ≥ 0, and A at each position; A includes the mirror image −q̄."""

    q: Any
    amplitudes: tuple[Any, ...]

    def at(self, row: int, tau: Any) -> Any:
        return (self.amplitudes[row] * (acb(0, 1) * self.q * tau).exp()).real


def steady(track: Track, given: Setting) -> list[BallWave]:
    """One wave for each frequency of the forces, the constant forces (q = 0) first. Raises PrecisionError."""
    found = []
    for tone in given.tones:
        q = acb(tone.frequency)
        pair = _seen_from_below(track, q)
        S = contact_image(track, pair, q, [4 * a for a in tone.amplitudes])
        found.append(_wave(track, q, pair, S, given))
    return found


def induced(track: Track, given: Setting, spectrum: SheetSpectrum) -> list[BallWave]:
    """One wave for each pair q, −q̄ of induced frequencies of the physical sheet, (36).

    Raises PrecisionError for a cluster of roots, and where a root is too wide for the division.
    """
    found = []
    for root in spectrum.roots:
        if root.symmetry is not Symmetry.IMAGINARY and not root.q.real > 0:
            continue
        if root.multiplicity > 1:
            raise PrecisionError(
                f"{root.multiplicity} induced frequencies near {root.q.str(6)} could not be told apart: certify with "
                "more digits and pass the spectrum, or change a parameter slightly"
            )
        pair = pairing(track, root.q)
        turn = acb(0, 1 if root.symmetry is Symmetry.IMAGINARY else 2) / characteristic_rate(track, root.q)[1]
        S = [turn * value for value in numerators(track, system(track, pair, root.q), given.balls(root.q))]
        found.append(_wave(track, root.q, pair, S, given))
    return found


def _wave(track: Track, q: Any, pair: Pairing, S: Sequence[Any], given: Setting) -> BallWave:
    contact = kernel_at_contact(track, pair)
    amplitudes = []
    for row in given.gaps:
        kernels = [
            kernel(track, pair, AHEAD if sign > 0 else BEHIND, abs(xi)) if sign else contact for sign, xi in row
        ]
        terms = [s * K for s, K in zip(S, kernels, strict=True)]
        amplitudes.append(sum(terms[1:], terms[0]) / track.field.pi)
    if not all(a.is_finite() for a in amplitudes):
        raise PrecisionError(
            f"the amplitude at the frequency {q.str(6)} is not bounded: a frequency of the forces may meet an "
            "induced one; ask for more digits, or change a parameter slightly"
        )
    return BallWave(q, tuple(amplitudes))


def _seen_from_below(track: Track, q: Any) -> Pairing:
    """The factors of D at a real force frequency on or below the cut line."""
    try:
        return pairing(track, q)
    except PrecisionError:
        if not track.eta_b.is_zero():
            raise
    seen = edge_roots(track, q.real)
    s = seen.a + seen.b  # 0 for constant forces above the critical velocity, so that nothing is divided by it
    return Pairing(s, s * s, seen.a * seen.b - seen.c * seen.e, -4 * track.A, seen.R)
