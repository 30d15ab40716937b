"""A frequency beyond which tight masses have no root on the cut, the same for all values of the parameter.

The theorem far out (SPEC2, 8.5) in balls that hold the beams of a whole range: on the edge below the cut, and on the
one above it, where η has the other sign.
"""

from __future__ import annotations

from itertools import pairwise

from mpsolve.characteristic.free_proved import value_at
from mpsolve.cuts.edge import beam
from mpsolve.numbers.balls import acb, arb, least, precision, rational_ball
from mpsolve.numbers.plain import outward
from mpsolve.problem.family import Family
from mpsolve.problem.line import on_line
from mpsolve.spectrum.far_line import Beam, beyond
from mpsolve.spectrum.premises import tight_masses

_NEAR = 36.0  # in units of c₀: what is looked at where no theorem tells of what is far
_FIRST = 1.0  # in the same units: the theorem is tried from here on


def wavenumber_of(family: Family, reach: float | None) -> tuple[float, float]:
    """(P, z): on the cut |p| ≤ P where Re z < z, for all parameters; z: the reach, or some frequency for None."""
    with precision(64):
        EI, T, k, m, c, v, _ = _coefficients(family)
        rest = k - c * c / (4 * m)
        z = _NEAR * outward((EI / m).sqrt(), up=True) if reach is None else reach
        steep = arb((EI / m).sqrt().lower()) / 2  # S ≥ p² √(EI/m)/2 where EI p⁴/4 ≥ |T| p² + |k′|
        speed, pull, stiff = (arb(abs(y).upper()) for y in (v, T / EI, rest / EI))
        P = (speed + (speed * speed + 4 * steep * arb(z)).sqrt()) / (2 * steep)
        first = 2 * (pull.sqrt() + stiff.sqrt().sqrt()) + 1
        return outward(P.max(first), up=True) * (1 + 2.0**-20), z


def far_reach(family: Family) -> float | None:
    """z, so that no root lies on the cut beyond it; None where no theorem tells."""
    line = on_line(family.base)
    if line is None or not tight_masses(line):
        return None
    with precision(64):
        EI, T, k, m, c, v, _ = _coefficients(family)
        places = sorted(family.places)
        gaps = [value_at(b - a, _box(family)).real for a, b in pairwise(places)]
        track = Beam(EI, T, k - c * c / (4 * m), m, v, c / (2 * m), least(gaps) if gaps else None)
        found = beyond(track, len(places), _FIRST * outward(track.speed, up=True))
    return None if found is None else found.reach


def _coefficients(family: Family) -> list[arb]:
    return [value_at(c, _box(family)).real for c in beam(family)]


def _box(family: Family) -> list[acb]:
    return [acb(rational_ball(a).union(rational_ball(b))) for a, b in family.box]
