"""A family seen from another line: σ = σ′ + s, so that the real axis of q′ is the line Im q = −s.

For s ≥ 0 it is a family of the same kind: masses, dampers and springs m, c, k become m, c + 2ms and k + cs + ms², in
the track and in the vehicles, which therefore stay passive. So does any track that is passive at rest: for each real
p, z N/D(z) is positive real in Re z > 0, so that N/D = a + ∫ dμ(ω)/(z² + ω²) with a, μ ≥ 0 (Herglotz), and each
1/((z + s)² + ω²) is the receptance of a damped oscillator. For s < 0 nothing of this is claimed.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Any, cast

from mpsolve.problem.family import Family
from mpsolve.problem.free_track import FreePolynomial
from mpsolve.problem.line import moved_in_s, moved_pencil
from mpsolve.tracks.waveguide import moving


def shifted(family: Family, s: Fraction) -> Family:
    """The same family as a function of σ̂ − s; s is scaled."""
    if not s:
        return family
    D_rest, N_rest = (moved_in_s(a, s) for a in (family.D_rest, family.N_rest))
    speed: Any = family.v
    D, N = (cast(FreePolynomial, moving(cast(Any, a), speed)) for a in (D_rest, N_rest))
    return replace(family, D_rest=D_rest, N_rest=N_rest, D=D, N=N, S=moved_pencil(family.S, s))
