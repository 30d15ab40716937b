"""A motion shows a headline and its numbers, a row for each time; what is not known as such."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.outcome import Reason
from mpsolve.vibration.rows import Rows


@dataclass
class Motion(Rows):
    rail: Any
    reason: Reason | None = None

    def __post_init__(self) -> None:
        self.times, self.places, self.contact_force = (
            np.array([0.0, 0.5]),
            np.array([0.0, 2.5]),
            np.array([[0.0, 7.0]]),
        )

    @property
    def rail_error(self) -> float:
        return 1e-9


def test_a_row_for_each_time() -> None:
    motion = Motion(np.array([[0.0, -3.0], [0.0, 2.0]]))
    assert list(motion.records())[1] == {"t": 0.5, "rail at 0": -3.0, "rail at 2.5": 2.0, "contact force 1": 7.0}
    said = "Motion at 2 times: largest deflection of the rail 3, estimated error 1.0e-09; float64, not proved"
    assert str(motion).splitlines()[0] == said
    assert said in motion._repr_html_()


def test_what_is_not_known_is_told() -> None:
    nothing = Motion(np.full((2, 2), np.nan), Reason("effort", "it is spent"))
    assert str(nothing).splitlines()[0].endswith("rail 0, estimated error 1.0e-09; float64, not proved: it is spent")
