"""The positions ξ and the times τ at which a motion is asked for, as float64 arrays of one dimension."""

from __future__ import annotations

from typing import Any

import numpy as np

from mpsolve.errors import InputError
from mpsolve.numbers.float_list import float_list


def checked_places(xi: Any, default: Any) -> Any:
    """The positions, those of the masses (the default) where there are none."""
    return np.array(default, float) if xi is None else float_list(xi, "xi")


def checked_times(tau: Any) -> Any:
    """The times, in the order given."""
    times = float_list(tau, "tau")
    if np.any(times < 0):
        raise InputError("tau", f"holds {times.min():g}: the motion starts at 0, give no earlier time")
    return times
