"""Without damping, and slower than its waves: nothing grows, whatever passive vehicle runs there (SPEC2, 8.8).

For real p, D σ̄ has the real part Re σ·(EI y² − (N + m v²) y + k + m|σ|²) at y = p². Where this bracket is never
below 0 at σ = 0, the mobility σG is positive real in all of Re σ > 0. No path and no count is needed.
"""

from __future__ import annotations

from mpsolve.characteristic.start import start
from mpsolve.problem.line import Line
from mpsolve.spectrum.count import Count
from mpsolve.spectrum.regions import HalfPlane

PASSIVE = "the undamped beam takes up power at all frequencies, so that a passive vehicle has no root with Im q < 0"


def passive_everywhere(line: Line) -> bool:
    """Whether the bracket is never below 0, decided exactly; such velocities go up to that at which the cuts join."""
    return not line.height and not line.passive_from and not line.upper.neutral


def none_unstable(line: Line) -> Count:
    """The count of the half-plane Im q < 0 where the beam is passive everywhere."""
    return Count(HalfPlane(), 0, start(line.lower.guide), (), None, PASSIVE, 0, "passive")
