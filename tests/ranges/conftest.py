"""The scope of the pair of masses of chart_pair, and a crossing in it."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from chart_pair import OVER, PAIR

from mpsolve import crossings
from mpsolve.ranges.scope import Scope, scope_of


@pytest.fixture(scope="package")
def scope() -> Scope:
    return scope_of(PAIR, OVER)


@pytest.fixture(scope="package")
def true(scope: Scope) -> Any:
    """(q̂, x̂, ŷ) of crossings over the velocity at a fixed mass, by the search in one parameter."""
    answer = crossings(PAIR, over={"v": OVER["v"]}, check=False)
    family = scope.family
    units = np.array([float(family.frequency_unit), *map(float, family.units)])
    return np.array([[float(c.q.mid()), float(c.value.mid()), 1.0] for c in answer.crossings]).T / units[:, None]
