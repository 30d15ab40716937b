"""What a little damping does to each undamped induced frequency: d Im q/dη_b at η_b = 0, exactly.

Below α_C the undamped roots are real and lie in the gap between the cuts, where Δ is analytic in q and η_b. By
implicit differentiation of Δ(q, η_b) = 0, eq. (26),

    d Im q/dη_b = Im(−Δ_{η_b}/Δ_q).

A root that it moves below the real axis is destabilised: damping, however small, makes the vibration grow.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, overload

import flint

from mpsolve.certificate.sheet import certify_sheet
from mpsolve.errors import InputError, PrecisionError
from mpsolve.fields import ball_arithmetic
from mpsolve.model.branch import ALONG_DAMPING, ALONG_Q, track
from mpsolve.model.characteristic import characteristic_rates
from mpsolve.model.limits import require_cuts_on_line
from mpsolve.model.parameters import Case
from mpsolve.numbers.rootball import RootBall, Symmetry
from mpsolve.outcome import Status
from mpsolve.sheet.enclose import isolate, refine
from mpsolve.stability.masses import below_critical, checked_digits

arb = flint.arb
_EXTRA = (12, 40, 120)  # digits of q beyond those of the rate, tried in turn


@dataclass(frozen=True)
class Sensitivity:
    """The real roots ±`q` (flint.arb ball, q > 0) move by i·`rate`·η_b + O(η_b²), beside what is real.

    `destabilised`: True where rate < 0 is proved (Im q < 0 grows), False where rate > 0 is, None where it is open.
    """

    q: Any
    rate: Any
    destabilised: bool | None


@dataclass(frozen=True)
class DampingSensitivity(Sequence[Sensitivity]):
    """The sensitivities by ascending q; all there are if `proved`, else `reason` says what is open."""

    case: Case
    items: tuple[Sensitivity, ...]
    status: Status
    reason: str
    digits: int

    @property
    def proved(self) -> bool:
        return self.status.holds

    def __len__(self) -> int:
        return len(self.items)

    @overload
    def __getitem__(self, index: int) -> Sensitivity: ...
    @overload
    def __getitem__(self, index: slice) -> tuple[Sensitivity, ...]: ...
    def __getitem__(self, index: int | slice) -> Sensitivity | tuple[Sensitivity, ...]:
        return self.items[index]


def damping_sensitivity(case: Case, digits: int = 30) -> DampingSensitivity:
    """d Im q/dη_b of every induced frequency q > 0 of an undamped case below α_C, as a ball (dimensionless).

    digits: 15 to 10,000 proved digits of q, and of the rate where it is not 0. Raises InputError for a case with
    damping, or with α ≥ α_C, where the roots are not real and in the gap.

    >>> case = Case(alpha="0.5", eta_b=0, eta_m=(40, 40), positions=(0, 1))
    >>> [item.destabilised for item in damping_sensitivity(case)]
    [False, False]
    """
    digits = checked_digits(digits)
    _require_gap(case)
    spectrum = certify_sheet(case, digits)
    items, reason = [], spectrum.reason
    for root in spectrum.roots:
        if root.symmetry is not Symmetry.REAL or root.multiplicity != 1:
            reason = reason or "a multiple root, or one that is not proved to be real: ask for more digits"
        elif root.q.real > 0:
            items.append(_sensitivity(case, root, digits))
    if any(item.destabilised is None for item in items):
        reason = reason or "a rate is 0, or too close to 0 to tell its sign: ask for more digits"
    status = Status.UNDECIDED if reason else Status.UNVERIFIED
    return DampingSensitivity(case, tuple(items), status, reason, digits)


def _require_gap(case: Case) -> None:
    if case.eta_b:
        stated = f"is {case.eta_b.short()}, but the rate is that at no damping"
        raise InputError("eta_b", f"{stated}: give 0")
    require_cuts_on_line(case)
    below = below_critical(case)
    if not below:
        stated = "is not below" if below is False else "cannot be told from"
        raise InputError("alpha", f"{stated} alpha_C = √(1 − N), where the gap between the cuts closes: lower it")


def _sensitivity(case: Case, root: RootBall, digits: int) -> Sensitivity:
    """The rate from ever sharper balls of the root, until it has its digits."""
    rate = arb("nan")
    for extra in _EXTRA:
        try:
            rate = _rate(case, root, digits + extra)
        except PrecisionError:
            continue
        if rate.rad() < abs(rate).lower() * arb(10) ** -digits:
            break
    destabilised = True if rate < 0 else False if rate > 0 else None
    return Sensitivity(root.q.real, rate, destabilised)


def _rate(case: Case, root: RootBall, digits: int) -> Any:
    """Im(−Δ_{η_b}/Δ_q) on a ball of the root that lies within `root.q`."""
    sharp = refine(case, isolate(case, root.q), digits)
    if not (sharp.symmetry is Symmetry.REAL and root.q.contains(sharp.q)):
        raise PrecisionError("the sharpened ball is not within the root's own")
    with ball_arithmetic(math.ceil(digits * math.log2(10)) + 64) as field:
        _, (along_q, along_damping) = characteristic_rates(track(case, field), sharp.q, (ALONG_Q, ALONG_DAMPING))
        return (-along_damping / along_q).imag
