"""What every answer about ranges is made of: status, reason, what it rests on, and how it is handed on."""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, fields
from enum import Enum
from fractions import Fraction
from html import escape
from typing import Any, ClassVar

import numpy as np
from flint import acb, arb

from mpsolve.errors import InputError
from mpsolve.numbers.balls import precision, rational_ball
from mpsolve.numbers.packed import Portable, pack
from mpsolve.numbers.result import Result
from mpsolve.outcome import Reason, Status
from mpsolve.problem.cases import Given
from mpsolve.proof.subdivide import Covered

Interval = tuple[Fraction, Fraction]


@dataclass(frozen=True)
class Spent:
    """What an answer took: processor seconds of the proof and of checks, boxes that were judged."""

    seconds: float
    verification: float = 0.0
    boxes: int = 0


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
    base: Any = None


_SHOWN = 100  # rows in a notebook


class Tabled(Result):
    """Base of what is data and a table: for JSON, for pandas and for notebooks. Frozen dataclasses."""

    hidden: ClassVar[frozenset[str]] = frozenset({"proofs", "problem", "spectrum", "certificate"})
    """Fields that are not in `to_dict`."""

    def records(self) -> Iterable[Mapping[str, Any]]:
        """The answer as a table, numbers as floats: one mapping for each row."""
        return ()

    def to_dict(self) -> dict[str, Any]:
        """Plain data for JSON: exact numbers as texts, with decimals beside them."""
        names = [one.name for one in fields(self) if one.name not in self.hidden]  # type: ignore[arg-type]
        return {name: plain(getattr(self, name)) for name in names} | {"proved": self.proved}

    def to_json(self) -> str:
        """`to_dict` as a text."""
        return json.dumps(self.to_dict(), ensure_ascii=False, indent=1)

    def to_frame(self) -> Any:
        """The table as a pandas.DataFrame; InputError where pandas is not installed."""
        try:
            import pandas  # type: ignore[import-untyped,import-not-found,unused-ignore]
        except ImportError:
            raise InputError("to_frame", "needs pandas: pip install pandas, or use to_dict()") from None
        return pandas.DataFrame(list(self.records()))

    def sentence(self) -> str:
        """How far it is proved, and why not further."""
        said = [self.status.value, str(self.reason or ""), getattr(self, "note", "")]
        return f"{type(self).__name__}: " + "; ".join(filter(None, said))

    def _repr_html_(self) -> str:
        """What a notebook shows."""
        rows = list(self.records())
        names = list(dict.fromkeys(name for row in rows for name in row))
        lines = [names, *([_cell(row.get(name)) for name in names] for row in rows[:_SHOWN])]
        tags = ["th", *("td" for _ in lines[1:])]
        cells = ["".join(f"<{tag}>{escape(x)}</{tag}>" for x in line) for tag, line in zip(tags, lines, strict=True)]
        table = "<table>" + "".join(f"<tr>{cell}</tr>" for cell in cells) + "</table>" if rows else ""
        more = f"<p>and {len(rows) - _SHOWN} more rows</p>" if len(rows) > _SHOWN else ""
        return f"<p>{escape(self.sentence())}</p>{table}{more}"


def _cell(x: Any) -> str:
    return "" if x is None else f"{x:.8g}" if isinstance(x, (float, complex)) else str(x)


@dataclass(frozen=True)
class Answer(Tabled):
    """Base of the answers. over: the ranges of which the answer speaks, in the problem's units. A range that is asked
    from v = 0 begins a little above it where the equations lose waves at rest (layers, Kelvin–Voigt damping).

    When undecided, `reason` says why and what helps, and `known` what is proved all the same. A proved answer is
    `Status.PROVED` where it has a `certificate` that passed the standalone verifier; else `Status.UNVERIFIED`, which
    says: proved, without certificate, and `note` tells why.
    """

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


def outward(ball: Any, up: bool) -> float:
    """The float next to the upper (lower) end of a ball that is not inside of it."""
    with precision(64):
        end = ball.upper() if up else ball.lower()
        x = float(end)
        toward = math.inf if up else -math.inf
        while math.isfinite(x) and not (arb(x) >= end if up else arb(x) <= end):
            x = math.nextafter(x, toward)
        return x


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


def shown_digits(ball: Any) -> str:
    """The decimals of a ball that are sure, one digit of them within 1."""
    with precision(max(int(ball.mid().bits()), 53) + 32):
        return str(ball.str(radius=False))


def within(ball: Any, interval: Interval) -> bool | None:
    """Whether a ball lies in a closed interval; None where it cannot be told."""
    with precision(max(int(ball.mid().bits()), 53) + 64):
        low, high = map(rational_ball, interval)
        if ball >= low and ball <= high:
            return True
        return False if ball < low or ball > high else None


def plain(value: Any) -> Any:
    """Data that JSON knows."""
    if isinstance(value, arb):
        ends = {"lower": outward(value, up=False), "upper": outward(value, up=True)}
        return {"decimal": shown_digits(value), **ends, "ball": [(str(x), e) for x, e in pack(value)]}
    if isinstance(value, acb):
        return {"real": plain(value.real), "imag": plain(value.imag)}
    if isinstance(value, Fraction):
        return {"exact": str(value), "decimal": float(value)}
    if isinstance(value, Enum):
        return value.value
    if isinstance(value, np.ndarray):
        return value.tolist()
    if isinstance(value, Reason):
        return value.data()
    if isinstance(value, Tabled):
        return value.to_dict()
    if isinstance(value, Mapping):
        return {str(key): plain(one) for key, one in value.items()}
    if isinstance(value, (tuple, list)):
        return [plain(one) for one in value]
    if hasattr(value, "__dataclass_fields__"):
        return {one.name: plain(getattr(value, one.name)) for one in fields(value) if one.repr}
    return value
