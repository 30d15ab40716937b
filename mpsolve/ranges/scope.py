"""What a question about ranges is asked of: checked ranges, the family, and the frequency that bounds its roots."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import product
from typing import Any

import numpy as np

from mpsolve.characteristic.free_matrix import FreeMatrix
from mpsolve.characteristic.free_proved import FreeProved
from mpsolve.errors import InputError, PrecisionError
from mpsolve.numbers.arrays import Reals
from mpsolve.numbers.model import shown
from mpsolve.numbers.plain import float_beside
from mpsolve.numbers.spoken import beside
from mpsolve.outcome import Reason
from mpsolve.passivity.box import passive_beyond
from mpsolve.passivity.decay import overtakes
from mpsolve.passivity.envelope import Envelope
from mpsolve.passivity.far import far, forget_tail
from mpsolve.passivity.subject import Subject
from mpsolve.problem.cases import Given, as_problem, value_at
from mpsolve.problem.family import Family, Interval, family_of, require_ends
from mpsolve.problem.problem import Problem
from mpsolve.problem.reduced import Guide
from mpsolve.ranges.judge import Judge
from mpsolve.ranges.on_string import passive_beyond as passive_beyond_on_string
from mpsolve.ranges.premises import require_no_wave_speed, require_stable_track
from mpsolve.spectrum.premises import require_premises
from mpsolve.spectrum.regions import HalfPlane

_GIVE = "give an upper end"
_NO_END: dict[bool, tuple[str, dict[str, str], str]] = {
    True: (
        "the contacts run faster than short waves of the track, so that roots may cross at any frequency",
        {},
        "give a range below that speed, or certify single velocities, where roots are counted within a radius",
    ),
    False: (
        "no frequency is found beyond which the contacts are passive for all these parameters",
        {},
        "give slower velocities or narrower ranges",
    ),
}
"""Why the frequencies of roots have no bound, by whether some short wave is slower than the contacts."""
_LONG = (
    "the longest waves run at v = {} and meet at q = 0, some ahead of the contacts and some behind: at slower "
    "velocities no box of frequencies from 0 on is decided"
)
_FASTER = "begin the range above that speed, or certify single velocities"
LEAST = Fraction(1, 1024)  # of a range of velocities: where it begins if v = 0 cannot be its start


_MOST = 256
_KNOWN: dict[Any, float | None] = {}
"""X̂ of tracks, velocities and places that were asked before."""


def forget() -> None:
    """What was found for earlier questions, so that times of questions can be compared."""
    _KNOWN.clear()
    forget_tail()


class OpenError(PrecisionError):
    """The question cannot be decided on these ranges, for a `Reason`."""


@dataclass(frozen=True)
class Scope:
    """A family with all that is proved of it as a whole. All is scaled.

    reach: a frequency up to which alone is asked, where passivity says nothing.
    """

    family: Family
    reach: float | None = None

    @cached_property
    def matrix(self) -> FreeMatrix:
        return FreeMatrix(self.family)

    @cached_property
    def proved(self) -> FreeProved:
        return FreeProved(self.family, self.matrix.receptance.track.up)

    @cached_property
    def low(self) -> Reals:
        """The corner of the box of x̂, rounded down."""
        return np.array([float_beside(a, False) for a, _ in self.family.box])

    @cached_property
    def high(self) -> Reals:
        return np.array([float_beside(b, True) for _, b in self.family.box])

    @cached_property
    def envelope(self) -> Envelope:
        """Over the box, which is thin along parameters of the vehicles: the track's receptance knows none of them."""
        family = self.family
        low = np.where(family.felt, self.low, self.high)
        return Envelope(Subject.of_family(family), tuple(low.tolist()), tuple(self.high.tolist()))

    @cached_property
    def X(self) -> float:
        """From this frequency on the contacts are passive for all parameters; `OpenError` where none is found.

        Or the reach.
        """
        if self.reach is not None:
            return self.reach
        long_waves = max((_speed_of_long_waves(self.family.guide(x)) for x in product(*self.family.box)), default=0.0)
        if long_waves:
            guide = self.family.base.guide
            speed = math.ldexp(long_waves, guide.length - guide.time)
            told = {"speed": f"{speed:.6g}"}
            raise OpenError(Reason("long-waves", _LONG.format(beside(speed, "m/s")), told, _FASTER))
        key = self._told_by
        if key not in _KNOWN:
            if len(_KNOWN) >= _MOST:
                _KNOWN.clear()
            _KNOWN[key] = self._found()
        found = _KNOWN[key]
        if found is None:
            fast = overtakes(self.family.base.guide, self.envelope.fastest)
            raise OpenError(Reason("passivity", *_NO_END[fast]))
        return found

    @property
    def _told_by(self) -> Any:
        """All that the frequency depends on: exact, and none of it of the vehicles but where they touch the track."""
        subject, felt = self.envelope.subject, self.family.felt
        terms = (subject.power.w, subject.power.real, subject.power.imaginary, subject.D, subject.v, *subject.places)
        ends = tuple(zip(self.envelope.low, self.envelope.high, strict=True))
        told = tuple(both if known else None for both, known in zip(ends, felt, strict=True))
        return (*(frozenset(one.items()) for one in terms), told)

    def _found(self) -> float | None:
        # for one parameter and one contact boxes are few, and the least frequency would cost more than they do
        one = len(self.family.paths) == len(self.family.places) == 1
        on_string = passive_beyond_on_string(self.family)
        if on_string is not None:
            return on_string
        # cells of frequencies are not halved: boxes do it where it is needed, and a checker has less to follow
        if one:
            return far(self.envelope)
        return passive_beyond(self.envelope, halvings=0)

    def judge(self, kind: type[Judge] = Judge, **more: Any) -> Judge:
        """A judge of boxes in (q̂, x̂) over the whole; more: of its kind."""
        width = np.concatenate([[self.X], self.high - self.low]) / 2
        return kind(self.matrix, self.envelope if self.reach is None else None, width, **more)

    @property
    def corners(self) -> tuple[Reals, Reals]:
        """Of the box in (q̂, x̂) that is to be covered."""
        return np.concatenate([[0.0], self.low]), np.concatenate([[self.X], self.high])


