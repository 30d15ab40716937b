"""What all results show of themselves: a headline and a table, printed, in a notebook, or as a DataFrame."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from itertools import islice
from typing import Any

from mpsolve.errors import InputError

_ROWS = 100  # printed, or shown in a notebook


class Tabled:
    """Base of what has `records`, a mapping for each row, and a headline."""

    def records(self) -> Iterable[Mapping[str, Any]]:
        """One mapping for each row."""
        raise NotImplementedError

    def _headline(self) -> str:
        raise NotImplementedError

    def to_frame(self) -> Any:
        """The table as a pandas.DataFrame; InputError where pandas is not installed."""
        try:
            import pandas  # type: ignore[import-untyped,import-not-found,unused-ignore]
        except ImportError:
            raise InputError("to_frame", "needs pandas: pip install pandas, or use to_dict()") from None
        return pandas.DataFrame(list(self.records()))

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

    def _printed(self) -> list[list[str]]:
        """The names of the columns, and the first rows."""
        rows = list(islice(self.records(), _ROWS))
        names = list(dict.fromkeys(name for row in rows for name in row))
        return [names, *([_text(row.get(name)) for name in names] for row in rows)]

    def _rest(self) -> str:
        left = sum(1 for _ in islice(self.records(), _ROWS, None))
        return f"and {left} more rows" if left else ""


def _text(x: Any) -> str:
    return "" if x is None else f"{x:.8g}" if isinstance(x, (float, complex)) else str(x)
