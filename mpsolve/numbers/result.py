"""What all answers share: how far they are to be trusted, why not further, what they rest on and what they took."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from dataclasses import Field, fields
from enum import Enum
from fractions import Fraction
from itertools import islice
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, ClassVar

from flint import arb

from mpsolve.errors import InputError
from mpsolve.frozen import frozen
from mpsolve.numbers.packed import Portable
from mpsolve.numbers.plain import plain

if TYPE_CHECKING:
    from mpsolve.outcome import Reason, Status

_ROWS = 100  # printed, or shown in a notebook


@frozen
class Cost:
    """What an answer took: processor seconds of the proof and of its check, evaluations, pieces of paths."""

    seconds: float
    verification: float = 0.0
    evaluations: int = 0
    pieces: int = 0


class Result(Portable):
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

    def to_frame(self) -> Any:
        """The table as a pandas.DataFrame; InputError where pandas is not installed."""
        try:
            import pandas  # type: ignore[import-untyped,import-not-found,unused-ignore]
        except ImportError:
            raise InputError("to_frame", "needs pandas: pip install pandas, or use to_dict()") from None
        return pandas.DataFrame(list(self.records()))

    def _shown(self) -> list[Field[Any]]:
        return [one for one in fields(self) if one.name not in self.hidden]  # type: ignore[arg-type]

    def _repr_html_(self) -> str:
        """What a notebook shows."""
        from html import escape

        names, *rows = self._printed()
        tags = ["th", *("td" for _ in rows)]
        cells = [
            "".join(f"<{tag}>{escape(x)}</{tag}>" for x in line)
            for tag, line in zip(tags, (names, *rows), strict=True)
        ]
        table = "<table>" + "".join(f"<tr>{cell}</tr>" for cell in cells) + "</table>" if rows else ""
        more = f"<p>{escape(self._rest())}</p>" if self._rest() else ""
        return f"<p>{escape(self._headline())}</p>{table}{more}"

    def __str__(self) -> str:
        """What `print` shows: how far it is to be trusted, and the table."""
        names, *rows = self._printed()
        widths = [max(map(len, column)) for column in zip(names, *rows, strict=True)]
        lines = ["  ".join(x.ljust(n) for x, n in zip(line, widths, strict=True)).rstrip() for line in (names, *rows)]
        return "\n".join([self._headline(), *lines[: bool(rows) and None], *filter(None, [self._rest()])])

    def _headline(self) -> str:
        return f"{type(self).__name__}: {self.trust}"

    def _printed(self) -> list[list[str]]:
        """The names of the columns, and the first rows."""
        rows = list(islice(self.records(), _ROWS))
        names = list(dict.fromkeys(name for row in rows for name in row))
        return [names, *([_text(row.get(name)) for name in names] for row in rows)]

    def _rest(self) -> str:
        left = sum(1 for _ in islice(self.records(), _ROWS, None))
        return f"and {left} more rows" if left else ""

    def __bool__(self) -> bool:
        raise TypeError(f"{type(self).__name__} has no truth value: ask for .proved, or for what it says")


def _cell(value: Any) -> Any:
    """What stands in a table: a number, rounded to a float, or a text; None for all else."""
    if isinstance(value, Enum):
        return value.value
    if isinstance(value, arb):
        return float(value.mid())
    return float(value) if isinstance(value, Fraction) else value if isinstance(value, (int, float, str)) else None


def _text(x: Any) -> str:
    return "" if x is None else f"{x:.8g}" if isinstance(x, (float, complex)) else str(x)
