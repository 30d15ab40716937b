"""A bogie with its wheels held: bounce and pitch of the frame at the frequencies of the field."""

from __future__ import annotations

import numpy as np
import pytest

from mpsolve.vehicles import Bogie

FRAME = {"wheel": 1813, "frame": 2615, "inertia": 1476, "wheelbase": "2.56", "k": "2.4e6", "c": "8e3"}


def test_the_frame_bounces_and_pitches_on_its_suspension() -> None:
    """ω² = 2k/frame and 2k (wheelbase/2)²/inertia, apart from each other."""
    pencil = Bogie(**FRAME).pencil
    M, K = np.array(pencil.M, float)[2:, 2:], np.array(pencil.K, float)[2:, 2:]
    assert np.linalg.solve(M, K) == pytest.approx(np.diag([4.8e6 / 2615, 4.8e6 * 1.28**2 / 1476]))


def test_the_body_rests_on_the_middle_of_the_frame() -> None:
    pencil = Bogie(**FRAME, body=16000, k2="4e5").pencil
    assert pencil.names[-1] == "body"
    assert pencil.K[4] == (0, 0, -400000, 0, 400000)
