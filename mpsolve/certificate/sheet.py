"""Every induced frequency of one case in a region: found, enclosed, counted, and the two held against each other."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import dataclass, field

from mpsolve.certificate.format import Certificate
from mpsolve.errors import InputError, PrecisionError
from mpsolve.numbers.rootball import RootBall, Symmetry
from mpsolve.outcome import Reason, Status
from mpsolve.problem.case import Case
from mpsolve.problem.physical import PhysicalCase
from mpsolve.progress import Progress, silent
from mpsolve.sheet import reasons
from mpsolve.sheet.collect import collect
from mpsolve.sheet.count import Count, count_roots
from mpsolve.sheet.region import Region, checked_region
from mpsolve.spectrum.regions import Rectangle

MAX_DIGITS = 10_000
MIN_DIGITS = 15
_MORE_DIGITS = (2, 4, 8)  # times what was asked for, where a sign of Im q is open
_MOST_ROOTS = 100_000
_ROUNDS = 4  # of looking for roots that the count has and the enclosures lack


@dataclass(frozen=True)
class SheetSpectrum:
    """The induced frequencies of a case in a region; `proved` only if count and enclosures are both proved.

    roots: disjoint balls `root.q` (flint.acb), each with exactly `root.multiplicity` roots, relative radius
    below 10^−digits, sorted by (Re q, Im q). count: number of roots in the region with multiplicity.
    unstable: how many of them have Im q < 0. status: `UNVERIFIED`, as no certificate is made.
    When undecided, `reason` says why and what helps, and
    `why` has the same in parts; `count` is then the proved number if there is one, and None otherwise.
    """

    case: Case
    region: Region
    digits: int
    status: Status
    reason: str
    count: int | None
    unstable: int | None
    roots: tuple[RootBall, ...]
    radius: float | None = None
    certificate: Certificate | None = field(default=None, repr=False)
    evaluations: int = 0
    why: Reason | None = field(default=None, repr=False)
    verified: str = ""

    @property
    def proved(self) -> bool:
        """Whether every root of the region is counted and enclosed."""
        return self.status.holds

    @property
    def stable(self) -> bool | None:
        """True if proved that no root has Im q < 0, False if proved that one has, None when undecided."""
        if not self.proved or isinstance(self.region, Rectangle):
            return None
        return self.unstable == 0


def certify_sheet(
    case: Case | PhysicalCase,
    digits: int = 30,
    region: Region = "sheet",
    max_pieces: int = 100_000,
    progress: Progress | None = None,
) -> SheetSpectrum:
    """Every root of Δ, eq. (26), in the region: a proof, or `Status.UNDECIDED` with reason and remedy.

    digits: certified digits of each root relative to |q|, 15 to 10,000. region: "sheet" (the whole physical
    sheet), "unstable" (Im q < 0) or a `Rectangle`. max_pieces bounds the effort of the count, by default to about
    a minute. progress is called with a stage and a fraction from 0 to 1.
    Raises InputError for a region that has no meaning.

    >>> from mpsolve import Case, certify
    >>> certify(Case(alpha="0.67", eta_b="0.05", eta_m=("70", "70"), positions=("0", "1.5"))).unstable
    2
    """
    if isinstance(case, PhysicalCase):
        case = case.dimensionless
    if not (isinstance(digits, int) and MIN_DIGITS <= digits <= MAX_DIGITS):
        raise InputError("digits", f"is {digits!r}: give a whole number from {MIN_DIGITS} to {MAX_DIGITS}")
    region = checked_region(case, region)
    tell = progress or silent
    return _found(case, region, digits, max_pieces, tell)


def _found(case: Case, region: Region, digits: int, max_pieces: int, tell: Progress) -> SheetSpectrum:
    """What is proved before the verifier is asked of the whole."""
    try:
        count = count_roots(case, region, max_pieces, tell)
    except PrecisionError as error:
        return _undecided(case, region, digits, error.reason)
    found = _explain(case, region, digits, count, tell)
    if region == "unstable" and not found.proved and count.contour == "edge" and case.eta_b > 0:
        with suppress(PrecisionError):  # roots elsewhere do not matter: those with Im q < 0 are counted by themselves
            line = count_roots(case, region, max_pieces, tell, line=True)
            found = _explain(case, region, digits, line, tell)
    return found


def _undecided(case: Case, region: Region, digits: int, why: Reason, count: int | None = None) -> SheetSpectrum:
    return SheetSpectrum(case, region, digits, Status.UNDECIDED, str(why), count, None, (), why=why)


def _explain(case: Case, region: Region, digits: int, count: Count, tell: Progress) -> SheetSpectrum:
    """Looks for the counted roots, with more effort each round, and encloses them."""
    if count.total > _MOST_ROOTS:
        why = reasons.too_many(case, region, count.total, _MOST_ROOTS)
        total = count.total if _counts_region(region, count) else None
        return _undecided(case, region, digits, why, total)
    roots: tuple[RootBall, ...] = ()
    reason: Reason | None = None
    for effort in range(1, _ROUNDS + 1):
        try:
            roots = collect(case, count, digits, 2 ** (effort - 1), tell)
            reason = None
        except PrecisionError as error:
            reason = error.reason
        if sum(root.multiplicity for root in roots) == count.total:
            return _verdict(case, region, digits, count, _signed(case, count, roots, digits, 2 ** (effort - 1)))
    found = sum(root.multiplicity for root in roots)
    why = reason or Reason(
        "roots-missing",
        f"{count.total} roots were counted, but {found} could be enclosed",
        {"counted": str(count.total), "enclosed": str(found)},
        reasons.missing_helps(case, region),
    )
    total = count.total if _counts_region(region, count) else None
    rest = total, None, roots, count.radius
    return SheetSpectrum(case, region, digits, Status.UNDECIDED, str(why), *rest, why=why)


def _signed(case: Case, count: Count, roots: tuple[RootBall, ...], digits: int, effort: int) -> tuple[RootBall, ...]:
    """The roots with as many more digits as the signs of Im q take, within reason."""
    for more in _MORE_DIGITS:
        if all(_below(root) is not None for root in roots):
            break
        with suppress(PrecisionError):
            sharper = collect(case, count, min(more * digits, MAX_DIGITS), effort, lambda _stage, _fraction: None)
            if sum(root.multiplicity for root in sharper) == count.total:
                roots = sharper
    return roots


def _counts_region(region: Region, count: Count) -> bool:
    """Whether the count is that of the region itself, not of the sheet around it."""
    return region != "unstable" or count.contour == "line"


def _verdict(case: Case, region: Region, digits: int, count: Count, roots: tuple[RootBall, ...]) -> SheetSpectrum:
    signs = [_below(root) for root in roots]
    if any(sign is None for sign in signs):
        why = Reason(
            "sign-open",
            "a root's ball meets the real axis, so that the sign of Im q is open",
            {"digits": str(digits)},
            "ask for more digits",
        )
        total = count.total if _counts_region(region, count) else None
        rest = total, None, roots, count.radius
        return SheetSpectrum(case, region, digits, Status.UNDECIDED, str(why), *rest, why=why)
    unstable = tuple(root for root, sign in zip(roots, signs, strict=True) if sign)
    number = sum(root.multiplicity for root in unstable)
    if region == "unstable":
        roots = unstable
    return SheetSpectrum(
        case,
        region,
        digits,
        Status.UNVERIFIED,
        "",
        sum(root.multiplicity for root in roots),
        number,
        roots,
        count.radius,
        evaluations=count.evaluations,
    )


def _below(root: RootBall) -> bool | None:
    """True if Im q < 0, False if Im q ≥ 0 (real by symmetry included), None if the ball does not tell."""
    if root.symmetry is Symmetry.REAL or root.q.imag >= 0:
        return False
    return True if root.q.imag < 0 else None
