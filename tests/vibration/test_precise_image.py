"""The image in many digits against that in floats."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import mpmath
import numpy as np
import pytest
from track_models import DAMPED

from mpsolve import Load, Problem, vehicles
from mpsolve.vehicles.loads import outer_forces
from mpsolve.vibration.balls.equations import exact_terms
from mpsolve.vibration.forcing import tones, transform
from mpsolve.vibration.image import Image
from mpsolve.vibration.precise_image import PreciseImage


@pytest.mark.parametrize("loads", [None, [Load(2, 1, 3)], {"wheel": Load(0, 1, 3, 1)}])
def test_the_image_is_that_of_the_floats(loads: Any) -> None:
    """The columns of forces and the channels, at one point."""
    problem = Problem(DAMPED["two-layer"], vehicles.Mass(900), v=30)
    image, mp = Image(problem, (Fraction(2),)), mpmath.MPContext()
    mp.dps = 40
    precise = PreciseImage(mp, image, exact_terms(image.pencil, loads), 30)
    sigma = 0.02 + 0.1j
    acting = tones(image, outer_forces(image.pencil, loads), ())
    row = image.solve(np.array([sigma]), transform(acting, np.array([sigma]), 2))[0]
    known = np.array([complex(x) for x in precise(mp.mpc(sigma))])
    assert row == pytest.approx(known, rel=1e-9)
