"""Along the real axis of q: where motions change most from one vehicle to the next, in float64.

Of the roots z of a row n₊ belong to motions that a shaken vehicle sends ahead, the others to those that it sends
back. While none has crossed the other, these are the n₊ smallest and the others by modulus. |z_{n₊}| is what a motion
gains from a vehicle to the next one ahead, 1/|z_{n₊+1}| what it gains to the next one behind.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.endless.bloch import Bloch
from mpsolve.numbers.arrays import Complexes, Reals
from mpsolve.numbers.float64 import lowest

_POINTS = 1200
_ZOOMS, _ZOOM = 6, 41
_SHORT = 1e-4


@dataclass(frozen=True)
class Gain:
    """The largest factor per vehicle in one direction, at the real frequency q (scaled), and its root z."""

    factor: float
    q: float
    z: complex


def gains(bloch: Bloch, most: float) -> tuple[Gain, Gain]:
    """(ahead, back): the largest factors for 0 < q ≤ most. A factor above 1 in either direction is growth."""
    return _largest(bloch, most, 0), _largest(bloch, most, 1)


def _factors(bloch: Bloch, q: Any, back: int) -> tuple[Reals, Complexes]:
    z = bloch.middle(1j * np.asarray(q))[back]
    return (1 / np.abs(z) if back else np.abs(z)), z


def _largest(bloch: Bloch, most: float, back: int) -> Gain:
    q, _ = _least(lambda q: -_factors(bloch, q, back)[0], most)
    factor, z = _factors(bloch, [q], back)
    return Gain(float(factor[0]), q, complex(z[0]))


def closest(bloch: Bloch, most: float) -> tuple[float, float]:
    """(ratio, q): the least |z_{n₊+1}/z_{n₊}| for 0 < q ≤ most; 1 where the two kinds of motion meet in modulus."""

    def ratio(q: Any) -> Reals:
        ahead, back = bloch.middle(1j * q)
        return np.abs(back / ahead)

    q, least = _least(ratio, most)
    return least, q


def _least(f: Callable[[Any], Any], most: float) -> tuple[float, float]:
    """(q, f) where f is least for 0 < q ≤ most."""
    return lowest(f, np.linspace(most * _SHORT, most, _POINTS), _ZOOM, _ZOOMS)
