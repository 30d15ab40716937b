"""The plain form (41) in time, against the march of the rearranged one."""

from __future__ import annotations

import numpy as np
import pytest
from beam_loads import pair
from newmark import coupled_beam, newmark

from mpsolve import InputError
from mpsolve.finite.beam.beam import finite_beam
from mpsolve.finite.beam.march import Loading, march
from mpsolve.finite.beam.modes import Beam


def test_newmark_in_both_forms_is_one_and_tends_to_the_march_at_second_order() -> None:
    """(41) against (52), and both against modes that are integrated exactly."""
    beam = Beam(40.0, 50, 0.5, 0.1, 0.05, tail=False)
    loading = Loading(
        np.array([40.0, 10.0]),
        np.array([12.0, 13.5]),
        lambda tau: np.array([2 + np.sin(0.5 * tau), 1 + 0 * tau]),
        degree=3,
    )
    exact = march(beam, loading, 16.0, 256).deflection
    errors = []
    for steps in (256, 512):
        rearranged = newmark(beam, loading, 16.0, steps, coupled=False)
        assert np.abs(newmark(beam, loading, 16.0, steps, coupled=True) - rearranged).max() < 1e-11
        errors.append(np.abs(rearranged[:, :: steps // 256] - exact).max())
    assert errors[0] < 5e-3
    assert errors[0] == pytest.approx(4 * errors[1], rel=0.05)


def test_the_coupled_form_as_a_function_agrees_with_the_finite_beam() -> None:
    case = pair("0.5", 10, "0.1", "1")
    errors = []
    for modes in (70, 140):
        tau, deflection = coupled_beam(case, tau=10, start=30, length=70, modes=modes, steps=200)
        assert deflection.shape == (2, 201)
        errors.append(np.abs(deflection[:, 1:] - finite_beam(case, tau=tau[1:]).displacement).max())
    assert 0.1 > errors[0] > 4 * errors[1]  # what the modes that are left out would add falls with their number
    with pytest.raises(InputError, match="length: is 20, but the load"):
        coupled_beam(case, tau=10, start=30, length=20, modes=160, steps=400)
