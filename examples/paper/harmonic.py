"""The harmonic solution (36) in balls: the amplitude of each induced frequency at the rear contact point ξ = 0."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import flint

from mpsolve.fields import ball_arithmetic
from mpsolve.model.branch import track
from mpsolve.model.characteristic import characteristic_rate, kernel_matrix
from mpsolve.problem.case import Case

from .cases import spectrum

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
        with ball_arithmetic(_BITS):
            return [2 * abs(A) for q, A in self.terms if q.real > 0]

    @property
    def frequencies(self) -> list[Any]:
        return [q.real for q, _ in self.terms if q.real > 0]

    @property
    def start(self) -> Any:
        """The displacement at τ = 0: what the truly transient part has to make up for, since all three give 0."""
        with ball_arithmetic(_BITS):
            return abs((self.steady + sum((A for _, A in self.terms), acb(0))).real)


@lru_cache(maxsize=512)
def harmonic(case: Case) -> Harmonic:
    """The harmonic solution of one mass, or of two equal ones, each under the constant force 1, at ξ = 0."""
    with ball_arithmetic(_BITS) as field:
        model = track(case, field)
        terms = []
        for root in sorted(spectrum(case).roots, key=lambda r: float(r.q.real.mid())):
            q = root.q
            _, slope = characteristic_rate(model, q)
            terms.append((q, 4 * _shape(model, q) / (q * field.pi ** len(model.eta_m) * slope)))
        steady = 4 * sum(kernel_matrix(model, acb(0))[0], acb(0)) / field.pi
        return Harmonic(steady, tuple(terms))


def _shape(model: Any, q: Any) -> Any:
    """The numerators of (36) times K(0), K(−d), summed; for one mass it is K(0)."""
    rows = kernel_matrix(model, q)
    if len(rows) == 1:
        return rows[0][0]
    K0, behind, ahead = rows[0][0], rows[0][1], rows[1][0]
    inertia, pi = 2 * model.eta_m[0] * q * q, model.field.pi
    return (pi - inertia * (K0 - behind)) * K0 + (pi - inertia * (K0 - ahead)) * behind


def superposed(alone: Case, d: str) -> Any:
    """2|A| at the rear contact if each of two masses moved `alone` (undamped: one pair of frequencies)."""
    with ball_arithmetic(_BITS) as field:
        model = track(Case(alpha=alone.alpha, eta_b=alone.eta_b, eta_m=(1, 1), positions=("0", d)), field)
        (q, A), *_ = [term for term in harmonic(alone).terms if term[0].real > 0]
        rows = kernel_matrix(model, q)
        return 2 * abs(A * (1 + rows[0][1] / rows[0][0]))
