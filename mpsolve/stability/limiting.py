"""The limiting mass: the smallest equal masses (or multiples of given proportions) that make a case unstable."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from mpsolve.errors import InputError, PrecisionError
from mpsolve.model.parameters import Case
from mpsolve.numbers.exact import Number
from mpsolve.numbers.ranges import checked_range
from mpsolve.outcome import Status
from mpsolve.stability.masses import CrossingMasses, below_critical, checked_digits, crossing_masses
from mpsolve.stability.together import alone


@dataclass(frozen=True)
class LimitingMass:
    """Below the mass level eta (a ball) the case is proved stable; q is the frequency at which it becomes unstable.

    eta and q are None if no mass is unstable (`proved`), or if it is open (`reason`). For a range of distances, d is
    the worst of them, a ball: for no mass below eta and no distance of the range is the case unstable.
    """

    eta: Any | None
    q: Any | None
    status: Status
    reason: str
    crossings: CrossingMasses | None = None
    d: Any | None = None

    @property
    def proved(self) -> bool:
        return self.status.holds


def limiting_mass(
    alpha: Number,
    eta_b: Number,
    positions: Number | Iterable[Number] | None = None,
    proportions: Number | Iterable[Number] | None = None,
    eta_n: Number = 0,
    eta_s: Number = 0,
    digits: int = 30,
    d: tuple[Number, Number] | None = None,
) -> LimitingMass:
    """The smallest mass level η, masses η·proportions, at which a root crosses into Im q < 0.

    At given positions, or at the worst distance d in [lo, hi] of masses at 0, d, 2d, … (two equal ones if no
    proportions are given). digits: 15 to 10,000 proved digits. Every lighter case is proved stable, at positions
    given because it is the first of `crossing_masses`. Raises InputError.

    >>> limiting_mass("0.99", "0.1", (0, "1.1")).eta.str(8, radius=False)
    '21.885373'
    """
    if d is not None:
        if positions is not None:
            raise InputError("positions", "are given, and a range of distances d too: keep only one of the two")
        return _at_worst(alpha, eta_b, proportions, eta_n, eta_s, digits, d)
    if positions is None:
        raise InputError("positions", "are missing: give them, or a range d = (lo, hi) of distances")
    found = crossing_masses(alpha, eta_b, positions, proportions, eta_n, eta_s, digits)
    if not found.proved:
        return LimitingMass(None, None, found.status, found.reason, found)
    if not found:
        return LimitingMass(None, None, Status.UNVERIFIED, "", found)
    return LimitingMass(found[0].eta, found[0].q, Status.UNVERIFIED, "", found)


def _at_worst(
    alpha: Number, eta_b: Number, proportions: Any, eta_n: Number, eta_s: Number, digits: int, d: Any
) -> LimitingMass:
    from mpsolve.stability.worst import worst_search

    digits = checked_digits(digits)
    low, high = checked_range(d, "d")
    if not low > 0:
        raise InputError("d", f"starts at {low.short()}: give a distance above 0")
    shares = (1, 1) if proportions is None else proportions
    places = [low * k for k in range(len(tuple(shares)) if isinstance(shares, Iterable) else 1)]
    case = Case(alpha=alpha, eta_b=eta_b, eta_m=shares, positions=places, eta_n=eta_n, eta_s=eta_s)
    if case.count < 2:
        raise InputError("proportions", "are those of one mass: a distance needs two or more")
    if not case.eta_b:
        if below_critical(case):
            return LimitingMass(None, None, Status.UNVERIFIED, "")
        reason = "without damping and from alpha_C on, the branch cut covers the real axis: give some damping"
        return LimitingMass(None, None, Status.UNDECIDED, reason)
    try:
        worst = alone(worst_search(case, low, high, digits))
    except PrecisionError as error:
        return LimitingMass(None, None, Status.UNDECIDED, str(error))
    return LimitingMass(worst.eta, worst.q, Status.UNVERIFIED, "", None, worst.d)
