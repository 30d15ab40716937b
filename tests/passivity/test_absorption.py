"""What a track absorbs: against complex numbers, and the speed of its shortest waves."""

import random

import pytest

from mpsolve import Problem, tracks, vehicles
from mpsolve.passivity.absorption import Absorption, overtakes, slowest_short_wave
from mpsolve.problem.reduced import reduce_problem

LAYERS = {"EI": "6.38e6", "m": "60.2", "k_pad": "300e6", "c_pad": "3e4", "m_sleeper": "250", "k_ballast": "100e6",
          "c_ballast": "8e4"}  # fmt: skip


def guide_of(track: object, v: int) -> object:
    return reduce_problem(Problem(track, [vehicles.Mass(900).at(0)], v=v)).guide


def test_it_is_the_imaginary_part_in_complex_numbers() -> None:
    guide = guide_of(tracks.TwoLayer(**LAYERS), 100)
    absorption, draw = Absorption.of(guide), random.Random(1)
    for _ in range(5):
        p, omega = draw.uniform(-2, 2), draw.uniform(-2, 2)
        D, N = (sum(float(c) * (1j * p) ** i * (1j * omega) ** j for (i, j), c in a.items())
                for a in (guide.D_rest, guide.N_rest))  # fmt: skip
        W, D2 = (sum(float(c) * p**i * omega**j for (i, j), c in a.items()) for a in (absorption.W, absorption.D2))
        assert pytest.approx(-(N * D.conjugate()).imag, rel=1e-9, abs=1e-12 * abs(N * D)) == W
        assert pytest.approx(abs(D) ** 2, rel=1e-9) == D2


def test_a_string_is_overtaken_at_the_speed_of_its_waves() -> None:
    wire = tracks.String(T=400, m=1, k=500, c=2)  # waves at 20 m/s
    slow, fast = (Absorption.of(guide_of(wire, v)) for v in (19, 21))
    assert slowest_short_wave(slow) / float(slow.v) == pytest.approx(20 / 19)
    assert not overtakes(slow, slow.v)
    assert overtakes(fast, fast.v)
