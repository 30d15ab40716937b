"""K(ξ, q) of (17) between two masses, and its slope in q, in balls: π/2 times the receptance of the beam."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import flint

from mpsolve.characteristic.proved import Proved
from mpsolve.numbers.balls import rational_ball
from mpsolve.problem.case import Case
from mpsolve.problem.cases import as_problem
from mpsolve.problem.reduced import Reduced, reduce_problem

Pair = tuple[Any, Any]


@dataclass(frozen=True)
class Kernels:
    """(K, dK/dq) at the contact, at the front mass of a force on the rear one, and the other way round."""

    contact: Pair
    ahead: Pair
    behind: Pair


def reduced_beam(case: Case) -> tuple[Reduced, Any]:
    """The scaled problem, and the factor of its receptances that gives K, a ball without π."""
    reduced = reduce_problem(as_problem(case))
    return reduced, reduced.guide.g / 2


def kernels(case: Case, q: Any) -> Kernels:
    """At the precision that is set; `PrecisionError` where the ball q may meet a cut."""
    reduced, factor = reduced_beam(case)
    turn = flint.acb(0, 1) / rational_ball(reduced.frequency_unit)
    d = reduced.places[-1] - reduced.places[0]
    split = Proved(reduced, eliminate=False).splitting(turn * q)
    scale = rational_ball(factor) * flint.arb.pi()
    values = zip(*split.receptances([0 * d, d, -d]), strict=True)
    return Kernels(*((scale * G, scale * turn * slope) for G, slope in values))


def delta_rate(eta_m: Any, q: Any, K: Kernels | Pair) -> Any:
    """Δ_q of (26) over π^n: of two equal masses, or of one for which K(0) alone is given."""
    pi = flint.arb.pi()
    a, a_q = 2 * q * q * eta_m / pi, 4 * q * eta_m / pi
    contact, contact_q = K.contact if isinstance(K, Kernels) else K
    first, first_q = 1 - a * contact, -a_q * contact - a * contact_q
    if not isinstance(K, Kernels):
        return first_q
    (ahead, ahead_q), (behind, behind_q) = K.ahead, K.behind
    crossed = 2 * a * a_q * ahead * behind + a * a * (ahead_q * behind + ahead * behind_q)
    return 2 * first * first_q - crossed
