"""The limiting mass: the smallest equal masses (or multiples of given proportions) that make a case unstable."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from mpsolve.errors import InputError
from mpsolve.model.exact import Number
from mpsolve.spectrum.certify import Status
from mpsolve.stability.masses import CrossingMasses, crossing_masses


@dataclass(frozen=True)
class LimitingMass:
    """Below the mass level eta (a ball) the case is proved stable; q is the frequency at which it becomes unstable.

    eta and q are None if no mass is unstable (`proved`), or if it is open (`reason`).
    """

    eta: Any | None
    q: Any | None
    status: Status
    reason: str
    crossings: CrossingMasses

    @property
    def proved(self) -> bool:
        return self.status is Status.PROVED


def limiting_mass(
    alpha: Number,
    eta_b: Number,
    positions: Number | Iterable[Number],
    proportions: Number | Iterable[Number] | None = None,
    eta_n: Number = 0,
    eta_s: Number = 0,
    digits: int = 30,
) -> LimitingMass:
    """The smallest mass level η, masses η·proportions, at which a root crosses into Im q < 0, at given positions.

    digits: 15 to 10,000 proved digits. It is the first of `crossing_masses`, and every lighter case is proved
    stable. Raises InputError.

    >>> limiting_mass("0.99", "0.1", (0, "1.1")).eta.str(8, radius=False)
    '21.885373'
    """
    found = crossing_masses(alpha, eta_b, positions, proportions, eta_n, eta_s, digits)
    if not found.proved:
        return LimitingMass(None, None, found.status, found.reason, found)
    if not found:
        return LimitingMass(None, None, Status.PROVED, "", found)
    if found.counts[0] != 0:
        raise InputError("alpha", "is unstable for any mass, however small: there is no limiting mass")
    return LimitingMass(found[0].eta, found[0].q, Status.PROVED, "", found)
