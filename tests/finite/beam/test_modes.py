"""The modes of the finite beam, and what those beyond give."""

from __future__ import annotations

import numpy as np
from beam_loads import constant

from mpsolve.finite.beam.march import march
from mpsolve.finite.beam.modes import Beam


def test_the_tail_gives_what_thousands_of_modes_give() -> None:
    loading = constant([2.0, 2.0], [20.0, 21.0], [40.0, 40.0])
    many, cut, bare = (
        march(Beam(60.0, modes, 0.5, 0.2, 0.0, tail), loading, 20.0, 40).deflection
        for modes, tail in ((2000, True), (180, True), (180, False))
    )
    assert np.abs(cut - many).max() < 1e-5
    assert np.abs(bare - many).max() > 50 * np.abs(cut - many).max()


def test_a_critically_damped_mode_is_between_its_neighbours() -> None:
    critical = float(np.sqrt((np.pi / 10) ** 4 / 4 + 1))  # the damping that is critical for the first mode

    def deflection(eta_b: float) -> object:
        return march(Beam(10.0, 20, 0.1, 0.0, eta_b), constant([2.0], [4.0], [3.0]), 8.0, 16).deflection

    low, middle, high = (deflection(critical + shift) for shift in (-1e-5, 0.0, 1e-5))
    assert np.abs((low + high) / 2 - middle).max() < 1e-8
    assert np.abs(high - low).max() > 1e-6
