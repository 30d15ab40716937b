"""The motion is that of the library, and grey after a lift-off."""

from __future__ import annotations

import numpy as np
import pytest

from mpsolve import InputError, Problem, read_problem, response, tracks, vehicles
from mpsolve.explorer.moving import POINTS, motion_pictures
from mpsolve.explorer.session import Session

TRACK = tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c=770)
PAIR = Problem(TRACK, vehicles.train(vehicles.Mass(10000), 2, "3.4"), v=100)


def test_both_pictures_and_the_lift_off() -> None:
    drawn = motion_pictures(PAIR, 1.0)
    assert drawn.count("<svg") == 2
    assert ">lift-off<" in drawn
    assert "beyond" in drawn
    assert ">contact 2<" in drawn
    motion = response(PAIR, times=np.linspace(0, 1, POINTS))
    assert motion.lift_off is not None
    assert motion.lift_off.time < 1


def test_a_session_draws_it_and_says_what_cannot_be() -> None:
    session = Session.of(read_problem("examples/two_layer_bogie.toml").problem)
    assert session.motion == ""
    session.draw_motion("0.05 s")
    assert session.motion.count("<svg") == 2
    assert ">lift-off<" not in session.motion
    session.zoom(0.5)
    assert session.motion
    session.change("v", 90)
    assert session.motion == ""  # it was that of another problem
    for wrong in ("0", "-1", "a while", "3 kg"):
        with pytest.raises(InputError):
            session.draw_motion(wrong)
