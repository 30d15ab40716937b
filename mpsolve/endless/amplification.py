"""The verb: how much stronger the last contact force of a train is than the first, when the first is shaken.

The largest ratio of two contact forces over a band is enclosed by branch and bound in discs.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np

from mpsolve.certificate.certify import certify
from mpsolve.characteristic.bordering import direct_contacts
from mpsolve.characteristic.disc_matrix import Arrays
from mpsolve.characteristic.discs import split
from mpsolve.characteristic.path import discs
from mpsolve.characteristic.residues import waves
from mpsolve.characteristic.start import start
from mpsolve.errors import EffortError, InputError, PrecisionError
from mpsolve.numbers.arrays import Complexes, Reals, Truths
from mpsolve.numbers.jets import UP, Jet, nearest
from mpsolve.numbers.model import checked_range
from mpsolve.numbers.plain import float_beside
from mpsolve.numbers.result import Result
from mpsolve.outcome import Reason, Status
from mpsolve.passivity.far import prove_tail
from mpsolve.problem.case import Case
from mpsolve.problem.cases import Given, as_problem
from mpsolve.problem.problem import Problem
from mpsolve.problem.reduced import Reduced, reduce_problem
from mpsolve.progress import Progress, silent
from mpsolve.proof.effort import Effort, begun
from mpsolve.proof.stopping import stoppable
from mpsolve.proof.turning import solution
from mpsolve.spectrum.premises import require_premises
from mpsolve.spectrum.regions import HalfPlane

_PIECES = 256
_SMALLEST = 2.0**-28
FLOOR = 1e-6
"""Ratios below are not told apart from it: where all are, `high` is at most this, and `low` may be far below."""


@dataclass(frozen=True)
class Largest:
    """low ≤ max ≤ high; the ratio is at least `low` at the frequency q (scaled). reason: why they are not as near to
    each other as was asked, with `high` infinite where nothing is known.
    """

    low: float
    high: float
    q: float
    reason: Reason | None = None


@dataclass(frozen=True)
class Ratio:
    """|λ_target/λ_source| of a problem whose contact `source` is shaken, at real frequencies q̂ (scaled)."""

    arrays: Arrays
    up: int
    source: int
    target: int

    def jets(self, a: Any, b: Any) -> tuple[Jet, Truths]:
        """The ratio as jets over discs that hold the pieces from a to b, and where it is proved."""
        m, r = discs(a, b)
        with np.errstate(all="ignore"):
            _, G, good = self.arrays.evaluate(m, r, self.up)
            y, regular = solution(self.arrays.matrix(G, m), self.arrays.shaken(self.source, m, r))
            force = self.arrays.first_force
            ratio = y[:, force + self.target, 0] * y[:, force + self.source, 0].inverse()
        fine = good & regular & self._on_their_sides(m, r) & np.isfinite(ratio.a) & np.isfinite(ratio.e)
        return ratio, fine

    def _on_their_sides(self, m: Complexes, r: Reals) -> Any:
        """Whether the p-roots of U are proved to decay ahead, and those of L to grow, so that U and L are what they
        are to be: no p-root is real for Re σ ≥ 0 (the premise), and so none has changed sides."""
        _, P, good = waves(self.arrays.N, self.arrays.D, split(self.arrays.D, m, r, self.up))
        with np.errstate(all="ignore"):
            size = np.abs(P.b) * r[:, None] + P.e
            off = P.a.real * np.where(np.arange(P.a.shape[1]) < self.up, -1.0, 1.0)
            return good & (off > size * UP).all(1)

    def largest(self, low: float, high: float, tolerance: float, effort: Effort) -> Largest:
        """The largest |ratio| for low ≤ q ≤ high, enclosed to the relative tolerance, or as far as the effort goes.

        On a real piece |a + b t| is convex, so its largest value is at an end. PrecisionError where the ratio is not
        bounded.
        """
        points = np.linspace(low, high, _PIECES + 1)
        a, b, above = points[:-1], points[1:], np.full(_PIECES, np.inf)
        best, at, ceiling = 0.0, low, 0.0
        while len(a):
            try:
                effort.spend(len(a))
            except EffortError as error:
                return Largest(best, max(ceiling, best, float(above.max())), at, error.reason)
            ratio, fine = self.jets(a + 0j, b + 0j)
            with np.errstate(all="ignore"):
                step = 1j * ratio.b * ratio.r
                upper = (np.maximum(np.abs(ratio.a + step), np.abs(ratio.a - step)) + ratio.e) * UP
                lower = np.where(fine, np.abs(ratio.a) / UP - ratio.e, -np.inf)
            upper = np.where(fine, upper, np.inf)
            k = int(np.argmax(lower))
            if lower[k] > best:
                best, at = float(lower[k]), float((a[k] + b[k]) / 2)
            done = upper <= max(best * (1 + tolerance), FLOOR)
            ceiling = max(ceiling, float(upper[done].max(initial=0.0)))
            a, b, above = a[~done], b[~done], upper[~done]
            if len(a) and (b - a).min() < _SMALLEST * (high - low):
                raise PrecisionError(f"the ratio of forces is not bounded near q = {a[0]:.6g} (scaled)")
            middle = (a + b) / 2
            a, b, above = np.concatenate([a, middle]), np.concatenate([middle, b]), np.tile(above, 2)
        return Largest(best, max(ceiling, best), at)


_EVALUATIONS = 100_000
_LEAST = 3000  # evaluations: for large matrices, each of which is dear
_DIGITS = 15


@dataclass(frozen=True)
class Peak:
    """low ≤ largest ratio ≤ high, proved; the ratio is at least `low` at the frequency `omega`, a float.

    high is infinite where no bound is known within the effort.
    """

    low: float
    high: float
    omega: float


@dataclass(frozen=True)
class Amplification(Result):
    """Ratios of contact forces over the band of real frequencies, in the problem's units.

    ahead: the rearmost contact is shaken, the ratio is that of the foremost force to the rearmost. back: the other
    way round. Where the effort ends early the bounds are those known by then; None where nothing is known, with the
    `reason`. stable: whether the train is proved to be stable; only
    then do the ratios describe vibrations that last.
    """

    problem: Problem
    band: tuple[Fraction, Fraction]
    status: Status
    stable: bool | None
    ahead: Peak | None
    back: Peak | None
    reason: Reason | None = None


@stoppable
def amplification(
    problem: Given,
    *,
    band: tuple[object, object] | None = None,
    tolerance: float = 1e-6,
    effort: Effort | None = None,
    progress: Progress | None = None,
) -> Amplification:
    """The largest ratio of the last contact's force to the first's over a band of frequencies, in both directions.

    The rail under one outer contact is uneven, ε e^{iωt}; λ are the harmonic contact forces that follow. The ratio
    |λ_last/λ_first| does not depend on ε, and is the same if the first vehicle is shaken by any force instead, where
    it has one contact. band: (from, to) in rad/s; left out, from 0 (for wheels that hang on springs from a
    thousandth of the end) to the frequency beyond which the track only takes energy from any contacts at these
    distances. The maximum is enclosed to the relative tolerance, or shown to be below 10⁻⁶.
    Raises InputError for a train of fewer than two contacts, for a band that is none, and as `certify` does.
    """
    train, tell = as_problem(problem), progress or silent
    reduced = reduce_problem(train)
    require_premises(reduced, HalfPlane())
    last = reduced.contacts - 1
    if not last:
        raise InputError("problem", "has one contact: give a train of at least two")
    if isinstance(tolerance, bool) or not 1e-12 <= tolerance <= 1:
        raise InputError("tolerance", f"is {tolerance!r}: give a relative width from 1e-12 to 1")
    ends = _band(reduced, band, None if isinstance(problem, Case) else "rad/s")
    low, high = (float_beside(x / reduced.frequency_unit, up) for x, up in zip(ends, (False, True), strict=True))
    tell("stability", 0.0)
    budget = begun(effort, _evaluations(reduced))
    stable = certify(train, region="unstable", digits=_DIGITS, check=False, effort=effort and budget.left()).stable
    arrays, peaks, reason = Arrays(reduced), [], None
    try:
        up = start(reduced.guide).up
        for k, (source, target) in enumerate(((0, last), (last, 0))):
            tell("ratio", 0.4 + 0.3 * k)
            part = budget.left()
            part.seconds = part.seconds and part.seconds / (2 - k)  # the other direction has the rest
            found = Ratio(arrays, up, source, target).largest(low, high, tolerance, part)
            peaks.append(Peak(found.low, found.high, found.q * float(reduced.frequency_unit)))
            reason = reason or found.reason
    except PrecisionError as error:
        reason = Reason("ratio", str(error), {}, "give a band that keeps away from this frequency")
    if stable is not True:
        word = "unstable" if stable is False else "not proved to be stable"
        reason = Reason("unstable", f"the train is {word}, so its vibrations need not last", {}, "lower the velocity")
    tell("done", 1.0)
    ahead, back = [*peaks, None, None][:2]
    status = Status.UNVERIFIED if reason is None else Status.UNDECIDED
    return Amplification(train, ends, status, stable, ahead, back, reason)


def _evaluations(reduced: Reduced) -> int:
    """About as much work for any size of the matrix."""
    size = reduced.bodies + reduced.contacts
    return max(_LEAST, min(_EVALUATIONS, _EVALUATIONS * 1024 // size**2))


def _band(reduced: Reduced, band: object, unit: str | None) -> tuple[Fraction, Fraction]:
    if band is None:
        tail = prove_tail(reduced.guide, reduced.smallest_gap) if reduced.guide.v else None
        top = Fraction(4.0 if tail is None else tail.X) * reduced.frequency_unit
        return (Fraction(0) if _at_zero(reduced) else top / 1000), top
    low, high = checked_range(band, "band", unit, 0)
    for x in (low, high):
        nearest(x)
    return low, high


def _at_zero(reduced: Reduced) -> bool:
    """Whether the ratio has a plain meaning at frequency 0: the outer wheels are masses of their own."""
    direct = {d.contact: d.body for d in direct_contacts(reduced)}
    bodies = [direct.get(0), direct.get(reduced.contacts - 1)]
    return all(
        body is not None and not any(rows[i][body] for rows in reduced.S for i in range(reduced.bodies) if i != body)
        for body in bodies
    )
