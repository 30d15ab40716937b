"""Where all waves stay behind the one place that is touched: nothing grows there (SPEC2, 5).

Without roots Re P < 0 G(0) = 0: the vehicle does not feel what it does to the track. The determinant is then that of
the vehicle on a rail that does not move, which has no root with Im q < 0.
"""

from __future__ import annotations

from flint import fmpq_mat

from mpsolve.characteristic.start import Start
from mpsolve.numbers.realroots import as_fmpq
from mpsolve.problem.reduced import Reduced

BEHIND = "all waves stay behind the contact, so that the vehicle does not feel what it does to the track"


def all_behind(reduced: Reduced, first: Start) -> bool:
    """Whether no wave runs ahead, one place is touched, and a rail at rest would tell all contact forces."""
    if first.up or len(reduced.places) > 1:
        return False
    soft = [[h * (i == j) for j in range(reduced.contacts)] for i, h in enumerate(reduced.h)]
    forces = fmpq_mat([[as_fmpq(x) for x in row] for row in (*reduced.B, *soft)])
    return bool(forces.rank() == reduced.contacts)
