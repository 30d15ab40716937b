"""The closed-form parts of the motion: one wave Re(A(ξ) e^{iqτ}) for each frequency of the forces and each pair ±q.

Steady state: the poles of the forces, q = 0 and q = ±ω. Unsteady harmonic part (36): the induced frequencies of the
whole physical sheet, below and above the cut line. S_j of each wave, that is the contact forces, are computed in
mpmath over the certified roots, so that near roots do not cancel; K(ξ − x_j) follows in float64.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.certificate.sheet import SheetSpectrum
from mpsolve.errors import InputError, PrecisionError
from mpsolve.fields import MP
from mpsolve.model.branch import Pairing, Track, pairing, track
from mpsolve.model.characteristic import characteristic_rate
from mpsolve.model.load import Load
from mpsolve.model.parameters import Case
from mpsolve.motion.field import images_at
from mpsolve.motion.forcing import Tone, image, tones
from mpsolve.motion.sheets import pairing_below
from mpsolve.motion.transform import contact_image, numerators, system
from mpsolve.numbers.rootball import RootBall, Symmetry

BITS = 160
_NEAR = 1e-5  # closer frequencies, relative, lose too many digits in float64


@dataclass(frozen=True)
class Wave:
    """Re(A(ξ) e^{iqτ}), Re q ≥ 0, with A(ξ) = (1/π) Σ S_j K(ξ − x_j, q), and the contact forces Re(S_j e^{iqτ})/4.

    A and S_j include the mirror image −q̄. `precise`: q, S and the pairing in mpmath.
    """

    q: complex
    S: tuple[complex, ...]
    pair: Pairing
    multiplicity: int
    precise: tuple[Any, tuple[Any, ...], Pairing]

    def amplitude(self, model: Track, xi: Any) -> Any:
        """A at the float64 positions ξ, shape (len(xi),)."""
        return images_at(model, self.pair, self.S, np.asarray(xi, float))[:, 0]


def steady_waves(case: Case, loads: Sequence[Load], bits: int = BITS) -> tuple[Wave, ...]:
    """One wave for each frequency of the forces, the constant forces (q = 0) first.

    Raises InputError where a frequency of the forces meets a branch point: the motion then grows without a steady
    state (α = α_C with constant forces and no damping).
    """
    field = MP(bits)
    model = track(case, field)
    nudge = field.context.mpf(2) ** -20
    found = []
    for tone in tones(case, loads, field):
        q = field.context.mpc(tone.frequency)
        F = [4 * a for a in tone.amplitudes]
        try:
            pair = pairing_below(model, q, nudge)
            S = contact_image(model, pair, q, F)
        except (PrecisionError, ZeroDivisionError):
            raise InputError("loads", _resonant(tone)) from None
        if not abs(pair.R) > 1e-12 * (1 + abs(pair.y)) ** 2:
            raise InputError("loads", _resonant(tone))
        found.append(_wave(q, S, pair, 1))
    return tuple(found)


def induced_waves(
    case: Case, loads: Sequence[Load], spectrum: SheetSpectrum, bits: int = BITS, near: float = _NEAR
) -> tuple[Wave, ...]:
    """One wave for each pair q, −q̄ of induced frequencies, (36), sorted by Re q, then Im q.

    Raises PrecisionError for a cluster of roots, or one too near a frequency of the forces.
    """
    field = MP(bits)
    model, parts = track(case, field), tones(case, loads, field)
    found = []
    for root in spectrum.roots:
        if root.symmetry is not Symmetry.IMAGINARY and not root.q.real > 0:
            continue
        q = _middle(root, field)
        _check(root, q, parts, near)
        pair = pairing(model, q)
        slope = characteristic_rate(model, q)[1]
        turn = field.i * (1 if root.symmetry is Symmetry.IMAGINARY else 2) / slope
        S = [turn * value for value in numerators(model, system(model, pair, q), image(parts, field, q))]
        found.append(_wave(q, S, pair, root.multiplicity))
    return tuple(sorted(found, key=lambda wave: (wave.q.real, wave.q.imag)))


def _wave(q: Any, S: Sequence[Any], pair: Pairing, multiplicity: int) -> Wave:
    rough = Pairing(*(np.array([complex(v)]) for v in (pair.s, pair.y, pair.h, pair.c2, pair.R)))
    return Wave(complex(q), tuple(complex(v) for v in S), rough, multiplicity, (q, tuple(S), pair))


def _middle(root: RootBall, field: MP) -> Any:
    parts = [field.context.ldexp(int(m), int(e)) for m, e in (x.mid().man_exp() for x in (root.q.real, root.q.imag))]
    return field.context.mpc(*parts)


def _check(root: RootBall, q: Any, parts: Sequence[Tone], near: float) -> None:
    if root.multiplicity > 1:
        raise PrecisionError(
            f"{root.multiplicity} induced frequencies near {complex(q):.6g} could not be told apart, so their "
            "residues are unknown: certify with more digits and pass the spectrum, or change a parameter slightly"
        )
    for tone in parts:
        if tone.exact and abs(q - tone.frequency) < near * abs(q):
            raise PrecisionError(
                f"the frequency {tone.exact.short()} of the forces lies within {near:g} (relative) of the induced "
                f"frequency {complex(q):.6g}: the steady and the unsteady part grow without bound and cancel; change "
                "the frequency, or ask for the sum in digits: response(…, digits=15)"
            )


def _resonant(tone: Tone) -> str:
    return (
        f"with the frequency {tone.exact.short()} meet a branch point of the beam on its foundation (resonance), so "
        "that there is no steady state: change the frequency or the velocity, or add damping"
    )


def modulus(pairs: Sequence[tuple[complex, Any]], tau: Any) -> Any:
    """|Σ A_k e^{iq_kτ}| for pairs (q_k, A_k(ξ)), shape (len(ξ), len(τ)): what Re Σ A_k e^{iq_kτ} never exceeds."""
    waves = [np.asarray(a)[:, None] * np.exp(1j * q * tau) for q, a in pairs]
    return np.abs(sum(waves[1:], waves[0]))
