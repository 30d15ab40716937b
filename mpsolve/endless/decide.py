"""Whether any motion of an endless row grows, at one velocity: a proof, for all Bloch numbers at once."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from flint import arb

from mpsolve.characteristic.origin import waves_meet_at_zero
from mpsolve.characteristic.paths import Paths
from mpsolve.characteristic.start import start
from mpsolve.endless.boxes import Boxes, LatticeArrays, covered
from mpsolve.endless.closing import Closed, close
from mpsolve.endless.row import Row
from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import precision
from mpsolve.proof.effort import Effort
from mpsolve.proof.winding import number_of_zeros
from mpsolve.spectrum.closing import closing_argument
from mpsolve.spectrum.premises import open_at_rest, require_premises
from mpsolve.spectrum.reasons import WavesMeetError
from mpsolve.spectrum.regions import HalfPlane


@dataclass(frozen=True)
class Count:
    """The proved number of growing motions for every real κ alike.

    closed: the rectangle that holds them; None where nothing moves. boxes: how many boxes (q, κ) hold no root on the
    real axis.
    """

    growing: int
    closed: Closed | None
    boxes: int


def count_growing(row: Row, effort: Effort) -> Count:
    """The number of roots with Im q < 0 for each real κ, the same for all of them, counted with multiplicity.

    PrecisionError where that is not so, or not proved: with a root on the real axis for some κ the number changes.
    InputError where a premise fails, as for `certify`.
    """
    reduced = row.reduced
    require_premises(reduced, HalfPlane())
    if waves_meet_at_zero(reduced.guide):
        raise WavesMeetError
    if len(reduced.places) < reduced.contacts:
        raise PrecisionError("two contacts of a vehicle are at one place, which the theorem about rows leaves out")
    at_rest = open_at_rest(reduced, certified=False)
    if at_rest:
        raise PrecisionError(at_rest)
    if not reduced.guide.v:
        return Count(0, None, 0)
    first = start(reduced.guide)
    arrays = LatticeArrays.of(row)
    boxes = Boxes(arrays, first.up)
    closed = close(boxes, row, effort)
    count = covered(boxes.regular(0j, complex(closed.rho)), effort)
    return Count(_in_step(Paths(arrays, first), closed.rho, effort), closed, count)


def _in_step(paths: Paths, rho: float, effort: Effort) -> int:
    """The number for z = 1, where all vehicles move alike: by the turn of Δ̂(1, ·) from 0 to ρ (SPEC, half-plane)."""
    reduced = paths.arrays.reduced
    down = -1j * paths.start.depth * np.array([1, 0.75, 0.5, 0.3, 0.2, 0.1, 0.05, 0.02, 0.0])
    along = np.linspace(0, rho, 25) + 0j
    chain = (paths.plan("link", down, effort), paths.plan("turn", along, effort))
    proved = paths.prove(chain, effort)
    with precision(64):
        turn = sum((arb(value, error) for value, error in proved.turns), arb(0))
        order = reduced.bodies - reduced.contacts - reduced.neutral
        total = (closing_argument(reduced, rho, *proved.corners[1]) + order * arb.pi() / 2 - turn) / arb.pi()
        return number_of_zeros(total, "the characteristic function")
