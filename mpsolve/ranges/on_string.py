"""Strings on which nothing grows, whatever passive vehicles run there, at all velocities but that of the waves.

With s = σ − vP the p-roots of T P² = m s² + c s + k part by the root of

    (T − m v²)P² + v(2mσ + c)P − (mσ² + cσ + k),    G(0) = 1/√disc,
    disc = 4T(mσ² + cσ + k) + v²(c² − 4mk) = 4Tm (σ + a)(σ + b),    a + b = c/m,  ab = (k/m)(1 − w) + w(c/2m)²,

w = mv²/T. *Slower than the waves* (w < 1) a and b are conjugates or real, with Re a, Re b ≥ 0. For Re σ > 0, Im σ ≥ 0
the argument of √((σ + a)(σ + b)) lies between 0 and that of σ: Im (σ + a)(σ + b) = (Im σ)(2 Re σ + c/m) ≥ 0, and
(σ + a)(σ + b)/σ² = 1 + (c/m)/σ + ab/σ² has an argument between −2 arg σ and 0. So Re σG(0) > 0 in Re σ > 0, and no
passive vehicle with one contact has a root there (SPEC2, section 5).

*Faster* (w > 1) both p-roots belong to the waves behind: G(ξ) = 0 for ξ ≥ 0. Where each vehicle touches the string at
one place and no two are joined, the forces of the rear contacts do not reach those ahead: Δ̃ is the product of the
vehicles' own determinants on a rail that does not move, and passive vehicles have no root in Re σ > 0. (Those without
dampers vibrate on there: real q, at all velocities.)
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from mpsolve.problem.family import Interval
from mpsolve.problem.problem import Problem
from mpsolve.tracks.string import String

SLOWER = "slower than its waves a string takes up power from one contact at all frequencies: no boxes are needed"
FASTER = (
    "faster than its waves a string carries none ahead, so that single contacts do not feel it: no boxes are needed"
)


def quiet(problem: Problem, over: Mapping[str, Interval], side: int | None = None) -> str | None:
    """Why nothing grows at any point of the ranges; None where the theorem does not tell.

    side: −1 where all velocities are known to be slower than the waves, 1 where faster; None: they are compared.
    """
    track = problem.track
    if not isinstance(track, String) or not _ends(problem, over, "track.c")[0] > 0:
        return None
    if side is None:
        T, m, v = (_ends(problem, over, path) for path in ("track.T", "track.m", "v"))
        if None in (*T, *m, *v):  # without an upper end
            return None
        side = -1 if v[1] ** 2 * m[1] < T[0] else 1 if v[0] ** 2 * m[0] > T[1] and v[0] > 0 else 0
    contacts = [placed.vehicle.pencil.contacts for placed in problem.vehicles]
    if side < 0 and sum(contacts) == 1:
        return SLOWER
    return FASTER if side > 0 and max(contacts) == 1 else None


def _ends(problem: Problem, over: Mapping[str, Interval], path: str) -> tuple[Fraction, Fraction]:
    own = problem.parameters[path]
    return over.get(path, (own, own))