def _speed_of_long_waves(guide: Guide) -> float:
    """Where the track's velocity is below the speed of two waves that come to P = 0 at q = 0: that speed, else 0.

    The moving D begins with aP² + bPσ + cσ², so that P = ζσ; the ζ lie on both sides of 0 where ac < 0 (SPEC2, 4.8).
    """
    if min(i + j for i, j in guide.D) != 2:
        return 0.0
    a, c = (Fraction(guide.D.get(key, 0)) for key in ((2, 0), (0, 2)))
    return math.sqrt(guide.v**2 - a / c) if a * c < 0 else 0.0


def scope_of(problem: Problem, over: Mapping[str, Interval]) -> Scope:
    """The scope of checked ranges; InputError where a premise fails somewhere in them."""
    family = family_of(problem, over)
    require_premises(family.base, HalfPlane())
    require_stable_track(family)
    require_no_wave_speed(family)
    return Scope(family)


def from_above_rest(problem: Problem, over: Mapping[str, Interval]) -> dict[str, Interval]:
    """The ranges from a small velocity on where a range begins at v = 0 and the equations lose p-roots there.

    Nothing is claimed of slower velocities.
    """
    out = dict(over)
    low, high = out.get("v", (Fraction(1), Fraction(1)))
    if low:
        return out
    D = problem.track.waveguide.dispersion
    if max(i for i, _ in D) < max(i + j for i, j in D):
        out["v"] = (high * LEAST, high)
    return out


def checked_over(given: Given, over: object, endless: bool = False) -> dict[str, Interval]:
    """{path: (low, high)} with exact ends in order, which may be texts with units; InputError names the path.

    endless: whether `high` may be None, for a range without an upper end.
    """
    if not isinstance(over, Mapping) or not over:
        raise InputError("over", 'is empty: give ranges by their paths, such as {"v": (0, 100)}')
    problem = as_problem(given)
    known = problem.parameters
    out: dict[str, Interval] = {}
    for path, ends in over.items():
        if path not in known:
            problem.changed(str(path), 1)  # says which paths there are
        try:
            first, last = ends
        except (TypeError, ValueError):
            raise InputError(str(path), f"is {ends!r}: give a range (low, high)") from None
        if first is None:
            raise InputError(path, "has no lower end: give one, such as 0")
        if last is None and not endless:
            raise InputError(path, f"has no upper end, which only crossings and onsets may have: {_GIVE}")
        low = value_at(given, path, first)
        high: Any = None if last is None else value_at(given, path, last)
        if high is None and low < 0:
            raise InputError(path, f"begins at {shown(low, first)}: without an upper end it must begin at 0 or above")
        if high is not None and not low < high:
            raise InputError(
                path, f"ends at {shown(high, last)}, not above its start {shown(low, first)}: give the ends in order"
            )
        out[path] = (low, high)
    require_ends(problem, out)  # theorems that need no family rest on it, too
    return out


def one_path(over: Mapping[str, Interval]) -> str:
    """The only path; InputError where there are several."""
    if len(over) != 1:
        raise InputError("over", f"names {len(over)} parameters, but this question is about one: give one path")
    return next(iter(over))
