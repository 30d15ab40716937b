"""What all answers share: how far they are to be trusted, why not further, what they rest on and what they took."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from dataclasses import Field, fields
from enum import Enum
from fractions import Fraction
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, ClassVar

from flint import arb

from mpsolve.frozen import frozen
from mpsolve.numbers.packed import Portable
from mpsolve.numbers.plain import plain
from mpsolve.numbers.tabled import Tabled

if TYPE_CHECKING:
    from mpsolve.outcome import Reason, Status


@frozen
class Cost:
    """What an answer took: processor seconds of the proof and of its check, evaluations, pieces of paths."""

    seconds: float
    verification: float = 0.0
    evaluations: int = 0
    pieces: int = 0


class Result(Portable, Tabled):
    """Base of frozen dataclasses with a `status`; they pickle, and refuse a truth value, which would mislead.

    reason: why the answer is undecided, and what helps, or None. known: what is proved all the same.
    certificate: what others can check, or None where no file of such a proof is written. cost: what it took, or None.
    """

    if TYPE_CHECKING:

        @property
        def status(self) -> Status: ...
        @property
        def reason(self) -> Reason | None: ...

    hidden: ClassVar[frozenset[str]] = frozenset({"proofs", "problem", "spectrum", "certificate"})
    """Fields that are not in `to_dict`."""
    known: Mapping[str, Any] = MappingProxyType({})
    certificate: Any = None
    cost: Any = None

    @property
    def proved(self) -> bool:
        """Whether the whole answer is proved."""
        return self.status.holds

    @property
    def trust(self) -> str:
        """How far it is proved, why not further, and whether there is a certificate, in plain words."""
        note = getattr(self, "note", "")
        if self.proved and self.certificate is None:
            stated = "proved, without certificate"
        elif self.proved:
            stated = f"{self.status.value}, with a certificate"
        else:
            stated, note = self.status.value, note or str(self.reason or "")
        return f"{stated}: {note}" if note else stated

    def records(self) -> Iterable[Mapping[str, Any]]:
        """The answer as a table: one mapping for each row; here one row with what is a number or a text."""
        told = {one.name: _cell(getattr(self, one.name)) for one in self._shown()}
        return [{name: value for name, value in told.items() if value is not None}]

    def to_dict(self) -> dict[str, Any]:
        """Plain data for JSON: exact numbers as texts, with decimals beside them."""
        told = {one.name: plain(getattr(self, one.name)) for one in self._shown()}
        state = {"status": self.status.value, "reason": plain(self.reason)}  # a table has them of its entries
        return told | state | {"proved": self.proved, "trust": self.trust}

    def to_json(self) -> str:
        """`to_dict` as a text."""
        return json.dumps(self.to_dict(), ensure_ascii=False, indent=1)

    def _shown(self) -> list[Field[Any]]:
        return [one for one in fields(self) if one.name not in self.hidden]  # type: ignore[arg-type]

    def _headline(self) -> str:
        return f"{type(self).__name__}: {self.trust}"

    def __bool__(self) -> bool:
        raise TypeError(f"{type(self).__name__} has no truth value: ask for .proved, or for what it says")


def _cell(value: Any) -> Any:
    """What stands in a table: a number, rounded to a float, or a text; None for all else."""
    if isinstance(value, Enum):
        return value.value
    if isinstance(value, arb):
        return float(value.mid())
    return float(value) if isinstance(value, Fraction) else value if isinstance(value, (int, float, str)) else None
