"""All mass levels at which a root crosses the real axis, and the number of unstable roots between them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any, overload

from mpsolve.certificate.crossings import crossings_certificate
from mpsolve.certificate.format import Certificate
from mpsolve.certificate.sheet import MAX_DIGITS, MIN_DIGITS
from mpsolve.errors import InputError, PrecisionError
from mpsolve.fields import ball_arithmetic
from mpsolve.model.limits import critical_velocity_ratio
from mpsolve.numbers.exact import Exact, Number
from mpsolve.outcome import Status
from mpsolve.problem.case import Case
from mpsolve.progress import Progress
from mpsolve.stability.family import Family
from mpsolve.stability.passages import Passages, passing
from mpsolve.stability.search import Strip
from mpsolve.stability.together import Search, alone
from mpsolve.stability.zero import mass_level

_GUARD = 6  # digits of q and u beyond those of η


@dataclass(frozen=True)
class Crossing:
    """At the mass level `eta` the roots ±`q` are real (flint.arb balls).

    direction +1: as the masses grow they become unstable there; −1: stable again.
    """

    eta: Any
    q: Any
    direction: int


@dataclass(frozen=True)
class CrossingMasses(Sequence[Crossing]):
    """The crossings by ascending mass level η, and `counts`: the number of unstable roots below, between, above them.

    Proved complete if `proved`; else `reason` says what is open, `strips` where (in u, with
    u/(1 − u) = 2ηq²/π/(1 + q²)), and counts beyond the first strip are None.
    """

    case: Case
    crossings: tuple[Crossing, ...]
    counts: tuple[int | None, ...]
    status: Status
    reason: str
    digits: int
    strips: tuple[Strip, ...] = ()
    certificate: Certificate | None = field(default=None, repr=False)
    evaluations: int = 0

    @property
    def proved(self) -> bool:
        return self.status.holds

    def __len__(self) -> int:
        return len(self.crossings)

    @overload
    def __getitem__(self, index: int) -> Crossing: ...
    @overload
    def __getitem__(self, index: slice) -> tuple[Crossing, ...]: ...
    def __getitem__(self, index: int | slice) -> Crossing | tuple[Crossing, ...]:
        return self.crossings[index]


def crossing_masses(
    alpha: Number,
    eta_b: Number,
    positions: Number | Iterable[Number],
    proportions: Number | Iterable[Number] | None = None,
    eta_n: Number = 0,
    eta_s: Number = 0,
    digits: int = 30,
    tell: Progress | None = None,
) -> CrossingMasses:
    """Every mass level η in (0, ∞), masses η·proportions, at which a root of Δ, eq. (26), crosses the real axis.

    proportions: one a position; equal masses if left out. digits: 15 to 10,000 proved digits of each η. For
    η → 0 no root is unstable; each crossing changes the number by two (q and −q̄). Without damping and below α_C
    no mass is unstable: in the moving frame the energy is conserved and positive. Raises InputError.

    >>> crossing_masses("0.99", "0.1", (0, "1.1"))[0].eta.str(8, radius=False)
    '21.885373'
    """
    return alone(crossings_search(alpha, eta_b, positions, proportions, eta_n, eta_s, digits, tell))


def crossings_search(
    alpha: Number,
    eta_b: Number,
    positions: Number | Iterable[Number],
    proportions: Number | Iterable[Number] | None = None,
    eta_n: Number = 0,
    eta_s: Number = 0,
    digits: int = 30,
    tell: Progress | None = None,
) -> Search[CrossingMasses]:
    """`crossing_masses` as a search, for together.py."""
    places = list(positions) if isinstance(positions, Iterable) and not isinstance(positions, str) else [positions]
    shares = [1] * len(places) if proportions is None else proportions
    case = Case(alpha=alpha, eta_b=eta_b, eta_m=shares, positions=places, eta_n=eta_n, eta_s=eta_s)
    digits = checked_digits(digits)
    if not case.eta_b:
        return _undamped(case, digits)
    family = Family(case, "level")
    try:
        found = yield from passing(family, Exact.parse(0, "u"), Exact.parse(1, "u"), digits + _GUARD, None, tell)
    except PrecisionError as error:
        return CrossingMasses(case, (), (None,), Status.UNDECIDED, str(error), digits)
    return _result(case, found, digits)


def checked_digits(digits: int) -> int:
    if not (isinstance(digits, int) and MIN_DIGITS <= digits <= MAX_DIGITS):
        raise InputError("digits", f"is {digits!r}: give a whole number from {MIN_DIGITS} to {MAX_DIGITS}")
    return digits


def below_critical(case: Case) -> bool | None:
    """α < α_C by balls; None where they cannot tell."""
    with ball_arithmetic(256) as balls:
        critical = critical_velocity_ratio(case, balls)
        alpha = case.alpha.ball()
        return True if alpha < critical else False if alpha > critical else None


def _undamped(case: Case, digits: int) -> CrossingMasses:
    if below_critical(case):
        return CrossingMasses(case, (), (0,), Status.UNVERIFIED, "", digits)
    reason = (
        "without damping and from alpha_C on, the branch cut covers the real axis, and roots appear on it rather "
        "than cross it: give some damping, or certify single cases"
    )
    return CrossingMasses(case, (), (None,), Status.UNDECIDED, reason, digits)


def _result(case: Case, found: Passages, digits: int) -> CrossingMasses:
    with ball_arithmetic(int(3.33 * (digits + _GUARD)) + 64):
        crossings = [Crossing(mass_level(zero), zero.x, zero.direction) for zero in found.zeros]
    strips, counts = found.strips, found.counts
    order = sorted(range(len(crossings)), key=lambda k: float(crossings[k].eta.mid()))
    crossings = [crossings[k] for k in order]
    if strips:
        return CrossingMasses(
            case, tuple(crossings), (None,) * (len(crossings) + 1), Status.UNDECIDED, strips[0].reason, digits, strips
        )
    if any(not a.eta < b.eta for a, b in pairwise(crossings)):
        reason = "two crossings at one mass level, or nearly so: ask for more digits"
        open_counts = (None,) * (len(crossings) + 1)
        return CrossingMasses(case, tuple(crossings), open_counts, Status.UNDECIDED, reason, digits)
    counts = _running(crossings)
    certificate = crossings_certificate(found)
    return CrossingMasses(
        case, tuple(crossings), counts, Status.UNVERIFIED, "", digits, (), certificate, found.evaluations
    )


def _running(crossings: list[Crossing]) -> tuple[int, ...]:
    counts = [0]
    for crossing in crossings:
        counts.append(counts[-1] + 2 * crossing.direction)
    return tuple(counts)
