"""A motion that several figures are drawn of."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from figure_parts import CASE

from mpsolve.vibration.of_case import motion_of_case


@pytest.fixture(scope="session")
def motion() -> Any:
    return motion_of_case(CASE, tau=np.linspace(0, 200, 801))
