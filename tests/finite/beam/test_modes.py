"""The modes of the finite beam, and what those beyond give."""

from __future__ import annotations

import numpy as np

from mpsolve import Case
from mpsolve.finite.beam.march import Loading, march
from mpsolve.finite.beam.modes import Beam
from mpsolve.vehicles.load import Load

TAU = np.linspace(0, 60, 121)
FORCES = (Load(1, "0.4", "0.3", "0.5"), Load("0.5", "0.3", "1.2", "-1"), Load("-0.2"))


def pair(alpha: str, eta_m: int, eta_b: str, distance: str) -> Case:
    return Case(alpha=alpha, eta_b=eta_b, eta_m=(eta_m, eta_m), positions=(0, distance))


def constant(values: list[float], places: list[float], eta_m: list[float]) -> Loading:
    force = np.array(values)
    return Loading(np.array(eta_m), np.array(places), lambda _tau: force)


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
