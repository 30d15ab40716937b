"""What every motion in time shows of itself: a headline, and a row for each time."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from mpsolve.numbers.tabled import Tabled


class Rows(Tabled):
    """Base of dataclasses with times (t,), places (p,), rail (p, t) and contact_force (n, t)."""

    if TYPE_CHECKING:
        times: Any
        places: Any
        rail: Any
        contact_force: Any

        @property
        def reason(self) -> Any: ...

    @property
    def rail_error(self) -> float:
        """The estimated error of the deflections of the rail."""
        raise NotImplementedError

    def records(self) -> Iterator[Mapping[str, Any]]:
        """A row for each time: the rail under each place, and the force of each contact."""
        names = [f"rail at {place:g}" for place in self.places]
        names += [f"contact force {j}" for j in range(1, len(self.contact_force) + 1)]
        rows = np.concatenate([self.rail, self.contact_force]).T.tolist()
        return (
            {"t": t} | dict(zip(names, row, strict=True)) for t, row in zip(self.times.tolist(), rows, strict=True)
        )

    def _headline(self) -> str:
        known = np.abs(self.rail[np.isfinite(self.rail)])
        size, off = float(np.max(known, initial=0.0)), self.rail_error
        stated = f"largest deflection of the rail {size:.6g}, estimated error {off:.1e}"
        note = "" if self.reason is None else f": {self.reason}"
        return f"{type(self).__name__} at {len(self.times)} times: {stated}; float64, not proved{note}"
