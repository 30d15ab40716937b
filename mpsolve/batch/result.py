"""What is known of the entries of a batch."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.errors import InputError
from mpsolve.numbers.arrays import Complexes, Integers, Reals
from mpsolve.numbers.tabled import Tabled
from mpsolve.problem.cases import Given

STATUSES = ("ok", "unresolved", "refused")


@dataclass(frozen=True)
class Frequencies(Tabled):
    """Counts and roots in a region for every entry of a batch, in float64: nothing is proved.

    over: the arrays that were given, broadcast to `shape`. count: int, −1 where it is not told. status: "ok";
    "unresolved" (float64 does not tell; `certify` may); "refused" (a track that buckles, or has no damping).
    reason: a sentence where the status is not "ok", else "". roots: complex, shape (…, n) with n the largest count,
    each row sorted by (Re q, Im q), then nan; None where only counts were asked for. q is in the problem's units.
    """

    problem: Given
    region: str
    over: Mapping[str, Reals]
    count: Integers
    status: Any
    reason: Any
    roots: Complexes | None = None

    @property
    def shape(self) -> tuple[int, ...]:
        """Of the broadcast arrays."""
        return tuple(self.count.shape)

    @property
    def unstable(self) -> Any:
        """The number of roots with Im q < 0, −1 where it is not known."""
        if self.region == "unstable":
            return self.count
        if self.roots is None:
            raise InputError("roots", "were not asked for, and the region goes above Im q = 0: ask for them")
        with np.errstate(invalid="ignore"):
            return np.where(self.count < 0, -1, (self.roots.imag < 0).sum(-1))

    def records(self) -> Iterator[Mapping[str, Any]]:
        """The columns of `to_dict`, an entry a row."""
        columns = self.to_dict()
        return (dict(zip(columns, row, strict=True)) for row in zip(*columns.values(), strict=True))

    def _headline(self) -> str:
        size, told = self.count.size, int((self.count >= 0).sum())
        some = int((self.count > 0).sum())
        where = "Im q < 0" if self.region == "unstable" else self.region
        stated = f"{some} of them with roots in {where}, {size - told} not told"
        return f"Frequencies of {size} entries, shape {self.shape}: {stated}; float64, not proved"

    def to_dict(self) -> dict[str, list[Any]]:
        """Columns by name, an entry a row: the parameters, status, reason, count, and re_1, im_1, … (None: none)."""
        out: dict[str, list[Any]] = {path: np.ravel(values).tolist() for path, values in self.over.items()}
        out |= {name: np.ravel(getattr(self, name)).tolist() for name in ("status", "reason")}
        out["count"] = [None if n < 0 else n for n in self.count.ravel().tolist()]
        if self.roots is not None:
            for k in range(self.roots.shape[-1]):
                column = self.roots[..., k].ravel().tolist()
                out[f"re_{k + 1}"] = [None if q != q else q.real for q in column]
                out[f"im_{k + 1}"] = [None if q != q else q.imag for q in column]
        return out
