"""Whether short, slow waves follow a constant force at every velocity, on a track without its damping."""

from __future__ import annotations

from mpsolve.errors import InputError
from mpsolve.tracks.undamped import undamped
from mpsolve.tracks.waveguide import Track, Waveguide

SLOW_WAVES = "Besides, shorter and slower waves of this track follow a constant force at any velocity."


def slow_waves(track: Track | Waveguide) -> bool:
    """Whether a branch of the dispersion curves has every phase velocity above 0.

    It starts at a frequency above 0 for long waves, as D(0, 0) ≠ 0 on a stable track, and its frequency stays bounded
    for short ones, as the highest power of P in the undamped D has a coefficient that depends on s: sleepers under a
    rail that bends no more. False where this is not known.
    """
    try:
        D = undamped(track).dispersion
    except InputError:
        return False
    highest = max((i for (i, _), c in D.items() if c), default=0)
    return bool(D.get((0, 0))) and any(i == highest and j and c for (i, j), c in D.items())
