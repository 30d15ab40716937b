"""Numbers as they are given, positions and times among them, as one float64 array of one dimension."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from mpsolve.errors import InputError
from mpsolve.numbers.arrays import Reals
from mpsolve.numbers.exact import exact_list


def float_list(values: Any, key: str) -> Reals:
    """One number, or each of many, in float64; InputError names the one that is none, or is beyond float64."""
    if isinstance(values, np.ndarray) and values.ndim == 1 and values.dtype.kind in "fiu":
        found = values.astype(float)
    else:
        found = np.array([_float(x, f"{key}[{j}]") for j, x in enumerate(exact_list(values, key), 1)], float)
    for j in np.flatnonzero(~np.isfinite(found)):
        raise InputError(f"{key}[{j + 1}]", f"is {found[j]}: give a finite number")
    return found


def _float(number: Any, key: str) -> float:
    try:
        value = float(number)
    except OverflowError:
        value = math.inf
    if math.isinf(value) or (value == 0 and number):
        raise InputError(key, f"is {number.short()}, beyond the range of float64: give a moderate number")
    return value


def checked_places(xi: Any, default: Sequence[float]) -> Reals:
    """The positions, those of the masses (the default) where there are none."""
    return np.array(default, float) if xi is None else float_list(xi, "xi")


def checked_times(tau: Any) -> Reals:
    """The times, in the order given."""
    times = float_list(tau, "tau")
    if np.any(times < 0):
        raise InputError("tau", f"holds {times.min():g}: the motion starts at 0, give no earlier time")
    return times
