"""What every answer about ranges is made of: status, reason, what it rests on, and how it is handed on."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, fields, replace
from fractions import Fraction
from time import process_time
from typing import TYPE_CHECKING, Any, ClassVar

from mpsolve.numbers.balls import precision, rational_ball
from mpsolve.numbers.model import shown
from mpsolve.numbers.packed import Portable
from mpsolve.numbers.plain import outward
from mpsolve.numbers.result import Result
from mpsolve.outcome import Reason, Status
from mpsolve.problem.cases import Given
from mpsolve.proof.subdivide import Covered

if TYPE_CHECKING:
    from mpsolve.spectrum.spectrum import Spectrum

Interval = tuple[Fraction, Fraction]


@dataclass(frozen=True)
class Spent:
    """What an answer took: processor seconds of the proof and of checks, boxes that were judged."""

    seconds: float
    verification: float = 0.0
    boxes: int = 0

    @classmethod
    def since(cls, started: float, *bases: Spectrum | None, boxes: int = 0) -> Spent:
        """From this processor time on, where the verifier passed these spectra."""
        checked = sum(base.cost.verification for base in bases if base is not None)
        return cls(process_time() - started - checked, checked, boxes)

    def with_check(self, seconds: float) -> Spent:
        """With what a further check took."""
        return replace(self, verification=self.verification + seconds)


def joined_cost(one: Spent, other: Spent) -> Spent:
    """Of both."""
    names = [field.name for field in fields(Spent)]
    return Spent(*(getattr(one, name) + getattr(other, name) for name in names))


@dataclass(frozen=True)
class Proof(Portable):
    """What an answer rests on: a tree of boxes in (q̂, x̂), the frequency X̂ from which on the contacts are passive for
    all parameters, and the certified spectrum at one point, from which roots are counted.
    """

    over: Mapping[str, Interval]
    units: tuple[Fraction, ...]
    frequency_unit: Fraction
    X: float
    cover: Covered
    known: tuple[Any, ...] = ()
    base: Spectrum | None = None


@dataclass(frozen=True)
class Answer(Result):
    """Base of the answers. over: the ranges of which the answer speaks, in the problem's units. A range that is asked
    from v = 0 begins a little above it where the equations lose waves at rest (layers, Kelvin–Voigt damping).

    When undecided, `reason` says why and what helps, and `known` what is proved all the same. A proved answer is
    `Status.PROVED` where it has a `certificate` that passed the standalone verifier; else `Status.UNVERIFIED`, which
    says: proved, without certificate, and `note` tells why.
    """

    a_list: ClassVar[bool] = False
    """Whether an answer without rows says that there is none."""
    problem: Given
    over: Mapping[str, Interval]
    status: Status
    reason: Reason | None = None
    known: Mapping[str, Any] = field(default_factory=dict)
    proofs: tuple[Proof, ...] = field(default=(), repr=False)
    cost: Spent = field(default_factory=lambda: Spent(0.0))
    certificate: Any = field(default=None, repr=False)
    note: str = ""

    def rows(self) -> Iterable[Mapping[str, Any]]:
        """The answer as a table, numbers as floats: one mapping for each row."""
        return ()

    def records(self) -> Iterable[Mapping[str, Any]]:
        """`rows`."""
        return self.rows()

    def _headline(self) -> str:
        ends = ((path, shown(a), f"to {shown(b)}" if b is not None else "on") for path, (a, b) in self.over.items())
        over = ", ".join(f"{path} from {a} {b}" for path, a, b in ends)
        none = "none, " if self.a_list and self.proved and not self.rows() else ""
        return f"{type(self).__name__}{over and f' over {over}'}: {none}{self.trust}"


class AtValue:
    """What stands at a ball `value`: floats that hold it between them."""

    value: Any

    @property
    def lower(self) -> float:
        """A float at or below `value`."""
        return outward(self.value, up=False)

    @property
    def upper(self) -> float:
        """A float at or above `value`."""
        return outward(self.value, up=True)


class Valued:
    """The same of what may have none: None."""

    value: Any

    @property
    def lower(self) -> float | None:
        """A float at or below `value`."""
        return None if self.value is None else outward(self.value, up=False)

    @property
    def upper(self) -> float | None:
        """A float at or above `value`."""
        return None if self.value is None else outward(self.value, up=True)


def within(ball: Any, interval: Interval) -> bool | None:
    """Whether a ball lies in a closed interval; None where it cannot be told."""
    with precision(max(int(ball.mid().bits()), 53) + 64):
        low, high = map(rational_ball, interval)
        if ball >= low and ball <= high:
            return True
        return False if ball < low or ball > high else None
