"""Which entries have no count, or an evident one: decided exactly, once for each different track.

As spectrum/premises.py, for the whole half-plane: a track that buckles or has no damping is refused; at rest a
passive track has no growing root; beyond the speed of its short waves there is no corner to count to.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache

import numpy as np

from mpsolve.batch.entries import Entries, different
from mpsolve.errors import InputError
from mpsolve.numbers.arrays import Integers
from mpsolve.passivity.decay import slowest_short_wave, vanishes
from mpsolve.problem.reduced import Guide, track_guide
from mpsolve.tracks.at_rest import Status, at_rest
from mpsolve.tracks.passive import passivity
from mpsolve.tracks.waveguide import Track, Waveguide

OVERTAKES = "the contacts run faster than short waves of the track: roots may be without number"
_MOVES = Fraction(1, 1000)  # of a scaled velocity: slow beside every wave of the track


@dataclass(frozen=True)
class Premise:
    """What is known of one track.

    refused: why it cannot be used, or "". passive: at rest. vanishes: its
    receptance does so at infinity. speed: of its slowest short waves, in its own units.
    """

    track: Track | Waveguide
    refused: str
    passive: bool
    vanishes: bool
    speed: float


@lru_cache(maxsize=4096)
def premise(track: Track | Waveguide) -> Premise:
    """The exact decisions about one track."""
    try:
        rest = at_rest(track)
    except InputError as error:
        return Premise(track, str(error), False, False, np.nan)
    if rest.status is Status.UNSTABLE:
        return Premise(track, rest.sentence, False, False, np.nan)
    if rest.status is Status.UNDAMPED:
        return Premise(track, "the track has vibrations without damping", False, False, np.nan)
    try:
        guide = track_guide(track, Fraction(0))
    except InputError as error:
        return Premise(track, str(error), False, False, np.nan)
    falls = max(j for _, j in guide.N_rest) < max(j for _, j in guide.D_rest)
    passive = bool(passivity(track).passive) and falls
    slow = _slow(track, guide)
    speed = slowest_short_wave(guide) * 2.0 ** (guide.length - guide.time)
    return Premise(track, "", passive, slow is not None and vanishes(slow.D, slow.N, slow.v), speed)


def _slow(track: Track | Waveguide, guide: Guide) -> Guide | None:
    """The track at a velocity that stands for all that are no wave speeds."""
    try:
        return track_guide(track, _MOVES * Fraction(2) ** (guide.length - guide.time))
    except InputError:
        return None


def premises(entries: Entries) -> tuple[tuple[Premise, ...], Integers]:
    """The premises of the different tracks, and which of them each entry has."""
    paths = [path for path in entries.over if path.startswith("track.")]
    each, which = different(entries.problem, entries.over, paths, len(entries))
    return tuple(premise(track) for track, _ in each), which
