"""The harmonic solution (36) in balls: the amplitude of each induced frequency at the rear contact point ξ = 0."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import flint

from mpsolve.numbers.balls import precision, rational_ball
from mpsolve.problem.case import Case

from .cases import spectrum
from .kernels import Kernels, delta_rate, kernels

acb, arb = flint.acb, flint.arb
_BITS = 160


@dataclass(frozen=True)
class Harmonic:
    """steady: the part of q = 0; terms: (q, amplitude) of e^{iqτ} for each root, by ascending Re q; η_C = 1."""

    steady: Any
    terms: tuple[tuple[Any, Any], ...]

    @property
    def amplitudes(self) -> list[Any]:
        """2|A| of the pairs ±q, Re q > 0, by ascending Re q."""
        with precision(_BITS):
            return [2 * abs(A) for q, A in self.terms if q.real > 0]

    @property
    def frequencies(self) -> list[Any]:
        return [q.real for q, _ in self.terms if q.real > 0]

    @property
    def start(self) -> Any:
        """The displacement at τ = 0: what the truly transient part has to make up for, since all three give 0."""
        with precision(_BITS):
            return abs((self.steady + sum((A for _, A in self.terms), acb(0))).real)


@lru_cache(maxsize=512)
def harmonic(case: Case) -> Harmonic:
    """The harmonic solution of one mass, or of two equal ones, each under the constant force 1, at ξ = 0."""
    masses = case.merged.eta_m
    with precision(_BITS):
        eta, pi = rational_ball(masses[0].as_fraction()), arb.pi()
        terms = []
        for root in sorted(spectrum(case).roots, key=lambda r: float(r.q.real.mid())):
            q = root.q
            found = kernels(case, q)
            slope = delta_rate(eta, q, found if len(masses) > 1 else found.contact)
            shape = _shape(eta, q, found) if len(masses) > 1 else found.contact[0]
            terms.append((q, 4 * shape / (q * pi ** len(masses) * slope)))
        still = kernels(case, acb(0))
        steady = 4 * (still.contact[0] + (still.behind[0] if len(masses) > 1 else 0)) / pi
        return Harmonic(steady, tuple(terms))


def _shape(eta: Any, q: Any, K: Kernels) -> Any:
    """The numerators of (36) of two equal masses times K(0), K(−d), summed."""
    contact, ahead, behind = K.contact[0], K.ahead[0], K.behind[0]
    inertia, pi = 2 * eta * q * q, arb.pi()
    return (pi - inertia * (contact - behind)) * contact + (pi - inertia * (contact - ahead)) * behind


def superposed(alone: Case, d: str) -> Any:
    """2|A| at the rear contact if each of two masses moved `alone` (undamped: one pair of frequencies)."""
    with precision(_BITS):
        both = Case(alpha=alone.alpha, eta_b=alone.eta_b, eta_m=(1, 1), positions=("0", d))
        (q, A), *_ = [term for term in harmonic(alone).terms if term[0].real > 0]
        found = kernels(both, q)
        return 2 * abs(A * (1 + found.behind[0] / found.contact[0]))
